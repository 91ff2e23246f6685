// The filters, against exact signs.
#include "fast/block_filter.h"

#include "support/environments.h"
#include "support/query_batch.h"
#include "support/statuses.h"
#include "support/support.h"

#include <math.h>
#include <string.h>

static const query_kind kinds[2] = {POINT_TRIANGLE, EDGE_EDGE};

// Verdicts --------------------------------------------------------------------

enum {
    BATCH = 1000
};

static void fail_at(const batch *b, size_t i, const char *name)
{
    query q = batch_query(b, i);
    ck_abort_msg("%s, query %zu of %zu, seed %llu, %s\n%s", name, i,
                 b->queries.count, (unsigned long long)seed(), query_name(&q),
                 query_text(&q));
}

/// The percentage of queries of a family that the filter leaves undecided.
static double try_family(const family *source, query_kind kind, long count)
{
    generator random = generator_new((uint64_t)(source - families));
    batch b = batch_new(BATCH);
    size_t undecided = 0, tried = 0;
    for (long i = 0; i < count; i += BATCH, tried += BATCH) {
        batch_fill(&b, &random, source, kind, BATCH);
        size_t wrong = batch_wrong(&b, &undecided);
        if (wrong < BATCH)
            fail_at(&b, wrong, source->name);
    }
    batch_free(&b);
    return 100 * (double)undecided / (double)tried;
}

START_TEST(no_certain_verdict_is_wrong)
{
    const family *source = &families[_i / 2];
    double undecided = try_family(source, kinds[_i % 2], cases(20000));
    ck_assert_msg(_i / 2 >= RANDOM_FAMILIES || undecided == 0,
                  "%s: %g %% undecided", source->name, undecided);
}
END_TEST

// Numbers of queries ----------------------------------------------------------

START_TEST(any_number_of_queries_can_be_decided)
{
    generator random = generator_new(1);
    batch b = batch_new(200);
    batch_fill(&b, &random, &families[1], kinds[_i], 200);
    ck_assert_int_eq(batch_filter(&b), TF_OK);
    tf_query_masks all[4], some[5];
    memcpy(all, b.masks, sizeof all);
    for (size_t count = 0; count <= 200; count++) {
        memset(b.masks, 42, 4 * sizeof *b.masks);
        memcpy(some, b.masks, sizeof all);
        b.queries.count = count;
        ck_assert_int_eq(batch_filter(&b), TF_OK);
        for (size_t i = 0; i < 4; i++) {
            const tf_query_masks *now = &b.masks[i];
            size_t used = count > 64 * i ? count - 64 * i : 0;
            uint64_t bits =
                used >= 64 ? ~UINT64_C(0) : (UINT64_C(1) << used) - 1;
            if (used == 0) {
                ck_assert_mem_eq(now, &some[i], sizeof *now);
                continue;
            }
            ck_assert_uint_eq(now->apart, all[i].apart & bits);
            ck_assert_uint_eq(now->separated, all[i].separated & bits);
            ck_assert_uint_eq(now->hit, all[i].hit & bits);
            ck_assert_uint_eq(now->undecided, all[i].undecided & bits);
        }
    }
    batch_free(&b);
}
END_TEST

// Not numbers -----------------------------------------------------------------

/// Gives 64 queries, that are generic otherwise, one coordinate.
static tf_query_masks with_coordinate(query_kind kind, int i, double x)
{
    generator random = generator_new(2);
    batch b = batch_new(64);
    batch_fill(&b, &random, &families[1], kind, 64);
    for (int block = 0; block < 8; block++)
        for (int lane = 0; lane < TF_BLOCK_QUERIES; lane++)
            b.block[block].at[i / 12][i / 3 % 4][i % 3][lane] = x;
    ck_assert_int_eq(batch_filter(&b), TF_OK);
    tf_query_masks masks = b.masks[0];
    batch_free(&b);
    return masks;
}

START_TEST(queries_not_finite_or_too_large_are_undecided)
{
    static const double bad[] = {NAN,      INFINITY, -INFINITY, 0x1p301,
                                 -0x1p301, 0x1p1023, -0x1p1023};
    for (int i = 0; i < 24; i++) {
        tf_query_masks masks = with_coordinate(kinds[_i], i, 0x1p299);
        ck_assert_uint_ne(masks.apart, 0);
        for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
            masks = with_coordinate(kinds[_i], i, bad[k]);
            ck_assert_uint_eq(masks.undecided, UINT64_MAX);
            ck_assert_uint_eq(masks.apart | masks.hit | masks.separated, 0);
        }
    }
}
END_TEST

// Trouble ---------------------------------------------------------------------

START_TEST(a_broken_environment_is_reported)
{
    tf_query_block block = {0};
    tf_query_masks masks = {.hit = 42};
    environment_break(_i);
    tf_status points = tf_filter_point_triangle(8, &block, &masks);
    tf_status edges = tf_filter_edge_edge(8, &block, &masks);
    environment_restore();
    ck_assert_int_eq(points, TF_BAD_ENVIRONMENT);
    ck_assert_int_eq(edges, TF_BAD_ENVIRONMENT);
    ck_assert_uint_eq(masks.hit, 42);
}
END_TEST

START_TEST(no_queries_are_decided_at_once)
{
    ck_assert_int_eq(tf_filter_point_triangle(0, NULL, NULL), TF_OK);
    ck_assert_int_eq(tf_filter_edge_edge(0, NULL, NULL), TF_OK);
}
END_TEST

START_TEST(missing_blocks_or_masks_break_the_contract)
{
    tf_query_block block = {0};
    tf_query_masks masks;
    exit_on_broken_contract();
    if (_i == 0)
        tf_filter_point_triangle(1, NULL, &masks);
    else
        tf_filter_edge_edge(1, &block, NULL);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("fast/block_filter");
    TCase *c = tcase_create("filter");
    tcase_add_loop_test(c, no_certain_verdict_is_wrong, 0, 2 * FAMILIES);
    tcase_add_loop_test(c, any_number_of_queries_can_be_decided, 0, 2);
    tcase_add_loop_test(c, queries_not_finite_or_too_large_are_undecided, 0, 2);
    tcase_add_loop_test(c, a_broken_environment_is_reported, 0, environments());
    tcase_add_test(c, no_queries_are_decided_at_once);
    tcase_add_loop_exit_test(c, missing_blocks_or_masks_break_the_contract,
                             BROKEN_CONTRACT, 0, 2);
    suite_add_tcase(suite, c);
    return suite;
}

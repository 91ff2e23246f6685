// The loops over lanes: that a lane's verdict depends on nothing but its own
// query, and how far a determinant must be from zero.
#include "fast/lanes.h"

#include "support/query_batch.h"
#include "support/support.h"

#include <stdbool.h>
#include <string.h>

static tf_lanes_filter *filter_of(query_kind kind)
{
    return kind == EDGE_EDGE ? tf_lanes_edge_edge : tf_lanes_point_triangle;
}

static query_kind kind_of(int i)
{
    return i % 2 ? EDGE_EDGE : POINT_TRIANGLE;
}

// Lanes -----------------------------------------------------------------------

enum {
    BLOCKS = 27
};

static bool same_bits(const tf_query_masks *one, const tf_query_masks *all,
                      size_t bit)
{
    return (one->apart & 1) == (all->apart >> bit & 1) &&
           (one->separated & 1) == (all->separated >> bit & 1) &&
           (one->hit & 1) == (all->hit >> bit & 1) &&
           (one->undecided & 1) == (all->undecided >> bit & 1);
}

/// A block with one query of another in each lane.
static tf_query_block copies_of(const tf_query_block *block, int lane)
{
    tf_query_block copies = {0};
    const double(*from)[TF_BLOCK_QUERIES] = block->at[0][0];
    double(*to)[TF_BLOCK_QUERIES] = copies.at[0][0];
    for (int row = 0; row < 24; row++)
        for (int i = 0; i < TF_BLOCK_QUERIES; i++)
            to[row][i] = from[row][lane];
    return copies;
}

START_TEST(each_lane_is_judged_by_itself)
{
    generator random = generator_new((uint64_t)_i);
    batch b = batch_new(BLOCKS * TF_BLOCK_QUERIES);
    batch_fill(&b, &random, &families[_i / 2], kind_of(_i),
               BLOCKS * TF_BLOCK_QUERIES);
    tf_lanes_filter *filter = filter_of(kind_of(_i));
    static double clearance[BLOCKS * TF_BLOCK_QUERIES];
    static tf_query_masks unmeasured[BLOCKS * TF_BLOCK_QUERIES];
    filter(BLOCKS, b.block, TF_SHARE_SURE, b.masks, clearance);
    filter(BLOCKS, b.block, TF_SHARE_SURE, unmeasured, NULL);
    for (size_t i = 0; i < BLOCKS * TF_BLOCK_QUERIES; i++) {
        tf_query_block copies = copies_of(&b.block[i / TF_BLOCK_QUERIES],
                                          (int)(i % TF_BLOCK_QUERIES));
        tf_query_masks own;
        double own_clearance[TF_BLOCK_QUERIES];
        filter(1, &copies, TF_SHARE_SURE, &own, own_clearance);
        ck_assert_mem_eq(&own_clearance[i % 3], &clearance[i],
                         sizeof *clearance);
        ck_assert(same_bits(&own, &unmeasured[i / TF_MASK_QUERIES],
                            i % TF_MASK_QUERIES));
        ck_assert_msg(
            same_bits(&own, &b.masks[i / TF_MASK_QUERIES], i % TF_MASK_QUERIES),
            "%s, query %zu, seed %llu", families[_i / 2].name, i,
            (unsigned long long)seed());
        ck_assert(own.hit == 0 || (own.hit & 255) == 255);
    }
    batch_free(&b);
}
END_TEST

// Shares ----------------------------------------------------------------------

/// Eight copies of a query of a point and a triangle.
static tf_query_masks judged(const double at[2][4][3], double share)
{
    tf_query_block block;
    for (int t = 0; t < 2; t++)
        for (int v = 0; v < 4; v++)
            for (int k = 0; k < 3; k++)
                for (int i = 0; i < TF_BLOCK_QUERIES; i++)
                    block.at[t][v][k][i] = at[t][v][k];
    tf_query_masks masks;
    tf_lanes_point_triangle(1, &block, share, &masks, NULL);
    return masks;
}

/// A query whose signs are determinants of integers, one of them, d, small: the
/// point (0, 0, 0) and a triangle at the height 1 that comes down to -1.  Its
/// corner is d off the axis through the point.
static tf_query_masks thin_hit(double d, double share)
{
    const double at[2][4][3] = {
        {{0, 0, 0}, {-d, 0, 1}, {1, -1, 1}, {1, 1, 1}},
        {{0, 0, 0}, {-d, 0, -1}, {1, -1, -1}, {1, 1, -1}}};
    return judged(at, share);
}

START_TEST(a_determinant_within_its_share_is_uncertain)
{
    // The corner is d to the left of the point; the error is share 1 1 1.
    ck_assert_uint_eq(thin_hit(0x1p-10, 0x1p-14).hit & 255, 255);
    ck_assert_uint_eq(thin_hit(0x1p-20, 0x1p-14).hit & 255, 0);
    ck_assert_uint_eq(thin_hit(0x1p-20, 0x1p-14).undecided & 255, 255);
    ck_assert_uint_eq(thin_hit(0x1p-20, 0x1p-24).hit & 255, 255);
    ck_assert_uint_eq(thin_hit(-0x1p-20, 0x1p-24).separated & 255, 255);
}
END_TEST

// Limits ----------------------------------------------------------------------

/// A triangle to the right of the point (0, 0, 0), with these largest
/// differences.
static tf_query_masks right_of_point(double x, double y, double z)
{
    const double at[2][4][3] = {{{0, 0, 0}, {x, 0, 0}, {x, -y, 0}, {x, 0, z}},
                                {{0, 0, 0}, {x, y, 0}, {x, 0, -z}, {x, 0, 0}}};
    return judged(at, TF_SHARE_SURE);
}

START_TEST(differences_add_up_to_the_limit_at_most)
{
    const double half = 0x1p299, quarter = 0x1p298;
    const double more = 0x1.0000000000002p299; // an ulp of the sum
    ck_assert_uint_eq(right_of_point(half, quarter, quarter).separated & 255,
                      255);
    ck_assert_uint_eq(right_of_point(more, quarter, quarter).undecided & 255,
                      255);
    ck_assert_uint_eq(right_of_point(quarter, more, quarter).undecided & 255,
                      255);
    ck_assert_uint_eq(right_of_point(quarter, quarter, more).undecided & 255,
                      255);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("fast/lanes");
    TCase *c = tcase_create("lanes");
    tcase_add_loop_test(c, each_lane_is_judged_by_itself, 0, 2 * FAMILIES);
    tcase_add_test(c, a_determinant_within_its_share_is_uncertain);
    tcase_add_test(c, differences_add_up_to_the_limit_at_most);
    suite_add_tcase(suite, c);
    return suite;
}

// Clearances, against exact queries of elements that have moved on.
#include "fast/clearance.h"

#include "arithmetic/exact.h"
#include "fast/vectorized.h"
#include "support/query_batch.h"
#include "support/support.h"

#include <string.h>

enum {
    BATCH = 200
};

static query_kind kind_of(int i)
{
    return i % 2 ? EDGE_EDGE : POINT_TRIANGLE;
}

static void measure(const batch *b, double clearance[])
{
    size_t separated = 0;
    ck_assert_int_eq(tf_vectorized.measure(NULL, &tf_exact, &b->queries,
                                           b->verdict[0], &separated,
                                           clearance),
                     TF_OK);
}

/// Decides the queries by exact signs, with the ends as they are now.
static void decide(const batch *b)
{
    size_t separated = 0;
    ck_assert_int_eq(tf_reference.decide(NULL, &tf_exact, &b->queries,
                                         b->verdict[1], &separated),
                     TF_OK);
}

// What is within the clearance stays apart ------------------------------------

/// Moves the ends of an element by a vector whose sum of coordinates is at most
/// `far`: along an axis, as that is what the bound is about, or anywhere.
static void move(generator *random, double far, int count, const int vertex[],
                 double *end)
{
    int axis = below(random, 4), toward = below(random, 2) ? 1 : -1;
    bool together = below(random, 2);
    for (int i = 0; i < count; i++) {
        if (!together)
            toward = -toward;
        for (int k = 0; k < 3; k++)
            end[3 * vertex[i] + k] += axis == 3
                                          ? uniform(random, -far / 3, far / 3)
                                      : axis == k ? toward * far
                                                  : 0;
    }
}

/// The largest sum of coordinates by which a vertex has moved.
static double movement(int count, const int vertex[], const double from[],
                       const double to[])
{
    double most = 0;
    for (int i = 0; i < count; i++) {
        double sum = 0;
        for (int k = 0; k < 3; k++)
            sum += fabs(to[3 * vertex[i] + k] - from[3 * vertex[i] + k]);
        most = fmax(most, sum);
    }
    return most;
}

/// Moves the ends of each query that is apart as far as its clearance allows;
/// puts those back that rounding has moved farther.  Returns how many have
/// moved.
static int move_all(generator *random, batch *b, const double before[],
                    const double clearance[])
{
    int first = b->queries.kind == TF_EDGE_EDGE ? 2 : 1, moved = 0;
    for (size_t i = 0; i < b->queries.count; i++) {
        if (b->verdict[0][i] != TF_APART || !(clearance[i] > 0))
            continue;
        const int *vertex = b->vertex + 4 * i;
        double own = below(random, 3) * clearance[i] / 2;
        double part = 1 - 0x1p-30;
        move(random, part * own, first, vertex, b->end);
        move(random, part * (clearance[i] - own), 4 - first, vertex + first,
             b->end);
        double sum = movement(first, vertex, before, b->end) +
                     movement(4 - first, vertex + first, before, b->end);
        moved += sum < clearance[i];
        for (int v = 0; v < 4 && !(sum < clearance[i]); v++)
            memcpy(b->end + (ptrdiff_t)3 * vertex[v],
                   before + (ptrdiff_t)3 * vertex[v], 3 * sizeof *before);
    }
    return moved;
}

START_TEST(within_the_clearance_elements_stay_apart)
{
    const family *source = &families[_i / 2];
    generator random = generator_new((uint64_t)_i);
    batch b = batch_new(BATCH);
    static double before[12 * BATCH], clearance[BATCH];
    int apart = 0, moved = 0;
    for (long i = cases(10000); i > 0; i -= BATCH) {
        batch_fill(&b, &random, source, kind_of(_i), BATCH);
        b.queries.motion = &b.motion;
        memcpy(before, b.end, sizeof before);
        measure(&b, clearance);
        moved += move_all(&random, &b, before, clearance);
        decide(&b);
        for (size_t j = 0; j < BATCH; j++) {
            apart += b.verdict[0][j] == TF_APART;
            query q = batch_query(&b, j);
            ck_assert_msg(clearance[j] >= 0, "%s", query_text(&q));
            ck_assert_msg(b.verdict[0][j] != TF_APART || clearance[j] == 0 ||
                              b.verdict[1][j] == TF_APART,
                          "%s, clearance %a, seed %llu, moved to\n%s",
                          source->name, clearance[j],
                          (unsigned long long)seed(), query_text(&q));
        }
    }
    if (_i / 2 < RANDOM_FAMILIES)
        ck_assert_int_gt(3 * moved, apart);
    batch_free(&b);
}
END_TEST

// What the clearance is -------------------------------------------------------

/// Of a query with each element's vertices one after another.
static double clearance_of(tf_kind kind, const double start[12],
                           const double end[12])
{
    tf_motion motion = {3, 4, start, end};
    const int vertex[] = {0, 1, 2, 3};
    tf_queries queries = {kind, &motion, 1, vertex};
    tf_verdict verdict;
    size_t separated = 0;
    double clearance;
    ck_assert_int_eq(tf_vectorized.measure(NULL, &tf_exact, &queries, &verdict,
                                           &separated, &clearance),
                     TF_OK);
    return clearance;
}

static void expect_clearance(double found, double expected)
{
    ck_assert_double_eq_tol(found, expected, 1e-9 * expected);
    ck_assert_double_le(found, expected);
}

START_TEST(clearance_above_a_slanted_triangle_is_along_its_normal)
{
    // The plane z = x / 2, and a point 0.3 above it: straight up.
    double start[] = {0, 0, 5, -2, -2, -1, 2, -2, 1, 0, 2, 0};
    double end[] = {0, 0, 0.3, -2, -2, -1, 2, -2, 1, 0, 2, 0};
    expect_clearance(clearance_of(TF_POINT_TRIANGLE, start, end), 0.3);
    start[2] = -5; // from the other side
    ck_assert_double_eq(clearance_of(TF_POINT_TRIANGLE, start, end), 0);
    end[2] = -0.3;
    expect_clearance(clearance_of(TF_POINT_TRIANGLE, start, end), 0.3);
}
END_TEST

START_TEST(clearance_beside_in_a_plane_is_toward_the_center)
{
    // Two edges in the plane z = 0, one diagonal step from each other.
    const double at[] = {0, 0, 0, 1, -1, 0, 2, 2, 0, 3, 1, 0};
    expect_clearance(clearance_of(TF_EDGE_EDGE, at, at), 4);
}
END_TEST

START_TEST(clearance_along_an_axis_is_the_gap)
{
    double at[] = {0, 0, 0, 0, 1, 0, 0.25, 0, 0, 0.25, 0, 1};
    expect_clearance(clearance_of(TF_EDGE_EDGE, at, at), 0.25);
}
END_TEST

START_TEST(nothing_is_known_where_rounding_may_hide_it)
{
    double start[] = {0, 0, 1, -2, -2, 0, 2, -2, 0, 0, 2, 0};
    double end[] = {0, 0, 1, -2, -2, 0, 2, -2, 0, 0, 2, 0};
    expect_clearance(clearance_of(TF_POINT_TRIANGLE, start, end), 1);
    for (int i = 0; i < 2; i++) {
        double *x = i ? end : start;
        x[2] = 0x1p-45;
        ck_assert_double_eq(clearance_of(TF_POINT_TRIANGLE, start, end), 0);
        x[2] = 1;
    }
    for (int i = 0; i < 12; i++)
        start[i] = ldexp(start[i], 299);
    ck_assert_double_eq(clearance_of(TF_POINT_TRIANGLE, start, end), 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("fast/clearance");
    TCase *c = tcase_create("clearances");
    tcase_add_loop_test(c, within_the_clearance_elements_stay_apart, 0,
                        2 * FAMILIES);
    tcase_add_test(c, clearance_above_a_slanted_triangle_is_along_its_normal);
    tcase_add_test(c, clearance_beside_in_a_plane_is_toward_the_center);
    tcase_add_test(c, clearance_along_an_axis_is_the_gap);
    tcase_add_test(c, nothing_is_known_where_rounding_may_hide_it);
    suite_add_tcase(suite, c);
    return suite;
}

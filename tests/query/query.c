#include "query/query.h"

#include "arithmetic/clamped.h"
#include "arithmetic/functions.h"
#include "base/contract.h"
#include "base/environment.h"
#include "support/environments.h"
#include "support/rational.h"
#include "support/scenes.h"
#include "support/statuses.h"
#include "support/support.h"

#include <limits.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

// Queries in the plane: a point, then an edge; two ends each.

typedef struct plane_query {
    double point[2][2], edge[2][2][2]; // [vertex][t][axis]
} plane_query;

static tf_status ask_in_plane(const tf_arithmetic *arithmetic,
                              const plane_query *q, tf_contact *contact)
{
    tf_worldline point = tf_worldline_between(2, q->point[0], q->point[1]);
    tf_worldline edge[2];
    for (int v = 0; v < 2; v++)
        edge[v] = tf_worldline_between(2, q->edge[v][0], q->edge[v][1]);
    return tf_query(arithmetic, 2, 1, &point, 2, edge, contact);
}

typedef struct expectation {
    const char *what;
    plane_query query;
    double toi, barycentric[2], normal[2], normal_velocity; // toi < 0: apart
    tf_classification classification;
} expectation;

static const expectation expected[] = {
    {"a point falls on an edge",
     {{{0.5, 1}, {0.5, -1}}, {{{0, 0}, {0, 0}}, {{2, 0}, {2, 0}}}},
     0.5,
     {0.75, 0.25},
     {0, 1},
     -2,
     TF_GENERIC},
    {"an edge rises to a point",
     {{{1, 1}, {1, 1}}, {{{0, 0}, {0, 4}}, {{2, 0}, {2, 4}}}},
     0.25,
     {0.5, 0.5},
     {0, 1},
     -4,
     TF_GENERIC},
    {"an edge rises to a point at its crease",
     {{{0.5, 1}, {0.5, 1}}, {{{0, 0}, {0, 4}}, {{2, 0}, {2, 4}}}},
     0.25,
     {0.75, 0.25},
     {0, 1},
     -4,
     TF_TOUCHING},
    {"a point runs into a slanted edge",
     {{{-4, 3}, {4, -3}}, {{{-3, -4}, {-3, -4}}, {{3, 4}, {3, 4}}}},
     0.5,
     {0.5, 0.5},
     {-0.8, 0.6},
     -10,
     TF_TOUCHING},
    {"a point falls on the end of an edge",
     {{{2, 1}, {2, -3}}, {{{0, 0}, {0, 0}}, {{2, 0}, {2, 0}}}},
     0.25,
     {0, 1},
     {0, 1},
     -4,
     TF_TOUCHING},
    {"a point falls beside an edge",
     {{{3, 1}, {3, -1}}, {{{0, 0}, {0, 0}}, {{2, 0}, {2, 0}}}},
     -1,
     {0, 0},
     {0, 0},
     0,
     TF_UNCLASSIFIED},
    {"a point slides along the line of an edge",
     {{{-1, 0}, {1, 0}}, {{{0, 0}, {0, 0}}, {{2, 0}, {2, 0}}}},
     0.5,
     {1, 0},
     {0, 1},
     0,
     TF_DEGENERATE},
    {"a point moves parallel to an edge",
     {{{0, 1}, {1, 1}}, {{{0, 0}, {0, 0}}, {{2, 0}, {2, 0}}}},
     -1,
     {0, 0},
     {0, 0},
     0,
     TF_UNCLASSIFIED},
    {"a point and an edge move as one",
     {{{1, 0}, {1, 5}}, {{{0, 0}, {0, 5}}, {{2, 0}, {2, 5}}}},
     0,
     {0.5, 0.5},
     {0, 1},
     0,
     TF_DEGENERATE},
    {"a point rests on the end of an edge at rest",
     {{{0, 0}, {0, 0}}, {{{0, 0}, {0, 0}}, {{2, 0}, {2, 0}}}},
     0,
     {1, 0},
     {0, 1},
     0,
     TF_DEGENERATE},
    {"a point runs through an edge of no length",
     {{{0, 0}, {4, 4}}, {{{1, 1}, {1, 1}}, {{1, 1}, {1, 1}}}},
     0.25,
     {NAN, NAN},
     {0, 0},
     0,
     TF_DEGENERATE},
    {"a point passes an edge of no length",
     {{{0, 0}, {4, 4}}, {{{1, 2}, {1, 2}}, {{1, 2}, {1, 2}}}},
     -1,
     {0, 0},
     {0, 0},
     0,
     TF_UNCLASSIFIED},
    {"everything is one point",
     {{{1, 1}, {1, 1}}, {{{1, 1}, {1, 1}}, {{1, 1}, {1, 1}}}},
     0,
     {NAN, NAN},
     {0, 0},
     0,
     TF_DEGENERATE},
    {"a point arrives at the last moment",
     {{{1, 1}, {1, 0}}, {{{0, 0}, {0, 0}}, {{2, 0}, {2, 0}}}},
     1,
     {0.5, 0.5},
     {0, 1},
     -1,
     TF_TOUCHING},
    {"an edge collapses onto a point in its line",
     {{{3, 0}, {3, 0}}, {{{0, 0}, {3, 0}}, {{2, 0}, {3, 0}}}},
     1,
     {NAN, NAN},
     {NAN, NAN},
     NAN,
     TF_DEGENERATE},
};

enum {
    EXPECTED = sizeof expected / sizeof *expected
};

static void expect_near(const char *what, const char *name, double got,
                        double wanted)
{
    ck_assert_msg(fabs(got - wanted) < 1e-12, "%s: %s is %a, expected %a", what,
                  name, got, wanted);
}

START_TEST(contacts_in_the_plane_have_the_expected_members)
{
    const expectation *e = &expected[_i];
    tf_contact c;
    ck_assert_int_eq(ask_in_plane(&oracle_arithmetic, &e->query, &c), TF_OK);
    ck_assert_msg((c.verdict == TF_HIT) == (e->toi >= 0), "%s: verdict %d",
                  e->what, c.verdict);
    ck_assert_msg(c.classification == e->classification,
                  "%s: classification %d", e->what, c.classification);
    if (e->toi < 0)
        return;
    ck_assert_msg(c.toi_lo <= e->toi && e->toi <= c.toi_hi,
                  "%s: time in [%a, %a]", e->what, c.toi_lo, c.toi_hi);
    expect_near(e->what, "the point's coordinate", c.barycentric[0][0], 1);
    expect_near(e->what, "the sum", c.barycentric[1][0] + c.barycentric[1][1],
                1);
    for (int k = 0; k < 2; k++) {
        // NaN stands for any.
        if (!isnan(e->barycentric[k]))
            expect_near(e->what, "barycentric", c.barycentric[1][k],
                        e->barycentric[k]);
        if (!isnan(e->normal[k]))
            expect_near(e->what, "normal", c.normal[k], e->normal[k]);
    }
    if (!isnan(e->normal_velocity))
        expect_near(e->what, "normal_velocity", c.normal_velocity,
                    e->normal_velocity);
}
END_TEST

// In space the normal tells which simplex of the sweep is in contact.

static tf_contact ask_in_space(const double point[2][3],
                               const double triangle[3][2][3])
{
    tf_worldline line = tf_worldline_between(3, point[0], point[1]), face[3];
    for (int v = 0; v < 3; v++)
        face[v] = tf_worldline_between(3, triangle[v][0], triangle[v][1]);
    tf_contact c;
    ck_assert_int_eq(tf_query(&oracle_arithmetic, 3, 1, &line, 3, face, &c),
                     TF_OK);
    return c;
}

START_TEST(the_normal_belongs_to_the_simplex_in_contact)
{
    // The triangle turns from the plane of x and y into that of x and z.
    static const double triangle[3][2][3] = {
        {{0, 0, 0}, {0, 0, 0}}, {{9, 0, 0}, {9, 0, 0}}, {{0, 9, 0}, {0, 0, 9}}};
    static const double early[2][3] = {{1, 1, 1}, {1, 1, -9}};
    tf_contact c = ask_in_space(early, triangle);
    ck_assert_int_eq(c.verdict, TF_HIT);
    expect_near("early", "normal x", c.normal[0], 0);
    ck_assert_double_ge(c.normal[2], 0.9);
    expect_near("early", "length", hypot(c.normal[1], c.normal[2]), 1);
    double expected_velocity = c.velocity[0] * c.normal[0] +
                               c.velocity[1] * c.normal[1] +
                               c.velocity[2] * c.normal[2];
    expect_near("early", "normal_velocity", c.normal_velocity,
                expected_velocity);
}
END_TEST

START_TEST(a_contact_in_space_has_the_expected_members)
{
    static const double triangle[3][2][3] = {
        {{0, 0, 0}, {0, 0, 0}}, {{4, 0, 0}, {4, 0, 0}}, {{0, 4, 0}, {0, 4, 0}}};
    static const double point[2][3] = {{1, 2, 1}, {1, 2, -3}};
    tf_contact c = ask_in_space(point, triangle);
    ck_assert_int_eq(c.verdict, TF_HIT);
    ck_assert(c.toi_lo <= 0.25 && 0.25 <= c.toi_hi);
    static const double barycentric[] = {0.25, 0.25, 0.5}, normal[] = {0, 0, 1};
    for (int k = 0; k < 3; k++) {
        expect_near("fall", "barycentric", c.barycentric[1][k], barycentric[k]);
        expect_near("fall", "normal", c.normal[k], normal[k]);
        expect_near("fall", "velocity", c.velocity[k], k == 2 ? -4 : 0);
    }
    expect_near("fall", "normal_velocity", c.normal_velocity, -4);
}
END_TEST

// The relative velocity is that of one vertex relative to another, and these
// are named by their places in the elements as given.
START_TEST(the_velocity_is_that_of_the_pivots)
{
    generator random = generator_new(700 + (uint64_t)_i);
    int met = 0, places[2][3] = {{0}};
    for (long n = cases(20000); n > 0; n--) {
        query q = query_soup(&random, (query_kind)_i);
        int all = q.vertices + q.others, index[] = {0, 1, 2, 3};
        for (int i = 0; i < all; i++) {
            int j = below(&random, i + 1), swap = index[j];
            index[j] = index[i];
            index[i] = swap;
        }
        for (int i = 0; i < all; i++)
            tf_worldline_set_vertex(&q.vertex[i], index[i]);
        tf_contact c;
        ck_assert_int_eq(tf_query(&oracle_arithmetic, q.axes, q.vertices,
                                  q.vertex, q.others, query_others(&q), &c),
                         TF_OK);
        if (c.verdict != TF_HIT)
            continue;
        met++;
        places[0][c.pivot[0]]++;
        places[1][c.pivot[1]]++;
        const tf_event *a = q.vertex[c.pivot[0]].at;
        const tf_event *b = query_others(&q)[c.pivot[1]].at;
        for (int k = 0; k < q.axes; k++)
            ck_assert_msg((a[1].x[k] - a[0].x[k]) - (b[1].x[k] - b[0].x[k]) ==
                              c.velocity[k],
                          "%s", query_text(&q));
    }
    for (int i = 0; i < 3; i++) {
        ck_assert((places[0][i] > 0) == (i < (_i == EDGE_EDGE ? 2 : 1)));
        ck_assert((places[1][i] > 0) == (i < (_i == POINT_TRIANGLE ? 3 : 2)));
    }
    ck_assert_int_gt(met, 0);
}
END_TEST

// The ends of the range

START_TEST(infinite_coordinates_are_refused)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 12; i++) {
        plane_query q = expected[0].query;
        double *x = i < 4 ? &q.point[i / 2][i % 2]
                          : &q.edge[(i - 4) / 4][(i - 4) / 2 % 2][i % 2];
        *x = bad[_i];
        tf_contact contact = {.normal_velocity = 42};
        ck_assert_int_eq(ask_in_plane(&oracle_arithmetic, &q, &contact),
                         TF_NOT_FINITE);
        ck_assert_double_eq(contact.normal_velocity, 42);
    }
}
END_TEST

START_TEST(coordinates_beyond_the_arithmetic_are_refused)
{
    tf_arithmetic narrow = oracle_arithmetic;
    narrow.bits[2] = 4;
    plane_query q = expected[4].query;
    tf_contact contact;
    ck_assert_int_eq(ask_in_plane(&narrow, &q, &contact), TF_OK);
    q.edge[1][1][0] = 15;
    ck_assert_int_eq(ask_in_plane(&narrow, &q, &contact), TF_OK);
    q.edge[1][1][0] = 16;
    ck_assert_int_eq(ask_in_plane(&narrow, &q, &contact), TF_OUT_OF_RANGE);
    q.edge[1][1][0] = 0.5;
    ck_assert_int_eq(ask_in_plane(&narrow, &q, &contact), TF_OUT_OF_RANGE);
}
END_TEST

START_TEST(a_normal_velocity_saturates)
{
    plane_query q = {
        {{0, 1.7e308}, {0, -1.7e308}},
        {{{-1, -1.7e308}, {-1, 1.7e308}}, {{1, -1.7e308}, {1, 1.7e308}}}};
    tf_contact c;
    ck_assert_int_eq(ask_in_plane(&oracle_arithmetic, &q, &c), TF_OK);
    ck_assert_int_eq(c.verdict, TF_HIT);
    ck_assert_double_eq(c.velocity[1], -DBL_MAX);
    ck_assert_double_eq(c.normal_velocity, -DBL_MAX);
}
END_TEST

START_TEST(products_that_overflow_leave_no_normal)
{
    plane_query q = {
        {{0, 1}, {0, -1}},
        {{{-1.7e308, 0}, {-1.7e308, 0}}, {{1.7e308, 0}, {1.7e308, 0}}}};
    tf_contact c;
    ck_assert_int_eq(ask_in_plane(&tf_clamped, &q, &c), TF_OK);
    ck_assert_int_ne(c.verdict, TF_APART);
    for (int k = 0; k < 2; k++)
        ck_assert_double_eq(c.normal[k], 0);
    ck_assert_double_eq(c.normal_velocity, 0);
    ck_assert_int_eq(ask_in_plane(&oracle_arithmetic, &q, &c), TF_OK);
    ck_assert_double_eq(c.normal[1], 1);
}
END_TEST

START_TEST(the_smallest_numbers_have_a_normal_velocity)
{
    double tiny = DBL_TRUE_MIN;
    plane_query q = {{{0, 3 * tiny}, {0, -tiny}},
                     {{{-tiny, 0}, {-tiny, 0}}, {{tiny, 0}, {tiny, 0}}}};
    tf_contact c;
    ck_assert_int_eq(ask_in_plane(&oracle_arithmetic, &q, &c), TF_OK);
    ck_assert_int_eq(c.verdict, TF_HIT);
    ck_assert(c.toi_lo <= 0.75 && 0.75 <= c.toi_hi);
    ck_assert_double_eq(c.normal_velocity, -4 * tiny);
}
END_TEST

// Broken contracts

START_TEST(three_vertices_in_the_plane_break_the_contract)
{
    tf_worldline vertex[4] = {{.at = {{.t = 0}, {.t = 1}}}};
    tf_contact contact;
    tf_query(&oracle_arithmetic, 2, 1, vertex, 3, vertex + 1, &contact);
}
END_TEST

/// Ends a test with 0 if it is the query that refuses.
static void exit_if_in_query(const char *file, int line, const char *condition)
{
    (void)line, (void)condition;
    exit(strstr(file, "query.c") ? 0 : 1);
}

START_TEST(impossible_shapes_break_the_contract)
{
    static const struct {
        int axes, vertices, others;
    } bad[] = {{1, 1, 1}, {2, 0, 3}, {2, 3, 0}, {3, 1, 2}, {3, 2, 3}};
    tf_worldline vertex[6] = {{.at = {{.t = 0}, {.t = 1}}}};
    for (int i = 0; i < 6; i++)
        tf_worldline_set_vertex(&vertex[i], i);
    tf_contact contact;
    tf_contract_set_handler(exit_if_in_query);
    tf_query(&oracle_arithmetic, bad[_i].axes, bad[_i].vertices, vertex,
             bad[_i].others, vertex + 3, &contact);
    exit(2);
}
END_TEST

// Statuses

static tf_status ask_scene(const tf_arithmetic *arithmetic,
                           const tf_motion *motion, const int vertex[],
                           tf_contact *contact)
{
    return tf_query_motion(arithmetic, 3, motion, 2, vertex, 2, vertex + 2,
                           contact);
}

static void use_scene(void)
{
    statuses_use(EDGE_EDGE, ask_scene);
}

static tf_status ask_verdict(const tf_arithmetic *arithmetic,
                             const tf_motion *motion, const int vertex[],
                             tf_contact *contact)
{
    // Which its callers check.
    if (!tf_environment_is_ieee())
        return TF_BAD_ENVIRONMENT;
    return tf_query_verdict(arithmetic, 2, motion, 1, vertex, 2, vertex + 1,
                            contact ? &contact->verdict : NULL, &(bool){false});
}

static void use_verdict(void)
{
    statuses_use(POINT_EDGE, ask_verdict);
}

START_TEST(a_broken_environment_is_reported_for_worldlines)
{
    tf_contact contact = {.normal_velocity = 42};
    environment_break(_i);
    tf_status status =
        ask_in_plane(&oracle_arithmetic, &expected[0].query, &contact);
    environment_restore();
    ck_assert_int_eq(status, TF_BAD_ENVIRONMENT);
    ck_assert_double_eq(contact.normal_velocity, 42);
}
END_TEST

static tf_status ask_with_indices(const tf_arithmetic *arithmetic,
                                  query_kind kind, const int index[])
{
    query q = scene_hit(kind);
    for (int i = 0; i < q.vertices + q.others; i++)
        tf_worldline_set_vertex(&q.vertex[i], index[i]);
    tf_contact contact;
    return tf_query(arithmetic, q.axes, q.vertices, q.vertex, q.others,
                    query_const_others(&q), &contact);
}

/// Expect TF_OK if some vertices, a bit each, have an index, only for all or
/// none of them.
static void expect_all_or_none(query_kind kind, int vertices, unsigned some)
{
    int index[QUERY_VERTICES];
    for (int i = 0; i < vertices; i++)
        index[i] = some >> i & 1 ? 10 - i : TF_NO_INDEX;
    bool all = some == (1U << vertices) - 1;
    tf_status status = ask_with_indices(&oracle_arithmetic, kind, index);
    ck_assert_msg(status == (all || some == 0 ? TF_OK : TF_BAD_INDEX),
                  "kind %d, indices %#x: \"%s\"", (int)kind, some,
                  tf_status_message(status));
    tf_arithmetic perturbed = oracle_arithmetic;
    perturbed.needs_indices = true;
    status = ask_with_indices(&perturbed, kind, index);
    ck_assert_msg(status == (all ? TF_OK : TF_BAD_INDEX),
                  "kind %d, needed indices %#x: \"%s\"", (int)kind, some,
                  tf_status_message(status));
}

START_TEST(either_all_vertices_have_an_index_or_none)
{
    for (int kind = 0; kind < KINDS; kind++) {
        int vertices = kind == POINT_EDGE ? 3 : 4;
        for (unsigned some = 0; some < 1U << vertices; some++)
            expect_all_or_none((query_kind)kind, vertices, some);
    }
}
END_TEST

START_TEST(worldlines_must_have_distinct_indices)
{
    for (int i = 0; i < QUERY_VERTICES; i++) {
        int index[QUERY_VERTICES] = {0, INT_MAX, 5, 3};
        ck_assert_int_eq(ask_with_indices(&oracle_arithmetic, EDGE_EDGE, index),
                         TF_OK);
        index[i] = index[(i + 1 + _i) % QUERY_VERTICES];
        ck_assert_int_eq(ask_with_indices(&oracle_arithmetic, EDGE_EDGE, index),
                         TF_BAD_INDEX);
    }
}
END_TEST

START_TEST(indices_below_no_index_are_bad)
{
    static const int index[][QUERY_VERTICES] = {
        {-2, -2, -2, -2}, {-2, -1, -1, -1}, {-1, -1, -1, -2}};
    for (int i = 0; i < 3; i++)
        ck_assert_int_eq(
            ask_with_indices(&oracle_arithmetic, EDGE_EDGE, index[i]),
            TF_BAD_INDEX);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("query/query");
    TCase *tcase = tcase_create("query");
    tcase_add_loop_test(tcase, contacts_in_the_plane_have_the_expected_members,
                        0, EXPECTED);
    tcase_add_test(tcase, the_normal_belongs_to_the_simplex_in_contact);
    tcase_add_test(tcase, a_contact_in_space_has_the_expected_members);
    tcase_add_loop_test(tcase, the_velocity_is_that_of_the_pivots, 0, KINDS);
    tcase_add_loop_test(tcase, infinite_coordinates_are_refused, 0, 3);
    tcase_add_test(tcase, coordinates_beyond_the_arithmetic_are_refused);
    tcase_add_test(tcase, a_normal_velocity_saturates);
    tcase_add_test(tcase, products_that_overflow_leave_no_normal);
    tcase_add_test(tcase, the_smallest_numbers_have_a_normal_velocity);
    tcase_add_test_raise_signal(
        tcase, three_vertices_in_the_plane_break_the_contract, SIGABRT);
    tcase_add_loop_exit_test(tcase, impossible_shapes_break_the_contract, 0, 0,
                             5);
    tcase_add_loop_test(tcase, a_broken_environment_is_reported_for_worldlines,
                        0, environments());
    tcase_add_test(tcase, either_all_vertices_have_an_index_or_none);
    tcase_add_loop_test(tcase, worldlines_must_have_distinct_indices, 0, 3);
    tcase_add_test(tcase, indices_below_no_index_are_bad);
    suite_add_tcase(suite, tcase);
    suite_add_tcase(suite, statuses_case("statuses of a scene", use_scene));
    suite_add_tcase(suite,
                    statuses_case("statuses of the verdict", use_verdict));
    return suite;
}

#include "query/contact.h"

#include "arithmetic/clamped.h"
#include "support/rational.h"
#include "support/support.h"

#include <fenv.h>
#include <math.h>
#include <signal.h>

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
    double toi, weight[2], normal[2], speed; // toi < 0: apart
    tf_decision decision;
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
     TF_GENERIC},
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
     TF_GENERIC},
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
     {-1, -1},
     {0, 0},
     0,
     TF_DEGENERATE},
    {"a point passes an edge of no length",
     {{{0, 0}, {4, 4}}, {{{1, 2}, {1, 2}}, {{1, 2}, {1, 2}}}},
     -1,
     {0, 0},
     {0, 0},
     0,
     TF_GENERIC},
    {"everything is one point",
     {{{1, 1}, {1, 1}}, {{{1, 1}, {1, 1}}, {{1, 1}, {1, 1}}}},
     0,
     {-1, -1},
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
     {-1, -1},
     {-2, -2},
     -2,
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

START_TEST(contacts_in_the_plane)
{
    const expectation *e = &expected[_i];
    tf_contact c;
    ck_assert_int_eq(ask_in_plane(&oracle_arithmetic, &e->query, &c), TF_OK);
    ck_assert_msg((c.verdict == TF_HIT) == (e->toi >= 0), "%s: verdict %d",
                  e->what, c.verdict);
    if (e->toi < 0)
        return;
    ck_assert_msg(c.decision == e->decision, "%s: decision %d", e->what,
                  c.decision);
    ck_assert_msg(c.toi_lo <= e->toi && e->toi <= c.toi_hi,
                  "%s: time in [%a, %a]", e->what, c.toi_lo, c.toi_hi);
    expect_near(e->what, "the point's weight", c.weight[0][0], 1);
    expect_near(e->what, "the sum", c.weight[1][0] + c.weight[1][1], 1);
    for (int k = 0; k < 2; k++) {
        // -1 and -2 stand for any.
        if (e->weight[k] >= 0)
            expect_near(e->what, "weight", c.weight[1][k], e->weight[k]);
        if (e->normal[k] > -2)
            expect_near(e->what, "normal", c.normal[k], e->normal[k]);
    }
    if (e->speed != -2 || e->normal[0] > -2)
        expect_near(e->what, "speed", c.speed, e->speed);
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

START_TEST(normal_is_that_of_the_simplex_in_contact)
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
    double speed = c.velocity[0] * c.normal[0] + c.velocity[1] * c.normal[1] +
                   c.velocity[2] * c.normal[2];
    expect_near("early", "speed", c.speed, speed);
}
END_TEST

START_TEST(falling_point_on_a_triangle_at_rest)
{
    static const double triangle[3][2][3] = {
        {{0, 0, 0}, {0, 0, 0}}, {{4, 0, 0}, {4, 0, 0}}, {{0, 4, 0}, {0, 4, 0}}};
    static const double point[2][3] = {{1, 2, 1}, {1, 2, -3}};
    tf_contact c = ask_in_space(point, triangle);
    ck_assert_int_eq(c.verdict, TF_HIT);
    ck_assert(c.toi_lo <= 0.25 && 0.25 <= c.toi_hi);
    static const double weight[] = {0.25, 0.25, 0.5}, normal[] = {0, 0, 1};
    for (int k = 0; k < 3; k++) {
        expect_near("fall", "weight", c.weight[1][k], weight[k]);
        expect_near("fall", "normal", c.normal[k], normal[k]);
        expect_near("fall", "velocity", c.velocity[k], k == 2 ? -4 : 0);
    }
    expect_near("fall", "speed", c.speed, -4);
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
        tf_contact contact = {.speed = 42};
        ck_assert_int_eq(ask_in_plane(&oracle_arithmetic, &q, &contact),
                         TF_NOT_FINITE);
        ck_assert_double_eq(contact.speed, 42);
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

START_TEST(speed_saturates)
{
    plane_query q = {
        {{0, 1.7e308}, {0, -1.7e308}},
        {{{-1, -1.7e308}, {-1, 1.7e308}}, {{1, -1.7e308}, {1, 1.7e308}}}};
    tf_contact c;
    ck_assert_int_eq(ask_in_plane(&oracle_arithmetic, &q, &c), TF_OK);
    ck_assert_int_eq(c.verdict, TF_HIT);
    ck_assert_double_eq(c.velocity[1], -DBL_MAX);
    ck_assert_double_eq(c.speed, -DBL_MAX);
}
END_TEST

START_TEST(overflow_leaves_no_normal)
{
    plane_query q = {
        {{0, 1}, {0, -1}},
        {{{-1.7e308, 0}, {-1.7e308, 0}}, {{1.7e308, 0}, {1.7e308, 0}}}};
    tf_contact c;
    ck_assert_int_eq(ask_in_plane(&tf_clamped, &q, &c), TF_OK);
    ck_assert_int_ne(c.verdict, TF_APART);
    for (int k = 0; k < 2; k++)
        ck_assert_double_eq(c.normal[k], 0);
    ck_assert_double_eq(c.speed, 0);
    ck_assert_int_eq(ask_in_plane(&oracle_arithmetic, &q, &c), TF_OK);
    ck_assert_double_eq(c.normal[1], 1);
}
END_TEST

START_TEST(smallest_numbers_have_a_speed)
{
    double tiny = DBL_TRUE_MIN;
    plane_query q = {{{0, 3 * tiny}, {0, -tiny}},
                     {{{-tiny, 0}, {-tiny, 0}}, {{tiny, 0}, {tiny, 0}}}};
    tf_contact c;
    ck_assert_int_eq(ask_in_plane(&oracle_arithmetic, &q, &c), TF_OK);
    ck_assert_int_eq(c.verdict, TF_HIT);
    ck_assert(c.toi_lo <= 0.75 && 0.75 <= c.toi_hi);
    ck_assert_double_eq(c.speed, -4 * tiny);
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

START_TEST(rounding_upward_breaks_the_contract)
{
    tf_contact contact;
    fesetround(FE_UPWARD);
    ask_in_plane(&oracle_arithmetic, &expected[0].query, &contact);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("query/contact");
    TCase *tcase = tcase_create("contact");
    tcase_add_loop_test(tcase, contacts_in_the_plane, 0, EXPECTED);
    tcase_add_test(tcase, normal_is_that_of_the_simplex_in_contact);
    tcase_add_test(tcase, falling_point_on_a_triangle_at_rest);
    tcase_add_loop_test(tcase, infinite_coordinates_are_refused, 0, 3);
    tcase_add_test(tcase, coordinates_beyond_the_arithmetic_are_refused);
    tcase_add_test(tcase, speed_saturates);
    tcase_add_test(tcase, overflow_leaves_no_normal);
    tcase_add_test(tcase, smallest_numbers_have_a_speed);
    tcase_add_test_raise_signal(
        tcase, three_vertices_in_the_plane_break_the_contract, SIGABRT);
    tcase_add_test_raise_signal(tcase, rounding_upward_breaks_the_contract,
                                SIGABRT);
    suite_add_tcase(suite, tcase);
    return suite;
}

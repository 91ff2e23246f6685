#include "linear/cubic.h"

#include "support/linear_methods.h"
#include "support/scenes.h"
#include "support/statuses.h"
#include "support/support.h"

#include <float.h>
#include <math.h>

static query_kind kind_of_case(int i)
{
    return i == 0 ? POINT_TRIANGLE : EDGE_EDGE;
}

// Closed forms ----------------------------------------------------------------

START_TEST(a_falling_point_meets_a_triangle)
{
    query q = scene_hit(POINT_TRIANGLE);
    tf_contact contact = cubic_answer(&q, 0);
    expect_contact(&q, &contact);
    ck_assert_int_eq(contact.verdict, TF_HIT);
    ck_assert_int_eq(contact.classification, TF_GENERIC);
    ck_assert_double_eq(contact.toi_lo, 0.5);
    ck_assert_double_eq(contact.normal[2], 1);
    ck_assert_double_eq(contact.normal_velocity, -2);
    ck_assert_double_eq_tol(contact.barycentric[1][0], 0.5, 1e-15);
}
END_TEST

START_TEST(a_falling_edge_meets_an_edge)
{
    query q = scene_hit(EDGE_EDGE);
    tf_contact contact = cubic_answer(&q, 0);
    expect_contact(&q, &contact);
    ck_assert_int_eq(contact.verdict, TF_HIT);
    ck_assert_double_eq(contact.toi_lo, 0.5);
    ck_assert_double_eq(contact.normal[2], 1);
    ck_assert_double_eq(contact.normal_velocity, -2);
    ck_assert_double_eq_tol(contact.barycentric[0][1], 1.0 / 3, 1e-15);
    ck_assert_double_eq_tol(contact.barycentric[1][1], 0.25, 1e-15);
}
END_TEST

// A point flies past a corner at a distance of 2^-10, and ends at a height of
// 2^-10: only tolerances make it touch.

static query fly(double x, double end)
{
    query q = scene_hit(POINT_TRIANGLE);
    for (int t = 0; t < 2; t++)
        q.vertex[0].at[t].x[0] = q.vertex[0].at[t].x[1] = x;
    q.vertex[0].at[1].x[2] = end;
    return q;
}

START_TEST(elements_within_the_distance_tolerance_touch)
{
    query beside = fly(-0x1p-10, -1), above = fly(1, 0x1p-10);
    ck_assert_int_eq(cubic_answer(&beside, 0x1p-10).verdict, TF_APART);
    ck_assert_int_eq(cubic_answer(&beside, 0x1p-9).verdict, TF_HIT);
    ck_assert_int_eq(cubic_answer(&above, 0x1p-11).verdict, TF_APART);
    tf_contact contact = cubic_answer(&above, 0x1p-10);
    ck_assert_int_eq(contact.classification, TF_TOUCHING);
    ck_assert_double_eq(contact.toi_lo, 1);
}
END_TEST

START_TEST(coordinates_within_the_barycentric_tolerance_touch)
{
    query q = fly(-0x1p-10, -1);
    scene s = scene_of(&q, (int[]){0, 1, 2, 3});
    tf_motion motion = scene_motion(&s);
    tf_contact contact;
    for (int i = 0; i < 2; i++) {
        tf_tolerances tolerances = {.barycentric = ldexp(1, -13 + 2 * i)};
        tf_cubic_point_triangle(&tolerances, &motion, 0, (int[]){1, 2, 3},
                                &contact);
        ck_assert_int_eq(contact.verdict, i ? TF_HIT : TF_APART);
    }
    expect_contact(&q, &contact);
}
END_TEST

START_TEST(contacts_at_the_ends_of_the_step_are_found)
{
    query q = fly(1, 0);
    tf_contact contact = cubic_answer(&q, 0);
    ck_assert_int_eq(contact.verdict, TF_HIT);
    ck_assert_double_eq(contact.toi_lo, 1);
    q.vertex[0].at[0].x[2] = 0;
    q.vertex[0].at[1].x[2] = 1;
    contact = cubic_answer(&q, 0);
    ck_assert_int_eq(contact.verdict, TF_HIT);
    ck_assert_double_eq(contact.toi_lo, 0);
    q.vertex[0].at[1].x[2] = 0; // at rest in the plane
    ck_assert_int_eq(cubic_answer(&q, 0).classification, TF_DEGENERATE);
}
END_TEST

START_TEST(an_end_in_the_plane_is_a_root)
{
    // Whatever rounding makes of the distance there.
    generator random = generator_new(50);
    for (int i = 0; i < 1000; i++) {
        query q = fly(uniform(&random, 0.1, 1.9), 0);
        ck_assert_msg(cubic_answer(&q, 0).verdict == TF_HIT, "%s",
                      query_text(&q));
    }
}
END_TEST

// Against the truth -----------------------------------------------------------

START_TEST(random_queries_are_decided_right)
{
    generator random = generator_new((uint64_t)_i);
    for (long i = 0; i < cases(10000); i++) {
        query q = query_soup(&random, kind_of_case(_i));
        expect_linear_truth(&q);
    }
}
END_TEST

START_TEST(large_lattices_are_decided_right)
{
    generator random = generator_new(10 + (uint64_t)_i);
    for (long i = 0; i < cases(10000); i++) {
        query q = query_lattice(&random, kind_of_case(_i), 1 << 20);
        expect_linear_truth(&q);
    }
}
END_TEST

START_TEST(no_tolerance_decides_all_queries_right)
{
    // The same small lattice, wrong both ways.
    generator random = generator_new(20 + (uint64_t)_i);
    long extra = 0, missed = 0;
    for (int i = 0; i < 3000; i++) {
        query q = query_any(&random, kind_of_case(_i));
        double toi;
        bool hit = linear_query_truth(&q, &toi);
        bool found = cubic_answer(&q, 1e-6).verdict == TF_HIT;
        extra += found && !hit;
        missed += hit && !found;
    }
    ck_assert_int_gt(extra, 0);
    ck_assert_int_gt(missed, 0);
}
END_TEST

// Invariants ------------------------------------------------------------------

static query any_query(generator *random, query_kind kind)
{
    switch (below(random, 3)) {
    case 0:
        return query_lattice(random, kind, 4);
    case 1:
        return query_extreme(random, kind);
    default:
        return query_any(random, kind);
    }
}

START_TEST(larger_tolerances_lose_no_contact)
{
    static const double tolerance[] = {0, 1e-14, 1e-9, 1e-6, 1e-4, 1e-2};
    generator random = generator_new(30 + (uint64_t)_i);
    for (long i = 0; i < cases(20000); i++) {
        query q = any_query(&random, kind_of_case(_i));
        tf_contact last = {.verdict = TF_APART};
        for (int n = 0; n < 6; n++) {
            tf_contact contact = cubic_answer(&q, tolerance[n]);
            expect_contact(&q, &contact);
            ck_assert_msg(last.verdict != TF_HIT ||
                              (contact.verdict == TF_HIT &&
                               contact.toi_lo <= last.toi_lo),
                          "lost at %g:\n%s", tolerance[n], query_text(&q));
            last = contact;
        }
    }
}
END_TEST

static void swap(tf_worldline *a, tf_worldline *b)
{
    tf_worldline kept = *a;
    *a = *b;
    *b = kept;
}

START_TEST(the_order_of_vertices_does_not_change_the_verdict)
{
    generator random = generator_new(40 + (uint64_t)_i);
    for (long i = 0; i < cases(10000); i++) {
        query q = query_soup(&random, kind_of_case(_i)), other = q;
        swap(&other.vertex[2], &other.vertex[3]);
        if (_i == 1 && below(&random, 2)) {
            swap(&other.vertex[0], &other.vertex[2]);
            swap(&other.vertex[1], &other.vertex[3]);
        }
        tf_contact a = cubic_answer(&q, 0), b = cubic_answer(&other, 0);
        ck_assert_msg(a.verdict == b.verdict &&
                          fabs(a.toi_lo - b.toi_lo) < 1e-7,
                      "%s", query_text(&q));
    }
}
END_TEST

// Statuses --------------------------------------------------------------------

static query_kind asked;

static tf_status ask_cubic(const tf_arithmetic *arithmetic,
                           const tf_motion *motion, const int vertex[],
                           tf_contact *contact)
{
    static const tf_tolerances none = {0};
    return cubic_query(asked, arithmetic ? &none : NULL, motion, vertex,
                       contact);
}

static void use_triangle(void)
{
    statuses_use(asked = POINT_TRIANGLE, ask_cubic);
}

static void use_edges(void)
{
    statuses_use(asked = EDGE_EDGE, ask_cubic);
}

START_TEST(bad_tolerances_are_refused)
{
    query q = scene_hit(kind_of_case(_i));
    static const int index[] = {0, 1, 2, 3};
    scene s = scene_of(&q, index);
    tf_motion motion = scene_motion(&s);
    tf_contact contact = {.normal_velocity = 42};
    static const double bad[] = {-1e-9, NAN, INFINITY};
    for (int i = 0; i < 3; i++) {
        tf_tolerances distance = {.distance = bad[i]};
        tf_tolerances barycentric = {.barycentric = bad[i]};
        ck_assert_int_eq(
            cubic_query(kind_of_case(_i), &distance, &motion, index, &contact),
            TF_BAD_OPTION);
        ck_assert_int_eq(cubic_query(kind_of_case(_i), &barycentric, &motion,
                                     index, &contact),
                         TF_BAD_OPTION);
    }
    ck_assert_double_eq(contact.normal_velocity, 42);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("linear/cubic");
    TCase *c = tcase_create("cubic");
    tcase_add_test(c, a_falling_point_meets_a_triangle);
    tcase_add_test(c, a_falling_edge_meets_an_edge);
    tcase_add_test(c, elements_within_the_distance_tolerance_touch);
    tcase_add_test(c, coordinates_within_the_barycentric_tolerance_touch);
    tcase_add_test(c, contacts_at_the_ends_of_the_step_are_found);
    tcase_add_test(c, an_end_in_the_plane_is_a_root);
    tcase_add_loop_test(c, random_queries_are_decided_right, 0, 2);
    tcase_add_loop_test(c, large_lattices_are_decided_right, 0, 2);
    tcase_add_loop_test(c, no_tolerance_decides_all_queries_right, 0, 2);
    tcase_add_loop_test(c, larger_tolerances_lose_no_contact, 0, 2);
    tcase_add_loop_test(c, the_order_of_vertices_does_not_change_the_verdict, 0,
                        2);
    tcase_add_loop_test(c, bad_tolerances_are_refused, 0, 2);
    suite_add_tcase(s, c);
    suite_add_tcase(s, statuses_case_of_doubles("triangle", use_triangle));
    suite_add_tcase(s, statuses_case_of_doubles("edges", use_edges));
    return s;
}

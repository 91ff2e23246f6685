#include "linear/linear_pair.h"

#include "support/linear_methods.h"
#include "support/scenes.h"
#include "support/statuses.h"
#include "support/support.h"

#include <math.h>

static tf_linear_pair take(const query *q)
{
    static const int index[] = {3, 0, 5, 1};
    scene s = scene_of(q, index);
    tf_motion motion = scene_motion(&s);
    tf_linear_pair taken;
    ck_assert_int_eq(tf_linear_pair_take(q->axes, &motion, q->vertices, index,
                                         q->others, index + q->vertices,
                                         &taken),
                     TF_OK);
    return taken;
}

START_TEST(vertices_are_taken_by_index)
{
    generator random = generator_new((uint64_t)_i);
    query q = query_soup(&random, (query_kind)_i);
    tf_linear_pair taken = take(&q);
    ck_assert_int_eq(taken.axes, q.axes);
    ck_assert_int_eq(taken.vertices, q.vertices);
    ck_assert_int_eq(taken.others, q.others);
    for (int i = 0; i < q.vertices + q.others; i++)
        for (int k = 0; k < TF_AXES; k++)
            for (int t = 0; t < 2; t++)
                ck_assert_double_eq(taken.at[t][i].x[k],
                                    k < q.axes ? q.vertex[i].at[t].x[k] : 0);
}
END_TEST

START_TEST(positions_lie_on_straight_paths)
{
    generator random = generator_new(5);
    query q = query_soup(&random, EDGE_EDGE);
    tf_linear_pair taken = take(&q);
    tf_vector x[TF_LINEAR_PAIR_VERTICES];
    for (int n = 0; n <= 4; n++) {
        double t = n / 4.0;
        tf_linear_pair_positions(&taken, t, x);
        for (int i = 0; i < 4; i++)
            for (int k = 0; k < TF_AXES; k++) {
                double a = taken.at[0][i].x[k], b = taken.at[1][i].x[k];
                double error = fabs(x[i].x[k] - (a + t * (b - a)));
                ck_assert_double_le(error, n % 4 == 0 ? 0 : 1e-15);
            }
    }
}
END_TEST

// An edge from (0, 0) to (4, 0) rises by 1 at its end; a point falls by 2.

START_TEST(a_contact_has_coordinates_normal_and_velocity)
{
    query q = query_new(POINT_EDGE);
    static const double x[] = {1, 1, 0, 0, 4, 0, 1, -1, 0, 0, 4, 1};
    for (int i = 0; i < query_size(&q); i++)
        *query_coordinate(&q, i) = x[i];
    tf_linear_pair taken = take(&q);
    tf_point_pair at = {.weight = {1, 0.75, 0.25}};
    tf_contact contact = tf_linear_pair_contact(&taken, 0, &at, TF_TOUCHING);
    expect_contact(&q, &contact);
    ck_assert_int_eq(contact.classification, TF_TOUCHING);
    ck_assert_double_eq(contact.barycentric[1][1], 0.25);
    ck_assert_double_eq(contact.normal[1], 1);
    ck_assert_double_eq(contact.velocity[1], -2.25);
    ck_assert_double_eq(contact.normal_velocity, -2.25);
}
END_TEST

START_TEST(a_contact_of_huge_elements_is_finite)
{
    query q = query_new(POINT_EDGE);
    for (int i = 0; i < query_size(&q); i++)
        *query_coordinate(&q, i) = i < 6 ? -1.7e308 : 1.7e308;
    tf_linear_pair taken = take(&q);
    tf_point_pair at = {.weight = {1, 0.5, 0.5}};
    tf_contact contact = tf_linear_pair_contact(&taken, 0.5, &at, TF_TOUCHING);
    expect_contact(&q, &contact);
}
END_TEST

START_TEST(tolerances_out_of_range_are_invalid)
{
    static const double bad[] = {-1, -1e-300, NAN, INFINITY, -INFINITY};
    ck_assert(tf_tolerances_valid(&(tf_tolerances){0}));
    ck_assert(tf_tolerances_valid(&(tf_tolerances){1e300, 1}));
    for (int i = 0; i < 5; i++) {
        ck_assert(!tf_tolerances_valid(&(tf_tolerances){bad[i], 0}));
        ck_assert(!tf_tolerances_valid(&(tf_tolerances){0, bad[i]}));
    }
}
END_TEST

// A polynomial that is nowhere near zero means that nothing is looked at.

START_TEST(touches_are_sought_at_roots_of_the_polynomial)
{
    query q = scene_hit(POINT_TRIANGLE);
    tf_linear_pair taken = take(&q);
    tf_polynomial far = {.degree = 3, .coefficient = {1, 1, 1, 1}};
    tf_polynomial zero = {.degree = 3};
    tf_polynomial half = {.degree = 3, .coefficient = {3, 1, -1, -3}};
    tf_tolerances none = {0};
    ck_assert_int_eq(tf_linear_pair_touch(&taken, &far, &none).verdict,
                     TF_APART);
    ck_assert_int_eq(tf_linear_pair_touch(&taken, &zero, &none).classification,
                     TF_DEGENERATE);
    tf_contact contact = tf_linear_pair_touch(&taken, &half, &none);
    ck_assert_int_eq(contact.classification, TF_GENERIC);
    ck_assert_double_eq(contact.toi_lo, 0.5);
}
END_TEST

// Statuses --------------------------------------------------------------------

static tf_status ask_straight(const tf_arithmetic *arithmetic,
                              const tf_motion *motion, const int vertex[],
                              tf_contact *contact)
{
    static const tf_tolerances none = {0};
    return cubic_query(EDGE_EDGE, arithmetic ? &none : NULL, motion, vertex,
                       contact);
}

static void use_straight(void)
{
    statuses_use(EDGE_EDGE, ask_straight);
}

Suite *suite(void)
{
    Suite *s = suite_create("linear/linear_pair");
    TCase *c = tcase_create("linear motion");
    tcase_add_loop_test(c, vertices_are_taken_by_index, 0, KINDS);
    tcase_add_test(c, positions_lie_on_straight_paths);
    tcase_add_test(c, a_contact_has_coordinates_normal_and_velocity);
    tcase_add_test(c, a_contact_of_huge_elements_is_finite);
    tcase_add_test(c, tolerances_out_of_range_are_invalid);
    tcase_add_test(c, touches_are_sought_at_roots_of_the_polynomial);
    suite_add_tcase(s, c);
    suite_add_tcase(s, statuses_case_of_doubles("statuses", use_straight));
    return s;
}

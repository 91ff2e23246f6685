// Velocity fields: none but growth has sources.
#include "simulate/flow_fields.h"

#include "support/support.h"

#include <math.h>

static tf_velocity_field *const fields[] = {
    tf_splash, tf_squeeze, tf_vortices, tf_turbulence, tf_whirl,
};

static const tf_vector no_normal;

/// The divergence around a point, by differences.
static double divergence(tf_velocity_field *field, double time, tf_vector at)
{
    const double h = 1e-4;
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        tf_vector left = at, right = at;
        left.x[k] -= h;
        right.x[k] += h;
        sum += (field(time, right, no_normal).x[k] -
                field(time, left, no_normal).x[k]) /
               (2 * h);
    }
    return sum;
}

START_TEST(a_field_has_no_sources)
{
    generator random = generator_new((uint64_t)_i);
    double fastest = 0;
    for (int i = 0; i < 200; i++) {
        tf_vector at;
        double time = uniform(&random, 0, 3);
        for (int k = 0; k < 3; k++)
            at.x[k] = uniform(&random, -0.5, 0.5);
        ck_assert_double_eq_tol(divergence(fields[_i], time, at), 0, 1e-5);
        fastest = fmax(fastest, fabs(fields[_i](time, at, no_normal).x[0]));
    }
    ck_assert_double_gt(fastest, 0.1);
}
END_TEST

START_TEST(vortices_turn_back)
{
    const tf_vector at = {{0.3, 0.4, 0.35}};
    tf_vector before = tf_vortices(1, at, no_normal);
    tf_vector after = tf_vortices(2, at, no_normal);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(before.x[k], -after.x[k], 1e-15);
    ck_assert_double_eq_tol(
        tf_vortices(0, at, no_normal).x[0],
        2 * 0.6545084971874737 * 0.587785252292473 * 0.809016994374947, 1e-12);
}
END_TEST

START_TEST(a_field_is_applied_point_by_point)
{
    static const double point[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
    static const double normal[] = {1, 0, 0, 0, 0.6, 0.8};
    tf_velocity_field *growth = tf_growth, *whirl = tf_whirl;
    double velocity[6];
    tf_field_apply(&growth, 1, 2, point, normal, velocity);
    for (int i = 0; i < 6; i++) // along the normals
        ck_assert_double_eq(velocity[i], 0.1 * normal[i]);
    tf_field_apply(&whirl, 1, 2, point, normal, velocity);
    for (int i = 0; i < 6; i++)
        ck_assert_double_eq(
            velocity[i],
            tf_whirl(1, tf_vector_at(point, i / 3), no_normal).x[i % 3]);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/flow_fields");
    TCase *tcase = tcase_create("fields");
    tcase_add_loop_test(tcase, a_field_has_no_sources, 0,
                        sizeof fields / sizeof *fields);
    tcase_add_test(tcase, vortices_turn_back);
    tcase_add_test(tcase, a_field_is_applied_point_by_point);
    suite_add_tcase(suite, tcase);
    return suite;
}

// Velocity fields: none but growth has sources.
#include "simulate/flow_fields.h"

#include "support/support.h"

#include <math.h>

static tf_flow_velocity *const fields[] = {
    tf_flow_splash,     tf_flow_squeeze, tf_flow_vortices,
    tf_flow_turbulence, tf_flow_whirl,
};

/// The divergence around a point, by differences.
static double divergence(tf_flow_velocity *field, double time,
                         const double at[3])
{
    const double h = 1e-4;
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        double point[] = {at[0], at[1], at[2], at[0], at[1], at[2]};
        double velocity[6];
        point[k] -= h;
        point[3 + k] += h;
        field(NULL, time, 2, point, NULL, velocity);
        sum += (velocity[3 + k] - velocity[k]) / (2 * h);
    }
    return sum;
}

START_TEST(nothing_is_gained)
{
    generator random = generator_new((uint64_t)_i);
    double fastest = 0;
    for (int i = 0; i < 200; i++) {
        double velocity[3], at[3], time = uniform(&random, 0, 3);
        for (int k = 0; k < 3; k++)
            at[k] = uniform(&random, -0.5, 0.5);
        ck_assert_double_eq_tol(divergence(fields[_i], time, at), 0, 1e-5);
        fields[_i](NULL, time, 1, at, NULL, velocity);
        fastest = fmax(fastest, fabs(velocity[0]));
    }
    ck_assert_double_gt(fastest, 0.1);
}
END_TEST

START_TEST(vortices_turn_back)
{
    static const double at[] = {0.3, 0.4, 0.35};
    double before[3], after[3];
    tf_flow_vortices(NULL, 1, 1, at, NULL, before);
    tf_flow_vortices(NULL, 2, 1, at, NULL, after);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(before[k], -after[k], 1e-15);
    tf_flow_vortices(NULL, 0, 1, at, NULL, before);
    ck_assert_double_eq_tol(
        before[0],
        2 * 0.6545084971874737 * 0.587785252292473 * 0.809016994374947, 1e-12);
}
END_TEST

START_TEST(growth_is_along_normals)
{
    static const double normal[] = {1, 0, 0, 0, 0.6, 0.8};
    double velocity[6];
    tf_flow_growth(NULL, 1, 2, normal, normal, velocity);
    for (int i = 0; i < 6; i++)
        ck_assert_double_eq(velocity[i], 0.1 * normal[i]);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/flow_fields");
    TCase *tcase = tcase_create("fields");
    tcase_add_loop_test(tcase, nothing_is_gained, 0,
                        sizeof fields / sizeof *fields);
    tcase_add_test(tcase, vortices_turn_back);
    tcase_add_test(tcase, growth_is_along_normals);
    suite_add_tcase(suite, tcase);
    return suite;
}

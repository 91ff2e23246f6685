// The product with a zone's matrix, against its definition.
#include "response/zone.h"

#include "support/support.h"
#include "support/watches.h"
#include "support/zones.h"

#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

enum {
    VERTICES = 8,
    CONSTRAINTS = 10
};

/// Entry (i, j) of J M^-1 J'.
static double entry(const tf_zone *zone, int i, int j)
{
    const tf_constraint *a = &zone->constraint[i], *b = &zone->constraint[j];
    double sum = 0;
    for (int p = 0; p < 4 && a->vertex[p] >= 0; p++)
        for (int q = 0; q < 4 && b->vertex[q] >= 0; q++)
            for (int k = 0; k < zone->axes; k++)
                if (a->vertex[p] == b->vertex[q])
                    sum += zone->inverse_mass[a->vertex[p]] *
                           a->coefficient[p] * a->normal[k] *
                           b->coefficient[q] * b->normal[k];
    return sum;
}

START_TEST(columns_are_those_of_the_matrix)
{
    generator random = generator_new(100 + (uint64_t)_i);
    for (int times = 0; times < (int)cases(100); times++) {
        zone_case z =
            zone_random(&random, 2 + _i, VERTICES, CONSTRAINTS, CONSTRAINTS);
        for (int j = 0; j < CONSTRAINTS; j++) {
            double unit[CONSTRAINTS] = {0}, column[CONSTRAINTS],
                   workspace[3 * VERTICES];
            unit[j] = 1;
            z.zone.constraint[j].friction[0] = 7; // must not count
            tf_zone_multiply(&z.zone, unit, column, workspace);
            for (int i = 0; i < CONSTRAINTS; i++)
                ck_assert_double_eq_tol(column[i], entry(&z.zone, i, j), 1e-14);
        }
        zone_free(&z);
    }
}
END_TEST

START_TEST(pushes_add_up)
{
    generator random = generator_new(200);
    zone_case z = zone_random(&random, 3, VERTICES, CONSTRAINTS, CONSTRAINTS);
    double impulse[CONSTRAINTS], once[3 * VERTICES] = {0}, twice[3 * VERTICES];
    for (int i = 0; i < CONSTRAINTS; i++)
        impulse[i] = uniform(&random, -1, 1);
    tf_zone_push(&z.zone, impulse, once);
    memcpy(twice, once, sizeof twice);
    tf_zone_push(&z.zone, impulse, twice);
    for (int i = 0; i < 3 * VERTICES; i++)
        ck_assert_double_eq_tol(twice[i], 2 * once[i], 1e-14);
    zone_free(&z);
}
END_TEST

START_TEST(null_breaks_the_contract)
{
    double number = 0;
    tf_zone_multiply(NULL, &number, &number, &number);
}
END_TEST

START_TEST(a_zone_without_a_watch_goes_on)
{
    const tf_zone zone = {.axes = 3};
    ck_assert(tf_zone_goes_on(&zone, 0));
    ck_assert(tf_zone_goes_on(&zone, 1000000));
}
END_TEST

START_TEST(visits_are_counted_until_the_caller_cancels)
{
    watched_call call;
    tf_zone zone = {.axes = 3, .watch = watched_begin(&call, 2)};
    long visits = 0;
    while (tf_zone_goes_on(&zone, 1))
        visits++;
    ck_assert_int_eq(call.calls, 2);
    ck_assert_int_eq(visits, TF_WATCHED_WORK - 1);
    ck_assert(!tf_zone_goes_on(&zone, 0));
}
END_TEST

// The coefficients of vertices follow their masses.
START_TEST(a_zone_tells_the_friction_of_a_constraint)
{
    const double masses_and_friction[] = {9, 9, 0.5, 2};
    const tf_constraint constraint = {.vertex = {0, 1, -1, -1},
                                      .coefficient = {1, -1}};
    tf_zone zone = {.axes = 2,
                    .vertices = 2,
                    .inverse_mass = masses_and_friction,
                    .friction = 0.3};
    ck_assert_double_eq(tf_zone_friction(&zone, &constraint), 0.3);
    zone.friction = 0;
    ck_assert_double_eq(tf_zone_friction(&zone, &constraint), 0);
    zone.friction = -1;
    ck_assert_double_eq_tol(tf_zone_friction(&zone, &constraint), 1, 1e-15);
}
END_TEST

// Nothing is written any more.
START_TEST(products_end_early)
{
    generator random = generator_new(300);
    zone_case z = zone_random(&random, 3, VERTICES, CONSTRAINTS, CONSTRAINTS);
    double impulse[CONSTRAINTS] = {0}, product[CONSTRAINTS] = {7},
           workspace[3 * VERTICES];
    watched_call call;
    z.zone.watch = watched_begin(&call, -1);
    tf_zone_multiply(&z.zone, impulse, product, workspace);
    ck_assert_double_eq(product[0], 7);
    ck_assert_uint_le(watched_work_after(&call), 2);
    z.zone.watch = watched_begin(&call, 0);
    tf_zone_multiply(&z.zone, impulse, product, workspace);
    ck_assert_double_ne(product[0], 7);
    ck_assert_uint_ge(watched_work(&call), 2 * CONSTRAINTS);
    zone_free(&z);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/zone");
    TCase *tcase = tcase_create("the product");
    tcase_add_loop_test(tcase, columns_are_those_of_the_matrix, 0, 2);
    tcase_add_test(tcase, pushes_add_up);
    tcase_add_test_raise_signal(tcase, null_breaks_the_contract, SIGABRT);
    tcase_add_test(tcase, a_zone_without_a_watch_goes_on);
    tcase_add_test(tcase, visits_are_counted_until_the_caller_cancels);
    tcase_add_test(tcase, a_zone_tells_the_friction_of_a_constraint);
    tcase_add_test(tcase, products_end_early);
    suite_add_tcase(suite, tcase);
    return suite;
}

// Strands: the energies of bent and stretched edges, against integrals.
#include "simulate/strand.h"

#include "support/support.h"

#include <math.h>

/// A strand with vertices at these positions, each joined to the next.
static tf_body strand_of(int axes, int vertices, const double x[],
                         const tf_material *material)
{
    tf_body body = {.axes = axes};
    for (int v = 0; v < vertices; v++)
        tf_body_add_vertex(&body, x + (ptrdiff_t)axes * v);
    for (int v = 1; v < vertices; v++)
        tf_body_add_edge(&body, v - 1, v);
    tf_strand_stiffen(&body, 0, material);
    return body;
}

// A circle with edges of random lengths: bend / 2 times the square of the
// curvature, times the length.
START_TEST(a_circle_has_the_energy_of_its_curvature)
{
    enum {
        MOST = 400
    };
    const tf_material material = {1, 1, 0.25};
    generator random = generator_new(1);
    for (int i = 0; i < cases(20); i++) {
        double x[2 * MOST], radius = uniform(&random, 0.1, 10), angle = 0;
        double begin = 0, end = 0, last = 0;
        for (int v = 0; v < MOST; v++) {
            x[2 * v] = radius * cos(angle);
            x[2 * v + 1] = radius * sin(angle);
            double to_next = uniform(&random, 0.002, 0.006);
            if (v == 0)
                begin = to_next / 2;
            if (v == MOST - 1)
                end = angle - last / 2;
            last = to_next;
            angle += to_next;
        }
        tf_body body = strand_of(2, MOST, x, &material);
        double energy = tf_body_elastic_energy(&body, x);
        double length = (end - begin) * radius;
        ck_assert_double_eq_tol(energy * radius * radius / length, 0.125,
                                0.125 * 1e-3);
        tf_body_free(&body);
    }
}
END_TEST

START_TEST(a_straight_strand_is_at_rest)
{
    const double x[] = {0, 0, 0, 1, 2, 3, 1.5, 3, 4.5, 4, 8, 12};
    tf_body body = strand_of(3, 4, x, &(tf_material){1, 1, 1});
    ck_assert_int_eq(body.elastics, 5);
    ck_assert_double_eq_tol(tf_body_elastic_energy(&body, x), 0, 1e-28);
    tf_body_free(&body);
}
END_TEST

// stretch / 2 times the square of the strain, times the length.
START_TEST(stretching_has_the_energy_of_its_strain)
{
    const double x[] = {0, 0, 1, 0, 4, 0}, longer[] = {0, 0, 1.1, 0, 4.4, 0};
    tf_body body = strand_of(2, 3, x, &(tf_material){2, 50, 0});
    ck_assert_int_eq(body.elastics, 2);
    ck_assert_double_eq_tol(tf_body_elastic_energy(&body, longer),
                            25 * 0.01 * 4, 1e-12);
    ck_assert_double_eq(tf_strand_length(&body, 1), 3);
    ck_assert(body.mass[0] == 1 && body.mass[1] == 4 && body.mass[2] == 3);
    tf_body_free(&body);
}
END_TEST

START_TEST(forks_and_ends_are_not_bent)
{
    tf_body body = {.axes = 2};
    for (int v = 0; v < 6; v++)
        tf_body_add_vertex(&body, (const double[]){v, v * v});
    tf_body_add_edge(&body, 5, 4); // of something else
    tf_body_add_edge(&body, 1, 0);
    tf_body_add_edge(&body, 2, 0);
    tf_body_add_edge(&body, 0, 3);
    tf_body_add_edge(&body, 5, 3);
    tf_strand_stiffen(&body, 1, &(tf_material){1, 1, 1});
    ck_assert_int_eq(body.elastics, 5);
    ck_assert_int_eq(body.elastic[4].vertex[1], 3);
    ck_assert_double_eq(body.mass[4], 0);
    tf_body_free(&body);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/strand");
    TCase *tcase = tcase_create("strands");
    tcase_add_test(tcase, a_circle_has_the_energy_of_its_curvature);
    tcase_add_test(tcase, a_straight_strand_is_at_rest);
    tcase_add_test(tcase, stretching_has_the_energy_of_its_strain);
    tcase_add_test(tcase, forks_and_ends_are_not_bent);
    suite_add_tcase(suite, tcase);
    return suite;
}

#include "geometry/vector.h"

#include "support/generator.h"
#include "support/support.h"

#include <float.h>
#include <gmp.h>
#include <stdbool.h>

static const double u = DBL_EPSILON / 2;

/// Small integers.
static tf_vector lattice_vector(generator *random)
{
    tf_vector v;
    for (int k = 0; k < TF_AXES; k++)
        v.x[k] = below(random, 17) - 8;
    return v;
}

/// Components whose magnitudes differ.
static tf_vector any_vector(generator *random)
{
    tf_vector v;
    for (int k = 0; k < TF_AXES; k++)
        v.x[k] = ldexp(uniform(random, -1, 1), below(random, 40) - 20);
    return v;
}

/// Whether `found` is a[0] b[0] + ... + a[count - 1] b[count - 1], but for the
/// roundings of `count` products and as many sums.
static bool is_sum(double found, int count, const double a[], const double b[])
{
    mpq_t error, factor, term;
    double size = 0;
    mpq_inits(error, factor, term, NULL);
    mpq_set_d(error, found);
    for (int i = 0; i < count; i++) {
        mpq_set_d(factor, a[i]);
        mpq_set_d(term, b[i]);
        mpq_mul(term, term, factor);
        mpq_sub(error, error, term);
        size += fabs(a[i] * b[i]);
    }
    bool good = fabs(mpq_get_d(error)) <= (count + 1) * u * size;
    mpq_clears(error, factor, term, NULL);
    return good;
}

START_TEST(the_position_of_a_vertex_is_three_coordinates_of_the_array)
{
    const double x[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    for (int v = 0; v < 3; v++)
        for (int k = 0; k < TF_AXES; k++)
            ck_assert_double_eq(tf_vector_at(x, v).x[k], 3 * v + k);
}
END_TEST

START_TEST(vectors_are_equal_if_all_coordinates_are)
{
    tf_vector a = {{1, 0, -2}};
    ck_assert(tf_vector_equals(a, (tf_vector){{1, -0.0, -2}}));
    for (int k = 0; k < 3; k++) {
        tf_vector b = a;
        b.x[k] = nextafter(b.x[k], 3);
        ck_assert(!tf_vector_equals(a, b));
    }
}
END_TEST

START_TEST(sums_of_integers_are_exact)
{
    generator random = generator_new(1);
    for (int i = 0; i < 1000; i++) {
        tf_vector a = lattice_vector(&random), b = lattice_vector(&random);
        int factor = below(&random, 17) - 8;
        for (int k = 0; k < TF_AXES; k++) {
            ck_assert_double_eq(tf_vector_scaled(factor, a).x[k],
                                factor * a.x[k]);
            ck_assert_double_eq(tf_vector_sum(a, factor, b).x[k],
                                a.x[k] + factor * b.x[k]);
            ck_assert_double_eq(tf_vector_difference(a, b).x[k],
                                a.x[k] - b.x[k]);
        }
    }
}
END_TEST

START_TEST(products_are_exact_but_for_rounding)
{
    generator random = generator_new(2);
    for (long i = cases(20000); i > 0; i--) {
        tf_vector a = any_vector(&random), b = any_vector(&random);
        tf_vector cross = tf_vector_cross(a, b);
        ck_assert(is_sum(tf_vector_dot(a, b), 3, a.x, b.x));
        for (int k = 0; k < TF_AXES; k++) {
            int l = (k + 1) % TF_AXES, m = (k + 2) % TF_AXES;
            const double first[] = {a.x[l], -a.x[m]};
            const double second[] = {b.x[m], b.x[l]};
            ck_assert_msg(is_sum(cross.x[k], 2, first, second),
                          "component %d of (%a, %a, %a) x (%a, %a, %a) is %a",
                          k, a.x[0], a.x[1], a.x[2], b.x[0], b.x[1], b.x[2],
                          cross.x[k]);
        }
    }
}
END_TEST

START_TEST(the_cross_product_of_two_axes_is_the_next_axis)
{
    for (int k = 0; k < TF_AXES; k++) {
        tf_vector axis[TF_AXES] = {0};
        for (int i = 0; i < TF_AXES; i++)
            axis[i].x[(k + i) % TF_AXES] = 1;
        tf_vector product = tf_vector_cross(axis[0], axis[1]);
        ck_assert_double_eq(tf_vector_dot(product, axis[2]), 1);
        ck_assert_double_eq(tf_vector_length(product), 1);
    }
}
END_TEST

START_TEST(the_cross_product_is_perpendicular_to_both_factors)
{
    generator random = generator_new(3);
    for (int i = 0; i < 1000; i++) {
        tf_vector a = lattice_vector(&random), b = lattice_vector(&random);
        tf_vector product = tf_vector_cross(a, b);
        ck_assert_double_eq(tf_vector_dot(product, a), 0);
        ck_assert_double_eq(tf_vector_dot(product, b), 0);
    }
}
END_TEST

START_TEST(a_unit_vector_has_length_1_in_the_same_direction)
{
    generator random = generator_new(4);
    for (long i = cases(20000); i > 0; i--) {
        tf_vector a = any_vector(&random), unit = tf_vector_unit(a);
        ck_assert_double_eq_tol(tf_vector_length(unit), 1, 8 * u);
        ck_assert_double_eq_tol(tf_vector_dot(unit, a), tf_vector_length(a),
                                8 * u * tf_vector_length(a));
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("geometry/vector");
    TCase *tcase = tcase_create("vector");
    tcase_add_test(tcase,
                   the_position_of_a_vertex_is_three_coordinates_of_the_array);
    tcase_add_test(tcase, vectors_are_equal_if_all_coordinates_are);
    tcase_add_test(tcase, sums_of_integers_are_exact);
    tcase_add_test(tcase, products_are_exact_but_for_rounding);
    tcase_add_test(tcase, the_cross_product_of_two_axes_is_the_next_axis);
    tcase_add_test(tcase, the_cross_product_is_perpendicular_to_both_factors);
    tcase_add_test(tcase, a_unit_vector_has_length_1_in_the_same_direction);
    suite_add_tcase(suite, tcase);
    return suite;
}

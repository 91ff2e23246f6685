#include "arithmetic/exact.h"

#include "arithmetic/functions.h"
#include "support/exactness.h"

#include <float.h>
#include <math.h>

static void use(void)
{
    exactness_use(&tf_exact);
}

START_TEST(any_finite_double_is_held)
{
    static const double ends[] = {0, DBL_TRUE_MIN, 0.1, DBL_MAX};
    for (int axes = 2; axes <= TF_AXES; axes++)
        for (int i = 0; i < (int)(sizeof ends / sizeof *ends); i++)
            ck_assert_msg(tf_arithmetic_holds(&tf_exact, axes, -ends[i]),
                          "%d axes: %a is not held", axes, -ends[i]);
}
END_TEST

// The stages ------------------------------------------------------------------

START_TEST(repeated_rows_are_seen_only_if_all_of_them_repeats)
{
    // The last row is another one, but for a unit in the last place somewhere.
    generator random = generator_new(11);
    long count = cases(20000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_flat(&random, 2 + below(&random, 2));
        int row = below(&random, m.n - 1), last = m.n - 1;
        m.to[last] = m.to[row];
        m.from[last] = m.from[row];
        expect_exact(&tf_exact, &m);
        int moved = 2 * m.n * last + below(&random, 2 * m.n);
        double *x = matrix_coordinate(&m, moved);
        *x = nextafter(*x, below(&random, 2) ? DBL_MAX : -DBL_MAX);
        expect_exact(&tf_exact, &m);
    }
}
END_TEST

START_TEST(signs_are_exact_between_the_points_of_a_grid)
{
    // Many lie on one, the others need the accumulator.
    generator random = generator_new(12);
    long count = cases(30000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_flat(&random, 2 + below(&random, 2));
        double *x = matrix_coordinate(&m, below(&random, matrix_size(&m)));
        *x = ldexp(*x, -4 - below(&random, 10));
        expect_exact(&tf_exact, &m);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *exact = suite_create("exact");
    exactness_add(exact, use);
    TCase *stages = tcase_create("stages");
    tcase_add_test(stages, any_finite_double_is_held);
    tcase_add_test(stages, repeated_rows_are_seen_only_if_all_of_them_repeats);
    tcase_add_test(stages, signs_are_exact_between_the_points_of_a_grid);
    suite_add_tcase(exact, stages);
    return exact;
}

#include "arithmetic/perturbed.h"

#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "support/matrices.h"

#include <limits.h>
#include <math.h>
#include <signal.h>

// A matrix whose rows end at events of their own, as in every determinant of
// the library, but start where they like.
static void number_events(matrix *m)
{
    for (int i = 0; i < m->n; i++) {
        m->to[i].vertex = 2 * i + 1;
        m->from[i].vertex = 2 * i + 2;
    }
}

START_TEST(a_sign_is_the_exact_one_unless_that_is_zero)
{
    generator random = generator_new((uint64_t)_i);
    long zeros = 0;
    for (long i = 0; i < cases(20000); i++) {
        matrix m = i % 2 ? matrix_any(&random, 1 + _i)
                         : matrix_lattice(&random, 1 + _i, 2);
        number_events(&m);
        tf_differences d = matrix_differences(&m);
        tf_sign exact = tf_exact.sign(&d), sign = tf_perturbed.sign(&d);
        zeros += exact == TF_ZERO;
        expect_of_matrix(sign == TF_POSITIVE || sign == TF_NEGATIVE,
                         "a sign that is no sign", &m);
        expect_of_matrix(exact == TF_ZERO || sign == exact,
                         "not the exact sign", &m);
    }
    ck_assert_int_gt(zeros, 0);
}
END_TEST

START_TEST(a_value_has_the_sign_of_the_determinant_and_its_order)
{
    generator random = generator_new((uint64_t)(10 + _i));
    for (long i = 0; i < cases(20000); i++) {
        matrix m = i % 2 ? matrix_any(&random, 1 + _i)
                         : matrix_lattice(&random, 1 + _i, 2);
        number_events(&m);
        tf_differences d = matrix_differences(&m);
        tf_value value = tf_perturbed.value(&d);
        bool finite = tf_exact.sign(&d) != TF_ZERO;
        tf_sign sign = (tf_sign)((value.number > 0) - (value.number < 0));
        expect_of_matrix(sign == tf_perturbed.sign(&d), "another sign", &m);
        expect_of_matrix((value.order[0] == 0) == finite,
                         "a wrong claim of being infinitely small", &m);
        for (int k = 1; k < TF_AXES; k++)
            expect_of_matrix(value.order[k] == 0 ||
                                 value.order[k] < value.order[k - 1],
                             "infinitesimals out of order", &m);
    }
}
END_TEST

START_TEST(exchanging_two_ends_changes_the_sign)
{
    generator random = generator_new((uint64_t)(20 + _i));
    for (long i = 0; i < cases(20000); i++) {
        matrix m = matrix_lattice(&random, 2 + _i, 2);
        number_events(&m);
        tf_differences d = matrix_differences(&m);
        tf_differences exchanged = d;
        exchanged.to[0] = d.to[1];
        exchanged.from[0] = d.from[1];
        exchanged.to[1] = d.to[0];
        exchanged.from[1] = d.from[0];
        expect_of_matrix(tf_perturbed.sign(&d) ==
                             -tf_perturbed.sign(&exchanged),
                         "the same sign for exchanged rows", &m);
    }
}
END_TEST

// By hand ---------------------------------------------------------------------

/// Where a equals b on a line, b - a is e_b - e_a, and the infinitesimal of the
/// lower index, of t = 0 for one index, is the larger.
START_TEST(on_a_line_the_lower_index_is_to_the_right)
{
    tf_event a = {.x = {5}, .vertex = 3}, b = {.x = {5}, .vertex = 4};
    tf_differences d = {.n = 1, .to = {&b}, .from = {&a}, .axis = {0}};
    ck_assert_int_eq(tf_perturbed.sign(&d), TF_NEGATIVE);
    b.vertex = 2;
    ck_assert_int_eq(tf_perturbed.sign(&d), TF_POSITIVE);
    b = (tf_event){.x = {5}, .t = 1, .vertex = 3};
    ck_assert_int_eq(tf_perturbed.sign(&d), TF_NEGATIVE);
    tf_value value = tf_perturbed.value(&d);
    ck_assert_double_eq(ldexp(value.number, value.exponent), -1);
    ck_assert_int_eq(value.order[0], 3 * 6 + 1);
}
END_TEST

START_TEST(the_largest_indices_have_an_order)
{
    tf_event a = {.x = {5}, .vertex = INT_MAX - 1};
    tf_event b = {.x = {5}, .t = 1, .vertex = INT_MAX};
    tf_differences d = {.n = 1, .to = {&b}, .from = {&a}, .axis = {2}};
    a.x[2] = b.x[2] = 5;
    ck_assert_int_eq(tf_perturbed.sign(&d), TF_NEGATIVE);
    tf_value value = tf_perturbed.value(&d);
    ck_assert_double_eq(ldexp(value.number, value.exponent), -1);
    ck_assert(value.order[0] == 3 * 2 * ((int64_t)INT_MAX - 1) + 3);

    a.vertex = INT_MAX;
    a.t = 1;
    b.vertex = INT_MAX;
    b.t = 0;
    ck_assert_int_eq(tf_perturbed.sign(&d), TF_POSITIVE);
    ck_assert(tf_perturbed.value(&d).order[0] == 6 * (int64_t)INT_MAX + 3);
}
END_TEST

/// a = (0,0), b = (1,0), c = (2,0), ranks 0 to 2: the rows b - a and c - a have
/// the determinant (1 + xb - xa)(yc - ya) - (2 + xc - xa)(yb - ya), in which
/// the largest infinitesimals are xa, whose factor is zero, and ya, times
/// -1 + 2.
START_TEST(collinear_points_turn_by_the_first_that_moves)
{
    tf_event a = {.x = {0, 0}, .vertex = 0}, b = {.x = {1, 0}, .vertex = 1};
    tf_event c = {.x = {2, 0}, .vertex = 2};
    tf_differences d = {
        .n = 2, .to = {&b, &c}, .from = {&a, &a}, .axis = {0, 1}};
    tf_value value = tf_perturbed.value(&d);
    ck_assert_double_eq(ldexp(value.number, value.exponent), 1);
    ck_assert_int_eq(value.order[0], 2);
    ck_assert_int_eq(value.order[1], 0);

    // In one point nothing but two infinitesimals on two axes is left: the
    // largest such product is xb ya, times -1.
    b.x[0] = c.x[0] = 0;
    value = tf_perturbed.value(&d);
    ck_assert_double_eq(ldexp(value.number, value.exponent), -1);
    ck_assert_int_eq(value.order[0], 6 + 1);
    ck_assert_int_eq(value.order[1], 2);
}
END_TEST

// Contracts -------------------------------------------------------------------

static void ask_of(int first, int second)
{
    tf_event a = {.x = {5}, .vertex = first}, b = {.x = {5}, .vertex = second};
    tf_differences d = {.n = 1, .to = {&b}, .from = {&a}, .axis = {0}};
    tf_perturbed.sign(&d);
}

START_TEST(two_events_of_one_index_and_time_break_the_contract)
{
    ask_of(7, 7);
}
END_TEST

START_TEST(the_same_index_in_two_rows_breaks_the_contract)
{
    tf_event a = {.vertex = 1}, b = {.x = {1, 1}, .vertex = 7},
             c = {.x = {3, 4}, .vertex = 7}, e = {.x = {5, 6}, .vertex = 9};
    tf_differences d = {
        .n = 2, .to = {&b, &e}, .from = {&a, &c}, .axis = {0, 1}};
    tf_perturbed.sign(&d);
}
END_TEST

START_TEST(a_negative_index_breaks_the_contract)
{
    ask_of(-1, 7);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("perturbed");
    TCase *c = tcase_create("signs");
    tcase_add_loop_test(c, a_sign_is_the_exact_one_unless_that_is_zero, 0,
                        TF_AXES);
    tcase_add_loop_test(
        c, a_value_has_the_sign_of_the_determinant_and_its_order, 0, TF_AXES);
    tcase_add_loop_test(c, exchanging_two_ends_changes_the_sign, 0,
                        TF_AXES - 1);
    tcase_add_test(c, on_a_line_the_lower_index_is_to_the_right);
    tcase_add_test(c, collinear_points_turn_by_the_first_that_moves);
    tcase_add_test_raise_signal(
        c, two_events_of_one_index_and_time_break_the_contract, SIGABRT);
    tcase_add_test_raise_signal(
        c, the_same_index_in_two_rows_breaks_the_contract, SIGABRT);
    tcase_add_test(c, the_largest_indices_have_an_order);
    tcase_add_test_raise_signal(c, a_negative_index_breaks_the_contract,
                                SIGABRT);
    suite_add_tcase(s, c);
    return s;
}

#include "arithmetic/fixed.h"

#include "support/exactness.h"
#include "support/rational.h"
#include "support/six.h"

#include <float.h>
#include <limits.h>
#include <math.h>

// What is on a grid -----------------------------------------------------------

/// The exponent of the last one bit of x, which is not zero.
static int last_place_of(double x)
{
    int exponent;
    double fraction = frexp(x, &exponent);
    while (fraction != trunc(fraction)) {
        fraction *= 2;
        exponent--;
    }
    return exponent;
}

/// Whether all coordinates of column j are multiples of one power of two, at
/// least 2^-1022, by less than 2^62.
static bool column_is_on_grid(const matrix *m, int j)
{
    int last = INT_MAX, end = INT_MIN;
    for (int i = 0; i < m->n; i++)
        for (int from = 0; from < 2; from++) {
            const tf_event *event = from ? &m->from[i] : &m->to[i];
            double x = event->x[m->axis[j]];
            if (x == 0)
                continue;
            int place = last_place_of(x);
            last = place < last ? place : last;
            end = ilogb(x) + 1 > end ? ilogb(x) + 1 : end;
        }
    return end == INT_MIN || (last >= -1022 && end - last <= TF_GRID_BITS);
}

static bool is_on_grid(const matrix *m)
{
    for (int j = 0; j < m->n; j++)
        if (!column_is_on_grid(m, j))
            return false;
    return true;
}

// A judge ---------------------------------------------------------------------

static tf_sign sign_on_grid(const tf_differences *differences)
{
    tf_sign sign = TF_UNKNOWN;
    tf_fixed_sign(differences, &sign);
    return sign;
}

static tf_value value_on_grid(const tf_differences *differences)
{
    tf_value value = {.number = NAN};
    tf_fixed_value(differences, &value);
    return value;
}

static const tf_arithmetic fixed = {
    .name = "fixed", .sign = sign_on_grid, .value = value_on_grid};

/// Expect the exact determinant if the matrix is on a grid, and none if it is
/// not; returns whether it is.
static bool judge(const matrix *m)
{
    tf_differences differences = matrix_differences(m);
    bool on_grid = is_on_grid(m);
    if (on_grid) {
        expect_exact(&fixed, m);
        return true;
    }
    tf_sign sign = TF_UNKNOWN;
    tf_value value;
    expect_of_matrix(!tf_fixed_sign(&differences, &sign) &&
                         !tf_fixed_value(&differences, &value),
                     "On no grid, but evaluated", m);
    expect_of_matrix(sign == TF_UNKNOWN, "A sign without a grid", m);
    return false;
}

// All kinds -------------------------------------------------------------------

START_TEST(signs_and_values_are_exact_wherever_there_is_a_grid)
{
    generator random = generator_new(1);
    long count = cases(60000), on_grid = 0;
    for (long i = 0; i < count; i++) {
        matrix m = matrix_any(&random, 1 + below(&random, TF_AXES));
        on_grid += judge(&m);
        matrix_nudge(&random, &m, 1);
        on_grid += judge(&m);
    }
    ck_assert_msg(on_grid > count / 3 && on_grid < 2 * count - count / 3,
                  "%ld of %ld are on a grid", on_grid, 2 * count);
}
END_TEST

START_TEST(signs_and_values_are_exact_for_columns_of_any_size)
{
    // Down to where units would be less than 2^-1022, and up to overflow.
    generator random = generator_new(2);
    long count = cases(60000), on_grid = 0;
    for (long i = 0; i < count; i++) {
        matrix m =
            below(&random, 2)
                ? matrix_flat(&random, 1 + below(&random, TF_AXES))
                : matrix_lattice(&random, 1 + below(&random, TF_AXES), 9);
        for (int j = 0; j < m.n; j++)
            matrix_scale(&m, j, below(&random, 2090) - 1075);
        if (isfinite(*matrix_coordinate(&m, 0)))
            on_grid += judge(&m);
    }
    ck_assert_msg(on_grid > count / 3, "%ld of %ld are on a grid", on_grid,
                  count);
}
END_TEST

// The ends of the range -------------------------------------------------------

static const double largest = 0x1.fffffffffffffp61; // below 2^62

START_TEST(the_largest_differences_have_exact_signs_and_values)
{
    generator random = generator_new(3);
    for (int n = 1; n <= TF_AXES; n++) {
        double end[9] = {-1, -1, -1, -1, -1, -1, -1, -1, -1};
        do {
            matrix m = matrix_new(&random, n);
            for (int k = 0; k < n * n; k++) {
                *matrix_coordinate(&m, 2 * k) = end[k] * largest;
                *matrix_coordinate(&m, 2 * k + 1) = -end[k] * largest;
            }
            ck_assert(judge(&m));
        } while (next_signs(n * n, end));
    }
}
END_TEST

/// A coordinate of 62 bits, its ends, the ends of words and zero above all.
static double any_coordinate(generator *random)
{
    static const double sizes[] = {0, 1, 3, 0x1p31, 0x1p53 - 1, 0x1p61};
    double sign = below(random, 2) ? 1 : -1;
    switch (below(random, 4)) {
    case 0:
        return sign * largest;
    case 1:
        return sign * sizes[below(random, 6)];
    case 2:
        return sign * trunc(uniform(random, 0, 0x1p32));
    default:
        return sign * trunc(uniform(random, 0, 0x1p62));
    }
}

START_TEST(coordinates_of_62_bits_have_a_grid)
{
    generator random = generator_new(4);
    long count = cases(60000);
    for (long i = 0; i < count; i++) {
        int n = 1 + below(&random, TF_AXES);
        matrix m = matrix_new(&random, n);
        for (int k = 0; k < matrix_size(&m); k++)
            *matrix_coordinate(&m, k) = any_coordinate(&random);
        ck_assert(judge(&m));

        // The last row is the first, and then not quite.
        m.to[n - 1] = m.to[0];
        m.from[n - 1] = m.from[0];
        ck_assert(judge(&m));
        *matrix_coordinate(&m, 2 * n * (n - 1)) = any_coordinate(&random);
        ck_assert(judge(&m));
    }
}
END_TEST

START_TEST(coordinates_beyond_62_bits_have_no_grid)
{
    // The largest coordinate of a column is below 2, so the unit is 2^-61.
    generator random = generator_new(5);
    for (int n = 1; n <= TF_AXES; n++)
        for (int place = 50; place <= 70; place++)
            for (int i = 0; i < 200; i++) {
                matrix m = matrix_lattice(&random, n, 2);
                int j = below(&random, n), row = below(&random, n);
                m.to[row].x[m.axis[j]] = 2 * (1 - DBL_EPSILON / 2);
                m.from[row].x[m.axis[j]] =
                    ldexp(1 + 2 * below(&random, 1 << 20), -place);
                matrix_scale(&m, j, below(&random, 1900) - 950);
                ck_assert(judge(&m) == (place <= 61));
            }
}
END_TEST

START_TEST(the_least_unit_is_2_to_minus_1022)
{
    for (int exponent = -1074; exponent <= -1000; exponent++)
        for (int bits = 1; bits <= 53; bits++) {
            matrix m = matrix_of(1, (double[]){ldexp(1, exponent)});
            *matrix_coordinate(&m, 1) = -ldexp(ldexp(1, bits) - 1, exponent);
            ck_assert_msg(judge(&m) == (exponent >= -1022),
                          "%d bits from 2^%d on", bits, exponent);
        }
}
END_TEST

START_TEST(zeros_lie_on_every_grid)
{
    for (int n = 1; n <= TF_AXES; n++) {
        matrix m = matrix_of(n, (double[9]){0});
        for (int i = 0; i < matrix_size(&m); i++)
            *matrix_coordinate(&m, i) = i % 3 == 0 ? -0.0 : 0.0;
        ck_assert(judge(&m));
        for (int k = 0; k < n; k++)
            *matrix_coordinate(&m, 2 * k * (n + 1)) = k == 0 ? DBL_MAX : 3;
        ck_assert(judge(&m));
    }
}
END_TEST

START_TEST(a_coordinate_that_underflows_on_its_way_to_the_grid_is_not_on_it)
{
    matrix m = matrix_of(2, (double[]){DBL_MAX, 1, DBL_TRUE_MIN, 1});
    ck_assert(!judge(&m));
    *matrix_coordinate(&m, 4) = -0x1p-1000;
    ck_assert(!judge(&m));
}
END_TEST

// Several values --------------------------------------------------------------

static void expect_value(const tf_value *value, const tf_differences *d)
{
    tf_value alone;
    ck_assert(tf_fixed_value(d, &alone));
    ck_assert_msg(value->number == alone.number &&
                      value->exponent == alone.exponent && value->radius == 0,
                  "%a 2^%d, expected %a 2^%d, seed %llu", value->number,
                  value->exponent, alone.number, alone.exponent,
                  (unsigned long long)seed());
}

static bool fits(const tf_event event[], int count)
{
    matrix m = {.n = TF_AXES, .axis = {0, 1, 2}};
    for (int i = 0; i < 2 * TF_AXES; i++)
        (i < TF_AXES ? m.to : m.from)[i % TF_AXES] =
            event[i < count ? i : count - 1];
    return is_on_grid(&m);
}

START_TEST(six_values_and_signs_at_once_are_those_of_each_alone)
{
    generator random = generator_new(5);
    long count = cases(30000), on_grid = 0;
    for (long i = 0; i < count; i++) {
        six_events six =
            below(&random, 4) ? six_any(&random) : six_flat(&random);
        const tf_event *list[TF_SIX];
        six_list(&six, list);
        tf_value value[TF_SIX];
        tf_sign sign[TF_SIX], alone;
        bool found = tf_fixed_six(six.start_count, list, value);
        ck_assert(found == fits(six.event, TF_SIX));
        ck_assert(found == tf_fixed_six_signs(six.start_count, list, sign));
        on_grid += found;
        for (int j = 0; j < TF_SIX && found; j++) {
            tf_differences d = six_without(&six, j);
            expect_value(&value[j], &d);
            ck_assert(tf_fixed_sign(&d, &alone) && sign[j] == alone);
        }
    }
    ck_assert_msg(on_grid > count / 4 && on_grid < count - count / 4,
                  "%ld of %ld are on a grid", on_grid, count);
}
END_TEST

START_TEST(a_cross_product_has_the_minors)
{
    generator random = generator_new(6);
    long count = cases(30000), on_grid = 0;
    for (long i = 0; i < count; i++) {
        six_events six = six_any(&random);
        tf_event *event = six.event;
        int start = below(&random, 2);
        tf_differences rows = {.n = 2,
                               .to = {&event[1], &event[3]},
                               .from = {&event[0], &event[2 * start]}};
        if (start == 0)
            event[2] = event[0];
        tf_value component[TF_AXES];
        bool found = tf_fixed_cross(&rows, component);
        ck_assert(found == fits(event, 4));
        on_grid += found;
        for (int k = 0; k < TF_AXES && found; k++) {
            rows.axis[0] = (k + 1) % 3;
            rows.axis[1] = (k + 2) % 3;
            expect_value(&component[k], &rows);
        }
    }
    ck_assert_msg(on_grid > count / 4 && on_grid < count - count / 4,
                  "%ld of %ld are on a grid", on_grid, count);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("fixed");
    TCase *kinds = tcase_create("kinds");
    tcase_add_test(kinds, signs_and_values_are_exact_wherever_there_is_a_grid);
    tcase_add_test(kinds, signs_and_values_are_exact_for_columns_of_any_size);
    suite_add_tcase(suite, kinds);
    TCase *ends = tcase_create("ends");
    tcase_add_test(ends, the_largest_differences_have_exact_signs_and_values);
    tcase_add_test(ends, coordinates_of_62_bits_have_a_grid);
    tcase_add_test(ends, coordinates_beyond_62_bits_have_no_grid);
    tcase_add_test(ends, the_least_unit_is_2_to_minus_1022);
    tcase_add_test(ends, zeros_lie_on_every_grid);
    tcase_add_test(
        ends, a_coordinate_that_underflows_on_its_way_to_the_grid_is_not_on_it);
    suite_add_tcase(suite, ends);
    TCase *several = tcase_create("several values");
    tcase_add_test(several,
                   six_values_and_signs_at_once_are_those_of_each_alone);
    tcase_add_test(several, a_cross_product_has_the_minors);
    suite_add_tcase(suite, several);
    return suite;
}

#include "arithmetic/differences.h"
#include "support/matrices.h"
#include "support/rational.h"
#include "support/sums.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

// Rounded differences ---------------------------------------------------------

/// Whether a - b, exactly, is so large that rounding it to nearest overflows.
static bool overflows(const mpz_t difference)
{
    mpz_t limit;
    mpz_init(limit);
    sum_add(limit, DBL_MAX, 1, 1);
    sum_add(limit, 0x1p970, 1, 1); // half the last place of DBL_MAX
    bool beyond = mpz_cmpabs(difference, limit) >= 0;
    mpz_clear(limit);
    return beyond;
}

/// Whether `entry` is a - b rounded to nearest.
static bool rounds_to(double a, double b, double entry)
{
    mpz_t difference;
    mpz_init(difference);
    sum_add(difference, a, 1, 1);
    sum_add(difference, -b, 1, 1);
    bool right = overflows(difference)
                     ? entry == copysign(INFINITY, mpz_sgn(difference))
                     : rational_is(difference, SUM_EXPONENT,
                                   (tf_value){.number = entry});
    mpz_clear(difference);
    return right && (entry == 0) == (a == b);
}

static void judge(matrix *m)
{
    double entry[TF_AXES][TF_AXES];
    tf_differences differences = matrix_differences(m);
    tf_differences_round(&differences, entry);
    for (int i = 0; i < matrix_size(m); i += 2) {
        double a = *matrix_coordinate(m, i), b = *matrix_coordinate(m, i + 1);
        expect_of_matrix(rounds_to(a, b, entry[i / 2 / m->n][i / 2 % m->n]),
                         "An entry is not its difference rounded to nearest",
                         m);
    }
}

START_TEST(entries_are_rounded_to_nearest)
{
    generator random = generator_new(1);
    long count = cases(20000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_any(&random, 1 + below(&random, TF_AXES));
        matrix_nudge(&random, &m, below(&random, 3));
        judge(&m);
    }
}
END_TEST

START_TEST(differences_of_neighboring_doubles_are_not_zero)
{
    static const double sizes[] = {
        0,      -0.0,        DBL_TRUE_MIN, DBL_MIN,     0x1p-1022,  1,
        0x1p53, DBL_MAX / 2, -DBL_MIN,     -0x1.8p1023, -0x1p-1073, DBL_MAX};
    generator random = generator_new(2);
    for (int i = 0; i < (int)(sizeof sizes / sizeof *sizes); i++)
        for (int steps = -2; steps <= 2; steps++) {
            matrix m = matrix_new(&random, 1);
            double *to = matrix_coordinate(&m, 0);
            *to = *matrix_coordinate(&m, 1) = sizes[i];
            for (int k = 0; k < abs(steps); k++)
                *to = nextafter(*to, steps > 0 ? DBL_MAX : -DBL_MAX);
            judge(&m);
        }
}
END_TEST

START_TEST(differences_overflow_to_infinity)
{
    // The last but one is the least that overflows: a tie, rounded to even.
    static const struct {
        double a, b, entry;
    } edge[] = {{DBL_MAX, -DBL_MAX, INFINITY},
                {-DBL_MAX, DBL_MAX, -INFINITY},
                {DBL_MAX, DBL_MAX, 0},
                {0x1p1023, -0x1p1023, INFINITY},
                {DBL_MAX, -0x1p970, INFINITY},
                {DBL_MAX, -0x1.fffffffffffffp969, DBL_MAX}};
    generator random = generator_new(3);
    for (int i = 0; i < (int)(sizeof edge / sizeof *edge); i++) {
        matrix m = matrix_new(&random, 1);
        *matrix_coordinate(&m, 0) = edge[i].a;
        *matrix_coordinate(&m, 1) = edge[i].b;
        judge(&m);

        double entry[TF_AXES][TF_AXES];
        tf_differences differences = matrix_differences(&m);
        tf_differences_round(&differences, entry);
        ck_assert_msg(entry[0][0] == edge[i].entry, "%a - %a: %a, not %a",
                      edge[i].a, edge[i].b, entry[0][0], edge[i].entry);
    }
}
END_TEST

START_TEST(rows_are_events_and_columns_axes)
{
    const tf_event a = {.x = {1, 20, 300}}, b = {.x = {4, 50, 600}};
    const tf_event origin = {.x = {0, 0, 0}, .t = 1};
    tf_differences differences = {
        .n = 2, .to = {&a, &origin}, .from = {&b, &a}, .axis = {2, 0}};
    double entry[TF_AXES][TF_AXES] = {{0}};
    tf_differences_round(&differences, entry);
    static const double expected[TF_AXES][TF_AXES] = {{-300, -3}, {-300, -1}};
    for (int i = 0; i < TF_AXES; i++)
        for (int j = 0; j < TF_AXES; j++)
            ck_assert_msg(entry[i][j] == expected[i][j],
                          "Entry (%d, %d) is %a, not %a", i, j, entry[i][j],
                          expected[i][j]);
}
END_TEST

Suite *suite(void)
{
    Suite *differences = suite_create("differences");
    TCase *entries = tcase_create("rounded entries");
    tcase_add_test(entries, entries_are_rounded_to_nearest);
    tcase_add_test(entries, differences_of_neighboring_doubles_are_not_zero);
    tcase_add_test(entries, differences_overflow_to_infinity);
    tcase_add_test(entries, rows_are_events_and_columns_axes);
    suite_add_tcase(differences, entries);
    return differences;
}

// Nearest points, against distances in rational numbers.
#include "distance/nearest.h"

#include "support/exact_distance.h"
#include "support/rest_pairs.h"
#include "support/support.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

/// Whether the bounds enclose the distance: a length of 0 bounds none from above,
/// and an infinite one all.
static void expect_enclosed(const rest_pair *pair, const tf_nearest *found)
{
    bool low = exact_distance_compare(pair->kind, pair->x, found->lower) >= 0;
    bool high = isinf(found->upper) ||
                exact_distance_compare(pair->kind, pair->x, found->upper) <= 0;
    ck_assert_msg(low && high, "seed %llu, %s, not from %a to %a",
                  (unsigned long long)seed(), rest_pair_text(pair),
                  found->lower, found->upper);
}

static void expect_narrow(const rest_pair *pair, const tf_nearest *found)
{
    double high = found->lower;
    for (int i = 0; i < 10 && high > 0; i++)
        high = nextafter(high, INFINITY);
    if (found->lower == 0 && found->upper != 0)
        high = 2 * DBL_TRUE_MIN;
    ck_assert_msg(found->upper <= high, "seed %llu, %s, from %a to %a",
                  (unsigned long long)seed(), rest_pair_text(pair),
                  found->lower, found->upper);
}

START_TEST(bounds_enclose_the_distance_and_are_narrow)
{
    generator random = generator_new((uint64_t)_i);
    for (long i = cases(_i == 6 ? 80 : 500); i > 0; i--) {
        rest_pair pair;
        rest_pair_make(&random, _i, &pair);
        tf_nearest found = tf_nearest_of(pair.kind, pair.x);
        expect_enclosed(&pair, &found);
        expect_narrow(&pair, &found);
    }
}
END_TEST

/// The length of the vector between the two points that were found.
static double length_between(const rest_pair *pair, const tf_nearest *found,
                             double *size)
{
    int axes = pair->kind == TF_POINT_EDGE ? 2 : 3;
    int first = pair->kind == TF_EDGE_EDGE ? 2 : 1;
    double square = 0;
    *size = 0;
    for (int k = 0; k < axes; k++) {
        double sum = 0;
        for (int i = 0; i <= axes; i++) {
            sum += i < first
                       ? found->barycentric[0][i] * pair->x[i][k]
                       : -found->barycentric[1][i - first] * pair->x[i][k];
            *size = fmax(*size, fabs(pair->x[i][k]));
        }
        square += sum * sum;
    }
    return sqrt(square);
}

START_TEST(points_are_at_the_distance)
{
    generator random = generator_new(200 + (uint64_t)_i);
    for (long i = cases(2000); i > 0; i--) {
        rest_pair pair;
        rest_pair_make(&random, _i, &pair);
        tf_nearest found = tf_nearest_of(pair.kind, pair.x);
        double size, length = length_between(&pair, &found, &size);
        ck_assert_msg(fabs(length - found.lower) <= 0x1p-49 * size,
                      "seed %llu, %s, %a is not %a", (unsigned long long)seed(),
                      rest_pair_text(&pair), length, found.lower);
        for (int j = 0; j < 2; j++) {
            double sum = 0;
            for (int k = 0; k < 3; k++) {
                ck_assert(found.barycentric[j][k] >= 0);
                sum += found.barycentric[j][k];
            }
            ck_assert_double_eq_tol(sum, 1, 0x1p-50);
        }
    }
}
END_TEST

START_TEST(elements_that_touch_have_distance_zero)
{
    static const double at[] = {0, 0, 0, 1, 1, 1, -1, -1, 1, 0, 0, -5};
    const double *x[] = {at, at + 3, at + 6, at + 9};
    tf_nearest found = tf_nearest_of(TF_POINT_TRIANGLE, x);
    ck_assert(found.lower == 0 && found.upper == 0);
    const double *edges[] = {at, at + 3, at, at + 6};
    found = tf_nearest_of(TF_EDGE_EDGE, edges);
    ck_assert(found.lower == 0 && found.upper == 0);
    const double *origin[] = {at, at, at};
    found = tf_nearest_of(TF_POINT_EDGE, origin);
    ck_assert(found.lower == 0 && found.upper == 0);
}
END_TEST

START_TEST(a_distance_beyond_all_doubles_is_at_least_the_largest)
{
    static const double at[] = {DBL_MAX,  DBL_MAX,  -DBL_MAX,
                                -DBL_MAX, -DBL_MAX, -DBL_MAX};
    const double *x[] = {at, at + 2, at + 4};
    tf_nearest found = tf_nearest_of(TF_POINT_EDGE, x);
    ck_assert(found.lower == DBL_MAX && isinf(found.upper));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("distance/nearest");
    TCase *tcase = tcase_create("nearest");
    tcase_add_loop_test(tcase, bounds_enclose_the_distance_and_are_narrow, 0,
                        REST_FAMILIES);
    tcase_add_loop_test(tcase, points_are_at_the_distance, 0, 4);
    tcase_add_test(tcase, elements_that_touch_have_distance_zero);
    tcase_add_test(tcase,
                   a_distance_beyond_all_doubles_is_at_least_the_largest);
    suite_add_tcase(suite, tcase);
    return suite;
}

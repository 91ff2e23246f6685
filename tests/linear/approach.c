#include "linear/approach.h"

#include "support/support.h"

#include <float.h>
#include <math.h>

// A point falls toward an edge along the second axis, as a table tells.

typedef struct fall {
    double height, speed, claimed;
} fall;

static void positions(const void *motion, double time, tf_vector x[])
{
    const fall *f = motion;
    x[0] = (tf_vector){{0, f->height - f->speed * time, 0}};
    x[1] = (tf_vector){{-1, 0, 0}};
    x[2] = (tf_vector){{1, 0, 0}};
}

static double speed(const void *motion, double time, const tf_vector x[],
                    const tf_point_pair *nearest)
{
    (void)time;
    (void)x;
    (void)nearest;
    return ((const fall *)motion)->claimed;
}

static tf_advancement advance(tf_advance_limits limits, fall f)
{
    tf_approach approach = {.motion = &f,
                            .vertices = 1,
                            .others = 2,
                            .positions = positions,
                            .speed = speed};
    return tf_advance(&limits, &approach);
}

START_TEST(a_true_bound_needs_one_step)
{
    tf_advancement at =
        advance((tf_advance_limits){.threshold = 0.25}, (fall){1, 2, 2});
    ck_assert_int_eq(at.verdict, TF_HIT);
    ck_assert_int_eq(at.steps, 1);
    ck_assert_double_eq(at.time, 0.4375); // half the threshold is left
    ck_assert_double_eq(at.distance, 0.125);
    ck_assert_double_eq(at.barycentric[0][0], 1);
    ck_assert_double_eq(at.barycentric[1][0], 0.5);
}
END_TEST

START_TEST(a_loose_bound_needs_more_steps)
{
    int last = 1;
    for (double threshold = 0.1; threshold > 1e-12; threshold /= 10) {
        tf_advancement at = advance((tf_advance_limits){.threshold = threshold},
                                    (fall){1, 2, 4});
        ck_assert_int_eq(at.verdict, TF_HIT);
        ck_assert_int_gt(at.steps, last);
        ck_assert_double_lt(at.time, 0.5);
        ck_assert_double_gt(at.time, 0.5 - threshold / 2);
        last = at.steps;
    }
}
END_TEST

START_TEST(a_fraction_of_the_distance_is_the_target)
{
    tf_advancement at =
        advance((tf_advance_limits){.fraction = 0.5}, (fall){1, 2, 2});
    ck_assert_int_eq(at.verdict, TF_HIT);
    ck_assert_double_eq(at.distance, 0.25);
    at = advance((tf_advance_limits){.fraction = 0.5, .threshold = 2},
                 (fall){1, 2, 2});
    ck_assert_int_eq(at.steps, 0);
    ck_assert_int_eq(at.verdict, TF_HIT);
}
END_TEST

START_TEST(elements_that_never_come_near_are_apart)
{
    tf_advance_limits limits = {.threshold = 0.01};
    tf_advancement at = advance(limits, (fall){1, 0.5, 0.5});
    ck_assert_int_eq(at.verdict, TF_APART);
    ck_assert_double_eq(at.time, 1);
    ck_assert_double_eq(at.distance, 0.5);
    ck_assert_int_eq(advance(limits, (fall){1, 0, 0}).verdict, TF_APART);
    ck_assert_int_eq(advance(limits, (fall){1, -1, -1}).verdict, TF_APART);
}
END_TEST

START_TEST(the_limit_of_steps_is_kept)
{
    tf_advance_limits limits = {.threshold = 1e-9, .steps = 3};
    tf_advancement at = advance(limits, (fall){1, 2, 4});
    ck_assert_int_eq(at.verdict, TF_UNDECIDED);
    ck_assert_int_eq(at.steps, 3);
    ck_assert_double_lt(at.time, 0.5);
    limits.steps = 0; // 10,000
    at = advance(limits, (fall){1, 1.5, 1e9});
    ck_assert_int_eq(at.verdict, TF_UNDECIDED);
    ck_assert_int_eq(at.steps, 10000);
}
END_TEST

START_TEST(advancement_ends_when_a_step_adds_nothing_to_the_time)
{
    // No target: the distance halves until a step changes no time.
    for (int i = 1; i < 100; i++) {
        double speed = 1 + i / 128.0;
        tf_advancement at =
            advance((tf_advance_limits){0}, (fall){0.1, speed, 2 * speed});
        ck_assert_int_ne(at.verdict, TF_APART);
        ck_assert_int_lt(at.steps, 200);
        ck_assert_double_le(at.time, 0.1 / speed * (1 + 1e-15));
    }
}
END_TEST

START_TEST(overflow_is_undecided)
{
    tf_advance_limits limits = {.threshold = 1};
    tf_advancement at = advance(limits, (fall){1e200, 1, 1});
    ck_assert_int_eq(at.verdict, TF_UNDECIDED);
    ck_assert_double_eq(at.distance, DBL_MAX);
    ck_assert_int_eq(advance(limits, (fall){2, 1, INFINITY}).verdict,
                     TF_UNDECIDED);
    ck_assert_int_eq(advance(limits, (fall){2, 1, NAN}).verdict, TF_UNDECIDED);
}
END_TEST

START_TEST(limits_out_of_range_are_invalid)
{
    static const tf_advance_limits bad[] = {
        {.threshold = -1}, {.threshold = NAN}, {.threshold = INFINITY},
        {.fraction = -1},  {.fraction = 1},    {.fraction = NAN},
        {.steps = -1},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        ck_assert(!tf_advance_limits_valid(&bad[i]));
    ck_assert(tf_advance_limits_valid(&(tf_advance_limits){0}));
    ck_assert(tf_advance_limits_valid(&(tf_advance_limits){1e-6, 0.1, 1000}));
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("linear/approach");
    TCase *c = tcase_create("steps");
    tcase_add_test(c, a_true_bound_needs_one_step);
    tcase_add_test(c, a_loose_bound_needs_more_steps);
    tcase_add_test(c, a_fraction_of_the_distance_is_the_target);
    tcase_add_test(c, elements_that_never_come_near_are_apart);
    tcase_add_test(c, the_limit_of_steps_is_kept);
    tcase_add_test(c, advancement_ends_when_a_step_adds_nothing_to_the_time);
    tcase_add_test(c, overflow_is_undecided);
    tcase_add_test(c, limits_out_of_range_are_invalid);
    suite_add_tcase(s, c);
    return s;
}

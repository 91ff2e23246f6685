#include "check.h"

void position_at(int axes, const tf_worldline *line, double t,
                 double position[]);

enum {
    UNTOUCHED = 99 // what is in the position before the call
};

static void expect(int axes, const tf_worldline *line, double t,
                   const double expected[])
{
    double got[TF_AXES] = {UNTOUCHED, UNTOUCHED, UNTOUCHED};
    check_input("the worldline %s, t = %s, axes = %d", text_line(axes, line),
                text_real(t), axes);
    check_call(got, position_at(axes, line, t, got));
    check_point(axes, expected, got, 0);
    for (int k = axes; k < TF_AXES; k++)
        check_that(got[k] == UNTOUCHED, "a position of axes coordinates",
                   "position[%d] = %s", k, text_real(got[k]));
}

TEST(is_halfway_at_half_time)
{
    tf_worldline line =
        tf_worldline_between(2, (double[]){1, 2}, (double[]){3, -4});
    expect(2, &line, 0.5, (double[]){2, -1});
}

TEST(goes_a_quarter_of_the_way_in_space)
{
    tf_worldline line =
        tf_worldline_between(3, (double[]){4, 0, -8}, (double[]){0, 8, 0});
    expect(3, &line, 0.25, (double[]){3, 2, -6});
}

TEST(rests_if_it_does_not_move)
{
    tf_worldline line =
        tf_worldline_between(2, (double[]){5, 6}, (double[]){5, 6});
    expect(2, &line, 0.75, (double[]){5, 6});
}

TEST(starts_and_ends_to_the_last_bit)
{
    static const double start[] = {0.1, 1e16, -0.7}, end[] = {0.7, 1, 1e-9};
    tf_worldline line = tf_worldline_between(3, start, end);
    expect(3, &line, 0, start);
    expect(3, &line, 1, end);
}

void run_tests(void)
{
    check_run(1, is_halfway_at_half_time);
    check_run(1, goes_a_quarter_of_the_way_in_space);
    check_run(1, rests_if_it_does_not_move);
    check_run(1, starts_and_ends_to_the_last_bit);
}

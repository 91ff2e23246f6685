#include "renderer/box.h"

#include "support/support.h"

static const fig_box box = {10, 20, 8, 4};

START_TEST(the_overlap_of_boxes_is_an_area)
{
    fig_box a = {0, 0, 10, 10}, b = {8, 7, 10, 10}, c = {10, 0, 5, 5};
    ck_assert_double_eq(fig_box_overlap(&a, &b), 6);
    ck_assert_double_eq(fig_box_overlap(&a, &c), 0);
    ck_assert_double_eq(fig_box_overlap(&a, &a), 100);
}
END_TEST

/// A segment, and by hand what of it is in the box: nothing if from > to.
static const struct {
    fig_point from, to;
    double part[2];
} segments[] = {
    {{12, 21}, {16, 23}, {0, 1}},           // inside
    {{6, 22}, {22, 22}, {0.25, 0.75}},      // all across
    {{22, 22}, {6, 22}, {0.25, 0.75}},      // backwards
    {{14, 22}, {14, 26}, {0, 0.5}},         // out below
    {{14, 16}, {14, 22}, {2. / 3, 1}},      // in from above
    {{6, 18}, {22, 26}, {0.25, 0.75}},      // from corner to corner
    {{6, 24}, {12, 18}, {2. / 3, 2. / 3}},  // a corner only
    {{10, 16}, {10, 28}, {1. / 3, 2. / 3}}, // along the border
    {{14, 22}, {14, 22}, {0, 1}},           // a point inside
    {{9, 22}, {9, 23}, {1, 0}},             // beside the box
    {{14, 25}, {18, 25}, {1, 0}},           // below it
    {{9, 21}, {9, 21}, {1, 0}},             // a point outside
    {{0, 22}, {9, 22}, {1, 0}},             // ends before the box
    {{6, 22}, {12, 16}, {1, 0}},            // past a corner
};

START_TEST(segments_are_clipped)
{
    const double *expected = segments[_i].part;
    double part[2];
    bool left = fig_box_clip(&box, segments[_i].from, segments[_i].to, part);
    ck_assert_int_eq(left, expected[0] <= expected[1]);
    for (int i = 0; left && i < 2; i++)
        ck_assert_msg(part[i] == expected[i], "end %d is at %.17g, not %.17g",
                      i, part[i], expected[i]);
}
END_TEST

Suite *suite(void)
{
    Suite *made = suite_create("renderer/box");
    TCase *tests = tcase_create("box");
    suite_add_tcase(made, tests);
    tcase_add_test(tests, the_overlap_of_boxes_is_an_area);
    tcase_add_loop_test(tests, segments_are_clipped, 0,
                        sizeof segments / sizeof *segments);
    return made;
}

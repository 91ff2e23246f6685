#include "kit/worlds.h"

#include "support/support.h"

static void expect_place(tf_vector place, double x, double y, double z)
{
    double expected[3] = {x, y, z};
    for (int k = 0; k < 3; k++)
        ck_assert_msg(place.x[k] == expected[k], "axis %d: %.17g, not %.17g", k,
                      place.x[k], expected[k]);
}

START_TEST(edge_has_its_crease_on_the_way_between)
{
    tf_worldline edge[2] = {
        tf_worldline_between(2, (double[]){0, 4}, (double[]){8, 0}),
        tf_worldline_between(2, (double[]){4, 4}, (double[]){8, 8})};
    tf_vector world[3];
    fig_world_of_edge(edge, 0.25, world);
    expect_place(world[0], 2, 3, 0.25);
    expect_place(world[1], 2, 5, 0.25);
    expect_place(world[2], 5, 5, 0.25);
}
END_TEST

START_TEST(contacts_are_in_the_middle_of_their_intervals)
{
    tf_contact contact = {.verdict = TF_HIT, .toi_lo = 0.25, .toi_hi = 0.75};
    ck_assert_double_eq(fig_toi(&contact), 0.5);
    contact.verdict = TF_APART;
    ck_assert_double_eq(fig_toi(&contact), -1);
}
END_TEST

START_TEST(slices_go_around_with_the_triangle)
{
    // The triangle grows from half its size to all of it.
    tf_worldline triangle[3] = {
        tf_worldline_between(3, (double[]){0, 0, 0}, (double[]){0, 0, 4}),
        tf_worldline_between(3, (double[]){4, 0, 0}, (double[]){8, 0, 4}),
        tf_worldline_between(3, (double[]){0, 4, 0}, (double[]){0, 8, 4})};
    tf_simplex sweep[3];
    tf_sweep(3, triangle, sweep);
    fig_slice first = fig_slice_of(&sweep[0], 3, 0.5);
    fig_slice middle = fig_slice_of(&sweep[1], 3, 0.5);
    fig_slice last = fig_slice_of(&sweep[2], 3, 0.5);
    ck_assert_int_eq(first.count, 3);
    expect_place(first.corner[0], 0, 4, 2);
    expect_place(first.corner[1], 2, 4, 2);
    expect_place(first.corner[2], 0, 6, 2);
    ck_assert_int_eq(middle.count, 4);
    expect_place(middle.corner[0], 4, 0, 2);
    expect_place(middle.corner[1], 6, 0, 2);
    expect_place(middle.corner[2], 2, 4, 2);
    expect_place(middle.corner[3], 0, 4, 2);
    ck_assert_int_eq(last.count, 3);
    expect_place(last.corner[0], 0, 0, 2);
    expect_place(last.corner[1], 4, 0, 2);
    expect_place(last.corner[2], 0, 4, 2);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("kit/worlds");
    TCase *worlds = tcase_create("worlds");
    tcase_add_test(worlds, edge_has_its_crease_on_the_way_between);
    tcase_add_test(worlds, contacts_are_in_the_middle_of_their_intervals);
    tcase_add_test(worlds, slices_go_around_with_the_triangle);
    suite_add_tcase(s, worlds);
    return s;
}

// Parts are moved apart.
#include "untangle/apart.h"

#include "support/support.h"
#include "support/tangles.h"

#include <math.h>
#include <string.h>

static made_tangle own;
static double x[3 * TANGLE_VERTICES];
static bool moved;

static void move_apart(void)
{
    tangle_finish(&own);
    memcpy(x, own.x, sizeof x);
    ck_assert(tf_move_apart(&own.tangle, x, &moved));
}

static size_t crossings_after(void)
{
    ck_assert_int_eq(tf_tangle_check(&own.tangle, x), TF_OK);
    return own.tangle.crossings.count;
}

static void add_box(double side, double from, double off)
{
    int first = own.mesh.vertices;
    for (int i = 0; i < 8; i++) {
        double place[3] = {from + (i & 1) * side, off + (i >> 1 & 1) * side,
                           off + (i >> 2) * side};
        tangle_add(&own, 1, place);
    }
    static const int corner[12][3] = {
        {0, 1, 3}, {0, 3, 2}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
        {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 3, 7}, {1, 7, 5}};
    for (int t = 0; t < 12; t++)
        tangle_add_triangle(&own, first + corner[t][0], first + corner[t][1],
                            first + corner[t][2]);
}

START_TEST(the_smaller_part_moves)
{
    tangle_make_bump(&own, 3);
    tangle_add_sheet(&own, 3, (double[]){1, 0, 0}, (double[]){0, 0.1, 1},
                     (double[]){-1.3, 0.4, -1.2});
    move_apart();
    ck_assert(moved);
    ck_assert_uint_eq(crossings_after(), 0);
    ck_assert_mem_eq(x, own.x, 3 * 169 * sizeof *x);
    // A part moves as a whole.
    for (int v = 339; v < own.mesh.vertices; v++)
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(x[3 * v + k] - own.x[3 * v + k],
                                    x[3 * 338 + k] - own.x[3 * 338 + k], 1e-14);
    tangle_free(&own);
}
END_TEST

START_TEST(a_part_with_fixed_vertices_stays)
{
    tangle_begin(&own, 3);
    add_box(4, 0, 0);
    add_box(1, 3.5, 1);
    own.fixed[9] = true;
    move_apart();
    ck_assert(moved);
    ck_assert_uint_eq(crossings_after(), 0);
    ck_assert_mem_eq(x + 24, own.x + 24, 24 * sizeof *x);
    ck_assert_double_ne(x[0], own.x[0]);
    tangle_free(&own);
}
END_TEST

// Half a unit of the small box is inside the large one, and half is outside: it
// goes either way, along x.
START_TEST(the_translation_is_about_the_least)
{
    tangle_begin(&own, 3);
    add_box(4, 0, 0);
    add_box(1, 3.5, 1.25);
    move_apart();
    tf_vector way = tf_vector_difference(tf_place(&own.tangle.near, x, 8),
                                         tf_place(&own.tangle.near, own.x, 8));
    ck_assert_double_ge(fabs(way.x[0]), 0.5);
    ck_assert_double_le(tf_vector_length(way), 0.6);
    tangle_free(&own);
}
END_TEST

START_TEST(clear_parts_stay)
{
    tangle_begin(&own, 3);
    add_box(4, 0, 0);
    add_box(1, 4.5, 1);
    move_apart();
    ck_assert(!moved);
    ck_assert_mem_eq(x, own.x, sizeof x);
    tangle_free(&own);
}
END_TEST

START_TEST(one_part_stays)
{
    tangle_begin(&own, 3);
    add_box(4, 0, 0);
    tangle_add_triangle(&own, 0, 5, 6);
    move_apart();
    ck_assert(!moved);
    tangle_free(&own);
}
END_TEST

START_TEST(many_boxes_are_freed_of_each_other)
{
    tangle_begin(&own, 3);
    for (int i = 0; i < 20; i++)
        add_box(1, 0.01 * i, 0.02 * i);
    move_apart();
    ck_assert(moved);
    ck_assert_uint_eq(crossings_after(), 0);
    tangle_free(&own);
}
END_TEST

START_TEST(curves_in_the_plane_move_apart)
{
    tangle_begin(&own, 2);
    for (int i = 0; i < 2; i++) {
        double a = 0.75 * i;
        int first = tangle_add(
            &own, 4, (double[]){a, a, a + 1, a, a + 1, a + 1, a, a + 1});
        for (int j = 0; j < 4; j++)
            tangle_add_edge(&own, first + j, first + (j + 1) % 4);
    }
    move_apart();
    ck_assert(moved);
    ck_assert_uint_eq(crossings_after(), 0);
    tangle_free(&own);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/apart");
    TCase *tcase = tcase_create("apart");
    tcase_add_test(tcase, the_smaller_part_moves);
    tcase_add_test(tcase, a_part_with_fixed_vertices_stays);
    tcase_add_test(tcase, the_translation_is_about_the_least);
    tcase_add_test(tcase, clear_parts_stay);
    tcase_add_test(tcase, one_part_stays);
    tcase_add_test(tcase, many_boxes_are_freed_of_each_other);
    tcase_add_test(tcase, curves_in_the_plane_move_apart);
    suite_add_tcase(suite, tcase);
    return suite;
}

// Where the policy that keeps the shape puts vertices.
#include "remesh/keep_shape.h"

#include "support/adaptive_surfaces.h"
#include "support/remeshers.h"
#include "support/support.h"
#include "surgery/star.h"

static tf_remesher *made;

/// A sheet whose middle has been lifted since it was copied.
static void begin(void)
{
    static const double lifted[] = {1, 1, 0.75};
    made = remesher_begin(adaptive_sheet(2, 2), &tf_keep_shape, 0.5);
    tf_vertex_put(made->surface, 4, lifted);
}

static void end(void)
{
    remesher_end(made);
}

/// How high the edge of two vertices is split.
static double height_of_split(int a, int b)
{
    tf_vector position;
    tf_volume_error error = {0};
    int corner = tf_find_edge(made->surface, a, b);
    ck_assert(tf_keep_shape.choose_split(made, corner, 0, &position, &error));
    ck_assert_int_eq(error.count, 0);
    return position.x[2];
}

START_TEST(edges_are_split_on_the_original_if_it_is_near)
{
    ck_assert_double_eq(height_of_split(0, 4), 0);
    made->edge = 0.3;
    ck_assert_double_eq(height_of_split(0, 4), 0.375);
}
END_TEST

START_TEST(sharp_edges_are_split_in_the_middle)
{
    static const double low[] = {0, 0, -1};
    tf_vertex_put(made->surface, 0, low);
    made->edge = 2;
    ck_assert_double_eq(height_of_split(0, 1), -0.5);
}
END_TEST

START_TEST(a_split_that_was_refused_is_not_tried_elsewhere)
{
    tf_vector position;
    tf_volume_error error;
    int corner = tf_find_edge(made->surface, 0, 4);
    ck_assert(!tf_keep_shape.choose_split(made, corner, 1, &position, &error));
}
END_TEST

START_TEST(free_vertices_move_on_the_original)
{
    tf_vector position;
    ck_assert(tf_keep_shape.choose_move(made, 4, &position));
    ck_assert_double_eq(position.x[2], 0);
    for (int v = 0; v < 9; v++)
        if (v != 4)
            ck_assert(!tf_keep_shape.choose_move(made, v, &position));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/keep_shape");
    TCase *tcase = tcase_create("positions");
    tcase_add_checked_fixture(tcase, begin, end);
    tcase_add_test(tcase, edges_are_split_on_the_original_if_it_is_near);
    tcase_add_test(tcase, sharp_edges_are_split_in_the_middle);
    tcase_add_test(tcase, a_split_that_was_refused_is_not_tried_elsewhere);
    tcase_add_test(tcase, free_vertices_move_on_the_original);
    suite_add_tcase(suite, tcase);
    return suite;
}

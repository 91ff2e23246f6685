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

/// Whether the vertex 1 of a new sheet slides along a side that goes from
/// (0, 0, 0) by there to an end; `position` is where to.  Corners stay.
static bool slides(const double at[3], const double to[3], tf_vector *position)
{
    static const int corner[] = {0, 2, 6, 8};
    tf_adaptive_surface *sheet = adaptive_sheet(2, 2);
    tf_vertex_put(sheet, 1, at);
    tf_vertex_put(sheet, 2, to);
    end();
    made = remesher_begin(sheet, &tf_keep_shape, 0.5);
    ck_assert_int_eq(tf_freedom_of(&made->sharp, 1), TF_ALONG_SHARP_EDGE);
    ck_assert(
        tf_trace_begin(&made->trace, &made->original, &made->sharp_before));
    for (int i = 0; i < 4; i++)
        ck_assert(!tf_keep_shape.choose_move(made, corner[i], position));
    return tf_keep_shape.choose_move(made, 1, position);
}

START_TEST(vertices_slide_along_sharp_edges)
{
    static const double end[] = {2, 0, 0}, far[] = {8, 0, 0};
    static const double early[] = {0.5, 0, 0}, late[] = {1.75, 0, 0};
    static const double slight[] = {1, 0, 0.03125};
    tf_vector position;
    ck_assert(slides(early, end, &position));
    ck_assert_double_eq(position.x[0], 1);
    ck_assert(slides(late, end, &position));
    ck_assert_double_eq(position.x[0], 1);
    // To the original's edge, which is bent a little.
    ck_assert(slides(slight, far, &position));
    ck_assert_double_eq_tol(position.x[0], 4, 0.01);
    ck_assert_double_eq_tol(position.x[2], 0.03125 * (8 - position.x[0]) / 7,
                            1e-15);
}
END_TEST

START_TEST(no_vertex_slides_off_a_bend)
{
    static const double bend[] = {1, -0.2, 0}, far[] = {4, 0, 0};
    tf_vector position;
    ck_assert(!slides(bend, far, &position));
}
END_TEST

START_TEST(vertices_slide_to_where_lengths_fit)
{
    static const double want[] = {1, 1, 3, 1, 1, 1, 1, 1, 1};
    tf_vector position;
    ck_assert(
        tf_trace_begin(&made->trace, &made->original, &made->sharp_before));
    made->target = want;
    ck_assert(tf_keep_shape.choose_move(made, 1, &position));
    // 1 to 2, like the mean lengths at their ends.
    ck_assert_double_eq_tol(position.x[0], 2.0 / 3, 1e-15);
    ck_assert_double_eq(position.x[1], 0);
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
    tcase_add_test(tcase, vertices_slide_along_sharp_edges);
    tcase_add_test(tcase, no_vertex_slides_off_a_bend);
    tcase_add_test(tcase, vertices_slide_to_where_lengths_fit);
    suite_add_tcase(suite, tcase);
    return suite;
}

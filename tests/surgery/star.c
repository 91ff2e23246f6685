// The stars of vertices, on a sheet of four squares:
//
//     6 - 7 - 8
//     | / | / |
//     3 - 4 - 5
//     | / | / |
//     0 - 1 - 2
#include "surgery/star.h"

#include "support/adaptive_surfaces.h"
#include "support/support.h"

static tf_adaptive_surface *sheet;

static void begin(void)
{
    sheet = adaptive_sheet(2, 2);
}

static void end(void)
{
    tf_adaptive_free(sheet);
}

START_TEST(edges_are_found_in_their_direction)
{
    int corner = tf_find_edge(sheet, 0, 1);
    ck_assert_int_ne(corner, TF_NONE);
    ck_assert_int_eq(tf_vertex_at(sheet, corner), 0);
    ck_assert_int_eq(tf_vertex_at(sheet, tf_corner_after(corner)), 1);
    ck_assert_int_eq(tf_vertex_at(sheet, tf_corner_before(corner)), 4);
    ck_assert_int_eq(tf_find_edge(sheet, 1, 0), TF_NONE);
    ck_assert_int_ne(tf_find_edge(sheet, 4, 0), TF_NONE);
    ck_assert_int_ne(tf_find_edge(sheet, 0, 4), TF_NONE);
    ck_assert_int_eq(tf_find_edge(sheet, 1, 3), TF_NONE);
    ck_assert(tf_is_boundary_edge(sheet, corner));
    ck_assert(!tf_is_boundary_edge(sheet, tf_find_edge(sheet, 0, 4)));
}
END_TEST

START_TEST(triangles_and_neighbors_are_counted)
{
    static const int size[] = {2, 3, 1, 3, 6, 3, 1, 3, 2};
    for (int v = 0; v < 9; v++) {
        ck_assert_int_eq(tf_star_size(sheet, v), size[v]);
        ck_assert(tf_is_boundary_vertex(sheet, v) == (v != 4));
    }
    ck_assert_int_eq(tf_common_neighbors(sheet, 0, 1), 1);
    ck_assert_int_eq(tf_common_neighbors(sheet, 1, 0), 1);
    ck_assert_int_eq(tf_common_neighbors(sheet, 0, 4), 2);
    ck_assert_int_eq(tf_common_neighbors(sheet, 4, 0), 2);
    ck_assert_int_eq(tf_common_neighbors(sheet, 3, 1), 2);
    ck_assert_int_eq(tf_common_neighbors(sheet, 2, 6), 0);
}
END_TEST

START_TEST(triangles_come_and_go)
{
    int corner = tf_find_edge(sheet, 1, 2), found[8];
    const int vertex[] = {1, 2, 5};
    tf_aabb box = tf_aabb_of(sheet, 3, vertex);
    int gone = corner / 3,
        count = tf_dynamic_tree_find(&sheet->tree, &box, found);
    tf_triangle_remove(sheet, gone);
    ck_assert(!tf_is_triangle(sheet, gone));
    ck_assert_int_eq(tf_first_corner(sheet, 2), TF_NONE);
    ck_assert_int_eq(tf_star_size(sheet, 5), 2);
    ck_assert_int_eq(tf_dynamic_tree_find(&sheet->tree, &box, found),
                     count - 1);
    ck_assert_int_eq(tf_triangle_add(sheet, vertex), gone);
    ck_assert_int_eq(tf_star_size(sheet, 5), 3);
    ck_assert_int_eq(tf_dynamic_tree_find(&sheet->tree, &box, found), count);
}
END_TEST

START_TEST(an_isolated_triangle_has_no_neighbor)
{
    static double position[][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    static const int triangle[] = {0, 1, 2};
    tf_adaptive_surface *single = adaptive_of(3, position, 1, triangle);
    ck_assert(tf_is_isolated(single, 0));
    for (int t = 0; t < 8; t++)
        ck_assert(!tf_is_isolated(sheet, t));
    tf_adaptive_free(single);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surgery/star");
    TCase *tcase = tcase_create("stars");
    tcase_add_checked_fixture(tcase, begin, end);
    tcase_add_test(tcase, edges_are_found_in_their_direction);
    tcase_add_test(tcase, triangles_and_neighbors_are_counted);
    tcase_add_test(tcase, triangles_come_and_go);
    tcase_add_test(tcase, an_isolated_triangle_has_no_neighbor);
    suite_add_tcase(suite, tcase);
    return suite;
}

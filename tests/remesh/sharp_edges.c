// Sharp edges, on a box of 2 x 2 x 1 squares and on a sheet.
#include "remesh/sharp_edges.h"

#include "support/adaptive_scenes.h"
#include "support/adaptive_surfaces.h"
#include "support/support.h"
#include "surgery/star.h"

#include <stdlib.h>

static adaptive_scene scene;

static tf_adaptive_surface *box(void)
{
    static const int low[] = {0, 0, 0}, high[] = {2, 2, 2};
    scene = (adaptive_scene){0};
    add_box(&scene, low, high);
    tf_mesh mesh = adaptive_scene_mesh(&scene);
    tf_adaptive_surface *made = NULL;
    if (tf_adaptive_create(&mesh, scene.position, &made, NULL) != TF_OK)
        abort();
    return made;
}

/// On how many sides of the box a vertex is.
static int sides(const double *x)
{
    int count = 0;
    for (int k = 0; k < 3; k++)
        count += x[k] == 0 || x[k] == 2;
    return count;
}

START_TEST(vertices_of_a_box_are_free_inside_its_sides)
{
    static const tf_freedom freedom[] = {TF_FREE, TF_FREE, TF_ALONG_SHARP_EDGE,
                                         TF_HELD};
    tf_adaptive_surface *surface = box();
    for (int v = 0; v < surface->vertices; v++)
        ck_assert_int_eq(tf_freedom_of(surface, v),
                         freedom[sides(coordinates_of(surface, v))]);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(the_edges_of_a_box_are_sharp)
{
    tf_adaptive_surface *surface = box();
    for (int c = 0; c < 3 * surface->triangles; c++) {
        const double *a = coordinates_of(surface, tf_vertex_at(surface, c));
        const double *b =
            coordinates_of(surface, tf_vertex_at(surface, tf_corner_after(c)));
        int common = 0;
        for (int k = 0; k < 3; k++)
            common += a[k] == b[k] && (a[k] == 0 || a[k] == 2);
        ck_assert(tf_is_sharp_edge(surface, c) == (common == 2));
    }
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(the_boundary_is_sharp)
{
    tf_adaptive_surface *sheet = adaptive_sheet(2, 2);
    static const tf_freedom freedom[] = {
        TF_HELD, TF_ALONG_SHARP_EDGE, TF_HELD, TF_ALONG_SHARP_EDGE,
        TF_FREE, TF_ALONG_SHARP_EDGE, TF_HELD, TF_ALONG_SHARP_EDGE,
        TF_HELD};
    for (int v = 0; v < 9; v++)
        ck_assert_int_eq(tf_freedom_of(sheet, v), freedom[v]);
    ck_assert(tf_is_sharp_edge(sheet, tf_find_edge(sheet, 0, 1)));
    ck_assert(!tf_is_sharp_edge(sheet, tf_find_edge(sheet, 0, 4)));
    tf_adaptive_free(sheet);
}
END_TEST

/// Expects how the diagonal of a sheet from 0 to 4 collapses.
static void expect_collapse(tf_freedom at_0, tf_freedom at_4, bool sharp,
                            int from, bool may_go)
{
    tf_adaptive_surface *sheet = adaptive_sheet(2, 2);
    const tf_freedom freedom[] = {at_0, at_4};
    tf_edge_collapse collapse;
    ck_assert(tf_collapse_freer(sheet, tf_find_edge(sheet, 0, 4), freedom,
                                sharp, &collapse) == may_go);
    ck_assert_int_eq(collapse.from, from);
    ck_assert_int_eq(collapse.to, 4 - from);
    ck_assert_double_eq(collapse.position.x[0], from == 4 ? 0 : 1);
    tf_adaptive_free(sheet);
}

START_TEST(the_freer_vertex_collapses)
{
    expect_collapse(TF_FREE, TF_FREE, false, 0, true);
    expect_collapse(TF_HELD, TF_FREE, false, 4, true);
    expect_collapse(TF_FREE, TF_HELD, false, 0, true);
    expect_collapse(TF_HELD, TF_HELD, true, 0, false);
    expect_collapse(TF_HELD, TF_ALONG_SHARP_EDGE, true, 4, true);
    expect_collapse(TF_HELD, TF_ALONG_SHARP_EDGE, false, 4, false);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/sharp_edges");
    TCase *tcase = tcase_create("sharp edges");
    tcase_add_test(tcase, vertices_of_a_box_are_free_inside_its_sides);
    tcase_add_test(tcase, the_edges_of_a_box_are_sharp);
    tcase_add_test(tcase, the_boundary_is_sharp);
    tcase_add_test(tcase, the_freer_vertex_collapses);
    suite_add_tcase(suite, tcase);
    return suite;
}

// Creases, on a box of 2 x 2 x 1 squares and on a sheet.
#include "remesh/crease.h"

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
static int sides(const double *place)
{
    int count = 0;
    for (int k = 0; k < 3; k++)
        count += place[k] == 0 || place[k] == 2;
    return count;
}

START_TEST(a_vertex_of_a_box_is_free_on_one_side)
{
    static const tf_freedom freedom[] = {TF_FREE, TF_FREE, TF_ALONG_CREASE,
                                         TF_HELD};
    tf_adaptive_surface *surface = box();
    for (int v = 0; v < surface->vertices; v++)
        ck_assert_int_eq(tf_freedom_of(surface, v),
                         freedom[sides(place_of(surface, v))]);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(an_edge_of_a_box_is_a_crease)
{
    tf_adaptive_surface *surface = box();
    for (int c = 0; c < 3 * surface->triangles; c++) {
        const double *a = place_of(surface, tf_vertex_at(surface, c));
        const double *b =
            place_of(surface, tf_vertex_at(surface, tf_corner_after(c)));
        int common = 0;
        for (int k = 0; k < 3; k++)
            common += a[k] == b[k] && (a[k] == 0 || a[k] == 2);
        ck_assert(tf_is_crease(surface, c) == (common == 2));
    }
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(the_boundary_is_a_crease)
{
    tf_adaptive_surface *sheet = adaptive_sheet(2, 2);
    static const tf_freedom freedom[] = {
        TF_HELD,         TF_ALONG_CREASE, TF_HELD,
        TF_ALONG_CREASE, TF_FREE,         TF_ALONG_CREASE,
        TF_HELD,         TF_ALONG_CREASE, TF_HELD};
    for (int v = 0; v < 9; v++)
        ck_assert_int_eq(tf_freedom_of(sheet, v), freedom[v]);
    ck_assert(tf_is_crease(sheet, tf_find_edge(sheet, 0, 1)));
    ck_assert(!tf_is_crease(sheet, tf_find_edge(sheet, 0, 4)));
    tf_adaptive_free(sheet);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/crease");
    TCase *tcase = tcase_create("creases");
    tcase_add_test(tcase, a_vertex_of_a_box_is_free_on_one_side);
    tcase_add_test(tcase, an_edge_of_a_box_is_a_crease);
    tcase_add_test(tcase, the_boundary_is_a_crease);
    suite_add_tcase(suite, tcase);
    return suite;
}

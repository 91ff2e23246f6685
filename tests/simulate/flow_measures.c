// What is measured on a surface.
#include "simulate/flow_measures.h"

#include "support/adaptive_scenes.h"
#include "support/adaptive_surfaces.h"
#include "support/support.h"

#include <math.h>

START_TEST(a_tetrahedron_is_a_sphere)
{
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    tf_flow_measures found;
    ck_assert(tf_flow_measure(surface, &found));
    ck_assert_int_eq(found.vertices, 4);
    ck_assert_int_eq(found.triangles, 4);
    ck_assert_int_eq(found.components, 1);
    ck_assert_int_eq(found.genus, 0);
    ck_assert_int_eq(found.boundaries, 0);
    ck_assert_double_eq_tol(found.area, 8 * sqrt(3), 1e-14);
    ck_assert_double_eq_tol(found.volume, 8.0 / 3, 1e-14);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(a_sheet_has_a_boundary_and_no_volume)
{
    tf_adaptive_surface *surface = adaptive_sheet(3, 4);
    tf_flow_measures found;
    ck_assert(tf_flow_measure(surface, &found));
    ck_assert_int_eq(found.components, 1);
    ck_assert_int_eq(found.genus, 0);
    ck_assert_int_eq(found.boundaries, 1);
    ck_assert_double_eq_tol(found.area, 12, 1e-14);
    ck_assert_double_eq(found.volume, 0);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(components_have_their_handles_and_boundaries)
{
    static adaptive_scene scene;
    static const adaptive_scene_kind kinds[] = {NESTED_SPHERES, LINKED_TORI,
                                                SLABS, SHEETS};
    static const int genus[] = {0, 1, 0, 0}, boundaries[] = {0, 0, 0, 1};
    for (int i = 0; i < 4; i++) {
        generator random = generator_new(1);
        adaptive_scene_make(&random, kinds[i], &scene);
        tf_mesh mesh = adaptive_scene_mesh(&scene);
        tf_adaptive_surface *surface = NULL;
        tf_flow_measures found;
        ck_assert_int_eq(
            tf_adaptive_create(&mesh, scene.position, &surface, NULL), TF_OK);
        ck_assert(tf_flow_measure(surface, &found));
        ck_assert_int_eq(found.components, scene.parts);
        ck_assert_int_eq(found.genus, genus[i] * scene.parts);
        ck_assert_int_eq(found.boundaries, boundaries[i] * scene.parts);
        tf_adaptive_free(surface);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/flow_measures");
    TCase *tcase = tcase_create("measures");
    tcase_add_test(tcase, a_tetrahedron_is_a_sphere);
    tcase_add_test(tcase, a_sheet_has_a_boundary_and_no_volume);
    tcase_add_test(tcase, components_have_their_handles_and_boundaries);
    suite_add_tcase(suite, tcase);
    return suite;
}

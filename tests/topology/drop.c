// Drops of a part.
#include "topology/drop.h"

#include "support/adaptive_scenes.h"
#include "support/adaptive_surfaces.h"
#include "support/blobs.h"
#include "support/support.h"
#include "surgery/star.h"

static tf_outcome drop(tf_adaptive_surface *surface, int vertex)
{
    tf_outcome outcome;
    ck_assert_int_eq(tf_adaptive_drop(surface, vertex, &outcome), TF_OK);
    return outcome;
}

/// A box in a box, and one beside, in the corner of a bent one.
static tf_adaptive_surface *boxes(int first[4])
{
    static adaptive_scene scene;
    static const int box[3][2][3] = {{{0, 0, 0}, {5, 3, 3}},
                                     {{1, 1, 1}, {2, 2, 2}},
                                     {{9, 0, 0}, {10, 1, 1}}};
    scene = (adaptive_scene){.unit = 1};
    for (int i = 0; i < 3; i++) {
        first[i] = scene.vertices;
        add_box(&scene, box[i][0], box[i][1]);
    }
    tf_mesh mesh = adaptive_scene_mesh(&scene);
    tf_adaptive_surface *made = NULL;
    ck_assert_int_eq(tf_adaptive_create(&mesh, scene.position, &made, NULL),
                     TF_OK);
    return made;
}

START_TEST(a_component_that_holds_another_is_not_dropped)
{
    int first[4];
    tf_adaptive_surface *surface = boxes(first);
    int all = triangles_of(surface);
    ck_assert_int_eq(drop(surface, first[0]), TF_PASSED_VERTEX);
    ck_assert_int_eq(triangles_of(surface), all);
    ck_assert_int_eq(drop(surface, first[1]), TF_COMMITTED);
    ck_assert_int_eq(triangles_of(surface), all - 12);
    ck_assert_int_eq(drop(surface, first[1]), TF_IMPOSSIBLE); // it is gone
    ck_assert_int_eq(drop(surface, first[0]), TF_COMMITTED);
    ck_assert_int_eq(drop(surface, first[2]), TF_COMMITTED);
    ck_assert_int_eq(triangles_of(surface), 0);
    tf_adaptive_free(surface);
}
END_TEST

// In the hole of a ring is not inside it.
START_TEST(a_ring_around_another_component_is_dropped)
{
    static blobs made;
    static const double at[] = {0, 0, 0.01};
    made.vertices = made.triangles = 0;
    add_ring(&made, at, 1, 0.4, 8, 5);
    add_ball(&made, at, 0.3, 2);
    tf_adaptive_surface *surface = blobs_surface(&made);
    ck_assert_int_eq(parts_of(surface), 2);
    ck_assert_int_eq(drop(surface, 0), TF_COMMITTED);
    ck_assert_int_eq(parts_of(surface), 1);
    ck_assert_int_eq(euler_of(surface), 2);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(a_component_that_is_left_alone_is_not_dropped)
{
    int first[4];
    tf_adaptive_surface *surface = boxes(first);
    adaptive_freeze(surface, first[2] + 3);
    ck_assert_int_eq(drop(surface, first[2]), TF_IMPOSSIBLE);
    ck_assert_int_eq(drop(surface, first[1]), TF_COMMITTED);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(a_component_with_a_boundary_is_not_dropped)
{
    tf_adaptive_surface *surface = adaptive_sheet(2, 2);
    tf_outcome outcome;
    ck_assert_int_eq(drop(surface, 0), TF_IMPOSSIBLE);
    ck_assert_int_eq(tf_adaptive_drop(surface, 9, &outcome), TF_BAD_INDEX);
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("topology/drop");
    TCase *tcase = tcase_create("drops");
    tcase_add_test(tcase, a_component_that_holds_another_is_not_dropped);
    tcase_add_test(tcase, a_ring_around_another_component_is_dropped);
    tcase_add_test(tcase, a_component_that_is_left_alone_is_not_dropped);
    tcase_add_test(tcase, a_component_with_a_boundary_is_not_dropped);
    suite_add_tcase(suite, tcase);
    return suite;
}

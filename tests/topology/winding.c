// Winding numbers, against those of the judge, at special points.
#include "topology/winding.h"

#include "support/adaptive_scenes.h"
#include "support/support.h"
#include "support/winding.h"
#include "surgery/adaptive_surface.h"
#include "surgery/touch.h"

#include <string.h>

/// Half of the points are level with vertices, or on the lattice.
static void choose_point(generator *random, const adaptive_scene *scene,
                         double x[3])
{
    for (int k = 0; k < 3; k++) {
        x[k] = below(random, 17) * 0.25 - 1;
        if (below(random, 2))
            x[k] = scene->position[3 * below(random, scene->vertices) + k];
        if (below(random, 3) == 0)
            x[k] = uniform(random, -1.2, 3.2);
    }
}

static bool is_on(const tf_adaptive_surface *surface, const double x[3])
{
    for (int t = 0; t < surface->triangles; t++) {
        tf_facet facet = tf_facet_of(surface, tf_triangle(surface, t));
        if (tf_point_touches_triangle(x, facet.corner))
            return true;
    }
    return false;
}

static int winding_of(const tf_adaptive_surface *surface, const double x[3])
{
    int sum = 0;
    for (int t = 0; t < surface->triangles; t++) {
        tf_facet facet = tf_facet_of(surface, tf_triangle(surface, t));
        sum += tf_winding_part(facet.corner, x);
    }
    return sum;
}

START_TEST(winding_numbers_are_exact)
{
    static adaptive_scene scene;
    static const adaptive_scene_kind kinds[] = {NESTED_SPHERES, SLABS,
                                                FACING_BOXES, LINKED_TORI};
    generator random = generator_new(1000 + (uint64_t)_i);
    tf_adaptive_surface *surface = NULL;
    int inside = 0;
    adaptive_scene_make(&random, kinds[_i], &scene);
    tf_mesh mesh = adaptive_scene_mesh(&scene);
    ck_assert_int_eq(tf_adaptive_create(&mesh, scene.position, &surface, NULL),
                     TF_OK);
    cycle whole = {scene.triangles, 3, scene.triangle};
    double *x = scene.position + 3 * scene.vertices;
    for (long i = 0; i < cases(2000); i++) {
        choose_point(&random, &scene, x);
        if (is_on(surface, x))
            continue;
        int expected =
            winding_number(3, scene.position, &whole, scene.vertices);
        ck_assert_int_eq(winding_of(surface, x), expected);
        inside += expected != 0;
    }
    ck_assert_int_gt(inside, 0);
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("topology/winding");
    TCase *tcase = tcase_create("winding numbers");
    tcase_add_loop_test(tcase, winding_numbers_are_exact, 0, 4);
    suite_add_tcase(suite, tcase);
    return suite;
}

// Remeshing: it never tangles, keeps the shape, and makes good triangles.
#include "remesh/remesh.h"

#include "remesh/keep_shape.h"
#include "remesh/passes.h"
#include "support/adaptive_surfaces.h"
#include "support/remeshers.h"
#include "support/support.h"
#include "support/surgery_runs.h"

#include <signal.h>
#include <string.h>

static surgery_run run;
static surgery_counts counts;

/// Gives new vertices the part of a neighbor that has one.
static void label_parts(int before)
{
    tf_mesh mesh = *tf_adaptive_mesh(run.surface);
    for (int v = before; v < mesh.vertices; v++)
        run.part[v] = -1;
    for (int changes = 1; changes > 0;) {
        changes = 0;
        for (int i = 0; i < 3 * mesh.triangles; i++) {
            const int *t = mesh.triangle + i / 3 * 3;
            int own = t[i % 3], next = t[(i + 1) % 3];
            if (run.part[own] < 0 && run.part[next] >= 0) {
                run.part[own] = run.part[next];
                changes++;
            }
        }
    }
}

static const char *first_fault(void)
{
    const char *fault = NULL;
    for (int part = 0; part < run.scene.parts && !fault; part++) {
        run.changed = part;
        fault = surgery_run_fault(&run);
    }
    return fault;
}

// The passes that add vertices or move them, without the compaction that would
// lose track of the parts.
START_TEST(no_close_surfaces_are_tangled_by_passes)
{
    surgery_run_begin(&run, generator_new((uint64_t)_i),
                      (adaptive_scene_kind)_i, &counts);
    static const tf_operation passes[] = {TF_SPLIT, TF_SPLIT, TF_SPLIT, TF_FLIP,
                                          TF_SMOOTH};
    tf_remesher *remesher =
        remesher_begin(run.surface, &tf_keep_shape, run.scene.unit / 3);
    for (int i = 0; i < 5; i++)
        ck_assert_int_eq(tf_remesh_pass(remesher, passes[i]), TF_OK);
    label_parts(run.scene.vertices);
    const char *fault = first_fault();
    ck_assert_msg(!fault, "%s", fault);
    remesher_end(remesher);
}
END_TEST

/// The scene as a surface of one part.
static void begin_unlabelled(void)
{
    memset(run.part, 0, sizeof run.part);
    run.scene.kind = SHEETS;
    run.changed = 0;
}

START_TEST(no_scene_is_tangled_by_remeshing)
{
    static const double fractions[] = {2, 1, 0.5};
    for (int i = 0; i < 3; i++) {
        surgery_run_begin(&run, generator_new((uint64_t)_i),
                          (adaptive_scene_kind)_i, &counts);
        tf_remesh_options how = {.edge = run.scene.unit * fractions[i]};
        const tf_remesh_report *report;
        ck_assert_int_eq(tf_adaptive_remesh(run.surface, &how, &report, NULL), TF_OK);
        ck_assert_int_eq(report->rounds, 5);
        begin_unlabelled();
        const char *fault = surgery_run_fault(&run);
        ck_assert_msg(!fault, "%s", fault);
        surgery_run_end(&run);
    }
}
END_TEST

START_TEST(a_sphere_gets_good_triangles)
{
    static adaptive_scene scene;
    scene = (adaptive_scene){0};
    add_sphere(&scene, 1);
    tf_mesh mesh = adaptive_scene_mesh(&scene);
    tf_adaptive_surface *surface = NULL;
    ck_assert_int_eq(tf_adaptive_create(&mesh, scene.position, &surface, NULL),
                     TF_OK);
    tf_remesh_options how = {.edge = 0.2};
    const tf_remesh_report *report;
    ck_assert_int_eq(tf_adaptive_remesh(surface, &how, &report, NULL), TF_OK);
    ck_assert_double_gt(report->mean_before, 0.9);
    ck_assert_double_gt(report->least_after, 0.5);
    ck_assert_double_gt(report->mean_after, 0.9);
    ck_assert_double_lt(report->distance, 0.1);
    ck_assert_double_lt(longest_edge(surface), 0.3);
    ck_assert_int_gt(triangles_of(surface), 400);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(a_box_stays_a_box)
{
    static adaptive_scene scene;
    static const int low[] = {0, 0, 0}, high[] = {1, 2, 3};
    scene = (adaptive_scene){0};
    add_box(&scene, low, high);
    tf_mesh mesh = adaptive_scene_mesh(&scene);
    tf_adaptive_surface *surface = NULL;
    ck_assert_int_eq(tf_adaptive_create(&mesh, scene.position, &surface, NULL),
                     TF_OK);
    for (int i = 1; i < 4; i++) {
        tf_remesh_options how = {.edge = 0.3 * i, .rounds = 3};
        const tf_remesh_report *report;
        ck_assert_int_eq(tf_adaptive_remesh(surface, &how, &report, NULL), TF_OK);
        ck_assert_double_lt(report->distance, 1e-12);
        ck_assert_int_eq(report->rounds, 3);
    }
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(bad_options_are_refused)
{
    static const double edges[] = {0, -1, NAN, INFINITY, 1e-9, 5e-324};
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    for (int i = 0; i < 6; i++) {
        tf_remesh_options how = {.edge = edges[i]};
        ck_assert_int_eq(tf_adaptive_remesh(surface, &how, NULL, NULL),
                         TF_BAD_OPTION);
    }
    tf_remesh_options how = {.edge = 1, .rounds = -1};
    ck_assert_int_eq(tf_adaptive_remesh(surface, &how, NULL, NULL), TF_BAD_OPTION);
    how.rounds = 0;
    ck_assert_int_eq(tf_adaptive_remesh(surface, &how, NULL, NULL), TF_OK);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(remeshing_needs_options)
{
    tf_adaptive_remesh(adaptive_tetrahedron(), NULL, NULL, NULL);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/remesh");
    TCase *tcase = tcase_create("remeshing");
    tcase_add_loop_test(tcase, no_close_surfaces_are_tangled_by_passes, 0,
                        ADAPTIVE_SCENES);
    tcase_add_loop_test(tcase, no_scene_is_tangled_by_remeshing, 0,
                        ADAPTIVE_SCENES);
    tcase_add_test(tcase, a_sphere_gets_good_triangles);
    tcase_add_test(tcase, a_box_stays_a_box);
    tcase_add_test(tcase, bad_options_are_refused);
    tcase_add_test_raise_signal(tcase, remeshing_needs_options, SIGABRT);
    suite_add_tcase(suite, tcase);
    return suite;
}

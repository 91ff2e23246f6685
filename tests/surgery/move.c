// Moves of vertices: those are refused in which the exact detection of contacts
// finds one, and no others.
#include "surgery/move.h"

#include "fast/detect.h"
#include "support/adaptive_surfaces.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/surgery_runs.h"
#include "surgery/outcome.h"

#include <string.h>

/// Whether a vertex of a surface without gaps meets something on its way.
static bool has_contact(tf_surface *detected,
                        const tf_adaptive_surface *surface,
                        const surgery_choice *move)
{
    static double end[3 * LABELLED];
    tf_mesh mesh = *tf_adaptive_mesh(surface);
    const double *start = tf_adaptive_positions(surface);
    tf_motion motion = {3, mesh.vertices, start, end};
    tf_contacts found;
    memcpy(end, start, 24 * (size_t)mesh.vertices);
    memcpy(end + 3 * move->a, move->position, sizeof move->position);
    ck_assert_int_eq(tf_surface_detect(detected, &motion, NULL, &found, NULL),
                     TF_OK);
    return found.any;
}

static int try_moves(surgery_run *run, tf_surface *detected, int times)
{
    int contacts = 0;
    while (times > 0) {
        surgery_choice move = surgery_run_choose(run);
        if (move.what != MOVE_VERTEX)
            continue;
        int vertex;
        bool met = has_contact(detected, run->surface, &move);
        tf_outcome outcome = surgery_choice_try(run->surface, &move, &vertex);
        if (outcome != TF_IMPOSSIBLE) // an isolated triangle has no contacts
            ck_assert_int_eq(outcome != TF_COMMITTED, met);
        contacts += met;
        times--;
    }
    return contacts;
}

START_TEST(a_move_is_refused_where_there_is_a_contact)
{
    static surgery_run run;
    static surgery_counts counts;
    int contacts = 0;
    for (long i = 0; i < cases(8); i++) {
        surgery_run_begin(&run, generator_new((uint64_t)(i * 10 + _i)),
                          (adaptive_scene_kind)_i, &counts);
        tf_mesh mesh = *tf_adaptive_mesh(run.surface);
        tf_surface *detected = surface_of(&mesh);
        contacts += try_moves(&run, detected, 200);
        tf_surface_free(detected);
        surgery_run_end(&run);
    }
    ck_assert_int_gt(contacts, 20);
}
END_TEST

START_TEST(a_vertex_without_triangles_does_not_move)
{
    static double position[][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 3, 3}};
    static const double to[] = {4, 4, 4};
    static const int triangle[] = {0, 1, 2};
    tf_adaptive_surface *surface = adaptive_of(4, position, 1, triangle);
    tf_outcome outcome;
    ck_assert_int_eq(tf_adaptive_move(surface, 3, to, &outcome), TF_OK);
    ck_assert_int_eq(outcome, TF_IMPOSSIBLE);
    ck_assert_int_eq(tf_adaptive_move(surface, 0, to, &outcome), TF_OK);
    ck_assert_int_eq(outcome, TF_IMPOSSIBLE); // it is of an isolated triangle
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surgery/move");
    TCase *tcase = tcase_create("moves");
    tcase_add_loop_test(tcase, a_move_is_refused_where_there_is_a_contact, 0,
                        ADAPTIVE_SCENES);
    tcase_add_test(tcase, a_vertex_without_triangles_does_not_move);
    suite_add_tcase(suite, tcase);
    return suite;
}

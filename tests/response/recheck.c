// The new search, against a detection from the beginning.
#include "response/recheck.h"

#include "arithmetic/exact.h"
#include "fast/vector.h"
#include "support/scrambled.h"
#include "support/stepped.h"
#include "support/support.h"
#include "support/surface_of.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static proposal made;
static stepped of;

/// Moves some vertices on from where they end.
static void move_some(generator *random, double far)
{
    int axes = made.mesh.axes;
    for (int moved = 1 + below(random, 6); moved > 0; moved--) {
        int v = below(random, made.mesh.vertices);
        for (int k = 0; k < axes; k++)
            of.end[axes * v + k] += uniform(random, -far, far) * made.unit;
        if (below(random, 4) == 0) // to rest
            memcpy(of.end + (ptrdiff_t)axes * v,
                   made.start + (ptrdiff_t)axes * v,
                   sizeof(double) * (size_t)axes);
        of.changed[v] = true;
    }
}

static void mark(const tf_contacts *contacts)
{
    for (size_t i = 0; i < contacts->count; i++)
        for (int j = 0; j < 4 && contacts->contact[i].vertex[j] >= 0; j++)
            of.changed[contacts->contact[i].vertex[j]] = true;
}

static tf_contacts find_in(const tf_motion *motion, const tf_parallel *parallel)
{
    tf_deciding how = {.surface = of.surface,
                       .motion = motion,
                       .arithmetic = &tf_exact,
                       .narrow_phase = &tf_vectorized};
    tf_contacts found;
    ck_assert_int_eq(tf_recheck(of.surface, &of.step, &how, parallel, &found),
                     TF_OK);
    return found;
}

static tf_contacts find(const tf_parallel *parallel)
{
    tf_motion motion = {of.step.vertices, of.step.start, of.end};
    return find_in(&motion, parallel);
}

/// Expects the rows of a detection on a surface of its own.
static void compare(tf_surface *other, const tf_contacts *found)
{
    tf_motion motion = {of.step.vertices, of.step.start, of.end};
    tf_contacts all;
    ck_assert_int_eq(tf_surface_detect(other, &motion, NULL, &all, NULL),
                     TF_OK);
    ck_assert_uint_eq(found->count, all.count);
    ck_assert(found->any == all.any);
    if (all.count > 0)
        ck_assert_mem_eq(found->contact, all.contact,
                         all.count * sizeof *all.contact);
}

static void search_again(generator *random, const tf_parallel *parallel)
{
    tf_surface *other = surface_of(&made.mesh);
    stepped_begin(&of, &made);
    tf_contacts found = stepped_contacts(&of);
    for (int round = 0; round < 12; round++) {
        mark(&found);
        move_some(random, round % 4 == 3 ? 2 : 0.05);
        found = find(parallel);
        compare(other, &found);
        ck_assert_int_eq(stepped_changes(&of), 0);
    }
    stepped_free(&of);
    tf_surface_free(other);
}

START_TEST(found_again_is_all_there_is)
{
    generator random = generator_new(100 + (uint64_t)_i);
    int workers = 3;
    tf_parallel parallel = scrambled(&workers);
    for (int times = 0; times < (int)cases(40); times++) {
        proposal_make(&random, (proposal_shape)_i, 2,
                      below(&random, 2) ? SCATTERED : RESTING, &made);
        search_again(&random, times % 2 ? &parallel : NULL);
    }
}
END_TEST

// Two particles near a triangle; only what has moved is tested.
START_TEST(what_has_not_changed_is_not_tested)
{
    proposal_begin(&made, 3);
    for (int i = 0; i < 5; i++) {
        proposal_add_vertex(&made, i == 1 ? 4 : 1, i == 2 ? 4 : 1, i > 2);
        made.end[3 * i] += 0.1;
    }
    made.start[0] = made.start[1] = 0;
    made.end[3 * 3 + 2] = made.end[3 * 4 + 2] = -1; // through the triangle
    proposal_add_triangle(&made, 0, 1, 2);
    stepped_begin(&of, &made);
    ck_assert_uint_eq(stepped_contacts(&of).count, 2);
    of.changed[3] = true;
    tf_contacts found = find(NULL);
    ck_assert_uint_eq(found.count, 1);
    ck_assert_int_eq(found.contact->vertex[0], 3);
    ck_assert_uint_eq(found.effort.candidates, 1);

    // A vertex of the triangle concerns both; nothing concerns neither.
    of.changed[0] = true;
    ck_assert_uint_eq(find(NULL).count, 2);
    found = find(NULL);
    ck_assert(!found.any);
    ck_assert_uint_eq(found.effort.candidates, 0);

    // The boxes are those of the ends as they are now.
    of.end[3 * 3 + 2] = 0.5;
    of.changed[3] = of.changed[4] = true;
    found = find(NULL);
    ck_assert_uint_eq(found.count, 1);
    ck_assert_int_eq(found.contact->vertex[0], 4);
    ck_assert_uint_eq(found.effort.candidates, 1);
    stepped_free(&of);
}
END_TEST

// More elements than a task has packs of, and each edge once.
START_TEST(many_edges_again)
{
    enum {
        EDGES = 40000
    };
    static double start[6 * EDGES], end[6 * EDGES];
    static bool changed[2 * EDGES];
    static int edge[2 * EDGES];
    int workers = 3;
    tf_parallel parallel = scrambled(&workers);
    for (int i = 0; i < 2 * EDGES; i++) {
        // Crosses far from each other; the edges of one pass through each other.
        double at[] = {4 * (i / 4) + (i % 4 == 1) - (i % 4 == 0),
                       (i % 4 == 3) - (i % 4 == 2), i % 4 < 2 ? 0 : 1};
        memcpy(start + (ptrdiff_t)3 * i, at, sizeof at);
        memcpy(end + (ptrdiff_t)3 * i, at, sizeof at);
        end[3 * i + 2] = 0.5;
        edge[i] = i;
    }
    tf_mesh mesh = {
        .axes = 3, .vertices = 2 * EDGES, .edges = EDGES, .edge = edge};
    of.surface = surface_of(&mesh);
    of.step = (tf_step){3, 2 * EDGES, start, end, NULL, end, changed};
    tf_motion motion = {2 * EDGES, start, end};
    tf_contacts found;
    ck_assert_int_eq(tf_surface_detect(of.surface, &motion, NULL, &found, NULL),
                     TF_OK);
    ck_assert_uint_eq(found.count, EDGES / 2);
    memset(changed, true, sizeof changed);
    ck_assert_uint_eq(find_in(&motion, &parallel).count, EDGES / 2);
    for (int i = 0; i < 2 * EDGES; i += 16)
        changed[i] = true;
    ck_assert_uint_eq(find_in(&motion, &parallel).count, EDGES / 8);
    tf_surface_free(of.surface);
}
END_TEST

// An element with ends on all sides, far out of the frame, overlaps the boxes
// of all elements, but not the lanes of none.
START_TEST(ends_far_out_of_the_frame)
{
    generator random = generator_new(400);
    proposal_make(&random, SHEETS, 2, RESTING, &made);
    tf_surface *other = surface_of(&made.mesh);
    stepped_begin(&of, &made);
    tf_contacts found = stepped_contacts(&of);
    mark(&found);
    for (int i = 0; i < 3; i++) {
        int v = made.mesh.triangle[i];
        for (int k = 0; k < made.mesh.axes; k++)
            of.end[made.mesh.axes * v + k] = i == k ? -0x1p1000 : 0x1p1000;
        of.changed[v] = true;
    }
    found = find(NULL);
    compare(other, &found);
    stepped_free(&of);
    tf_surface_free(other);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/recheck");
    TCase *tcase = tcase_create("contacts");
    tcase_add_loop_test(tcase, found_again_is_all_there_is, 0, PROPOSAL_SHAPES);
    tcase_add_test(tcase, what_has_not_changed_is_not_tested);
    tcase_add_test(tcase, many_edges_again);
    tcase_add_test(tcase, ends_far_out_of_the_frame);
    suite_add_tcase(suite, tcase);
    return suite;
}

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
static tf_recheck recheck;

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

static tf_contacts find(const tf_parallel *parallel, int *rebuilds)
{
    tf_motion motion = {of.step.vertices, of.step.start, of.end};
    tf_deciding how = {.surface = of.surface,
                       .motion = &motion,
                       .arithmetic = &tf_exact,
                       .narrow_phase = &tf_vectorized};
    tf_contacts found;
    ck_assert_int_eq(tf_recheck_find(&recheck, of.surface, &of.step, &how,
                                     parallel, &found, rebuilds),
                     TF_OK);
    return found;
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

static int search_again(generator *random, const tf_parallel *parallel)
{
    int rebuilds = 0;
    tf_surface *other = surface_of(&made.mesh);
    memset(&recheck, 0, sizeof recheck);
    stepped_begin(&of, &made);
    tf_recheck_begin(&recheck, 0.3 * made.unit);
    tf_contacts found = stepped_contacts(&of);
    for (int round = 0; round < 12; round++) {
        mark(&found);
        move_some(random, round % 4 == 3 ? 2 : 0.05);
        found = find(parallel, &rebuilds);
        compare(other, &found);
        ck_assert_int_eq(stepped_changes(&of), 0);
    }
    tf_recheck_free(&recheck);
    stepped_free(&of);
    tf_surface_free(other);
    return rebuilds;
}

START_TEST(found_again_is_all_there_is)
{
    generator random = generator_new(100 + (uint64_t)_i);
    int workers = 3, rebuilds = 0;
    tf_parallel parallel = scrambled(&workers);
    for (int times = 0; times < (int)cases(40); times++) {
        proposal_make(&random, (proposal_shape)_i, 2,
                      below(&random, 2) ? SCATTERED : RESTING, &made);
        rebuilds += search_again(&random, times % 2 ? &parallel : NULL);
    }
    ck_assert_int_gt(rebuilds, 0);
}
END_TEST

// Two particles near a triangle; only what has moved is tested.
START_TEST(what_has_not_changed_is_not_tested)
{
    int rebuilds = 0;
    proposal_begin(&made, 3);
    for (int i = 0; i < 5; i++) {
        proposal_add_vertex(&made, i == 1 ? 4 : 1, i == 2 ? 4 : 1, i > 2);
        made.end[3 * i] += 0.1;
    }
    made.start[0] = made.start[1] = 0;
    made.end[3 * 3 + 2] = made.end[3 * 4 + 2] = -1; // through the triangle
    proposal_add_triangle(&made, 0, 1, 2);
    stepped_begin(&of, &made);
    memset(&recheck, 0, sizeof recheck);
    tf_recheck_begin(&recheck, 1);
    of.changed[3] = true;
    tf_contacts found = find(NULL, &rebuilds);
    ck_assert_uint_eq(found.count, 1);
    ck_assert_int_eq(found.contact->vertex[0], 3);
    ck_assert_uint_eq(found.effort.candidates, 1);

    // At rest nothing is tested, whatever has changed.
    memcpy(of.end, made.start, sizeof of.end);
    memset(of.changed, true, 5);
    found = find(NULL, &rebuilds);
    ck_assert_uint_eq(found.effort.candidates, 0);
    tf_recheck_free(&recheck);
    stepped_free(&of);
}
END_TEST

START_TEST(rows_of_one_margin_serve_small_moves)
{
    int rebuilds = 0;
    generator random = generator_new(300);
    proposal_make(&random, SHEETS, 2, RESTING, &made);
    stepped_begin(&of, &made);
    memset(&recheck, 0, sizeof recheck);
    tf_recheck_begin(&recheck, made.unit);
    of.end[0] += made.unit;
    of.changed[0] = true;
    find(NULL, &rebuilds);
    ck_assert_double_eq(recheck.margin, 0.2 * made.unit);
    of.end[0] += 0.19 * made.unit;
    of.changed[0] = true;
    find(NULL, &rebuilds);
    ck_assert_int_eq(rebuilds, 0);
    of.end[0] += 0.03 * made.unit;
    of.changed[0] = true;
    find(NULL, &rebuilds);
    ck_assert_int_eq(rebuilds, 1);
    ck_assert_double_eq(recheck.margin, 0.4 * made.unit);
    tf_recheck_free(&recheck);
    stepped_free(&of);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/recheck");
    TCase *tcase = tcase_create("contacts");
    tcase_add_loop_test(tcase, found_again_is_all_there_is, 0, PROPOSAL_SHAPES);
    tcase_add_test(tcase, what_has_not_changed_is_not_tested);
    tcase_add_test(tcase, rows_of_one_margin_serve_small_moves);
    suite_add_tcase(suite, tcase);
    return suite;
}

// Drafts: what is done to one happens to the surface as a whole or not at all.
#include "surgery/draft.h"

#include "support/adaptive_surfaces.h"
#include "support/support.h"
#include "support/surgery_runs.h"
#include "surgery/adaptive.h"
#include "surgery/collapse.h"

#include <string.h>

static surgery_run run;
static surgery_counts counts;

/// Does random operations on the surface of the run.
static void operate_often(int times)
{
    for (int i = 0; i < times; i++) {
        surgery_choice request = surgery_run_choose(&run);
        operate(&run, &request);
    }
}

/// Does the same on both, and expects the same outcomes and numbers.
static void operate_on_both(tf_adaptive_surface *draft, int times)
{
    for (int i = 0; i < times; i++) {
        surgery_choice request = surgery_run_choose(&run);
        int own = 0, other = 0;
        ck_assert_int_eq(surgery_choice_try(run.surface, &request, &own),
                         surgery_choice_try(draft, &request, &other));
        ck_assert_int_eq(own, other);
    }
}

START_TEST(a_draft_behaves_as_its_surface)
{
    surgery_run_begin(&run, generator_new((uint64_t)_i),
                      (adaptive_scene_kind)_i, &counts);
    operate_often(200);
    tf_adaptive_surface draft = {0};
    for (int i = 0; i < 3; i++) {
        ck_assert_int_eq(tf_draft_begin(&draft, run.surface, NULL), TF_OK);
        ck_assert_uint_eq(adaptive_hash(&draft), adaptive_hash(run.surface));
        operate_on_both(&draft, 200);
        ck_assert_uint_eq(adaptive_hash(&draft), adaptive_hash(run.surface));
    }
    tf_draft_free(&draft);
    surgery_run_end(&run);
}
END_TEST

static tf_outcome collapse_middle(tf_adaptive_surface *sheet)
{
    tf_outcome outcome;
    ck_assert_int_eq(tf_adaptive_collapse(sheet, 4, 5, &outcome), TF_OK);
    return outcome;
}

START_TEST(a_surface_changes_only_if_the_draft_is_accepted)
{
    tf_adaptive_surface *sheet = adaptive_sheet(2, 2), draft = {0};
    const double *lent = tf_adaptive_positions(sheet);
    uint64_t before = adaptive_hash(sheet);
    ck_assert_int_eq(tf_draft_begin(&draft, sheet, NULL), TF_OK);
    ck_assert_int_eq(collapse_middle(&draft), TF_COMMITTED);
    ck_assert_uint_eq(adaptive_hash(sheet), before);
    ck_assert_ptr_eq(tf_adaptive_positions(sheet), lent);
    uint64_t after = adaptive_hash(&draft);
    tf_draft_accept(&draft, sheet);
    ck_assert_uint_eq(adaptive_hash(sheet), after);
    ck_assert_uint_ne(after, before);
    ck_assert_int_eq(triangles_of(sheet), 6);
    // The draft has the memory of the surface, and can be used again.
    ck_assert_ptr_eq(draft.position.data, lent);
    ck_assert_int_eq(tf_draft_begin(&draft, sheet, NULL), TF_OK);
    ck_assert_uint_eq(adaptive_hash(&draft), after);
    tf_draft_free(&draft);
    tf_adaptive_free(sheet);
}
END_TEST

START_TEST(what_a_surface_lends_is_not_exchanged)
{
    tf_adaptive_surface *sheet = adaptive_sheet(2, 2), draft = {0};
    const tf_mesh *mesh = tf_adaptive_mesh(sheet);
    ck_assert(tf_buffer_extend(&sheet->lent.remesh_report, 1, 8));
    const void *report = sheet->lent.remesh_report.data;
    sheet->lent.has_origins = true;
    ck_assert_int_eq(tf_draft_begin(&draft, sheet, NULL), TF_OK);
    tf_draft_accept(&draft, sheet);
    ck_assert_ptr_eq(tf_adaptive_mesh(sheet), mesh);
    ck_assert_ptr_eq(sheet->lent.remesh_report.data, report);
    ck_assert(!sheet->lent.has_origins);
    tf_draft_free(&draft);
    tf_adaptive_free(sheet);
}
END_TEST

static bool never(void *context, const tf_stage *stage)
{
    (void)context, (void)stage;
    return false;
}

START_TEST(a_draft_can_be_cancelled)
{
    tf_adaptive_surface *sheet = adaptive_sheet(2, 2), draft = {0};
    tf_watch own, *watch = tf_watch_begin(&own, never, NULL);
    ck_assert_int_eq(tf_draft_begin(&draft, sheet, watch), TF_CANCELLED);
    ck_assert_int_eq(tf_draft_begin(&draft, sheet, NULL), TF_OK);
    draft.watch = tf_watch_begin(&own, never, NULL);
    ck_assert_int_eq(tf_adaptive_compact(&draft, NULL), TF_CANCELLED);
    // The watch is over before the surface can be used.
    ck_assert_int_eq(tf_draft_begin(&draft, sheet, NULL), TF_OK);
    draft.watch = &own;
    tf_draft_accept(&draft, sheet);
    ck_assert_ptr_null(sheet->watch);
    tf_draft_free(&draft);
    tf_adaptive_free(sheet);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surgery/draft");
    TCase *tcase = tcase_create("drafts");
    tcase_add_loop_test(tcase, a_draft_behaves_as_its_surface, 0,
                        ADAPTIVE_SCENES);
    tcase_add_test(tcase, a_surface_changes_only_if_the_draft_is_accepted);
    tcase_add_test(tcase, what_a_surface_lends_is_not_exchanged);
    tcase_add_test(tcase, a_draft_can_be_cancelled);
    suite_add_tcase(suite, tcase);
    return suite;
}

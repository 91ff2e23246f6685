// The passes of a reconnection, with memory that is kept.
#include "topology/passes.h"

#include "support/blobs.h"
#include "support/support.h"
#include "surgery/adaptive.h"
#include "topology/reconnect.h"

#include <math.h>
#include <string.h>

/// Two balls that are close enough to merge, and a small one.
static tf_adaptive_surface *make_balls(void)
{
    static blobs made;
    static const double middle[][3] = {
        {-1.03, 0, 0}, {1.03, 0.1, 0}, {9, 0, 0}};
    made.vertices = made.triangles = 0;
    for (int i = 0; i < 3; i++)
        add_ball(&made, middle[i], i < 2 ? 1 : 0.1, 6);
    return blobs_surface(&made);
}

START_TEST(memory_that_is_kept_changes_nothing)
{
    static const tf_reconnect_options lengths = {.edge = 0.3, .merge = 0.6};
    tf_adaptive_surface *one = make_balls(), *other = make_balls();
    tf_reconnector reconnector = {.surface = one};
    tf_reconnect_options own;
    ck_assert_int_eq(tf_reconnect_options_read(&own, &lengths, 1,
                                               &reconnector.lengths, NULL),
                     TF_OK);
    size_t bytes = 0;
    for (int i = 0; i < 3; i++) {
        const tf_reconnect_report *kept = &reconnector.report, *anew;
        ck_assert_int_eq(tf_reconnect_passes(&reconnector), TF_OK);
        ck_assert_int_eq(tf_adaptive_reconnect(other, &lengths, &anew, NULL),
                         TF_OK);
        ck_assert_uint_ge(tf_reconnector_memory(&reconnector), bytes);
        bytes = tf_reconnector_memory(&reconnector);
        ck_assert_mem_eq(kept, anew, sizeof *kept);
        ck_assert_uint_eq(kept->tried[TF_MERGE][TF_COMMITTED], i == 0);
        ck_assert_uint_eq(kept->tried[TF_DROP][TF_COMMITTED], i == 0);
    }
    ck_assert_uint_gt(bytes, 0);
    ck_assert_int_eq(one->triangles, other->triangles);
    ck_assert_mem_eq(one->vertex.data, other->vertex.data,
                     3 * sizeof(int) * (size_t)one->triangles);
    tf_reconnector_free(&reconnector);
    tf_adaptive_free(one);
    tf_adaptive_free(other);
}
END_TEST

// Options ---------------------------------------------------------------------

static tf_reconnect_lengths lengths_of(const tf_reconnect_options *options)
{
    tf_reconnect_options own;
    tf_reconnect_lengths lengths;
    ck_assert_int_eq(
        tf_reconnect_options_read(&own, options, 1, &lengths, NULL), TF_OK);
    return lengths;
}

START_TEST(zero_is_the_usual_length)
{
    tf_reconnect_lengths usual = lengths_of(&(tf_reconnect_options){.edge = 2});
    ck_assert_double_eq(usual.merge, 0.6);
    ck_assert_double_eq(usual.apart, 0.6);
    ck_assert_double_eq(usual.patch, 1);
    ck_assert_double_eq(usual.pinch, 1.4);
    ck_assert_double_eq(usual.drop, 4);
}
END_TEST

START_TEST(a_negative_length_is_none)
{
    tf_reconnect_lengths none = lengths_of(&(tf_reconnect_options){
        .edge = 2, .merge = -1, .patch = -1, .pinch = -1e-300, .drop = -5});
    ck_assert_double_eq(none.merge, 0);
    ck_assert_double_eq(none.patch, 0);
    ck_assert_double_eq(none.pinch, 0);
    ck_assert_double_eq(none.drop, 0);
    ck_assert_double_eq(none.apart, 0.6);
    tf_reconnect_lengths patch = lengths_of(
        &(tf_reconnect_options){.edge = 2, .merge = 0.4, .patch = -1});
    ck_assert_double_eq(patch.patch, 0.8); // no less than `merge`
}
END_TEST

START_TEST(what_is_switched_off_is_not_tried)
{
    static const tf_reconnect_options off[] = {
        {.edge = 0.3, .merge = -1},
        {.edge = 0.3, .merge = 0.6, .drop = -1},
        {.edge = 0.3, .merge = -1, .pinch = -1, .drop = -1}};
    static const size_t merges[] = {0, 1, 0}, drops[] = {1, 0, 0};
    for (int i = 0; i < 3; i++) {
        tf_adaptive_surface *balls = make_balls();
        const tf_reconnect_report *report;
        ck_assert_int_eq(tf_adaptive_reconnect(balls, &off[i], &report, NULL),
                         TF_OK);
        ck_assert_uint_eq(report->tried[TF_MERGE][TF_COMMITTED], merges[i]);
        ck_assert_uint_eq(report->tried[TF_DROP][TF_COMMITTED], drops[i]);
        tf_adaptive_free(balls);
    }
}
END_TEST

START_TEST(bad_lengths_are_refused)
{
    static const tf_reconnect_options bad[] = {
        {0}, {.edge = -1}, {.edge = 1, .drop = NAN}};
    for (int i = 0; i < 3; i++) {
        tf_reconnect_options own;
        tf_reconnect_lengths lengths;
        tf_error error;
        ck_assert_int_eq(
            tf_reconnect_options_read(&own, &bad[i], 1, &lengths, &error),
            TF_BAD_OPTION);
        ck_assert_int_eq(error.subject, TF_OPTION);
        ck_assert_str_eq(error.option, i < 2 ? "edge" : "drop");
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("topology/passes");
    TCase *tcase = tcase_create("passes");
    tcase_add_test(tcase, memory_that_is_kept_changes_nothing);
    suite_add_tcase(suite, tcase);
    tcase = tcase_create("options");
    tcase_add_test(tcase, zero_is_the_usual_length);
    tcase_add_test(tcase, a_negative_length_is_none);
    tcase_add_test(tcase, what_is_switched_off_is_not_tried);
    tcase_add_test(tcase, bad_lengths_are_refused);
    suite_add_tcase(suite, tcase);
    return suite;
}

// The passes of a reconnection, with memory that is kept.
#include "topology/passes.h"

#include "support/blobs.h"
#include "support/support.h"
#include "surgery/adaptive.h"
#include "topology/reconnect.h"

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
    tf_reconnect_report kept = {0}, anew = {0};
    size_t bytes = 0;
    for (int i = 0; i < 3; i++) {
        ck_assert_int_eq(tf_reconnect_passes(&reconnector, &lengths, &kept),
                         TF_OK);
        ck_assert_int_eq(tf_adaptive_reconnect(other, &lengths, &anew), TF_OK);
        ck_assert_uint_ge(tf_reconnector_memory(&reconnector), bytes);
        bytes = tf_reconnector_memory(&reconnector);
    }
    ck_assert_uint_gt(bytes, 0);
    ck_assert_mem_eq(&kept, &anew, sizeof kept);
    ck_assert_uint_eq(kept.tried[TF_MERGE][TF_COMMITTED], 1);
    ck_assert_uint_eq(kept.tried[TF_DROP][TF_COMMITTED], 1);
    ck_assert_int_eq(one->triangles, other->triangles);
    ck_assert_mem_eq(one->vertex.data, other->vertex.data,
                     3 * sizeof(int) * (size_t)one->triangles);
    tf_reconnector_free(&reconnector);
    tf_adaptive_free(one);
    tf_adaptive_free(other);
}
END_TEST

START_TEST(bad_lengths_are_refused)
{
    static const tf_reconnect_options bad[] = {
        {0}, {.edge = -1}, {.edge = 1, .merge = -1}, {.edge = 1, .drop = NAN}};
    tf_adaptive_surface *balls = make_balls();
    tf_reconnector reconnector = {.surface = balls};
    tf_reconnect_report report = {0};
    for (int i = 0; i < 4; i++)
        ck_assert_int_eq(tf_reconnect_passes(&reconnector, &bad[i], &report),
                         TF_BAD_OPTION);
    tf_adaptive_free(balls);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("topology/passes");
    TCase *tcase = tcase_create("passes");
    tcase_add_test(tcase, memory_that_is_kept_changes_nothing);
    tcase_add_test(tcase, bad_lengths_are_refused);
    suite_add_tcase(suite, tcase);
    return suite;
}

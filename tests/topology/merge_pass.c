// The pass that merges: once in each contact, and nothing that would be
// pinched.
#include "topology/merge_pass.h"

#include "support/blobs.h"
#include "support/support.h"
#include "topology/reconnector.h"

static blobs made;
static tf_reconnector reconnector;

/// Two balls, one above the other; `edge` is the mean length of an edge.
static void begin(double gap, double edge)
{
    made.vertices = made.triangles = 0;
    for (int i = 0; i < 2; i++) {
        const double middle[] = {0, 0.1 * i, (i ? 1 : -1) * (1 + gap / 2)};
        add_ball(&made, middle, 1, 6);
    }
    reconnector = (tf_reconnector){.surface = blobs_surface(&made),
                                   .lengths = {.merge = 0.3 * edge,
                                               .patch = 0.5 * edge,
                                               .pinch = 0.7 * edge}};
}

static size_t merges(void)
{
    ck_assert_int_eq(tf_merge_pass(&reconnector), TF_OK);
    return reconnector.report.tried[TF_MERGE][TF_COMMITTED];
}

static void end(void)
{
    tf_adaptive_free(reconnector.surface);
    tf_reconnector_free(&reconnector);
}

START_TEST(a_contact_is_merged_once)
{
    begin(0.02, 0.3);
    double before = volume_of(reconnector.surface);
    ck_assert_uint_eq(merges(), 1);
    ck_assert_int_eq(euler_of(reconnector.surface), 2);
    ck_assert_double_eq_tol(volume_of(reconnector.surface) - before,
                            reconnector.report.gained[TF_MERGE], 1e-12);
    ck_assert_uint_eq(merges(), 1); // and not again
    end();
}
END_TEST

START_TEST(distant_edges_are_not_merged)
{
    begin(0.1, 0.3);
    ck_assert_uint_eq(merges(), 0);
    ck_assert_int_gt(reconnector.candidates, 0); // though it is in contact
    end();
}
END_TEST

// If edges should be longer than they are, a tube would be too thin.
START_TEST(edges_with_short_sides_are_not_merged)
{
    begin(0.02, 0.3);
    reconnector.lengths.pinch = 0.45;
    ck_assert_uint_eq(merges(), 0);
    end();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("topology/merge_pass");
    TCase *tcase = tcase_create("merging");
    tcase_add_test(tcase, a_contact_is_merged_once);
    tcase_add_test(tcase, distant_edges_are_not_merged);
    tcase_add_test(tcase, edges_with_short_sides_are_not_merged);
    suite_add_tcase(suite, tcase);
    return suite;
}

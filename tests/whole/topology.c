// Random merges, pinches and drops on adaptive surfaces, judged after each; and
// that the judge sees what happens if one of the tests is left out.
#include "support/reconnections.h"
#include "support/support.h"

static reconnection_counts counts;

START_TEST(only_what_reconnects_changes_sides)
{
    long runs = cases(5);
    for (long i = 0; i < runs; i++) {
        uint64_t stream = (uint64_t)(100 * i + _i);
        const char *fault = run_reconnections(
            generator_new(stream), (adaptive_scene_kind)_i, 100, 0, &counts);
        ck_assert_msg(!fault, "stream %llu: %s", (unsigned long long)stream,
                      fault);
    }
}
END_TEST

/// A test that is left out, and a scene that shows it.  (On closed surfaces D
/// follows from S.  What E excludes is a matter of knots and links.)
static const struct {
    tf_outcome left_out;
    adaptive_scene_kind kind;
} needed[] = {
    {TF_OVERLAPPED, DUST},
    {TF_PASSED_VERTEX, FACING_BOXES},
};

START_TEST(each_test_left_out_is_noticed)
{
    const char *fault = NULL;
    for (uint64_t i = 0; i < 40 && !fault; i++)
        fault = run_reconnections(generator_new(i), needed[_i].kind, 150,
                                  1U << needed[_i].left_out, &counts);
    ck_assert(fault);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/topology");
    TCase *tcase = tcase_create("reconnections");
    tcase_add_loop_test(tcase, only_what_reconnects_changes_sides, 0,
                        MERGING_SCENES);
    tcase_add_loop_test(tcase, each_test_left_out_is_noticed, 0,
                        sizeof needed / sizeof *needed);
    suite_add_tcase(suite, tcase);
    return suite;
}

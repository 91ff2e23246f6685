// Calls about adaptive surfaces at all scales, with slivers and needles.
#include "support/scaled_calls.h"
#include "support/support.h"

static scaled_counts counts;

START_TEST(the_unit_of_length_does_not_matter)
{
    long runs = cases(20);
    for (long i = 0; i < runs; i++) {
        uint64_t stream = (uint64_t)(100 * i + _i);
        const char *fault = run_scaled_call(generator_new(stream),
                                            (adaptive_scene_kind)_i, &counts);
        ck_assert_msg(!fault, "stream %llu: %s", (unsigned long long)stream,
                      fault);
    }
}
END_TEST

// Slivers whose normals are so short that their squares are subnormal.
START_TEST(normals_of_slivers_are_unit_vectors)
{
    static const long streams[] = {14297};
    const char *fault = run_scaled_call(
        generator_new((uint64_t)streams[_i]),
        (adaptive_scene_kind)(streams[_i] % MERGING_SCENES), &counts);
    ck_assert_msg(!fault, "stream %ld: %s", streams[_i], fault);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/scales");
    TCase *tcase = tcase_create("calls");
    tcase_add_loop_test(tcase, the_unit_of_length_does_not_matter, 0,
                        MERGING_SCENES);
    tcase_add_loop_test(tcase, normals_of_slivers_are_unit_vectors, 0, 1);
    suite_add_tcase(suite, tcase);
    return suite;
}

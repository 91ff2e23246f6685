// Random operations on adaptive surfaces, judged after each; and that the judge
// sees what happens if one of the tests is left out.
#include "support/adaptive_surfaces.h"
#include "support/support.h"
#include "support/surgery_runs.h"

static surgery_counts counts;

START_TEST(operations_never_tangle_the_surface)
{
    long runs = cases(20);
    for (long i = 0; i < runs; i++) {
        uint64_t stream = (uint64_t)(100 * i + _i);
        const char *fault = run_surgery(
            generator_new(stream), (adaptive_scene_kind)_i, 200, 0, &counts);
        ck_assert_msg(!fault, "stream %llu: %s", (unsigned long long)stream,
                      fault);
    }
}
END_TEST

/// The surface of a scene, mirrored in the plane x = 0, with vertices numbered
/// anew, and triangles listed in another order, turned over, from any corner on.
static tf_adaptive_surface *mirrored(const adaptive_scene *scene,
                                     generator *random, int number[])
{
    static double position[PLACED_VERTICES][3];
    static int triangle[3 * PLACED_TRIANGLES];
    for (int v = 0; v < scene->vertices; v++) {
        int other = below(random, v + 1);
        number[v] = v;
        number[v] = number[other];
        number[other] = v;
    }
    for (int i = 0; i < 3 * scene->vertices; i++)
        position[number[i / 3]][i % 3] =
            i % 3 == 0 ? -scene->position[i] : scene->position[i];
    for (int t = 0; t < scene->triangles; t++) {
        int turned = below(random, 3);
        for (int i = 0; i < 3; i++)
            triangle[3 * (scene->triangles - 1 - t) + (turned + 3 - i) % 3] =
                number[scene->triangle[3 * t + i]];
    }
    return adaptive_of(scene->vertices, position, scene->triangles, triangle);
}

START_TEST(the_same_surgery_is_accepted_in_a_mirror)
{
    static surgery_run run;
    static int number[LABELLED];
    surgery_run_begin(&run, generator_new(50 + (uint64_t)_i),
                      (adaptive_scene_kind)_i, &counts);
    tf_adaptive_surface *other = mirrored(&run.scene, &run.random, number);
    for (long i = 0; i < cases(1000); i++) {
        int vertex, others;
        surgery_choice one = surgery_run_choose(&run), its = one;
        its.a = number[one.a];
        its.b = number[one.b];
        its.position[0] = -one.position[0];
        tf_outcome outcome = surgery_choice_try(run.surface, &one, &vertex);
        tf_outcome same = surgery_choice_try(other, &its, &others);
        ck_assert_int_eq(outcome == TF_COMMITTED, same == TF_COMMITTED);
        ck_assert_int_eq(outcome == TF_IMPOSSIBLE, same == TF_IMPOSSIBLE);
        if (vertex >= 0)
            number[vertex] = others;
    }
    tf_adaptive_free(other);
    surgery_run_end(&run);
}
END_TEST

/// A test that is left out, and a scene that shows it.
static const struct {
    tf_outcome left_out;
    adaptive_scene_kind kind;
} needed[] = {
    {TF_FLATTENED, SHEETS},     {TF_OVERLAPPED, SLABS},
    {TF_PASSED_VERTEX, DUST},   {TF_PASSED_EDGE, DUST},
    {TF_PASSED_TRIANGLE, DUST},
};

START_TEST(each_test_left_out_is_noticed)
{
    const char *fault = NULL;
    for (uint64_t i = 0; i < 200 && !fault; i++)
        fault = run_surgery(generator_new(i), needed[_i].kind, 300,
                            1U << needed[_i].left_out, &counts);
    ck_assert(fault);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/surgery");
    TCase *tcase = tcase_create("operations");
    tcase_add_loop_test(tcase, operations_never_tangle_the_surface, 0,
                        ADAPTIVE_SCENES);
    tcase_add_loop_test(tcase, the_same_surgery_is_accepted_in_a_mirror, 0,
                        ADAPTIVE_SCENES);
    tcase_add_loop_test(tcase, each_test_left_out_is_noticed, 0,
                        sizeof needed / sizeof *needed);
    suite_add_tcase(suite, tcase);
    return suite;
}

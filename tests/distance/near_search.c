// The search of near pairs, against all pairs in rational numbers.
#include "distance/near_search.h"

#include "support/environments.h"
#include "support/near_oracle.h"
#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"

#include <float.h>
#include <math.h>

static void expect_pairs(const tf_near_search *search)
{
    size_t count;
    const near_oracle_pair *all =
        near_oracle(search->surface, search->position, search->before,
                    search->length, &count);
    tf_near_pairs found;
    ck_assert_int_eq(tf_near_search_run(search, &found, NULL), TF_OK);
    ck_assert_msg(
        found.count == count, "seed %llu, %zu pairs within %a, not %zu",
        (unsigned long long)seed(), found.count, search->length, count);
    for (size_t i = 0; i < count; i++) {
        ck_assert_int_eq((int)found.pair[i].kind, all[i].kind);
        for (int j = 0; j < 4; j++)
            ck_assert_int_eq(found.pair[i].vertex[j], all[i].vertex[j]);
    }
}

/// A length of about the size of an element: the distance of two vertices.
static double draw_length(generator *random, const surface_case *given)
{
    int axes = given->mesh.axes, a = below(random, given->mesh.vertices),
        b = below(random, given->mesh.vertices);
    double most = 0;
    for (int k = 0; k < axes; k++)
        most = fmax(most, fabs(given->start[axes * a + k] / 2 -
                               given->start[axes * b + k] / 2));
    most *= uniform(random, 0, 2);
    return most > 0 ? most : 1;
}

START_TEST(pairs_are_those_of_all)
{
    static surface_case given;
    generator random = generator_new((uint64_t)_i);
    int workers = 3;
    tf_parallel parallel = scrambled_workers(&workers);
    // At least one case in the plane and one in space.
    for (long i = 1 + cases(_i == HUGE_AND_TINY ? 5 : 15); i > 0; i--) {
        random_surface(&random, 2 + (int)(i % 2), 6, (placement)_i, &given);
        tf_surface *surface = surface_of(&given.mesh);
        tf_near_search search = {.surface = surface,
                                 .vertices = given.mesh.vertices,
                                 .position = given.end,
                                 .before = i % 3 ? given.start : NULL,
                                 .length = draw_length(&random, &given)};
        expect_pairs(&search);
        search.parallel = &parallel;
        expect_pairs(&search);
        tf_surface_free(surface);
    }
}
END_TEST

// Two points over a triangle in the plane z = 0, one of them nearer than 2.
START_TEST(a_length_counts_to_the_last_bit)
{
    static const int triangle[] = {0, 1, 2};
    tf_mesh mesh = {
        .axes = 3, .vertices = 5, .triangles = 1, .triangle = triangle};
    tf_surface *surface = surface_of(&mesh);
    double position[] = {-9, -9, 0, 9, -9, 0, 0, 9, 0, 0, 0, 2, 0, 0, -2};
    position[14] = nextafter(-2, 0);
    tf_near_search search = {
        .surface = surface, .vertices = 5, .position = position, .length = 2};
    tf_near_pairs found;
    ck_assert_int_eq(tf_near_search_run(&search, &found, NULL), TF_OK);
    ck_assert_uint_eq(found.count, 1);
    ck_assert_int_eq(found.pair[0].vertex[0], 4);
    search.before = position;
    ck_assert_int_eq(tf_near_search_run(&search, &found, NULL), TF_OK);
    ck_assert_uint_eq(found.count, 0);
    search.before = NULL;
    search.length = DBL_MAX;
    ck_assert_int_eq(tf_near_search_run(&search, &found, NULL), TF_OK);
    ck_assert_uint_eq(found.count, 2);
    tf_surface_free(surface);
}
END_TEST

// A point on either side of a triangle that has no extent along an axis; before, it
// was far away on that side.
START_TEST(what_was_searched_before_leaves_no_traces)
{
    static const int triangle[] = {0, 1, 2};
    tf_mesh mesh = {
        .axes = 3, .vertices = 4, .triangles = 1, .triangle = triangle};
    int axis = _i / 2;
    double side = _i % 2 ? -1 : 1, position[12] = {0};
    position[3 + (axis + 1) % 3] = position[6 + (axis + 2) % 3] = 4;
    position[9 + (axis + 1) % 3] = position[9 + (axis + 2) % 3] = 1;
    tf_surface *surface = surface_of(&mesh);
    tf_near_search search = {
        .surface = surface, .vertices = 4, .position = position, .length = 2};
    tf_near_pairs found;
    for (int near = 0; near < 2; near++) {
        position[9 + axis] = side * (near ? 1.5 : 100);
        ck_assert_int_eq(tf_near_search_run(&search, &found, NULL), TF_OK);
        ck_assert_uint_eq(found.count, (size_t)near);
    }
    tf_surface_free(surface);
}
END_TEST

static void run_broken(void *context, int count, tf_task *run, void *argument)
{
    for (int task = 0; task < count; task++) {
        environment_break(*(int *)context);
        run(argument, task, 0);
        environment_restore();
    }
}

enum {
    MANY = 1500
};

// Points above a triangle, so many that there is more than one task.
START_TEST(a_broken_environment_of_a_worker_is_told)
{
    static const int triangle[] = {0, 1, 2};
    static double position[3 * MANY] = {0, 0, 0, 9, 0, 0, 0, 9, 0};
    for (int v = 3; v < MANY; v++)
        position[3 * v] = position[3 * v + 1] = position[3 * v + 2] = v / 3000.;
    tf_mesh mesh = {
        .axes = 3, .vertices = MANY, .triangles = 1, .triangle = triangle};
    tf_surface *surface = surface_of(&mesh);
    tf_parallel parallel = {2, run_broken, &_i};
    tf_near_search search = {.surface = surface,
                             .vertices = MANY,
                             .position = position,
                             .length = 2,
                             .parallel = &parallel};
    tf_near_pairs found = {.count = 42};
    ck_assert_int_eq(tf_near_search_run(&search, &found, NULL),
                     TF_BAD_ENVIRONMENT);
    ck_assert_uint_eq(found.count, 42);
    tf_surface_free(surface);
}
END_TEST

// In the plane, an edge at one end of the doubles, a point in the middle, one
// nearer to it, and one at the other end.
START_TEST(cubes_may_reach_beyond_all_doubles)
{
    static const int edge[] = {0, 1};
    static const double position[] = {-DBL_MAX,     0, -DBL_MAX, 1, 0, 0,
                                      -DBL_MAX / 2, 0, DBL_MAX,  0};
    tf_mesh mesh = {.axes = 2, .vertices = 5, .edges = 1, .edge = edge};
    tf_surface *surface = surface_of(&mesh);
    tf_near_search search = {.surface = surface,
                             .vertices = 5,
                             .position = position,
                             .length = DBL_MAX};
    tf_near_pairs found;
    ck_assert_int_eq(tf_near_search_run(&search, &found, NULL), TF_OK);
    ck_assert_uint_eq(found.count, 1);
    ck_assert_int_eq(found.pair[0].vertex[0], 3);
    tf_surface_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("distance/near_search");
    TCase *tcase = tcase_create("near_search");
    tcase_add_loop_test(tcase, pairs_are_those_of_all, 0, PLACEMENTS);
    tcase_add_test(tcase, a_length_counts_to_the_last_bit);
    tcase_add_loop_test(tcase, what_was_searched_before_leaves_no_traces, 0, 6);
    tcase_add_loop_test(tcase, a_broken_environment_of_a_worker_is_told, 0,
                        environments());
    tcase_add_test(tcase, cubes_may_reach_beyond_all_doubles);
    suite_add_tcase(suite, tcase);
    return suite;
}

// Each operation of a flow keeps the volume, checked by volumes in rational
// numbers.
#include "flow/keep_volume.h"

#include "remesh/passes.h"
#include "support/careless.h"
#include "support/flows.h"
#include "support/generator.h"
#include "support/remeshers.h"
#include "support/support.h"

// Passes ----------------------------------------------------------------------

/// Passes that find a lot to do on a bumpy sphere.
static const struct {
    tf_operation operation;
    int n;
    double bump, edge;
} passes[TF_REMESH_PASSES] = {
    {TF_SPLIT, 8, 0.05, 0.15},
    {TF_COLLAPSE, 8, 0.05, 0.6},
    {TF_FLIP, 12, 0.033, 0.2},
    {TF_SMOOTH, 8, 0.05, 0.2},
};

/// How much the volume changes in one of the passes by a policy.
static double change_by(int pass, const tf_remesh_policy *policy,
                        uint64_t stream)
{
    tf_operation operation = passes[pass].operation;
    tf_remesher *remesher = remesher_begin(
        adaptive_bumpy_sphere(passes[pass].n, passes[pass].bump, stream),
        policy, passes[pass].edge);
    mpq_t before;
    mpq_init(before);
    exact_volume(remesher->surface, before);
    ck_assert_int_eq(tf_remesh_pass(remesher, operation), TF_OK);
    ck_assert_int_gt(done(remesher, operation), 10);
    double gained = volume_gained(remesher->surface, before);
    mpq_clear(before);
    expect_embedded(remesher->surface);
    remesher_end(remesher);
    return fabs(gained);
}

START_TEST(each_pass_keeps_the_volume)
{
    for (uint64_t stream = 0; stream < 3; stream++)
        ck_assert_double_lt(change_by(_i, &tf_keep_volume, stream), 1e-14);
}
END_TEST

START_TEST(no_careless_pass_keeps_the_volume)
{
    tf_remesh_policy policy = careless_policy(1U << passes[_i].operation);
    ck_assert_double_gt(change_by(_i, &policy, 0), 1e-6);
}
END_TEST

// Splits ----------------------------------------------------------------------

START_TEST(a_split_that_was_refused_is_tried_in_the_middle)
{
    tf_remesher *remesher =
        remesher_begin(adaptive_bumpy_sphere(4, 0.02, 0), &tf_keep_volume, 0.2);
    const int *v = tf_triangle(remesher->surface, 0);
    tf_vector middle = tf_middle_of(remesher->surface, v[0], v[1]), position;
    tf_volume_error error;
    for (int refused = 0; refused < 3; refused++) {
        ck_assert(tf_keep_volume.choose_split(remesher, 0, refused, &position,
                                              &error) == (refused < 2));
        ck_assert_int_eq(error.count, refused == 0 ? 4 : 0);
        ck_assert((position.x[0] == middle.x[0]) == (refused > 0));
    }
    remesher_end(remesher);
}
END_TEST

// Restoring -------------------------------------------------------------------

static tf_remesher *made;

static void begin(void)
{
    made =
        remesher_begin(adaptive_bumpy_sphere(6, 0.02, 0), &tf_keep_volume, 0.3);
}

static void end(void)
{
    remesher_end(made);
}

static double gain_by_restoring(const tf_volume_error *error)
{
    mpq_t before;
    mpq_init(before);
    exact_volume(made->surface, before);
    ck_assert_int_eq(tf_keep_volume.restore(made, error), TF_OK);
    double gained = volume_gained(made->surface, before);
    mpq_clear(before);
    return gained;
}

START_TEST(what_was_lost_is_gained)
{
    generator random = generator_new(100);
    for (int i = 0; i < 60; i++) {
        tf_volume_error error = {uniform(&random, -0.004, 0.004), 4, {0}};
        for (int k = 0; k < 4; k++)
            error.vertex[k] = 25 * k + below(&random, 25);
        ck_assert_double_eq_tol(gain_by_restoring(&error), error.lost / 6,
                                1e-16);
    }
    ck_assert_uint_eq(made->restored[TF_COMMITTED], 240);
}
END_TEST

START_TEST(no_vertex_moves_far)
{
    static const tf_volume_error large = {1, 1, {3}};
    ck_assert_double_eq(gain_by_restoring(&large), 0);
}
END_TEST

START_TEST(an_error_of_no_vertices_is_not_restored)
{
    static const tf_volume_error none = {1e-3, 0, {3}};
    ck_assert_double_eq(gain_by_restoring(&none), 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("flow/keep_volume");
    TCase *tcase = tcase_create("passes");
    tcase_add_loop_test(tcase, each_pass_keeps_the_volume, 0, TF_REMESH_PASSES);
    tcase_add_loop_test(tcase, no_careless_pass_keeps_the_volume, 0,
                        TF_REMESH_PASSES);
    tcase_add_test(tcase, a_split_that_was_refused_is_tried_in_the_middle);
    suite_add_tcase(suite, tcase);
    tcase = tcase_create("restoring");
    tcase_add_checked_fixture(tcase, begin, end);
    tcase_add_test(tcase, what_was_lost_is_gained);
    tcase_add_test(tcase, no_vertex_moves_far);
    tcase_add_test(tcase, an_error_of_no_vertices_is_not_restored);
    suite_add_tcase(suite, tcase);
    return suite;
}

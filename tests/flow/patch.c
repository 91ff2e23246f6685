// The plane of positions at which no volume is gained, checked by volumes in
// rational numbers.
#include "flow/patch.h"

#include "support/flows.h"
#include "support/support.h"
#include "surgery/move.h"

/// Moves a vertex to where its star gains 1/6 of `more`; returns by how much
/// the surface then differs from that.
static double error_of_move(tf_adaptive_surface *surface, int vertex,
                            tf_vector apex, double more)
{
    mpq_t before;
    tf_outcome outcome;
    tf_patch star = tf_patch_of_star(surface, vertex, apex);
    tf_vector position = tf_patch_position(&star, more);
    mpq_init(before);
    exact_volume(surface, before);
    ck_assert_int_eq(tf_adaptive_move(surface, vertex, position.x, &outcome),
                     TF_OK);
    ck_assert_int_eq(outcome, TF_COMMITTED);
    double error = volume_gained(surface, before) - more / 6;
    mpq_clear(before);
    return error;
}

START_TEST(a_move_gains_what_it_should)
{
    tf_adaptive_surface *surface = adaptive_bumpy_sphere(4, 0.02, 1);
    generator random = generator_new(2);
    for (int v = 0; v < surface->vertices; v++) {
        tf_vector apex = tf_position_of(surface, v);
        for (int k = 0; k < 3; k++)
            apex.x[k] += uniform(&random, -0.02, 0.02);
        double more = v % 2 ? uniform(&random, -0.01, 0.01) : 0;
        ck_assert_double_eq_tol(error_of_move(surface, v, apex, more), 0,
                                1e-16);
    }
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(the_apex_goes_straight_to_the_level)
{
    static const tf_shape shape = {{{{0, 0, 1}}, {{1, 0, 1}}, {{0, 1, 1}}}};
    tf_patch patch = {.apex = {{0.25, 0.5, -1}}};
    tf_patch_add(&patch, &shape);
    ck_assert_double_eq(patch.below, 2);
    tf_vector position = tf_patch_position(&patch, 0);
    static const double expected[] = {0.25, 0.5, 1};
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq(position.x[k], expected[k]);
    ck_assert_double_eq(tf_patch_position(&patch, 0.5).x[2], 1.5);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("flow/patch");
    TCase *tcase = tcase_create("level");
    tcase_add_test(tcase, a_move_gains_what_it_should);
    tcase_add_test(tcase, the_apex_goes_straight_to_the_level);
    suite_add_tcase(suite, tcase);
    return suite;
}

// Smoothing around what crosses.
#include "untangle/smooth.h"

#include "support/support.h"
#include "support/tangles.h"

#include <limits.h>

static made_tangle own;
static tf_change change;

static void smooth(int rings)
{
    ck_assert(tf_change_begin(&change, &own.tangle));
    ck_assert(tf_smooth(&change, &own.tangle, own.x, rings));
}

static void release(void)
{
    tf_change_free(&change);
    tangle_free(&own);
    change = (tf_change){.move = NULL};
}

START_TEST(only_what_is_near_moves)
{
    tangle_make_bump(&own, 3);
    tangle_finish(&own);
    own.fixed[169 + 84] = true;
    smooth(1);
    for (int k = 0; k < 3; k++) {
        ck_assert_double_eq(change.move[169].x[k], 0);
        ck_assert_double_eq(change.move[169 + 84].x[k], 0);
    }
    // The bump's ring is pulled up by the neighbors outside.
    int raised = 0;
    for (int v = 169; v < 338; v++)
        raised += change.move[v].x[2] != 0;
    ck_assert_int_gt(raised, 4);
    release();
}
END_TEST

START_TEST(a_vertex_goes_half_way_to_the_mean)
{
    tangle_make_bump(&own, 3);
    tangle_finish(&own);
    smooth(INT_MAX);
    int v = 169 + 84;
    const tf_lists *around = &own.tangle.near.around;
    tf_vector mean = {{0, 0, 0}}, place = tf_place(&own.tangle.near, own.x, v);
    int count = tf_list_length(around, v);
    for (int i = 0; i < count; i++)
        mean = tf_vector_sum(mean, 1.0 / count,
                             tf_place(&own.tangle.near, own.x,
                                      around->item[around->start[v] + i]));
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(change.move[v].x[k],
                                (mean.x[k] - place.x[k]) / 2, 1e-14);
    release();
}
END_TEST

START_TEST(a_boundary_goes_along_itself)
{
    tangle_make_bump(&own, 3);
    tangle_finish(&own);
    own.x[3 * 6] += 0.25;
    smooth(INT_MAX);
    // A corner goes a quarter of the way to each of its two neighbors, what is
    // between two others on a line stays on it.
    ck_assert_double_eq_tol(change.move[0].x[0], 0.25, 1e-15);
    ck_assert_double_eq_tol(change.move[0].x[1], 0.25, 1e-15);
    ck_assert_double_eq_tol(change.move[3].x[0], 0, 1e-15);
    ck_assert_double_eq_tol(change.move[3].x[1], 0, 1e-15);
    ck_assert_double_eq_tol(change.move[6].x[0], -0.125, 1e-15);
    release();
}
END_TEST

// Four fans at a vertex make eight boundary edges of it.
START_TEST(a_vertex_of_many_boundaries_does_not_go_too_far)
{
    tangle_begin(&own, 3);
    tangle_add(&own, 1, (double[]){0, 0, 3});
    for (int i = 0; i < 4; i++) {
        double a = i < 2 ? 1 : -1, b = i % 2 ? 1 : -1;
        int first = tangle_add(&own, 2, (double[]){a, b, 0, a, 2 * b, 0});
        tangle_add_triangle(&own, 0, first, first + 1);
    }
    tangle_add(&own, 3, (double[]){-9, -9, 1, 9, -9, 1, 0, 9, 1});
    tangle_add_triangle(&own, 9, 10, 11);
    tangle_finish(&own);
    smooth(0);
    ck_assert_double_eq_tol(change.move[0].x[2], -1.5, 1e-15);
    release();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/smooth");
    TCase *tcase = tcase_create("smooth");
    tcase_add_test(tcase, only_what_is_near_moves);
    tcase_add_test(tcase, a_vertex_goes_half_way_to_the_mean);
    tcase_add_test(tcase, a_boundary_goes_along_itself);
    tcase_add_test(tcase, a_vertex_of_many_boundaries_does_not_go_too_far);
    suite_add_tcase(suite, tcase);
    return suite;
}

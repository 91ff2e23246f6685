// Wrong regions are pushed through what they have passed.
#include "untangle/push.h"

#include "support/support.h"
#include "support/tangles.h"

static made_tangle own;
static tf_push push;
static tf_change change;

static void propose(void)
{
    ck_assert(tf_push_begin(&push, &own.tangle));
    ck_assert(tf_change_begin(&change, &own.tangle));
    ck_assert(tf_push_propose(&push, &own.tangle, own.x, &change));
}

static void release(void)
{
    tf_push_free(&push);
    tf_change_free(&change);
    tangle_free(&own);
    push = (tf_push){.targets = 0};
    change = (tf_change){.move = NULL};
}

START_TEST(a_bump_goes_back_through_the_sheet)
{
    tangle_make_bump(&own, 3);
    tangle_finish(&own);
    propose();
    int wrong = 0;
    for (int v = 169; v < own.mesh.vertices; v++)
        if (own.x[3 * v + 2] < 0) {
            ck_assert_double_gt(change.weight[v], 0);
            ck_assert_double_gt(change.move[v].x[2], 0);
            wrong++;
        }
    ck_assert_int_gt(wrong, 4);
    // The sheet comes half of the way.
    double least = 0;
    for (int v = 0; v < 169; v++)
        least = change.move[v].x[2] < least ? change.move[v].x[2] : least;
    ck_assert_double_lt(least, 0);
    release();
}
END_TEST

// A sheet that is free comes half of the way.
START_TEST(a_fixed_sheet_lets_the_other_go_all_the_way)
{
    double way[2];
    for (int i = 0; i < 2; i++) {
        tangle_make_bump(&own, 1);
        for (int v = 0; v < 169; v++)
            own.fixed[v] = i == 1;
        tangle_finish(&own);
        propose();
        int tip = 169;
        for (int v = 169; v < own.mesh.vertices; v++)
            tip = own.x[3 * v + 2] < own.x[3 * tip + 2] ? v : tip;
        way[i] = change.move[tip].x[2] / change.weight[tip];
        release();
    }
    ck_assert_double_gt(way[0], 0);
    ck_assert_double_gt(way[1], 1.5 * way[0]);
}
END_TEST

START_TEST(a_clear_surface_is_not_pushed)
{
    tangle_make_bump(&own, 0.1);
    tangle_finish(&own);
    ck_assert_uint_eq(own.tangle.crossings.count, 0);
    propose();
    for (int v = 0; v < own.mesh.vertices; v++)
        ck_assert_double_eq(change.weight[v], 0);
    release();
}
END_TEST

// Edges that are cut twice cut nothing, so the curves shorten.
START_TEST(where_nothing_is_cut_curves_shorten)
{
    tangle_begin(&own, 3);
    tangle_add(&own, 3, (double[]){0, 0, 0, 4, 0, 0, 0, 4, 0});
    tangle_add(&own, 3, (double[]){0, 0, 1, 4, 0, 1, 0, 4, 1});
    tangle_add(&own, 3, (double[]){1, 1, -1, 1, 1, 2, 0.9, 1.2, 0.5});
    for (int t = 0; t < 3; t++)
        tangle_add_triangle(&own, 3 * t, 3 * t + 1, 3 * t + 2);
    tangle_finish(&own);
    propose();
    ck_assert_double_gt(change.weight[6], 0);
    release();
}
END_TEST

START_TEST(in_the_plane_a_corner_goes_back)
{
    tangle_begin(&own, 2);
    int first = tangle_add(&own, 5, (double[]){-4, 0, -2, 0, 0, 0, 2, 0, 4, 0});
    for (int i = 0; i < 4; i++)
        tangle_add_edge(&own, first + i, first + i + 1);
    int other =
        tangle_add(&own, 5, (double[]){-2, 2, -1, 1, 0.1, -0.5, 1, 1, 2, 2});
    for (int i = 0; i < 4; i++)
        tangle_add_edge(&own, other + i, other + i + 1);
    tangle_finish(&own);
    propose();
    ck_assert_double_gt(change.move[other + 2].x[1], 0);
    release();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/push");
    TCase *tcase = tcase_create("push");
    tcase_add_test(tcase, a_bump_goes_back_through_the_sheet);
    tcase_add_test(tcase, a_fixed_sheet_lets_the_other_go_all_the_way);
    tcase_add_test(tcase, a_clear_surface_is_not_pushed);
    tcase_add_test(tcase, where_nothing_is_cut_curves_shorten);
    tcase_add_test(tcase, in_the_plane_a_corner_goes_back);
    suite_add_tcase(suite, tcase);
    return suite;
}

// How proposals become moves.
#include "untangle/change.h"

#include "support/support.h"
#include "support/tangles.h"

static made_tangle own;
static tf_change change;
static const tf_vector up = {{0, 0, 1}};

static void begin(void)
{
    tangle_begin(&own, 3);
    tangle_add_sheet(&own, 9, (double[]){1, 0, 0}, (double[]){0, 1, 0},
                     (double[]){0, 0, 0});
    tangle_finish(&own);
    ck_assert(tf_change_begin(&change, &own.tangle));
}

static void release(void)
{
    tf_change_free(&change);
    tangle_free(&own);
    change = (tf_change){.move = NULL};
}

START_TEST(proposals_are_added_with_their_weights)
{
    begin();
    tf_change_add(&change, &own.tangle, 7, up, 0.5, 2);
    tf_change_add(&change, &own.tangle, 7, up, -0.25, 1);
    tf_change_add(&change, &own.tangle, 7, up, 9, 0);
    ck_assert_double_eq(change.move[7].x[2], 0.75);
    ck_assert_double_eq(change.weight[7], 3);
    ck_assert_double_eq(change.weight[6], 0);
    release();
}
END_TEST

START_TEST(nothing_is_proposed_to_fixed_vertices)
{
    begin();
    own.fixed[40] = own.fixed[41] = true;
    tf_change_add(&change, &own.tangle, 40, up, 1, 1);
    ck_assert_double_eq(change.weight[40], 0);
    tf_change_add(&change, &own.tangle, 39, up, 0.2, 1);
    ck_assert(tf_change_finish(&change, &own.tangle));
    ck_assert_double_eq(change.move[40].x[2], 0);
    ck_assert_double_eq(change.move[41].x[2], 0);
    ck_assert_double_gt(change.move[38].x[2], 0);
    release();
}
END_TEST

// Where everything is to move alike, spreading changes nothing; and no move is
// longer than half of the edges at its vertex.
START_TEST(what_moves_alike_is_as_long_as_half_an_edge)
{
    begin();
    double least = own.tangle.edge_at[0];
    for (int v = 0; v < own.mesh.vertices; v++) {
        tf_change_add(&change, &own.tangle, v, up, 99, 1);
        least = own.tangle.edge_at[v] < least ? own.tangle.edge_at[v] : least;
    }
    ck_assert(tf_change_finish(&change, &own.tangle));
    for (int v = 0; v < own.mesh.vertices; v++) {
        ck_assert_double_le(change.move[v].x[2], own.tangle.edge / 2 * 1.3);
        ck_assert_double_ge(change.move[v].x[2], least / 2 * (1 - 1e-14));
    }
    release();
}
END_TEST

START_TEST(moves_spread_and_fade)
{
    begin();
    tf_change_add(&change, &own.tangle, 40, up, 0.5, 1);
    ck_assert(tf_change_finish(&change, &own.tangle));
    double last = change.move[40].x[2];
    ck_assert_double_gt(last, 0);
    for (int v = 41; v < 45; v++) {
        ck_assert_double_gt(change.move[v].x[2], 0);
        ck_assert_double_lt(change.move[v].x[2], last);
        last = change.move[v].x[2];
    }
    release();
}
END_TEST

// What is pushed a little at a corner does not move the whole sheet.
START_TEST(the_least_moves_are_dropped)
{
    begin();
    tf_change_add(&change, &own.tangle, 0, up, 0.2, 1);
    ck_assert(tf_change_finish(&change, &own.tangle));
    ck_assert_double_gt(change.move[1].x[2], 0);
    int still = 0;
    for (int v = 0; v < own.mesh.vertices; v++) {
        double length = tf_vector_length(change.move[v]);
        ck_assert(length == 0 || length >= own.tangle.edge_at[v] / 65536);
        still += length == 0;
    }
    ck_assert_int_gt(still, 20);
    release();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/change");
    TCase *tcase = tcase_create("change");
    tcase_add_test(tcase, proposals_are_added_with_their_weights);
    tcase_add_test(tcase, nothing_is_proposed_to_fixed_vertices);
    tcase_add_test(tcase, what_moves_alike_is_as_long_as_half_an_edge);
    tcase_add_test(tcase, moves_spread_and_fade);
    tcase_add_test(tcase, the_least_moves_are_dropped);
    suite_add_tcase(suite, tcase);
    return suite;
}

// Rung after rung, until a surface is clear.
#include "untangle/attempts.h"

#include "support/support.h"
#include "support/tangles.h"

#include <string.h>

static made_tangle own;
static tf_attempts attempts;
static double x[3][3 * TANGLE_VERTICES];
static bool extends;

static void try_all(const tf_untangle_options *options)
{
    tangle_finish(&own);
    attempts = (tf_attempts){
        .tangle = own.tangle, .options = options, .extends = extends};
    attempts.x = x[0];
    attempts.next = x[1];
    attempts.best = x[2];
    memcpy(x[2], own.x, sizeof x[2]);
    ck_assert_int_eq(tf_attempt(&attempts), TF_OK);
    own.tangle = attempts.tangle;
}

static void release(void)
{
    tf_attempts_free(&attempts);
    tangle_free(&own);
}

static size_t crossings_of(const double place[])
{
    ck_assert_int_eq(tf_tangle_check(&own.tangle, place), TF_OK);
    return own.tangle.crossings.count;
}

START_TEST(a_bump_is_pushed_out)
{
    tangle_make_bump(&own, 3);
    try_all(&(tf_untangle_options){.rounds = 0});
    ck_assert_uint_eq(attempts.fewest, 0);
    ck_assert_uint_eq(crossings_of(attempts.best), 0);
    ck_assert_int_ne(attempts.rungs & TF_RUNG_PUSH, 0);
    ck_assert_int_gt(attempts.rounds, 0);
    release();
}
END_TEST

START_TEST(without_the_push_it_is_smoothed)
{
    tangle_make_bump(&own, 1.5);
    try_all(&(tf_untangle_options){.without = TF_RUNG_PUSH});
    ck_assert_uint_eq(attempts.fewest, 0);
    ck_assert_int_eq(attempts.rungs & TF_RUNG_PUSH, 0);
    ck_assert_int_ne(attempts.rungs & TF_RUNG_SMOOTH, 0);
    release();
}
END_TEST

START_TEST(with_nothing_else_parts_move_apart)
{
    tangle_make_bump(&own, 3);
    try_all(&(tf_untangle_options){.without = TF_RUNG_PUSH | TF_RUNG_SMOOTH |
                                              TF_RUNG_AGAIN | TF_RUNG_RELAX});
    ck_assert_uint_eq(attempts.fewest, 0);
    ck_assert_int_eq(attempts.rungs, TF_RUNG_APART);
    release();
}
END_TEST

START_TEST(without_all_rungs_nothing_moves)
{
    tangle_make_bump(&own, 3);
    try_all(&(tf_untangle_options){.without = 2 * TF_RUNG_RETURN - 1});
    ck_assert_uint_eq(attempts.fewest, crossings_of(own.x));
    ck_assert_int_eq(attempts.rungs, 0);
    ck_assert_mem_eq(attempts.best, own.x, sizeof own.x);
    release();
}
END_TEST

START_TEST(the_best_state_is_kept)
{
    for (int rounds = 1; rounds < 4; rounds++) {
        tangle_make_bump(&own, 3);
        try_all(&(tf_untangle_options){
            .rounds = rounds, .without = TF_RUNG_APART | TF_RUNG_RELAX});
        size_t before = crossings_of(own.x);
        ck_assert_uint_le(attempts.fewest, before);
        ck_assert_uint_eq(crossings_of(attempts.best), attempts.fewest);
        release();
    }
}
END_TEST

// One round is not enough to halve the crossings; five are, so five more follow.
START_TEST(an_attempt_goes_on_while_it_halves_its_crossings)
{
    int without = 2 * TF_RUNG_RETURN - 1 - TF_RUNG_PUSH;
    extends = true;
    for (int rounds = 1; rounds <= 5; rounds += 4) {
        tangle_make_bump(&own, 3);
        try_all(&(tf_untangle_options){.rounds = rounds, .without = without});
        bool halves = 2 * attempts.fewest <= crossings_of(own.x);
        ck_assert_int_eq(halves, rounds == 5);
        ck_assert_int_eq(attempts.rounds > rounds, halves);
        release();
    }
    extends = false;
}
END_TEST

START_TEST(no_attempt_has_more_rounds_than_the_caller_gives_it)
{
    int without = 2 * TF_RUNG_RETURN - 1 - TF_RUNG_PUSH;
    for (int rounds = 1; rounds <= 5; rounds += 4) {
        tangle_make_bump(&own, 3);
        try_all(&(tf_untangle_options){.rounds = rounds, .without = without});
        ck_assert_int_eq(attempts.rounds, rounds);
        release();
    }
}
END_TEST

// A flat sheet between a fixed border and a fixed bump has nowhere to go.
START_TEST(a_relaxation_goes_on_to_its_last_round)
{
    tangle_make_bump(&own, 3);
    for (int v = 0; v < own.mesh.vertices; v++)
        own.fixed[v] = v >= 169 || v / 13 % 12 == 0 || v % 13 % 12 == 0;
    try_all(&(tf_untangle_options){.without =
                                       2 * TF_RUNG_RETURN - 1 - TF_RUNG_RELAX});
    ck_assert_int_eq(attempts.rungs, TF_RUNG_RELAX);
    ck_assert_uint_eq(attempts.beyond, 0);
    ck_assert_uint_gt(attempts.fewest, 0);
    ck_assert_int_eq(attempts.rounds, 4000);
    release();
}
END_TEST

START_TEST(what_is_beyond_help_is_not_tried)
{
    tangle_make_bump(&own, 3);
    memset(own.fixed, 1, sizeof own.fixed);
    try_all(&(tf_untangle_options){.rounds = 0});
    ck_assert_uint_eq(attempts.beyond, attempts.fewest);
    ck_assert_int_eq(attempts.rounds, 0);
    release();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/attempts");
    TCase *tcase = tcase_create("attempts");
    tcase_add_test(tcase, a_bump_is_pushed_out);
    tcase_add_test(tcase, without_the_push_it_is_smoothed);
    tcase_add_test(tcase, with_nothing_else_parts_move_apart);
    tcase_add_test(tcase, without_all_rungs_nothing_moves);
    tcase_add_test(tcase, the_best_state_is_kept);
    tcase_add_test(tcase, an_attempt_goes_on_while_it_halves_its_crossings);
    tcase_add_test(tcase, no_attempt_has_more_rounds_than_the_caller_gives_it);
    tcase_add_test(tcase, a_relaxation_goes_on_to_its_last_round);
    tcase_add_test(tcase, what_is_beyond_help_is_not_tried);
    suite_add_tcase(suite, tcase);
    return suite;
}

#include "support/statuses.h"

#include "arithmetic/arithmetic.h"
#include "arithmetic/functions.h"
#include "base/contract.h"
#include "support/environments.h"
#include "support/rational.h"
#include "support/scenes.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// What is tried ---------------------------------------------------------------

static query_kind kind;
static status_query *ask;

void statuses_use(query_kind tried_kind, status_query *tried)
{
    kind = tried_kind;
    ask = tried;
}

/// Expect a status, and, unless it is TF_OK, that the result is left unset.
static void expect_status(const tf_arithmetic *arithmetic, const scene *s,
                          tf_status expected, const char *what)
{
    tf_motion motion = scene_motion(s);
    tf_contact contact, before;
    memset(&before, 42, sizeof before);
    contact = before;
    tf_status status = ask(arithmetic, &motion, s->index, &contact);
    ck_assert_msg(status == expected, "%s: \"%s\" and not \"%s\"", what,
                  tf_status_message(status), tf_status_message(expected));
    ck_assert_msg(status == TF_OK ||
                      memcmp(&contact, &before, sizeof contact) == 0,
                  "%s: a result without success", what);
    ck_assert_msg(status != TF_OK || contact.verdict == TF_HIT,
                  "%s: verdict %d", what, (int)contact.verdict);
}

static scene good_scene(void)
{
    static const int index[QUERY_VERTICES] = {4, 1, 3, 2};
    query q = scene_hit(kind);
    return scene_of(&q, index);
}

/// How many vertices the query has, and the i-th coordinate of one of them.
static int vertices(void)
{
    return kind == POINT_EDGE ? 3 : 4;
}

static double *coordinate(scene *s, int i)
{
    int axes = kind == POINT_EDGE ? 2 : 3, count = axes * vertices();
    double *x = i < count ? s->start : s->end;
    return &x[axes * s->index[i % count / axes] + i % axes];
}

static int coordinates(void)
{
    return 2 * vertices() * (kind == POINT_EDGE ? 2 : 3);
}

// Statuses --------------------------------------------------------------------

START_TEST(a_good_query_is_answered)
{
    scene s = good_scene();
    expect_status(&oracle_arithmetic, &s, TF_OK, "a good query");
    tf_arithmetic perturbed = oracle_arithmetic;
    perturbed.needs_indices = true;
    expect_status(&perturbed, &s, TF_OK, "a good query with indices");
}
END_TEST

START_TEST(a_broken_environment_is_reported)
{
    scene s = good_scene();
    tf_motion motion = scene_motion(&s);
    tf_contact contact = {.normal_velocity = 42};
    environment_break(_i);
    tf_status status = ask(&oracle_arithmetic, &motion, s.index, &contact);
    bool left = environment_is_broken(_i);
    environment_restore();
    ck_assert_msg(status == TF_BAD_ENVIRONMENT, "%s: \"%s\"",
                  environment_name(_i), tf_status_message(status));
    ck_assert_msg(left, "%s is changed", environment_name(_i));
    ck_assert_double_eq(contact.normal_velocity, 42);
    expect_status(&oracle_arithmetic, &s, TF_OK, "the environment restored");
}
END_TEST

START_TEST(an_index_of_no_vertex_is_bad)
{
    static const int bad[] = {-1, -2, INT_MIN, SCENE_VERTICES, INT_MAX};
    for (int i = 0; i < vertices(); i++)
        for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
            scene s = good_scene();
            s.index[i] = bad[k];
            expect_status(&oracle_arithmetic, &s, TF_BAD_INDEX,
                          "an index of no vertex");
        }
}
END_TEST

START_TEST(a_repeated_index_is_bad)
{
    for (int i = 0; i < vertices(); i++)
        for (int k = 0; k < vertices(); k++) {
            scene s = good_scene();
            s.index[i] = s.index[k];
            expect_status(&oracle_arithmetic, &s, i == k ? TF_OK : TF_BAD_INDEX,
                          "a repeated index");
        }
}
END_TEST

/// Expect a status of a motion, and that the result is left unset.
static void expect_refused(const tf_motion *motion, tf_status expected)
{
    scene s = good_scene();
    tf_contact contact = {.normal_velocity = 42};
    tf_status status = ask(&oracle_arithmetic, motion, s.index, &contact);
    ck_assert_msg(status == expected, "\"%s\"", tf_status_message(status));
    ck_assert_double_eq(contact.normal_velocity, 42);
}

START_TEST(motions_of_other_axes_are_refused)
{
    static const int axes[] = {0, 1, 2, 3, 4, -1, INT_MAX, INT_MIN};
    scene s = good_scene();
    for (size_t i = 0; i < sizeof axes / sizeof *axes; i++) {
        tf_motion motion = scene_motion(&s);
        motion.axes = axes[i];
        if (axes[i] != s.axes)
            expect_refused(&motion, TF_BAD_AXES);
    }
    expect_refused(&(tf_motion){0}, TF_BAD_AXES);
}
END_TEST

START_TEST(motions_without_a_count_are_refused)
{
    scene s = good_scene();
    const tf_motion good = scene_motion(&s);
    tf_motion negative = good, least = good, no_start = good, no_end = good;
    negative.vertices = -1;
    least.vertices = INT_MIN;
    no_start.start = NULL;
    no_end.end = NULL;
    expect_refused(&negative, TF_BAD_COUNT);
    expect_refused(&least, TF_BAD_COUNT);
    expect_refused(&no_start, TF_BAD_COUNT);
    expect_refused(&no_end, TF_BAD_COUNT);
    expect_refused(&(tf_motion){.axes = good.axes}, TF_BAD_INDEX);
}
END_TEST

START_TEST(a_coordinate_that_is_not_finite_is_refused)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < coordinates(); i++) {
        scene s = good_scene();
        *coordinate(&s, i) = bad[_i];
        expect_status(&oracle_arithmetic, &s, TF_NOT_FINITE, "not finite");
    }
}
END_TEST

START_TEST(a_coordinate_beyond_the_arithmetic_is_refused)
{
    tf_arithmetic narrow = oracle_arithmetic;
    narrow.bits[2] = narrow.bits[3] = 3;
    for (int i = 0; i < coordinates(); i++) {
        static const double bad[] = {8, -8, 0.5, 0x1p60, 0x1p-1074};
        for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
            scene s = good_scene();
            expect_status(&narrow, &s, TF_OK, "all in range");
            *coordinate(&s, i) = bad[k];
            expect_status(&narrow, &s, TF_OUT_OF_RANGE, "out of range");
        }
    }
}
END_TEST

// Contracts -------------------------------------------------------------------

static void exit_if_known(const char *file, int line, const char *condition)
{
    bool known = strstr(file, ".c") && line > 0 && condition[0] != '\0';
    exit(known ? BROKEN_CONTRACT : 1);
}

void exit_on_broken_contract(void)
{
    tf_contract_set_handler(exit_if_known);
}

START_TEST(a_null_pointer_breaks_the_contract)
{
    enum {
        NO_ARITHMETIC,
        NO_MOTION,
        NO_CONTACT
    };
    scene s = good_scene();
    tf_motion motion = scene_motion(&s);
    tf_contact contact;
    exit_on_broken_contract();
    ask(_i == NO_ARITHMETIC ? NULL : &oracle_arithmetic,
        _i == NO_MOTION ? NULL : &motion, s.index,
        _i == NO_CONTACT ? NULL : &contact);
}
END_TEST

TCase *statuses_case_of_doubles(const char *name, void (*use)(void))
{
    TCase *c = tcase_create(name);
    tcase_add_checked_fixture(c, use, NULL);
    tcase_add_test(c, a_good_query_is_answered);
    tcase_add_loop_test(c, a_broken_environment_is_reported, 0, environments());
    tcase_add_test(c, an_index_of_no_vertex_is_bad);
    tcase_add_test(c, a_repeated_index_is_bad);
    tcase_add_test(c, motions_of_other_axes_are_refused);
    tcase_add_test(c, motions_without_a_count_are_refused);
    tcase_add_loop_test(c, a_coordinate_that_is_not_finite_is_refused, 0, 3);
    tcase_add_loop_exit_test(c, a_null_pointer_breaks_the_contract,
                             BROKEN_CONTRACT, 0, 3);
    return c;
}

TCase *statuses_case(const char *name, void (*use)(void))
{
    TCase *c = statuses_case_of_doubles(name, use);
    tcase_add_test(c, a_coordinate_beyond_the_arithmetic_is_refused);
    return c;
}

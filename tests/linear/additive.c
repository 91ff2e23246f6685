#include "linear/additive.h"

#include "support/linear_methods.h"
#include "support/scenes.h"
#include "support/statuses.h"
#include "support/support.h"

#include <math.h>

static query_kind kind;

static void use_kind(int i)
{
    kind = (query_kind)i;
}

START_TEST(advancement_ends_near_the_contact)
{
    use_kind(_i);
    query q = scene_hit(kind);
    double last = 0;
    for (double threshold = 0.1; threshold > 1e-13; threshold /= 10) {
        tf_advance_limits limits = {.threshold = threshold};
        tf_advancement at;
        tf_contact contact = additive_answer(&q, &limits, &at);
        expect_contact(&q, &contact);
        ck_assert_int_eq(contact.verdict, TF_HIT);
        ck_assert_double_lt(contact.toi_lo, 0.5);
        ck_assert_double_gt(contact.toi_lo, 0.5 - threshold);
        ck_assert_double_gt(contact.toi_lo, last);
        ck_assert_double_eq(contact.normal[q.axes - 1], 1);
        ck_assert_double_eq(contact.toi_lo, at.time);
        last = contact.toi_lo;
    }
}
END_TEST

START_TEST(a_shared_translation_costs_no_step)
{
    // The whole scene flies off; the point falls at the same speed as before.
    query q = scene_hit(POINT_TRIANGLE);
    tf_advance_limits limits = {.threshold = 1e-6};
    tf_advancement still, flying;
    additive_answer(&q, &limits, &still);
    for (int i = 0; i < 4; i++)
        q.vertex[i].at[1].x[1] += 1024;
    additive_answer(&q, &limits, &flying);
    ck_assert_int_eq(still.steps, flying.steps);
}
END_TEST

// The time never passes the true one, and apart is always true.

static query any_query(generator *random)
{
    return below(random, 2) ? query_any(random, kind)
                            : query_lattice(random, kind, 8);
}

START_TEST(advancement_never_passes_the_contact)
{
    use_kind(_i);
    generator random = generator_new((uint64_t)_i);
    static const tf_advance_limits limits[] = {
        {.threshold = 1e-3}, {.threshold = 1e-6}, {1e-9, 0.1, 0}};
    for (long i = 0; i < cases(6000); i++) {
        query q = any_query(&random);
        double toi = 2;
        linear_query_truth(&q, &toi);
        tf_advancement at;
        tf_contact contact = additive_answer(&q, &limits[i % 3], &at);
        expect_contact(&q, &contact);
        ck_assert_msg(at.time <= toi, "time %a, truth %a:\n%s", at.time, toi,
                      query_text(&q));
        ck_assert_msg(toi > 1 || contact.verdict != TF_APART, "missed:\n%s",
                      query_text(&q));
    }
}
END_TEST

START_TEST(extreme_coordinates_give_finite_contacts)
{
    use_kind(_i);
    generator random = generator_new(10 + (uint64_t)_i);
    for (long i = 0; i < cases(3000); i++) {
        query q = query_extreme(&random, kind);
        tf_advance_limits limits = {.threshold = 1e-6, .steps = 100};
        tf_advancement at;
        tf_contact contact = additive_answer(&q, &limits, &at);
        expect_contact(&q, &contact);
        ck_assert_msg(isfinite(at.distance) && at.time >= 0 && at.time <= 1,
                      "%s", query_text(&q));
    }
}
END_TEST

START_TEST(the_limit_of_steps_is_kept)
{
    query q = scene_hit(POINT_TRIANGLE);
    q.vertex[3].at[1].x[1] = 8; // the bound is not the speed any more
    tf_advance_limits limits = {.threshold = 1e-9, .steps = 1};
    tf_advancement at;
    tf_contact contact = additive_answer(&q, &limits, &at);
    ck_assert_int_eq(contact.verdict, TF_UNDECIDED);
    ck_assert_int_eq(at.steps, 1);
    ck_assert_double_lt(contact.toi_lo, 0.5);
}
END_TEST

// Statuses --------------------------------------------------------------------

static tf_status ask_additive(const tf_arithmetic *arithmetic,
                              const tf_motion *motion, const int vertex[],
                              tf_contact *contact)
{
    static const tf_advance_limits limits = {.threshold = 1e-6};
    return additive_query(kind, arithmetic ? &limits : NULL, motion, vertex,
                          contact, NULL);
}

static void use_point_edge(void)
{
    statuses_use(kind = POINT_EDGE, ask_additive);
}

static void use_triangle(void)
{
    statuses_use(kind = POINT_TRIANGLE, ask_additive);
}

static void use_edges(void)
{
    statuses_use(kind = EDGE_EDGE, ask_additive);
}

START_TEST(bad_limits_are_refused)
{
    use_kind(_i);
    query q = scene_hit(kind);
    static const int index[] = {0, 1, 2, 3};
    scene s = scene_of(&q, index);
    tf_motion motion = scene_motion(&s);
    tf_contact contact;
    tf_advance_limits limits = {.threshold = NAN};
    ck_assert_int_eq(
        additive_query(kind, &limits, &motion, index, &contact, NULL),
        TF_BAD_OPTION);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("linear/additive");
    TCase *c = tcase_create("additive advancement");
    tcase_add_loop_test(c, advancement_ends_near_the_contact, 0, KINDS);
    tcase_add_test(c, a_shared_translation_costs_no_step);
    tcase_add_loop_test(c, advancement_never_passes_the_contact, 0, KINDS);
    tcase_add_loop_test(c, extreme_coordinates_give_finite_contacts, 0, KINDS);
    tcase_add_test(c, the_limit_of_steps_is_kept);
    tcase_add_loop_test(c, bad_limits_are_refused, 0, KINDS);
    suite_add_tcase(s, c);
    suite_add_tcase(s, statuses_case_of_doubles("point-edge", use_point_edge));
    suite_add_tcase(s, statuses_case_of_doubles("triangle", use_triangle));
    suite_add_tcase(s, statuses_case_of_doubles("edges", use_edges));
    return s;
}

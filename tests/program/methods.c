#include "program/methods.h"

#include "arithmetic/exact.h"
#include "support/support.h"

#include <math.h>
#include <string.h>

static const tf_method *method_named(const char *name)
{
    const tf_method *found = tf_choice_named(tf_methods, name);
    ck_assert_msg(found, "no '%s'", name);
    return found;
}

START_TEST(each_method_takes_an_option_of_its_own)
{
    ck_assert_str_eq(tf_method_option(method_named("spacetime")), "arithmetic");
    ck_assert_str_eq(tf_method_option(method_named("cubic")), "tolerance");
    ck_assert_str_eq(tf_method_option(method_named("advancement")),
                     "threshold");
}
END_TEST

// By each kind, an element falls on another, at t = 1/2.

static const struct fall {
    const char *kind;
    double start[12];
} falls[] = {
    {"point-edge", {0, 1, -1, 0, 2, 0}},
    {"point-triangle", {1, 1, 1, 0, 0, 0, 4, 0, 0, 0, 4, 0}},
    {"edge-edge", {-1, 0, 1, 2, 0, 1, 0, -1, 0, 0, 3, 0}},
};

START_TEST(each_method_answers_each_kind)
{
    static const char *const methods[] = {"spacetime", "cubic", "advancement"};
    const struct fall *fall = &falls[_i / 3];
    const tf_query_kind *kind = tf_choice_named(tf_query_kinds, fall->kind);
    tf_query_rows query = {.ground_truth = -1};
    memcpy(query.x[0], fall->start, sizeof fall->start);
    memcpy(query.x[1], fall->start, sizeof fall->start);
    for (int i = 0; i < kind->vertices[0]; i++)
        query.x[1][kind->axes * (i + 1) - 1] = -1;
    tf_method_options options = {
        .arithmetic = &tf_exact, .tolerance = 1e-6, .threshold = 1e-6};
    tf_contact contact;
    ck_assert_int_eq(tf_method_answer(method_named(methods[_i % 3]), &options,
                                      kind, &query, &contact),
                     TF_OK);
    ck_assert_int_eq(contact.verdict, TF_HIT);
    ck_assert_double_eq_tol(contact.toi_lo, 0.5, 1e-6);
    ck_assert_double_eq(contact.normal[kind->axes - 1], 1);
}
END_TEST

START_TEST(each_passes_its_option_on)
{
    const tf_query_kind *kind = tf_choice_named(tf_query_kinds, "point-edge");
    tf_query_rows query = {.ground_truth = -1};
    tf_contact contact;
    tf_method_options options = {
        .arithmetic = &tf_exact, .tolerance = NAN, .threshold = NAN};
    ck_assert_int_eq(tf_method_answer(method_named("cubic"), &options, kind,
                                      &query, &contact),
                     TF_BAD_OPTION);
    ck_assert_int_eq(tf_method_answer(method_named("advancement"), &options,
                                      kind, &query, &contact),
                     TF_BAD_OPTION);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("program/methods");
    TCase *c = tcase_create("methods");
    tcase_add_test(c, each_method_takes_an_option_of_its_own);
    tcase_add_loop_test(c, each_method_answers_each_kind, 0, 9);
    tcase_add_test(c, each_passes_its_option_on);
    suite_add_tcase(s, c);
    return s;
}

#define _GNU_SOURCE // strtok_r

#include "program/methods.h"

#include "arithmetic/exact.h"
#include "support/support.h"

#include <math.h>
#include <string.h>

START_TEST(the_names_told_are_those_found)
{
    char names[] = TF_METHOD_NAMES;
    int found = 0;
    char *rest = names;
    for (char *name; (name = strtok_r(rest, ", ", &rest));)
        if (strcmp(name, "or") != 0) {
            const tf_method *method = tf_method_named(name);
            ck_assert_msg(method, "no '%s'", name);
            ck_assert_str_eq(tf_method_name(method), name);
            found++;
        }
    ck_assert_int_eq(found, 3);
    ck_assert_ptr_null(tf_method_named(""));
    ck_assert_ptr_null(tf_method_named("Cubic"));
}
END_TEST

START_TEST(each_takes_its_own_option)
{
    ck_assert_int_eq(tf_method_takes(tf_method_named("spacetime")),
                     TF_TAKES_ARITHMETIC);
    ck_assert_int_eq(tf_method_takes(tf_method_named("cubic")),
                     TF_TAKES_TOLERANCE);
    ck_assert_int_eq(tf_method_takes(tf_method_named("advancement")),
                     TF_TAKES_THRESHOLD);
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
    const tf_query_kind *kind = tf_query_kind_named(fall->kind);
    tf_query_rows query = {.ground_truth = -1};
    memcpy(query.x[0], fall->start, sizeof fall->start);
    memcpy(query.x[1], fall->start, sizeof fall->start);
    for (int i = 0; i < kind->vertices[0]; i++)
        query.x[1][kind->axes * (i + 1) - 1] = -1;
    tf_method_options options = {
        .arithmetic = &tf_exact, .tolerance = 1e-6, .threshold = 1e-6};
    tf_contact contact;
    ck_assert_int_eq(tf_method_answer(tf_method_named(methods[_i % 3]),
                                      &options, kind, &query, &contact),
                     TF_OK);
    ck_assert_int_eq(contact.verdict, TF_HIT);
    ck_assert_double_eq_tol(contact.toi_lo, 0.5, 1e-6);
    ck_assert_double_eq(contact.normal[kind->axes - 1], 1);
}
END_TEST

START_TEST(each_passes_its_option_on)
{
    const tf_query_kind *kind = tf_query_kind_named("point-edge");
    tf_query_rows query = {.ground_truth = -1};
    tf_contact contact;
    tf_method_options options = {
        .arithmetic = &tf_exact, .tolerance = NAN, .threshold = NAN};
    ck_assert_int_eq(tf_method_answer(tf_method_named("cubic"), &options, kind,
                                      &query, &contact),
                     TF_BAD_TOLERANCE);
    ck_assert_int_eq(tf_method_answer(tf_method_named("advancement"), &options,
                                      kind, &query, &contact),
                     TF_BAD_TOLERANCE);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("program/methods");
    TCase *c = tcase_create("methods");
    tcase_add_test(c, the_names_told_are_those_found);
    tcase_add_test(c, each_takes_its_own_option);
    tcase_add_loop_test(c, each_method_answers_each_kind, 0, 9);
    tcase_add_test(c, each_passes_its_option_on);
    suite_add_tcase(s, c);
    return s;
}

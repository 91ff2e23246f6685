#include "program/options.h"

#include "arithmetic/exact.h"
#include "fast/vectorized.h"
#include "program/arithmetics.h"
#include "response/gauss_seidel.h"
#include "support/support.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum {
    COMMANDS = 6
};

static const tf_option *option_of(unsigned command, const char *name)
{
    const tf_option *option = tf_options;
    while (option->name &&
           (!(option->commands & command) || strcmp(option->name, name) != 0))
        option++;
    ck_assert_msg(option->name, "no --%s", name);
    return option;
}

// The table -------------------------------------------------------------------

/// Whether two options could be confused by a user of a command.
static bool clash(const tf_option *a, const tf_option *b)
{
    return a->commands & b->commands && (strcmp(a->name, b->name) == 0 ||
                                         (a->letter && a->letter == b->letter));
}

START_TEST(each_command_has_an_option_once)
{
    int rows = 0;
    for (const tf_option *a = tf_options; a->name; a++, rows++)
        for (const tf_option *b = tf_options; b < a; b++)
            ck_assert_msg(!clash(a, b), "--%s and --%s", a->name, b->name);
    ck_assert_int_le(rows, 64); // bits of `given`
}
END_TEST

START_TEST(a_letter_and_a_name_mean_the_same_in_all_commands)
{
    for (const tf_option *a = tf_options; a->name; a++)
        for (const tf_option *b = tf_options; b < a; b++) {
            bool same = strcmp(a->name, b->name) == 0;
            ck_assert_msg(!a->letter || a->letter != b->letter || same,
                          "-%c is --%s and --%s", a->letter, a->name, b->name);
            ck_assert_msg(!same || a->letter == b->letter, "--%s", a->name);
        }
}
END_TEST

START_TEST(old_spellings_name_options_and_are_none)
{
    for (const tf_old_spelling *old = tf_old_spellings; old->commands; old++) {
        ck_assert_msg(!old->name != !old->letter, "--%s", old->now);
        for (unsigned command = 1; command <= TF_SIMULATE; command *= 2)
            if (old->commands & command) {
                option_of(command, old->now);
                for (const tf_option *o = tf_options; o->name; o++)
                    ck_assert_msg(!(o->commands & command) ||
                                      (old->name
                                           ? strcmp(old->name, o->name) != 0
                                           : old->letter != o->letter),
                                  "--%s", o->name);
            }
    }
}
END_TEST

START_TEST(every_command_has_a_format_and_an_output)
{
    for (unsigned command = 1; command <= TF_SIMULATE; command *= 2) {
        ck_assert_int_eq(option_of(command, "format")->type, TF_CHOICE);
        ck_assert_int_eq(option_of(command, "output")->letter, 'o');
        ck_assert_msg(!option_of(command, "output")->formats ==
                          (command == TF_SIMULATE),
                      "%u", command);
    }
}
END_TEST

START_TEST(each_option_is_described)
{
    for (const tf_option *option = tf_options; option->name; option++) {
        ck_assert_msg(isupper(option->help[0]), "--%s", option->name);
        ck_assert_msg((option->type == TF_SWITCH) == !option->argument &&
                          (option->type == TF_CHOICE) == !!option->choices,
                      "--%s", option->name);
        ck_assert_msg(option->type < TF_WHOLE || option->least < option->most,
                      "--%s", option->name);
        ck_assert_msg(!option->required || !option->usual, "--%s",
                      option->name);
    }
}
END_TEST

static void expect_help(unsigned command, const char *name, const char *right)
{
    char *help = tf_option_help(option_of(command, name));
    ck_assert_str_eq(help, right);
    free(help);
}

START_TEST(help_tells_the_choices_and_what_is_usual)
{
    expect_help(TF_QUERY, "kind",
                "Which elements: point-edge, point-triangle, edge-edge or "
                "vertex-face (which is point-triangle); required");
    expect_help(TF_DETECT, "narrow-phase",
                "What decides the candidates: reference or vector; the default "
                "is vector, which is faster; both give the same answers");
    expect_help(TF_QUERY, "threshold",
                "The distance at which advancement ends; the default is 1e-6");
    expect_help(TF_DETECT, "first", "Only the first contact of each step");
}
END_TEST

START_TEST(what_is_usual_is_set)
{
    tf_request request;
    for (int i = 0; i < COMMANDS; i++) {
        tf_request_begin(&request, 1u << i);
        ck_assert_int_eq(request.threads, 0);
        ck_assert(request.given == 0);
    }
    tf_request_begin(&request, TF_QUERY);
    ck_assert_ptr_eq(request.method, tf_choice_named(tf_methods, "spacetime"));
    ck_assert_ptr_eq(request.answering.arithmetic, &tf_exact);
    ck_assert_double_eq(request.answering.tolerance, 1e-6);
    ck_assert_double_eq(request.answering.threshold, 1e-6);
    ck_assert_int_eq(*request.format, TF_CSV);
    ck_assert_str_eq(request.out, "-");
    tf_request_begin(&request, TF_DETECT);
    ck_assert_ptr_eq(request.narrow_phase, &tf_vectorized);
    tf_request_begin(&request, TF_RESOLVE);
    ck_assert_ptr_eq(request.solver, &tf_gauss_seidel);
    ck_assert_int_eq(*request.format, TF_SUMMARY);
    tf_request_begin(&request, TF_REMESH);
    ck_assert_int_eq(request.rounds, 0);
    ck_assert_ptr_null(request.out);
}
END_TEST

// Arguments -------------------------------------------------------------------

static tf_request request;

static void read_option(unsigned command, const char *name, const char *text)
{
    tf_option_read(option_of(command, name), text, &request);
}

START_TEST(each_type_of_argument_is_read)
{
    read_option(TF_DETECT, "first", NULL);
    ck_assert(request.first);
    read_option(TF_RESOLVE, "masses", "a b");
    ck_assert_str_eq(request.masses, "a b");
    read_option(TF_DETECT, "arithmetic", "report");
    ck_assert_ptr_eq(request.answering.arithmetic,
                     tf_choice_named(tf_arithmetics, "report"));
    read_option(TF_REMESH, "rounds", "1000");
    ck_assert_int_eq(request.rounds, 1000);
    read_option(TF_RESOLVE, "substeps", "1000");
    ck_assert_int_eq(request.substeps, 1000);
    read_option(TF_SIMULATE, "steps", "0");
    ck_assert_int_eq(request.steps, 0);
    read_option(TF_RESOLVE, "restitution", "0x1p-2");
    ck_assert_double_eq(request.restitution, 0.25);
    read_option(TF_RESOLVE, "restitution", "1");
    ck_assert_double_eq(request.restitution, 1);
    read_option(TF_RESOLVE, "friction", "1e308");
    ck_assert_double_eq(request.friction, 1e308);
    read_option(TF_REMESH, "edge", "4.9e-324");
    ck_assert_double_gt(request.edge, 0);
}
END_TEST

START_TEST(what_was_given_is_told_by_its_name)
{
    tf_request_begin(&request, TF_REMESH);
    ck_assert(!tf_request_gave(&request, "edge"));
    request.given = UINT64_C(1) << (option_of(TF_REMESH, "edge") - tf_options);
    ck_assert(tf_request_gave(&request, "edge"));
    ck_assert(!tf_request_gave(&request, "rounds"));
    ck_assert(!tf_request_gave(&request, "ed"));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/options");
    TCase *table = tcase_create("table");
    tcase_add_test(table, each_command_has_an_option_once);
    tcase_add_test(table, a_letter_and_a_name_mean_the_same_in_all_commands);
    tcase_add_test(table, old_spellings_name_options_and_are_none);
    tcase_add_test(table, every_command_has_a_format_and_an_output);
    tcase_add_test(table, each_option_is_described);
    tcase_add_test(table, help_tells_the_choices_and_what_is_usual);
    tcase_add_test(table, what_is_usual_is_set);
    suite_add_tcase(suite, table);

    TCase *arguments = tcase_create("arguments");
    tcase_add_test(arguments, each_type_of_argument_is_read);
    tcase_add_test(arguments, what_was_given_is_told_by_its_name);
    suite_add_tcase(suite, arguments);
    return suite;
}

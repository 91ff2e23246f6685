#include "files/masses.h"

#include "support/program.h"
#include "support/support.h"

#include <float.h>
#include <stdio.h>
#include <string.h>

enum {
    VERTICES = 4
};

typedef bool reader(const char *, int, double[], tf_fault *);

static tf_fault fault;

/// Expects that a text gives these inverse masses, where those before are -1.
static void expect_read(reader *read, const char *text,
                        const double right[VERTICES])
{
    double inverse_mass[VERTICES] = {-1, -1, -1, -1};
    make_file("text", text);
    bool good = read("text", VERTICES, inverse_mass, &fault);
    ck_assert_msg(good, "%s: %ld: %s", text, fault.place, fault.text);
    for (int v = 0; v < VERTICES; v++)
        ck_assert_msg(inverse_mass[v] == right[v], "%s: vertex %d: %a, not %a",
                      text, v, inverse_mass[v], right[v]);
}

static void expect_refused(reader *read, const char *text, long line,
                           const char *words)
{
    double inverse_mass[VERTICES];
    make_file("text", text);
    ck_assert_msg(!read("text", VERTICES, inverse_mass, &fault), "%s", text);
    ck_assert_str_eq(fault.text, words);
    ck_assert_int_eq(fault.place, line);
}

// Masses ----------------------------------------------------------------------

START_TEST(masses_are_inverted)
{
    const double right[] = {1, 0.5, 8, 0x1p1022};
    expect_read(tf_masses_read, "1\n2\n0.125\n0x1p-1022\n", right);
    expect_read(tf_masses_read, "1 2 # two\n\n# a line\n\t.125\t0x1p-1022#\n",
                right);
    expect_read(tf_masses_read, "1 2 125e-3 0x1p-1022", right);
    const double least[] = {1 / DBL_MAX, 1, 1, 1};
    expect_read(tf_masses_read, "0x1.fffffffffffffp1023 1 1 1", least);
}
END_TEST

START_TEST(invalid_masses_are_rejected)
{
    static const char *const words[] = {"0",      "-1", "nan", "inf", "1e999",
                                        "1e-320", "x",  "1x",  "1,2", "--1"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        char text[100], right[100];
        snprintf(text, sizeof text, "1 1\n#\n1 %s # 4\n", words[i]);
        snprintf(right, sizeof right,
                 "'%s' is not a mass; write a number above 0 such as 0.5",
                 words[i]);
        expect_refused(tf_masses_read, text, 3, right);
    }
}
END_TEST

START_TEST(each_vertex_needs_a_mass)
{
    expect_refused(tf_masses_read, "1\n1\n1\n", -1,
                   "the number of masses is 3, but there are 4 vertices; write "
                   "one for each, in their order");
    expect_refused(tf_masses_read, "", -1,
                   "the number of masses is 0, but there are 4 vertices; write "
                   "one for each, in their order");
    expect_refused(tf_masses_read, "1 1 1\n1\n1\n", 3,
                   "more masses than the 4 vertices; write one for each");
}
END_TEST

// Friction --------------------------------------------------------------------

START_TEST(friction_is_read)
{
    const double right[] = {0, 0.5, 8, DBL_MAX};
    expect_read(tf_friction_read, "0\n.5\n8\n0x1.fffffffffffffp1023\n", right);
    const double least[] = {0x1p-1074, 0, 0, 1};
    expect_read(tf_friction_read, "0x1p-1074 0 # none\n\n-0 1", least);
}
END_TEST

START_TEST(invalid_friction_is_rejected)
{
    static const char *const words[] = {
        "-1", "-1e-300", "nan", "inf", "1e999", "x", "1x", "1,2", "-0x1p-1074"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        char text[100], right[100];
        snprintf(text, sizeof text, "1 1\n#\n1 %s # 4\n", words[i]);
        snprintf(right, sizeof right,
                 "'%s' is not a coefficient of friction; write a number from 0 "
                 "on such as 0.5",
                 words[i]);
        expect_refused(tf_friction_read, text, 3, right);
    }
}
END_TEST

START_TEST(each_vertex_needs_friction)
{
    expect_refused(tf_friction_read, "1\n0\n1\n", -1,
                   "the number of coefficients of friction is 3, but there are "
                   "4 vertices; write one for each, in their order");
    expect_refused(tf_friction_read, "1 1 1\n1\n1\n", 3,
                   "more coefficients of friction than the 4 vertices; write "
                   "one for each");
}
END_TEST

// Scripted vertices -----------------------------------------------------------

START_TEST(scripted_vertices_have_no_inverse_mass)
{
    expect_read(tf_fixed_read, "", (double[]){-1, -1, -1, -1});
    expect_read(tf_fixed_read, "# none\n", (double[]){-1, -1, -1, -1});
    expect_read(tf_fixed_read, "1\n", (double[]){-1, 0, -1, -1});
    expect_read(tf_fixed_read, "3 0 # both ends\n003\n",
                (double[]){0, -1, -1, 0});
    expect_read(tf_fixed_read, "\t0 1#\n2\r\n3", (double[]){0, 0, 0, 0});
}
END_TEST

START_TEST(invalid_vertices_are_rejected)
{
    static const char *const words[] = {"-1", "x",   "1x",  "1.5",
                                        "+1", "0,1", "99x", "1e0"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        char text[100], right[100];
        snprintf(text, sizeof text, "0\n1 %s\n", words[i]);
        snprintf(right, sizeof right,
                 "'%s' is not a vertex; write its number, from 0", words[i]);
        expect_refused(tf_fixed_read, text, 2, right);
    }
}
END_TEST

START_TEST(absent_vertices_are_rejected)
{
    expect_refused(tf_fixed_read, "0\n1 4 5\n", 2,
                   "there is no vertex 4; they are numbered from 0 to 3");
    expect_refused(tf_fixed_read, "18446744073709551616", 1,
                   "there is no vertex 18446744073709551616; they are numbered "
                   "from 0 to 3");
}
END_TEST

START_TEST(unreadable_files_are_rejected)
{
    double inverse_mass[VERTICES];
    reader *const readers[] = {tf_masses_read, tf_fixed_read, tf_friction_read};
    for (int i = 0; i < 3; i++) {
        ck_assert(!readers[i]("absent", VERTICES, inverse_mass, &fault));
        expect_words(fault.text, "cannot open: No such file or directory; ");
        make_binary_file("zero", "0 \0", 3);
        ck_assert(!readers[i]("zero", VERTICES, inverse_mass, &fault));
        expect_words(fault.text, "a NUL byte; ");
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("files/masses");
    TCase *lists = tcase_create("lists");
    tcase_add_checked_fixture(lists, enter_folder, leave_folder);
    tcase_add_test(lists, masses_are_inverted);
    tcase_add_test(lists, invalid_masses_are_rejected);
    tcase_add_test(lists, each_vertex_needs_a_mass);
    tcase_add_test(lists, friction_is_read);
    tcase_add_test(lists, invalid_friction_is_rejected);
    tcase_add_test(lists, each_vertex_needs_friction);
    tcase_add_test(lists, scripted_vertices_have_no_inverse_mass);
    tcase_add_test(lists, invalid_vertices_are_rejected);
    tcase_add_test(lists, absent_vertices_are_rejected);
    tcase_add_test(lists, unreadable_files_are_rejected);
    suite_add_tcase(suite, lists);
    return suite;
}

#include "files/masses.h"

#include "support/program.h"
#include "support/support.h"

#include <float.h>
#include <string.h>

enum {
    VERTICES = 4
};

typedef bool reader(tf_text_lines *, const char *, int, double[]);

/// Expects that a text gives these inverse masses, where those before are -1.
static void expect_read(reader *read, const char *text,
                        const double right[VERTICES])
{
    tf_text_lines lines;
    double inverse_mass[VERTICES] = {-1, -1, -1, -1};
    make_file("text", text);
    bool good = read(&lines, "text", VERTICES, inverse_mass);
    ck_assert_msg(good, "%s: %ld: %s", text, lines.fault_line, lines.fault);
    tf_text_lines_close(&lines);
    for (int v = 0; v < VERTICES; v++)
        ck_assert_msg(inverse_mass[v] == right[v], "%s: vertex %d: %a, not %a",
                      text, v, inverse_mass[v], right[v]);
}

static void expect_refused(reader *read, const char *text, long line,
                           const char *fault)
{
    tf_text_lines lines;
    double inverse_mass[VERTICES];
    make_file("text", text);
    ck_assert_msg(!read(&lines, "text", VERTICES, inverse_mass), "%s", text);
    ck_assert_str_eq(lines.fault, fault);
    ck_assert_int_eq(lines.fault_line, line);
    tf_text_lines_close(&lines);
}

// Masses ----------------------------------------------------------------------

START_TEST(masses)
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

START_TEST(masses_that_are_none)
{
    static const char *const words[] = {"0",      "-1", "nan", "inf", "1e999",
                                        "1e-320", "x",  "1x",  "1,2", "--1"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        char text[100], fault[100];
        snprintf(text, sizeof text, "1 1\n#\n1 %s # 4\n", words[i]);
        snprintf(fault, sizeof fault,
                 "\"%s\" is not a mass; write a positive number such as 0.5",
                 words[i]);
        expect_refused(tf_masses_read, text, 3, fault);
    }
}
END_TEST

START_TEST(as_many_masses_as_vertices)
{
    expect_refused(tf_masses_read, "1\n1\n1\n", 0,
                   "the number of masses is 3, but there are 4 vertices; write "
                   "one for each, in their order");
    expect_refused(tf_masses_read, "", 0,
                   "the number of masses is 0, but there are 4 vertices; write "
                   "one for each, in their order");
    expect_refused(tf_masses_read, "1 1 1\n1\n1\n", 3,
                   "more masses than the 4 vertices; write one for each");
}
END_TEST

// Scripted vertices -----------------------------------------------------------

START_TEST(scripted_vertices)
{
    expect_read(tf_fixed_read, "", (double[]){-1, -1, -1, -1});
    expect_read(tf_fixed_read, "# none\n", (double[]){-1, -1, -1, -1});
    expect_read(tf_fixed_read, "1\n", (double[]){-1, 0, -1, -1});
    expect_read(tf_fixed_read, "3 0 # both ends\n003\n",
                (double[]){0, -1, -1, 0});
    expect_read(tf_fixed_read, "\t0 1#\n2\r\n3", (double[]){0, 0, 0, 0});
}
END_TEST

START_TEST(vertices_that_are_none)
{
    static const char *const words[] = {"-1", "x",   "1x",  "1.5",
                                        "+1", "0,1", "99x", "1e0"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        char text[100], fault[100];
        snprintf(text, sizeof text, "0\n1 %s\n", words[i]);
        snprintf(fault, sizeof fault,
                 "\"%s\" is not a vertex; write its number, from 0", words[i]);
        expect_refused(tf_fixed_read, text, 2, fault);
    }
}
END_TEST

START_TEST(vertices_that_are_not_there)
{
    expect_refused(tf_fixed_read, "0\n1 4 5\n", 2,
                   "there is no vertex 4; they are numbered from 0 to 3");
    expect_refused(tf_fixed_read, "18446744073709551616", 1,
                   "there is no vertex 18446744073709551616; they are numbered "
                   "from 0 to 3");
}
END_TEST

START_TEST(files_that_cannot_be_read)
{
    tf_text_lines lines;
    double inverse_mass[VERTICES];
    reader *const readers[] = {tf_masses_read, tf_fixed_read};
    for (int i = 0; i < 2; i++) {
        ck_assert(!readers[i](&lines, "absent", VERTICES, inverse_mass));
        expect_words(lines.fault, "cannot open: No such file or directory; ");
        tf_text_lines_close(&lines);
        make_binary_file("zero", "0 \0", 3);
        ck_assert(!readers[i](&lines, "zero", VERTICES, inverse_mass));
        expect_words(lines.fault, "a NUL byte; ");
        tf_text_lines_close(&lines);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("files/masses");
    TCase *lists = tcase_create("lists");
    tcase_add_checked_fixture(lists, enter_folder, leave_folder);
    tcase_add_test(lists, masses);
    tcase_add_test(lists, masses_that_are_none);
    tcase_add_test(lists, as_many_masses_as_vertices);
    tcase_add_test(lists, scripted_vertices);
    tcase_add_test(lists, vertices_that_are_none);
    tcase_add_test(lists, vertices_that_are_not_there);
    tcase_add_test(lists, files_that_cannot_be_read);
    suite_add_tcase(suite, lists);
    return suite;
}

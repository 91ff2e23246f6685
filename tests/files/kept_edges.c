#include "files/kept_edges.h"

#include "support/program.h"
#include "support/support.h"

#include <stdio.h>
#include <string.h>

enum {
    VERTICES = 9
};

static tf_fault fault;
static tf_kept_edges kept;

START_TEST(edges_and_corners_are_read)
{
    static const int right[] = {0, 1, 8, 2, 3, 3, 5, 5, 0, 1};
    make_file("text", "0 1\n# a line\n  8\t2 # two\n\n3\n5#\n0 1");
    bool good = tf_kept_edges_read(&kept, "text", VERTICES, &fault);
    ck_assert_msg(good, "%s", fault.text);
    ck_assert_int_eq(kept.count, 5);
    ck_assert_mem_eq(kept.vertex, right, sizeof right);
    tf_kept_edges_free(&kept);
    ck_assert_int_eq(kept.count, 0);
}
END_TEST

START_TEST(many_edges_are_read)
{
    FILE *stream = fopen("text", "w");
    for (int i = 0; i < 1000; i++)
        fprintf(stream, "%d %d\n", i, i + 1);
    fclose(stream);
    ck_assert(tf_kept_edges_read(&kept, "text", 1001, &fault));
    ck_assert_int_eq(kept.count, 1000);
    for (int i = 0; i < 2000; i++)
        ck_assert_int_eq(kept.vertex[i], (i + 1) / 2);
    tf_kept_edges_free(&kept);
}
END_TEST

START_TEST(an_empty_file_keeps_nothing)
{
    make_file("text", "# none\n");
    ck_assert(tf_kept_edges_read(&kept, "text", VERTICES, &fault));
    ck_assert_int_eq(kept.count, 0);
    tf_kept_edges_free(&kept);
}
END_TEST

static void expect_refused(const char *text, long line, const char *words)
{
    make_file("text", text);
    ck_assert_msg(!tf_kept_edges_read(&kept, "text", VERTICES, &fault), "%s",
                  text);
    ck_assert_str_eq(fault.text, words);
    ck_assert_int_eq(fault.place, line);
    tf_kept_edges_free(&kept);
}

START_TEST(bad_lines_are_refused)
{
    expect_refused("0 1\n9 2\n", 2,
                   "there is no vertex 9; they are numbered from 0 to 8");
    expect_refused("1 -2\n", 1,
                   "'-2' is not a vertex; write its number, from 0");
    expect_refused("x\n", 1, "'x' is not a vertex; write its number, from 0");
    expect_refused("1 2 3\n", 1,
                   "more than two vertices; write an edge a line");
    ck_assert(!tf_kept_edges_read(&kept, "nowhere", VERTICES, &fault));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("files/kept_edges");
    TCase *tcase = tcase_create("kept edges");
    tcase_add_checked_fixture(tcase, enter_folder, NULL);
    tcase_add_test(tcase, edges_and_corners_are_read);
    tcase_add_test(tcase, many_edges_are_read);
    tcase_add_test(tcase, an_empty_file_keeps_nothing);
    tcase_add_test(tcase, bad_lines_are_refused);
    suite_add_tcase(suite, tcase);
    return suite;
}

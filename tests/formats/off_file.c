// OFF, good and bad.
#include "formats/off_file.h"

#include "support/meshes.h"
#include "support/support.h"

#include <stdio.h>
#include <string.h>

static const double corners[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5};

static void expect_mesh(const char *text)
{
    ck_assert(tf_is_off(text, strlen(text)));
    tf_mesh_file file = good_mesh(text);
    expect_vertices(&file, 4, corners);
    expect_triangles(&file, 3, (int[]){0, 1, 2, 0, 1, 2, 0, 2, 3});
    expect_edges(&file, 0, NULL);
    ck_assert_int_eq(tf_mesh_file_polygons(&file), 1);
    ck_assert_int_eq(file.first_index, 0);
    ck_assert_int_eq(file.format, TF_OFF);
    tf_mesh_file_free(&file);
}

#define VERTICES "0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n"
#define FACES "3 0 1 2\n4 1 2 3 0\n"

START_TEST(all_headers_are_read)
{
    static const char *const texts[] = {
        "OFF\n4 2 0\n" VERTICES FACES,
        "OFF 4 2 5\n" VERTICES FACES,
        "OFF4 2 0\n" VERTICES FACES,
        "# by hand\n\nOFF # a comment\n# 7 7 7\n4 2 0 # and one\n\n" VERTICES
        "#\n" FACES,
        "COFF\n4 2 0\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n1 1 0 0\n0 1 "
        ".5\n" FACES,
        "NOFF\n4 2 0\n0 0 0 0 0 1\n1 0 0 nan 0 1\n1 1 0 0 0 1\n0 1 .5 0 0 1\n"
        "3 0 1 2 255 0 0\n4 1 2 3 0 0.1 0.2 0.3 # red\n",
        "\nSTCNOFF\n4 2 0\n" VERTICES FACES};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        char marked[500], mac[500];
        expect_mesh(texts[i]);
        snprintf(marked, sizeof marked, "\xEF\xBB\xBF%s", texts[i]);
        expect_mesh(marked);
        snprintf(mac, sizeof mac, "%s", texts[i]);
        for (char *c = mac; *c; c++)
            *c = *c == '\n' ? '\r' : *c;
        tf_mesh_file file = good_mesh(mac);
        expect_vertices(&file, 4, corners);
        tf_mesh_file_free(&file);
    }
    expect_mesh("OFF\r\n4 2\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 .5\r\n" FACES);
}
END_TEST

START_TEST(numbers_may_go_on_in_the_next_line)
{
    expect_mesh("OFF\n4\n2 0\n0 0\n0\n1 0 0\n1 1 0\n0 1 .5\n3 0\n1\n2\n4 1 2 "
                "3\n0");
}
END_TEST

START_TEST(places_are_lines)
{
    tf_mesh_file file = good_mesh("OFF\n4 2 0\n" VERTICES "\n" FACES);
    ck_assert(!file.counts_bytes);
    ck_assert_int_eq(file.vertex_place.item[3], 6);
    ck_assert_int_eq(file.triangle_place.item[0], 8);
    ck_assert_int_eq(file.triangle_place.item[2], 9);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(other_words_are_no_off)
{
    static const char *const texts[] = {"",     "OF",    "off\n",  "OFFA\n",
                                        "XOFF", "v OFF", "NCOFF\n"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        ck_assert_msg(!tf_is_off(texts[i], strlen(texts[i])), "%s", texts[i]);
}
END_TEST

START_TEST(the_word_may_be_missing)
{
    ck_assert(tf_is_nameless_off("# a\n\n 8 6 12\n", 14));
    ck_assert(!tf_is_nameless_off("v 8\n", 4));
    ck_assert(!tf_is_nameless_off("#8\n", 3));
    ck_assert(!tf_is_nameless_off("-8\n", 3));
}
END_TEST

static const struct {
    const char *text;
    long line;
    const char *words;
} bad[] = {
    {"OFF\n", 2, "the file ends too early; it may be cut short, or its header"},
    {"OFF BINARY\n", 1, "this is binary OFF; save the mesh as text"},
    {"COFF binary\n", 1, "this is binary OFF"},
    {"4OFF\n4 2 0\n", 1,
     "'4OFF' is OFF with other coordinates than three; export"},
    {"STC4OFF\n", 1, "'STC4OFF' is OFF with other coordinates than three"},
    {"nOFF\n3 4 2 0\n", 1, "'nOFF' is OFF with other coordinates than three"},
    {"OFF\n4 x 0\n", 2, "'x' is not an integer from 0"},
    {"OFF\n-4 2 0\n", 2, "'-4' is not an integer from 0"},
    {"OFF\n4 2 0\n" VERTICES "3 0 1 2\n", 8, "the file ends too early"},
    {"OFF\n5 2 0\n" VERTICES "3 0 1 2\n4 1 2 3 0\n", 9, "ends too early"},
    {"OFF\n3 1 0\n" VERTICES "3 0 1 2\n", 6,
     "a face with 0 corners; each must have three or more"},
    {"OFF\n4 1 0\n" VERTICES FACES, 8, "more follows than the header declares"},
    {"OFF\n4 2 0\n" VERTICES "3 0 1 2\n4 1 2 3 4\n", 8,
     "there is no vertex 4; they are numbered from 0 to 3"},
    {"OFF\n4 2 0\n" VERTICES "2 0 1\n4 1 2 3 0\n", 7, "a face with 2 corners"},
    {"OFF\n4 2 0\n" VERTICES "3 0 1 -2\n4 1 2 3 0\n", 7, "'-2' is not an"},
    {"OFF\n4 2 0\n0 0 a\n", 3, "'a' is not a finite number"},
    {"OFF\n4 2 0\n0 0 1e999\n", 3, "'1e999' is beyond the largest double"},
};

START_TEST(bad_texts_are_refused)
{
    expect_bad_mesh(bad[_i].text, bad[_i].line, bad[_i].words);
}
END_TEST

START_TEST(zeros_are_refused)
{
    static const char text[] = "OFF\n3 1 0\n0 0 \0 0\n";
    expect_bad_bytes(text, sizeof text - 1, 3, "a NUL byte; ");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("formats/off_file");
    TCase *good = tcase_create("good");
    tcase_add_test(good, all_headers_are_read);
    tcase_add_test(good, numbers_may_go_on_in_the_next_line);
    tcase_add_test(good, places_are_lines);
    tcase_add_test(good, the_word_may_be_missing);
    tcase_add_test(good, other_words_are_no_off);
    suite_add_tcase(suite, good);

    TCase *faults = tcase_create("faults");
    tcase_add_loop_test(faults, bad_texts_are_refused, 0,
                        sizeof bad / sizeof *bad);
    tcase_add_test(faults, zeros_are_refused);
    suite_add_tcase(suite, faults);
    return suite;
}

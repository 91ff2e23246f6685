// Texts of OBJ, good and bad.
#include "formats/obj_file.h"

#include "support/meshes.h"
#include "support/support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Four vertices, on lines 1 to 4; and a triangle of the first three.
#define FOUR "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
#define FACE "f 1 2 3\n"

static const int first_three[] = {0, 1, 2};

// Vertices --------------------------------------------------------------------

START_TEST(vertices_keep_their_order)
{
    tf_mesh_file file =
        good_mesh("v 1 -2 3.5\nv\t4\t5e-1  6 \n" FACE "v 0x1.8p-1 .25 -0\n");
    expect_vertices(&file, 3,
                    (double[]){1, -2, 3.5, 4, 0.5, 6, 0.75, 0.25, -0.});
    ck_assert_int_eq(file.first_index, 1);
    ck_assert_int_eq(file.vertex_place.item[2], 4);
    ck_assert_int_eq(file.triangle_place.item[0], 3);
    ck_assert_int_eq(file.flat_place, 0);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(weights_and_colors_do_not_count)
{
    tf_mesh_file file = good_mesh("v 1 2 3 0.5\nv 4 5 6 0.1 0.2 0.3\n"
                                  "v 7 8 9 1 0.1 0.2 0.3\n" FACE);
    expect_vertices(&file, 3, (double[]){1, 2, 3, 4, 5, 6, 7, 8, 9});
    tf_mesh_file_free(&file);
    expect_bad_mesh("v 1 2 3 red\n" FACE, 1, "'red' is not a finite number");
}
END_TEST

START_TEST(colors_are_columns)
{
    static const double colors[] = {1, 1, 1, 0.5, 0.25, 0, 1, 1, 1};
    tf_columns columns;
    read_columns(&columns);
    tf_mesh_file file = good_mesh("v 1 2 3 0.5\nv 4 5 6 0.5 .25 0\n"
                                  "v 7 8 9 1 0.1 0.2 0.3\n" FACE);
    expect_vertices(&file, 3, (double[]){1, 2, 3, 4, 5, 6, 7, 8, 9});
    ck_assert_int_eq(columns.count, 3);
    ck_assert_int_eq(tf_columns_find(&columns, "red"), 0);
    ck_assert_int_eq(tf_columns_find(&columns, "green"), 1);
    ck_assert_int_eq(tf_columns_find(&columns, "blue"), 2);
    ck_assert_int_eq(columns.column[0].type, TF_DOUBLE);
    ck_assert_uint_eq(columns.rows, 3);
    ck_assert_mem_eq(columns.value, colors, sizeof colors);
    tf_columns_free(&columns);
    tf_mesh_file_free(&file);
    read_columns(&columns);
    file = good_mesh(FOUR FACE);
    ck_assert_int_eq(columns.count, 0);
    tf_mesh_file_free(&file);
    read_columns(NULL);
}
END_TEST

START_TEST(vertices_without_z_are_of_the_plane)
{
    tf_mesh_file file = good_mesh("v 1 2 0\nv 3 4\nl 1 2\n");
    expect_vertices(&file, 2, (double[]){1, 2, 0, 3, 4, 0});
    ck_assert(tf_mesh_file_is_flat(&file));
    ck_assert_int_eq(file.flat_place, 2);
    tf_mesh_file_free(&file);
}
END_TEST

/// A double of random bits, so that most are huge or tiny, and some subnormal.
static double any_double(generator *random)
{
    double x;
    do {
        uint64_t bits = next_bits(random);
        if (below(random, 8) == 0)
            bits &= ~(UINT64_C(0x7ff) << 52);
        memcpy(&x, &bits, sizeof x);
    } while (!isfinite(x));
    return x;
}

START_TEST(random_doubles_come_back_to_the_last_bit)
{
    generator random = generator_new(1);
    for (long i = 0; i < cases(20000); i++) {
        double x[9];
        char text[1000] = "";
        for (int v = 0; v < 3; v++) {
            for (int k = 0; k < 3; k++)
                x[3 * v + k] = any_double(&random);
            sprintf(text + strlen(text),
                    below(&random, 2) ? "v %.17g %.17g %.17g\n"
                                      : "v %a %a %a\n",
                    x[3 * v], x[3 * v + 1], x[3 * v + 2]);
        }
        strcat(text, FACE);
        tf_mesh_file file = good_mesh(text);
        expect_vertices(&file, 3, x);
        tf_mesh_file_free(&file);
    }
}
END_TEST

START_TEST(the_largest_and_smallest_doubles_are_read)
{
    tf_mesh_file file =
        good_mesh("v 1.7976931348623157e308 4.9e-324 0x1p-1074\n"
                  "v -1e-400 1e+3 +5.\nl 1 2\n");
    expect_vertices(
        &file, 2,
        (double[]){0x1.fffffffffffffp1023, 0x1p-1074, 0x1p-1074, -0., 1000, 5});
    tf_mesh_file_free(&file);
}
END_TEST

// Elements --------------------------------------------------------------------

START_TEST(all_forms_of_indices_are_read)
{
    static const char *const faces[] = {"f 1 2 3",
                                        "f 1/7 2/8 3/9",
                                        "f 1//5 2//6 3//7",
                                        "f 1/1/1 2/2/2 3/3/3",
                                        "f 1/ 2/ 3/",
                                        "f 1// 2// 3//",
                                        "f 1/4/ 2/-1/ 3/5/",
                                        "f +1 02 3",
                                        "f 1/-1/-1 2//-3 3",
                                        "f -4 -3 -2",
                                        "f -4/-4/-4 2 -2//1",
                                        "f\t1\t2\t3\t",
                                        "  f 1 2 3",
                                        "f 1 2 3 # a face",
                                        "f 1 2 3#",
                                        "f  1  2  3\r"};
    for (size_t i = 0; i < sizeof faces / sizeof *faces; i++) {
        char text[200];
        snprintf(text, sizeof text, FOUR "%s\n", faces[i]);
        expect_triangles_of(text, 1, first_three);
        // The last line needs no end.
        text[strlen(text) - 1] = '\0';
        expect_triangles_of(text, 1, first_three);
    }
}
END_TEST

START_TEST(faces_have_any_number_of_corners)
{
    tf_mesh_file file = good_mesh("f 4 1 2 3\n" FOUR "v -1 .5 0\nf 1 2 3\n"
                                  "f 5/1/1 -5//2 2/3 \\\n 3/-1/-1\nf 2 3 4\n");
    expect_triangles(
        &file, 6,
        (int[]){0, 1, 2, 0, 2, 3, 0, 1, 2, 0, 1, 2, 0, 2, 4, 1, 2, 3});
    ck_assert_int_eq(tf_mesh_file_polygons(&file), 2);
    static const int places[] = {1, 1, 7, 8, 8, 10};
    ck_assert_mem_eq(file.triangle_place.item, places, sizeof places);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(negative_indices_count_from_where_they_are)
{
    expect_triangles_of(FOUR "f -1 -2 -3\nv 2 2 2\nf -1 -2 -3\nf 1 2 -5\n", 3,
                        (int[]){3, 2, 1, 4, 3, 2, 0, 1, 0});
}
END_TEST

START_TEST(elements_may_precede_their_vertices)
{
    expect_triangles_of("f 1 2 4\n" FOUR, 1, (int[]){0, 1, 3});
}
END_TEST

START_TEST(polylines_are_edges)
{
    expect_edges_of(FOUR "l 1 2\nl 1 2 3 4\nl -1 -4/2 3/1\n", 6,
                    (int[]){0, 1, 0, 1, 1, 2, 2, 3, 3, 0, 0, 2});
    tf_mesh_file file = good_mesh(FOUR "l 4 2\n" FACE);
    expect_edges(&file, 1, (int[]){3, 1});
    expect_triangles(&file, 1, first_three);
    ck_assert_int_eq(file.edge_place.item[0], 5);
    ck_assert_int_eq(file.triangle_place.item[0], 6);
    tf_mesh_file_free(&file);
}
END_TEST

// Lines -----------------------------------------------------------------------

START_TEST(other_lines_are_skipped)
{
    expect_triangles_of("# v 9 9 9\nmtllib a.mtl\no f 1 2 3\nvn 0 0 1\n"
                        "vt 0 0\nvp 1\ng l\ns off\nusemtl v\np 1\n\n \t\n"
                        "fo 1 2\nline\n" FOUR FACE "vn nan nan nan\n#",
                        1, first_three);
}
END_TEST

START_TEST(windows_text_with_a_byte_order_mark_is_read)
{
    tf_mesh_file file =
        good_mesh("\xEF\xBB\xBFv 0 0 0\r\nv 1 0 0\r\n\r\nv 0 1 0\r\n"
                  "f 1 2 3\r\n");
    expect_triangles(&file, 1, first_three);
    expect_vertices(&file, 3, (double[]){0, 0, 0, 1, 0, 0, 0, 1, 0});
    ck_assert_int_eq(file.triangle_place.item[0], 5);
    tf_mesh_file_free(&file);
    // A part of the mark, or the mark later, makes a line unknown.
    file = good_mesh("\xEF\xBBv 9 9 9\n" FOUR "\xEF\xBB\xBFv 9 9 9\n" FACE);
    ck_assert_int_eq(tf_mesh_file_vertices(&file), 4);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(a_backslash_continues_a_line)
{
    tf_mesh_file file = good_mesh("v 0 \\\n 0 0\nv 1\\\r\n0 \\\n\\\n 0\n"
                                  "v\\\n0 1 0\nf 1 \\\n2 3\\\n\nl 1\\\n 2\n");
    expect_vertices(&file, 3, (double[]){0, 0, 0, 1, 0, 0, 0, 1, 0});
    expect_triangles(&file, 1, first_three);
    expect_edges(&file, 1, (int[]){0, 1});
    // Each is where it begins.
    ck_assert_int_eq(file.vertex_place.item[1], 3);
    ck_assert_int_eq(file.vertex_place.item[2], 7);
    ck_assert_int_eq(file.triangle_place.item[0], 9);
    ck_assert_int_eq(file.edge_place.item[0], 12);
    tf_mesh_file_free(&file);
    expect_bad_mesh("v 0 0\\\n 0\nv 1 \\\n x 0\n", 4, "'x' is");
    expect_bad_mesh("v 0 0 \\ 0\n", 1, "'\\' is");
    expect_bad_mesh("v 0 0 0\nv 1 2 3\\", 2, "'\\' is");
}
END_TEST

START_TEST(comments_do_not_go_on)
{
    expect_triangles_of(FOUR "# C:\\\n" FACE "mtllib C:\\\nf 1 2 3 # \\\n" FACE,
                        3, (int[]){0, 1, 2, 0, 1, 2, 0, 1, 2});
}
END_TEST

START_TEST(very_long_lines_are_read)
{
    enum {
        LONG = 1000000
    };
    char *text = malloc(LONG + 100);
    strcpy(text, FOUR "#");
    memset(text + strlen(text), 'x', LONG);
    strcpy(text + LONG, "\nf 1 2 3");
    expect_triangles_of(text, 1, first_three);
    strcpy(text, FOUR "f 1 2 3");
    memset(text + strlen(text), ' ', LONG);
    text[LONG] = '\0';
    expect_triangles_of(text, 1, first_three);
    memset(text, '0', LONG);
    memcpy(text, "v ", 2);
    strcpy(text + LONG, "1 0 0\nv 0 1 0\nv 0 0 1\n" FACE);
    expect_triangles_of(text, 1, first_three);
    memset(text, '9', LONG);
    memcpy(text, FOUR "f 1 2 ", strlen(FOUR) + 6);
    text[LONG] = '\0';
    expect_bad_mesh(text, 5,
                    "'9999999999999999999999999999...' is not a corner");
    free(text);
}
END_TEST

// Faults ----------------------------------------------------------------------

/// Lines after four vertices, and what is told of them.
static const struct {
    const char *line, *words;
} faults[] = {
    {"v 1 2 nan", "'nan' is not a finite number; write a decimal"},
    {"v NaN 2 3", "'NaN' is not a finite number"},
    {"v 1 inf 3", "'inf' is not a finite number"},
    {"v 1 -Infinity 3", "'-Infinity' is not a finite number"},
    {"v 1 2 1e309", "'1e309' is beyond the largest double; scale"},
    {"v 1 2 -0x1p1024", "'-0x1p1024' is beyond"},
    {"v 1 2 3x", "'3x' is not a finite number"},
    {"v 1 2,5 3", "'2,5' is not a finite number"},
    {"v 1,2,3", "'1,2,3' is"},
    {"v 1 2 0x", "'0x' is"},
    {"v 1 2 3/4", "'3/4' is"},
    {"v one 2 3", "'one' is"},
    {"v 1 2 \x1b[31m", "'?[31m' is"},
    {"v 1 2 3v 4 5 6", "'3v' is"},
    {"v 1 \xc3\xa9 3", "'\?\?' is"},
    {"v 1", "the line ends too early; a vertex is v x y z"},
    {"v", "the line ends too early; a vertex"},
    {"v # 1 2 3", "the line ends too early; a vertex"},
    {"f 1 2 3 5", "there is no vertex 5; they are numbered from 1 to 4"},
    {"f 1 2 3 4 2", "vertex 2 is a corner twice; divide the face, or delete"},
    {"f 1 2 3 0", "'0' is not a corner"},
    {"f 1 2", "the line ends too early; a face has three corners"},
    {"f 1", "the line ends too early; a face has three corners"},
    {"f", "the line ends too early; a face has three corners"},
    {"f 0 1 2", "'0' is not a corner; write the number of a vertex, from 1"},
    {"f 1 2 -0", "'-0' is not a corner"},
    {"f 1 2 0/1/1", "'0/1/1' is not a corner"},
    {"f 1 2 -5", "'-5' is before the first vertex; -1 is"},
    {"f 1 2 -2147483648", "'-2147483648' is not a corner"},
    {"f 1 2 -2147483647", "'-2147483647' is before the first vertex"},
    {"f 1 2 2147483648", "'2147483648' is not a corner"},
    {"f 1 2 4294967297", "'4294967297' is not a corner"},
    {"f 1 2 18446744073709551617", "'18446744073709551617' is not a corner"},
    {"f 1 2 3.0", "'3.0' is not a corner"},
    {"f 1 2 3e0", "'3e0' is not a corner"},
    {"f 1 2 x", "'x' is not a corner"},
    {"f 1 2 -", "'-' is not a corner"},
    {"f 1 2 /3", "'/3' is not a corner"},
    {"f 1 2 3/x", "'3/x' is not a corner"},
    {"f 1 2 3/1/1/1", "'3/1/1/1' is not a corner"},
    {"f 1 2 3/99999999999", "'3/99999999999' is not a corner"},
    {"f 1 2 3;", "'3;' is not a corner"},
    {"f 1 2 --3", "'--3' is not a corner"},
    {"l 1", "the line ends too early; an l line has two corners or more"},
    {"l", "the line ends too early; an l line"},
    {"l 1 0", "'0' is not a corner"},
    {"l 1 2 -5", "'-5' is before the first vertex"},
    {"l 1 b", "'b' is not a corner"},
};

START_TEST(bad_lines_are_refused)
{
    char text[300];
    snprintf(text, sizeof text, FOUR "# %d\n%s\n" FACE, _i, faults[_i].line);
    expect_bad_mesh(text, 6, faults[_i].words);
    snprintf(text, sizeof text, FOUR FACE "%s", faults[_i].line);
    expect_bad_mesh(text, 6, faults[_i].words);
    snprintf(text, sizeof text, FOUR FACE "%s\r\n", faults[_i].line);
    expect_bad_mesh(text, 6, faults[_i].words);
}
END_TEST

START_TEST(triangles_need_depth)
{
    expect_bad_mesh("v 0 0 0\nv 1 0\nv 0 1\nf 1 2 3\n", 2,
                    "a vertex without z; the vertices of triangles must");
    expect_bad_mesh(FOUR FACE "v 1 \\\n 1\n", 6, "a vertex without z");
}
END_TEST

START_TEST(nul_bytes_are_refused)
{
    static const char text[] = FOUR FACE;
    enum {
        SIZE = sizeof text - 1
    };
    for (size_t at = 0; at < SIZE; at++) {
        char broken[SIZE];
        memcpy(broken, text, SIZE);
        broken[at] = '\0';
        tf_mesh_file file;
        long line = 1;
        for (size_t i = 0; i < at; i++)
            line += text[i] == '\n';
        ck_assert(!parse_mesh(&file, broken, SIZE));
        ck_assert_msg(file.fault->place == line, "byte %zu: line %ld", at,
                      file.fault->place);
        tf_mesh_file_free(&file);
    }
    expect_bad_bytes(FOUR FACE "\0", sizeof text, 6,
                     "a NUL byte; the file must be plain");
    expect_bad_bytes(FOUR "f 1 2 3\0\n", sizeof text, 5, "a NUL byte");
    expect_bad_bytes("\0", 1, 1, "a NUL byte");
}
END_TEST

START_TEST(utf_16_is_refused)
{
    static const char utf_16[] = "\xFF\xFEv\0 \0001\0\n\0";
    expect_bad_bytes(utf_16, 10, -1, "this is UTF-16 text; save it as UTF-8");
    expect_bad_bytes(utf_16 + 2, 8, -1, "this is UTF-16 text; ");
    expect_bad_bytes("\0v\0 \0001\0\n", 8, -1, "this is UTF-16 text; ");
    expect_bad_bytes("v 0 0 0\n\0", 9, 2,
                     "a NUL byte; the file must be plain "
                     "text (ASCII or UTF-8, not UTF-16)");
}
END_TEST

START_TEST(text_cut_short_has_a_mendable_fault)
{
    static const char text[] = FOUR "l 1 2\nf 1/1/1 2//2 -2\nl -1 2 3\n";
    for (size_t size = 0; size < sizeof text; size++) {
        tf_mesh_file file;
        if (!parse_mesh(&file, text, size))
            ck_assert_msg(strstr(file.fault->text, "; "), "%zu bytes: '%s'",
                          size, file.fault->text);
        tf_mesh_file_free(&file);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("formats/obj_file");
    TCase *vertices = tcase_create("vertices");
    tcase_add_test(vertices, vertices_keep_their_order);
    tcase_add_test(vertices, weights_and_colors_do_not_count);
    tcase_add_test(vertices, colors_are_columns);
    tcase_add_test(vertices, vertices_without_z_are_of_the_plane);
    tcase_add_test(vertices, random_doubles_come_back_to_the_last_bit);
    tcase_add_test(vertices, the_largest_and_smallest_doubles_are_read);
    suite_add_tcase(suite, vertices);

    TCase *elements = tcase_create("elements");
    tcase_add_test(elements, all_forms_of_indices_are_read);
    tcase_add_test(elements, faces_have_any_number_of_corners);
    tcase_add_test(elements, negative_indices_count_from_where_they_are);
    tcase_add_test(elements, elements_may_precede_their_vertices);
    tcase_add_test(elements, polylines_are_edges);
    suite_add_tcase(suite, elements);

    TCase *lines = tcase_create("lines");
    tcase_add_test(lines, other_lines_are_skipped);
    tcase_add_test(lines, windows_text_with_a_byte_order_mark_is_read);
    tcase_add_test(lines, a_backslash_continues_a_line);
    tcase_add_test(lines, comments_do_not_go_on);
    tcase_add_test(lines, very_long_lines_are_read);
    suite_add_tcase(suite, lines);

    TCase *bad = tcase_create("faults");
    tcase_add_loop_test(bad, bad_lines_are_refused, 0,
                        sizeof faults / sizeof *faults);
    tcase_add_test(bad, triangles_need_depth);
    tcase_add_test(bad, nul_bytes_are_refused);
    tcase_add_test(bad, utf_16_is_refused);
    tcase_add_test(bad, text_cut_short_has_a_mendable_fault);
    suite_add_tcase(suite, bad);
    return suite;
}

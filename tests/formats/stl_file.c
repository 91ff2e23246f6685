// STL, as text and in binary, good and bad.
#include "formats/stl_file.h"

#include "support/bytes.h"
#include "support/meshes.h"
#include "support/support.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

// A square of two triangles, and what is read of it.
static const float square[2][3][3] = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
                                      {{1, 1, -0.f}, {0, 1, .1f}, {0, 0, 0}}};
static const double corners[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, .1f};
static const int triangles[] = {0, 1, 2, 2, 3, 0};

static void expect_square(tf_mesh_file file)
{
    expect_vertices(&file, 4, corners);
    expect_triangles(&file, 2, triangles);
    expect_edges(&file, 0, NULL);
    ck_assert_int_eq(file.left_out[2], 0);
    tf_mesh_file_free(&file);
}

// Binary ----------------------------------------------------------------------

static bytes header_of(const char *beginning, int64_t facets)
{
    bytes made = {0};
    put_text(&made, beginning);
    made.count = 80;
    put_int(&made, 4, facets);
    return made;
}

static void put_facet(bytes *to, const float x[3][3])
{
    for (int k = 0; k < 3; k++)
        put_float(to, NAN); // the normal is skipped
    for (int i = 0; i < 9; i++)
        put_float(to, x[i / 3][i % 3]);
    put_int(to, 2, 0x1234);
}

static bytes binary_square(const char *beginning)
{
    bytes made = header_of(beginning, 2);
    put_facet(&made, square[0]);
    put_facet(&made, square[1]);
    return made;
}

START_TEST(binary_is_read)
{
    static const char *const beginnings[] = {
        "", "solid", "solid x\nfacet normal 0 0 0\nouter loop\n", "ply", "# a"};
    for (int i = 0; i < 5; i++) {
        bytes made = binary_square(beginnings[i]);
        ck_assert(tf_is_binary_stl(made.at, made.count));
        expect_square(good_bytes(made.at, made.count));
    }
    bytes made = binary_square("");
    tf_mesh_file file = good_bytes(made.at, made.count);
    ck_assert(file.counts_bytes);
    ck_assert_int_eq(file.format, TF_STL_BINARY);
    ck_assert_int_eq(file.vertex_place.item[2], 84 + 12 + 24);
    ck_assert_int_eq(file.vertex_place.item[3], 134 + 12 + 12);
    ck_assert_int_eq(file.triangle_place.item[1], 134);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(many_facets_are_read)
{
    bytes made = header_of("", 60);
    for (int i = 0; i < 60; i++) {
        float h = (float)i;
        const float x[3][3] = {{0, 0, 0}, {h, 1, 0}, {h + 1, 1, 0}};
        put_facet(&made, x);
    }
    tf_mesh_file file = good_bytes(made.at, made.count);
    ck_assert_int_eq(tf_mesh_file_vertices(&file), 62);
    ck_assert_int_eq(tf_mesh_file_triangles(&file), 60);
    for (int i = 0; i < 60; i++)
        for (int k = 0; k < 3; k++)
            ck_assert_int_eq(file.triangle.item[3 * i + k], k == 0 ? 0 : i + k);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(triangles_without_area_are_counted_and_left_out)
{
    static const float flat[3][3][3] = {{{0, 0, 0}, {0, 0, -0.f}, {1, 1, 0}},
                                        {{0, 0, 0}, {1, 1, 0}, {1, 1, 0}},
                                        {{0, 1, 0}, {1, 1, 0}, {0, 1, 0}}};
    bytes made = header_of("", 4);
    put_facet(&made, flat[0]);
    put_facet(&made, square[0]);
    put_facet(&made, flat[1]);
    put_facet(&made, flat[2]);
    tf_mesh_file file = good_bytes(made.at, made.count);
    expect_triangles(&file, 1, (int[]){0, 2, 1});
    ck_assert_int_eq(file.left_out[2], 3);
    ck_assert_int_eq(tf_mesh_file_vertices(&file), 4);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(bad_numbers_in_binary_are_refused)
{
    bytes made = binary_square("");
    for (int i = 0; i < 9; i++) {
        bytes bad = made;
        bad.count = 134 + 12 + 4 * (size_t)i;
        put_float(&bad, i % 2 ? NAN : -INFINITY);
        bad.count = made.count;
        expect_bad_bytes(bad.at, bad.count, 134 + 12 + 4 * i,
                         "a coordinate is infinite or NaN; write finite");
    }
}
END_TEST

START_TEST(other_sizes_are_refused)
{
    bytes made = binary_square("solid");
    expect_bad_bytes(made.at, made.count - 1, 80,
                     "the file has 183 bytes, but its header declares 2 "
                     "triangles, which need 184; it may be cut short");
    put_int(&made, 1, 0);
    expect_bad_bytes(
        made.at, made.count, 80,
        "has 185 bytes, but its header declares 2 triangles, which need 184;");
    expect_bad_bytes(made.at, 83, 83,
                     "the file ends too early; binary STL has a header of 84");
    ck_assert(!tf_is_binary_stl(made.at, 83));
    ck_assert(!tf_is_binary_stl(made.at, 185));
    ck_assert(!tf_is_above_binary_stl(made.at, 184));
    ck_assert(tf_is_above_binary_stl(made.at, 185));
    // As many triangles as a header can declare.
    made = header_of("solid", 0xffffffff);
    expect_bad_bytes(made.at, made.count, 80,
                     "has 84 bytes, but its header declares 4294967295 "
                     "triangles, which need 214748364834;");
}
END_TEST

// Text ------------------------------------------------------------------------

#define LOOP_OF(a, b, c)                                                       \
    "facet normal 0 0 nan\n  outer loop\n    vertex " a "\n    vertex " b      \
    "\n    vertex " c "\n  endloop\nendfacet\n"
#define ONE LOOP_OF("0 0 0", "1 0 0", "1 1 0")
#define TWO LOOP_OF("1 1 -0", "0 1 0x1.99999ap-4", "0e9 0 0")

START_TEST(text_is_read)
{
    static const char *const texts[] = {
        "solid\n" ONE TWO "endsolid\n",
        "solid a name\n" ONE TWO "endsolid a name",
        " \nsolid facet\n" ONE "endsolid facet\nsolid b\n" TWO "endsolid b\n"};
    for (int i = 0; i < 3; i++) {
        char text[1000], upper[1000] = "";
        strcpy(text, texts[i]);
        expect_square(good_mesh(text));
        for (int k = 0; text[k]; k++)
            upper[k] = (char)toupper((unsigned char)text[k]);
        expect_square(good_mesh(upper));
        for (char *c = text; *c; c++)
            *c = *c == '\n' ? '\r' : *c;
        expect_square(good_mesh(text));
    }
    tf_mesh_file file = good_mesh(texts[0]);
    ck_assert(!file.counts_bytes);
    ck_assert_int_eq(file.format, TF_STL_TEXT);
    ck_assert_int_eq(file.vertex_place.item[2], 6);
    ck_assert_int_eq(file.vertex_place.item[3], 12);
    ck_assert_int_eq(file.triangle_place.item[1], 9);
    tf_mesh_file_free(&file);
}
END_TEST

static const struct {
    const char *text;
    long line;
    const char *words;
} bad[] = {
    {"solid\n" ONE, 9, "the file ends too early; it may be cut short"},
    {"solid\n" ONE "facet normal 0 0 0\nouter loop\nvertex 1 1", 11,
     "the file ends too early"},
    {"solid\nfacet normal 0 0 0\n", 3, "the file ends too early"},
    {"solid\n" LOOP_OF("0 0 0", "1 0", "1 1 0"), 6,
     "'vertex' is not a finite number"},
    {"solid\n" LOOP_OF("0 0 0", "1 inf 0", "1 1 0"), 5,
     "'inf' is not a finite number"},
    {"solid\n" LOOP_OF("0 0 0 1", "1 1 0", "1 1 0"), 4,
     "'1' is not the word vertex; a loop has three of them"},
    {"solid\n" LOOP_OF("0 0 0", "1 1 0", "1 1 0\nvertex 0 0 1"), 7,
     "'vertex' is not the word endloop; a loop has three"},
    {"solid\nfacet\nvertex 1 1 1\n", 3,
     "'vertex' is not the words outer loop; a facet has one"},
    {"solid\n" ONE "outer loop\n", 9,
     "'outer' is not the word facet or endsolid; write one"},
    {"solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
     "endloop\nfacet\n",
     8, "'facet' is not the word endfacet; add it"},
    {"solid\n" ONE "endsolid\nv 1 2 3\n", 10,
     "'v' is not the word solid; text of STL begins with it"},
    {"solid\nendsolid\n", -1, "no vertices; "},
};

START_TEST(bad_texts_are_refused)
{
    expect_bad_mesh(bad[_i].text, bad[_i].line, bad[_i].words);
}
END_TEST

START_TEST(text_begins_with_a_word)
{
    ck_assert(tf_is_text_stl("solid", 5));
    ck_assert(tf_is_text_stl("\n\tSOLID a\n", 10));
    ck_assert(!tf_is_text_stl("solids\n", 7));
    ck_assert(!tf_is_text_stl("# solid\n", 8));
    ck_assert(!tf_is_text_stl("", 0));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("formats/stl_file");
    TCase *binary = tcase_create("binary");
    tcase_add_test(binary, binary_is_read);
    tcase_add_test(binary, many_facets_are_read);
    tcase_add_test(binary, triangles_without_area_are_counted_and_left_out);
    tcase_add_test(binary, bad_numbers_in_binary_are_refused);
    tcase_add_test(binary, other_sizes_are_refused);
    suite_add_tcase(suite, binary);

    TCase *text = tcase_create("text");
    tcase_add_test(text, text_is_read);
    tcase_add_loop_test(text, bad_texts_are_refused, 0,
                        sizeof bad / sizeof *bad);
    tcase_add_test(text, text_begins_with_a_word);
    suite_add_tcase(suite, text);
    return suite;
}

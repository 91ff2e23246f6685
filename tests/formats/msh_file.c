// Gmsh's format in both versions, as text and in binary, good and bad.
#include "formats/msh_file.h"

#include "support/bytes.h"
#include "support/meshes.h"
#include "support/support.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

// One mesh in all forms: six nodes with tags in any order, a point, two lines, a
// triangle, a quadrangle and a tetrahedron.
enum {
    NODES = 6,
    ELEMENTS = 6
};

static const int tags[NODES] = {4, 70, 2, 9, 1, 30};
static const double corners[3 * NODES] = {0, 0, 0, 1,   0,    0, 1, 1, 0,
                                          0, 1, 0, 0.1, -0.5, 2, 5, 5, 5};
static const struct {
    int type, dimensions, nodes, node[4];
} elements[ELEMENTS] = {
    {15, 0, 1, {4}},       {1, 1, 2, {4, 70}},       {1, 1, 2, {70, 2}},
    {2, 2, 3, {4, 70, 1}}, {3, 2, 4, {2, 9, 4, 70}}, {4, 3, 4, {4, 70, 9, 1}},
};

static void expect_surface(tf_mesh_file file)
{
    expect_vertices(&file, NODES, corners);
    expect_triangles(&file, 3, (int[]){0, 1, 4, 0, 1, 2, 0, 2, 3});
    expect_edges(&file, 0, NULL);
    ck_assert_int_eq(tf_mesh_file_polygons(&file), 1);
    ck_assert_int_eq(file.left_out[0], 1);
    ck_assert_int_eq(file.left_out[1], 2);
    ck_assert_int_eq(file.left_out[2], 0);
    ck_assert_int_eq(file.left_out[3], 1);
    ck_assert_int_eq(file.format, TF_MSH);
    tf_mesh_file_free(&file);
}

// Text ------------------------------------------------------------------------

#define FORMAT(version) "$MeshFormat\n" version " 0 8\n$EndMeshFormat\n"
#define NAMES "$PhysicalNames\n1\n2 1 \"$Nodes\"\n$EndPhysicalNames\n"

static void put_format(bytes *to, const char *format, ...)
{
    char text[200];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    put_text(to, text);
}

static void put_old_text(bytes *to)
{
    put_format(to, "$Nodes\n%d\n", NODES);
    for (int i = 0; i < NODES; i++)
        put_format(to, "%d %.17g %.17g %.17g\n", tags[i], corners[3 * i],
                   corners[3 * i + 1], corners[3 * i + 2]);
    put_format(to, "$EndNodes\n$Elements\n%d\n", ELEMENTS);
    for (int i = 0; i < ELEMENTS; i++) {
        put_format(to, "%d %d %d", i + 7, elements[i].type, i % 3);
        for (int k = 0; k < i % 3; k++)
            put_format(to, " %d", k == 0 ? 1 : -5);
        for (int k = 0; k < elements[i].nodes; k++)
            put_format(to, " %d", elements[i].node[k]);
        put_text(to, "\n");
    }
    put_text(to, "$EndElements\n");
}

/// The first three nodes on a surface, with parameters.
static void put_new_text(bytes *to)
{
    put_text(to, "$Nodes\n2 6 1 70\n");
    for (int block = 0; block < 2; block++) {
        put_text(to, block ? "3 1 0 3\n" : "2 -4 1 3\n");
        for (int i = 3 * block; i < 3 * block + 3; i++)
            put_format(to, "%d\n", tags[i]);
        for (int i = 3 * block; i < 3 * block + 3; i++)
            put_format(to, "%.17g %.17g %.17g%s\n", corners[3 * i],
                       corners[3 * i + 1], corners[3 * i + 2],
                       block ? "" : " 7 nan");
    }
    put_text(to, "$EndNodes\n$Elements\n5 6 7 12\n");
    for (int i = 0; i < ELEMENTS; i++) {
        if (i != 2)
            put_format(to, "%d -1 %d %d\n", elements[i].dimensions,
                       elements[i].type, 1 + (i == 1));
        put_format(to, "%d", i + 7);
        for (int k = 0; k < elements[i].nodes; k++)
            put_format(to, " %d", elements[i].node[k]);
        put_text(to, "\n");
    }
    put_text(to, "$EndElements\n");
}

START_TEST(text_is_read)
{
    static const char *const formats[] = {FORMAT("2.2"), FORMAT("2"),
                                          FORMAT("4.1")};
    for (int i = 0; i < 3; i++) {
        bytes made = {0}, mac;
        put_text(&made, formats[i]);
        put_text(&made, NAMES);
        (i < 2 ? put_old_text : put_new_text)(&made);
        put_text(&made, "$NodeData\n7 $ 8\n$EndNodeData\n");
        expect_surface(good_bytes(made.at, made.count));
        mac = made;
        for (size_t k = 0; k < mac.count; k++)
            mac.at[k] = mac.at[k] == '\n' ? '\r' : mac.at[k];
        expect_surface(good_bytes(mac.at, mac.count));
    }
}
END_TEST

START_TEST(places_are_lines)
{
    bytes made = {0};
    put_text(&made, FORMAT("2.2") NAMES);
    put_old_text(&made);
    tf_mesh_file file = good_bytes(made.at, made.count);
    ck_assert(!file.counts_bytes);
    ck_assert_int_eq(file.vertex_place.item[2], 12);
    ck_assert_int_eq(file.triangle_place.item[2], 23);
    tf_mesh_file_free(&file);
    made.count = 0;
    put_text(&made, FORMAT("4.1") NAMES);
    put_new_text(&made);
    file = good_bytes(made.at, made.count);
    ck_assert_int_eq(file.vertex_place.item[5], 23);
    ck_assert_int_eq(file.triangle_place.item[0], 33);
    tf_mesh_file_free(&file);
}
END_TEST

// Binary ----------------------------------------------------------------------

static bytes binary_format(bool big, const char *version)
{
    bytes made = {.big = big};
    put_format(&made, "$MeshFormat\n%s 1 8\n", version);
    put_int(&made, 4, 1);
    put_text(&made, "\n$EndMeshFormat\n" NAMES);
    return made;
}

static void put_nodes_of(bytes *to, int element, int size)
{
    for (int k = 0; k < elements[element].nodes; k++)
        put_int(to, size, elements[element].node[k]);
}

static void put_ints(bytes *to, int count, const int number[])
{
    for (int i = 0; i < count; i++)
        put_int(to, 4, number[i]);
}

static void put_old_binary(bytes *to)
{
    put_format(to, "$Nodes\n%d\n", NODES);
    for (int i = 0; i < NODES; i++) {
        put_int(to, 4, tags[i]);
        for (int k = 0; k < 3; k++)
            put_double(to, corners[3 * i + k]);
    }
    put_format(to, "\n$EndNodes\n$Elements\n%d\n", ELEMENTS);
    for (int i = 0; i < ELEMENTS; i++) {
        if (i != 2)
            put_ints(to, 3, (int[]){elements[i].type, 1 + (i == 1), 1});
        put_ints(to, 2, (int[]){i + 7, -3});
        put_nodes_of(to, i, 4);
    }
    put_text(to, "\n$EndElements\n");
}

static void put_sizes(bytes *to, int count, const int number[])
{
    for (int i = 0; i < count; i++)
        put_int(to, 8, number[i]);
}

static void put_new_binary(bytes *to)
{
    put_text(to, "$Nodes\n");
    put_sizes(to, 4, (int[]){2, 6, 1, 70});
    for (int block = 0; block < 2; block++) {
        put_ints(to, 3, block ? (int[]){3, 1, 0} : (int[]){2, -4, 1});
        put_sizes(to, 1, (int[]){3});
        put_sizes(to, 3, tags + (ptrdiff_t)3 * block);
        for (int i = 3 * block; i < 3 * block + 3; i++)
            for (int k = 0; k < (block ? 3 : 5); k++)
                put_double(to, k < 3 ? corners[3 * i + k] : NAN);
    }
    put_text(to, "\n$EndNodes\n$Elements\n");
    put_sizes(to, 4, (int[]){5, 6, 7, 12});
    for (int i = 0; i < ELEMENTS; i++) {
        if (i != 2) {
            put_ints(to, 3,
                     (int[]){elements[i].dimensions, -1, elements[i].type});
            put_sizes(to, 1, (int[]){1 + (i == 1)});
        }
        put_sizes(to, 1, (int[]){i + 7});
        put_nodes_of(to, i, 8);
    }
    put_text(to, "\n$EndElements\n");
}

static bytes binary(bool big, bool is_new)
{
    bytes made = binary_format(big, is_new ? "4.1" : "2.2");
    (is_new ? put_new_binary : put_old_binary)(&made);
    return made;
}

START_TEST(binary_is_read)
{
    bytes made = binary(_i % 2, _i / 2);
    tf_mesh_file file = good_bytes(made.at, made.count);
    ck_assert(file.counts_bytes);
    for (int i = 0; i < NODES; i++) {
        double x;
        bytes copy = {.big = made.big};
        put_double(&copy, corners[3 * i]);
        memcpy(&x, copy.at, sizeof x);
        ck_assert_mem_eq(made.at + file.vertex_place.item[i], &x, sizeof x);
    }
    expect_surface(file);
}
END_TEST

START_TEST(binary_cut_short_is_refused)
{
    bytes made = binary(_i % 2, _i / 2);
    size_t last = strlen("\n$EndElements\n");
    for (size_t size = 0; size < made.count - last; size++) {
        tf_mesh_file file;
        ck_assert_msg(!parse_mesh(&file, made.at, size), "%zu", size);
        ck_assert_msg(strstr(file.fault->text, "; ") != NULL, "%s",
                      file.fault->text);
        ck_assert_int_le(file.fault->place, (long)size + 1);
        tf_mesh_file_free(&file);
    }
}
END_TEST

// Other elements --------------------------------------------------------------

#define THREE_NODES "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n"
#define OLD FORMAT("2.2") THREE_NODES
#define ELEMENTS_OF(text) OLD "$Elements\n" text "\n$EndElements\n"

START_TEST(lines_are_edges_if_there_is_no_surface)
{
    tf_mesh_file file =
        good_mesh(ELEMENTS_OF("3\n1 1 0 3 2\n2 15 0 1\n3 8 0 1 2 3"));
    expect_edges(&file, 1, (int[]){2, 1});
    ck_assert(tf_mesh_file_is_flat(&file));
    ck_assert_int_eq(file.left_out[1], 1);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(volumes_without_a_surface_are_refused)
{
    expect_bad_mesh(ELEMENTS_OF("2\n1 4 0 1 2 3 1\n2 4 0 1 2 3 1"), -1,
                    "no triangles, but 2 volume elements; save their surface");
    expect_bad_mesh(ELEMENTS_OF("1\n1 15 0 1"), -1,
                    "no triangles and no edges; ");
}
END_TEST

START_TEST(curved_surfaces_are_refused)
{
    static const struct {
        int type, nodes;
    } curved[] = {{9, 6},   {10, 9},  {16, 8},  {20, 9},  {21, 10},
                  {22, 12}, {23, 15}, {24, 15}, {25, 21}, {36, 16},
                  {37, 25}, {38, 36}, {39, 12}, {40, 16}, {41, 20}};
    for (size_t i = 0; i < sizeof curved / sizeof *curved; i++) {
        char text[400], words[100];
        snprintf(text, sizeof text, ELEMENTS_OF("1\n1 %d 0 1 2 3"),
                 curved[i].type);
        snprintf(words, sizeof words,
                 "a curved element with %d nodes; save the mesh with",
                 curved[i].nodes);
        expect_bad_mesh(text, 12, words);
    }
}
END_TEST

START_TEST(all_other_types_are_left_out)
{
    // The numbers of nodes, by dimensions and types, from Gmsh's manual.
    static const int types[][3] = {
        {3, 5, 8},   {3, 6, 6},   {3, 7, 5},   {1, 8, 3},   {3, 11, 10},
        {3, 12, 27}, {3, 13, 18}, {3, 14, 14}, {3, 17, 20}, {3, 18, 15},
        {3, 19, 13}, {1, 26, 4},  {1, 27, 5},  {1, 28, 6},  {3, 29, 20},
        {3, 30, 35}, {3, 31, 56}, {3, 92, 64}, {3, 93, 125}};
    for (size_t i = 0; i < sizeof types / sizeof *types; i++) {
        bytes made = {0};
        put_text(&made, OLD "$Elements\n2\n1 2 0 3 2 1\n");
        put_format(&made, "2 %d 0", types[i][1]);
        for (int k = 0; k < types[i][2]; k++)
            put_format(&made, " %d", k + 1);
        put_text(&made, "\n$EndElements\n");
        tf_mesh_file file = good_bytes(made.at, made.count);
        expect_triangles(&file, 1, (int[]){2, 1, 0});
        ck_assert_int_eq(file.left_out[types[i][0]], 1);
        tf_mesh_file_free(&file);
    }
}
END_TEST

// Faults ----------------------------------------------------------------------

static const struct {
    const char *text;
    long line;
    const char *words;
} bad[] = {
    {FORMAT("4"), 2, "this is version 4 of Gmsh's format; save the mesh in"},
    {FORMAT("1.0"), 2, "this is version 1 of"},
    {FORMAT("5"), 2, "this is version 5 of"},
    {"$MeshFormat\nx 0 8\n", 2, "'x' is not a finite number"},
    {"$MeshFormat\n2.2 0 8\nx\n", 3,
     "'$EndMeshFormat' does not follow; correct"},
    {"$MeshFormat\n2.2 1 4\n", 2, "numbers of 4 bytes; save the mesh with 8"},
    {FORMAT("2.2") "Nodes\n", 4, "'Nodes' is not the name of a section; one"},
    {FORMAT("2.2") "$Names\n1\n$End\n", 4,
     "'$EndNames' does not follow; the file may be cut short"},
    {FORMAT("2.2") "$ASectionWithALongNameOfItsOwnThatIsCut\n"
                   "$EndASectionWithALongNameOfItsOwnThatIsCut\n",
     4, "does not follow; "},
    {FORMAT("2.2") "$Elements\n", 4, "$Elements comes before $Nodes; swap"},
    {OLD THREE_NODES, 10, "a second section $Nodes; join the two"},
    {FORMAT("2.2") "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n", 9,
     "'$EndNodes' is not an integer from 0 to 2147483647"},
    {FORMAT("2.2") "$Nodes\n2\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n", 8,
     "'$EndNodes' does not follow; correct the numbers in the section"},
    {FORMAT("2.2") "$Nodes\n2\n7 0 0 0\n7 1 0 0\n$EndNodes\n", 7,
     "two nodes have the tag 7; number them differently"},
    {FORMAT("2.2") "$Nodes\n2\n1 0 0 inf\n", 6, "'inf' is not a finite number"},
    {ELEMENTS_OF("1\n1 2 0 1 2 4"), 12,
     "there is no node 4; the section $Nodes must have it"},
    {ELEMENTS_OF("1\n1 1 0 0 2"), 12, "there is no node 0; "},
    {ELEMENTS_OF("1\n1 94 0 1 2 4"), 12,
     "unknown type 94 of elements; save the mesh with elements of order 1"},
    {ELEMENTS_OF("1\n1 35 0 1 2 4"), 12, "unknown type 35 of elements"},
    {ELEMENTS_OF("1\n1 0 0 1 2 4"), 12, "unknown type 0 of elements"},
    {ELEMENTS_OF("1\n1 2 0 1 2"), 13, "'$EndElements' is not an integer"},
    {OLD "$Elements\n1\n1 2 0 1 2 3", 12, "'$EndElements' does not follow"},
    {OLD "$Elements\n2\n1 2 0 1 2 3\n", 13, "the file ends too early"},
    {ELEMENTS_OF("1\n1 3 0 1 2 3 2"), 12, "vertex 1 is a corner twice; divide"},
};

START_TEST(bad_texts_are_refused)
{
    expect_bad_mesh(bad[_i].text, bad[_i].line, bad[_i].words);
}
END_TEST

START_TEST(bad_binary_is_refused)
{
    bytes made = binary_format(false, "4.1"), rows;
    const char *at = strstr(made.at, "1 8\n");
    long one = at - made.at + 4;
    rows = made;
    rows.at[one] = 2;
    expect_bad_bytes(rows.at, rows.count, one + 4,
                     "the byte order is not told by a 1; the file may be");
    put_text(&made, "$Nodes\n");
    rows = made;
    put_int(&rows, 8, INT64_C(0x80000000));
    expect_bad_bytes(rows.at, rows.count, (long)rows.count,
                     "a number or tag is above 2147483647; correct it");
    rows = made;
    put_sizes(&rows, 4, (int[]){1, 1, 1, 1});
    put_ints(&rows, 1, (int[]){-1});
    expect_bad_bytes(rows.at, rows.count, (long)rows.count,
                     "-1 is not an integer from 0; correct it");
    rows.count -= 4;
    put_ints(&rows, 3, (int[]){0, 1, 0});
    put_sizes(&rows, 2, (int[]){1, 1});
    put_double(&rows, NAN);
    expect_bad_bytes(rows.at, rows.count, (long)rows.count,
                     "a coordinate is infinite or NaN; write finite numbers");
    // Neither memory nor time is spent on what is declared alone.
    rows = made;
    put_sizes(&rows, 4, (int[]){2147483647, 1, 1, 1});
    put_ints(&rows, 3, (int[]){0, 1, 0});
    put_sizes(&rows, 2, (int[]){2147483647, 1});
    expect_bad_bytes(rows.at, rows.count, (long)rows.count,
                     "the file ends too early; it may be cut short");
}
END_TEST

START_TEST(a_missing_node_has_a_byte)
{
    bytes made = binary(false, true);
    size_t last = made.count - strlen("\n$EndElements\n") - 8;
    made.at[last - 8 * 3 - 12 - 16 - 8 * 2] = 99; // of the quadrangle
    tf_mesh_file file;
    ck_assert(!parse_mesh(&file, made.at, made.count));
    ck_assert_str_eq(file.fault->text,
                     "there is no node 99; the section $Nodes must have it");
    ck_assert(file.fault->counts_bytes);
    ck_assert_int_lt(file.fault->place, (long)last);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(files_begin_with_their_format)
{
    ck_assert(tf_is_msh("$MeshFormat\n", 12));
    ck_assert(tf_is_msh("\n$MeshFormat 2", 14));
    ck_assert(!tf_is_msh("$MeshFormats", 12));
    ck_assert(!tf_is_msh("$Nodes\n", 7));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("formats/msh_file");
    TCase *good = tcase_create("good");
    tcase_add_test(good, text_is_read);
    tcase_add_test(good, places_are_lines);
    tcase_add_loop_test(good, binary_is_read, 0, 4);
    tcase_add_test(good, lines_are_edges_if_there_is_no_surface);
    tcase_add_test(good, all_other_types_are_left_out);
    tcase_add_test(good, files_begin_with_their_format);
    suite_add_tcase(suite, good);

    TCase *faults = tcase_create("faults");
    tcase_add_loop_test(faults, binary_cut_short_is_refused, 0, 4);
    tcase_add_test(faults, volumes_without_a_surface_are_refused);
    tcase_add_test(faults, curved_surfaces_are_refused);
    tcase_add_loop_test(faults, bad_texts_are_refused, 0,
                        sizeof bad / sizeof *bad);
    tcase_add_test(faults, bad_binary_is_refused);
    tcase_add_test(faults, a_missing_node_has_a_byte);
    suite_add_tcase(suite, faults);
    return suite;
}

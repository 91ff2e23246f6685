// PLY, as text and in binary, good and bad.
#include "formats/ply_file.h"

#include "support/bytes.h"
#include "support/meshes.h"
#include "support/support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Three vertices, on lines 10 to 12, and a triangle of them on line 13.
#define VERTICES                                                               \
    "element vertex 3\nproperty double x\nproperty double y\n"                 \
    "property double z\n"
#define FACES "element face 1\nproperty list uchar int vertex_indices\n"
#define HEADER "ply\nformat ascii 1.0\n" VERTICES FACES "end_header\n"
#define THREE "0 0 0\n1 0 0\n0 1 0\n"

static const int first_three[] = {0, 1, 2};
static const double three[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};

// Building binary files -------------------------------------------------------

static bytes binary(bool big, const char *declarations)
{
    bytes made = {.big = big};
    put_text(&made, "ply\nformat binary_");
    put_text(&made, big ? "big" : "little");
    put_text(&made, "_endian 1.0\n");
    put_text(&made, declarations);
    put_text(&made, "end_header\n");
    return made;
}

static void put_face(bytes *to)
{
    put_int(to, 1, 3);
    for (int i = 0; i < 3; i++)
        put_int(to, 4, i);
}

/// The triangle of HEADER and THREE.
static bytes binary_triangle(bool big)
{
    bytes made = binary(big, VERTICES FACES);
    for (int i = 0; i < 9; i++)
        put_double(&made, three[i]);
    put_face(&made);
    return made;
}

// Good files ------------------------------------------------------------------

START_TEST(a_file_is_ply_by_its_first_line)
{
    static const char *const good[] = {"ply\n", "ply\r", "ply\r\n",
                                       "ply\nplenty"};
    static const char *const bad[] = {"",      "\n",   "ply",   "pl\n",
                                      "plx\n", "ply ", "PLY\n", "plyx\n"};
    for (int i = 0; i < 4; i++)
        ck_assert_msg(tf_is_ply(good[i], strlen(good[i])), "%s", good[i]);
    for (int i = 0; i < 8; i++)
        ck_assert_msg(!tf_is_ply(bad[i], strlen(bad[i])), "%s", bad[i]);
    ck_assert(!tf_is_ply("ply\n", 3));
}
END_TEST

START_TEST(a_triangle_is_read_as_text)
{
    tf_mesh_file file = good_mesh(HEADER THREE "3 0 1 2\n");
    expect_vertices(&file, 3, three);
    expect_triangles(&file, 1, first_three);
    expect_edges(&file, 0, NULL);
    ck_assert_int_eq(file.first_index, 0);
    ck_assert(!file.counts_bytes);
    ck_assert_int_eq(file.vertex_place.item[0], 10);
    ck_assert_int_eq(file.triangle_place.item[0], 13);
    tf_mesh_file_free(&file);
}
END_TEST

// Five vertices, two polygons with a triangle between them.
#define FIVE_VERTICES                                                          \
    "element vertex 5\nproperty char x\nproperty char y\nproperty char z\n"
#define THREE_FACES "element face 3\nproperty list uchar char vertex_indices\n"
static const int five[] = {0, 0, 0, 2, 0, 0, 3, 2, 0, 1, 3, 0, -1, 2, 0};
static const int corners[] = {4, 4, 0, 1, 2, 3, 1, 2, 3, 5, 2, 3, 4, 0, 1};

static void expect_polygons(tf_mesh_file file)
{
    expect_triangles(
        &file, 6,
        (int[]){0, 1, 2, 0, 2, 4, 1, 2, 3, 0, 1, 2, 0, 2, 3, 0, 3, 4});
    ck_assert_int_eq(tf_mesh_file_polygons(&file), 2);
    tf_mesh_file_free(&file);
}

START_TEST(faces_have_any_number_of_corners)
{
    char text[500] = "ply\nformat ascii 1.0\n" THREE_FACES FIVE_VERTICES
                     "end_header\n4 4 0 1 2\n3 1 2 3\n5 2 3 4 0 1\n";
    bytes made = binary(_i, THREE_FACES FIVE_VERTICES);
    for (int i = 0; i < 15; i++)
        put_int(&made, 1, corners[i]);
    for (int i = 0; i < 15; i++) {
        put_int(&made, 1, five[i]);
        sprintf(text + strlen(text), i % 3 == 2 ? "%d\n" : "%d ", five[i]);
    }
    expect_polygons(good_mesh(text));
    expect_polygons(good_bytes(made.at, made.count));
}
END_TEST

// Strips ----------------------------------------------------------------------

#define STRIPS "element tristrips 2\nproperty list int int vertex_indices\n"

/// The lists are numbers, each of which begins with how many there are.
static void expect_strips(const char *faces, const int list[], int numbers,
                          int count, const int vertex[])
{
    char text[600];
    snprintf(text, sizeof text,
             "ply\nformat ascii 1.0\n" FIVE_VERTICES "%s" STRIPS
             "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 2 2\n%s",
             faces, *faces ? "3 0 1 4\n" : "");
    for (int i = 0, at = 0; i < 2; i++) {
        int length = list[at];
        for (int k = 0; k <= length; k++)
            sprintf(text + strlen(text), k < length ? "%d " : "%d\n",
                    list[at++]);
        ck_assert_int_le(at, numbers);
    }
    tf_mesh_file file = good_mesh(text);
    expect_triangles(&file, count, vertex);
    tf_mesh_file_free(&file);
}

START_TEST(strips_are_triangles_of_one_side)
{
    static const int plain[] = {5, 0, 1, 2, 3, 4, 3, 4, 3, 2};
    expect_strips("", plain, 10, 4,
                  (int[]){0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 2});
    // Strips within a list, of which some are too short.
    static const int ended[] = {12, -1, 0, 1, 2, 3, -1, -1, 1,
                                2,  -1, 4, 3, 4, 2, 1,  0,  -1};
    expect_strips("", ended, 18, 3, (int[]){0, 1, 2, 2, 1, 3, 2, 1, 0});
    // A corner twice joins strips; the sides go on to alternate.
    static const int joined[] = {7, 0, 1, 2, 2, 3, 4, 1, 0}; // and none
    expect_strips("", joined, 9, 3, (int[]){0, 1, 2, 3, 2, 4, 3, 4, 1});
    expect_strips("element face 1\nproperty list uchar int vertex_index\n",
                  joined, 9, 4, (int[]){0, 1, 4, 0, 1, 2, 3, 2, 4, 3, 4, 1});
}
END_TEST

START_TEST(strips_are_read_in_binary)
{
    bytes made = binary(_i, FIVE_VERTICES STRIPS);
    for (int i = 0; i < 15; i++)
        put_int(&made, 1, five[i]);
    static const int list[] = {7, 0, 1, 2, -1, 2, 3, 4, 0};
    for (int i = 0; i < 9; i++)
        put_int(&made, 4, list[i]);
    tf_mesh_file file = good_bytes(made.at, made.count);
    expect_triangles(&file, 2, (int[]){0, 1, 2, 2, 3, 4});
    ck_assert_int_eq(file.triangle_place.item[1], (int)made.count - 36);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(a_triangle_is_read_in_binary)
{
    bytes made = binary_triangle(_i);
    tf_mesh_file file = good_bytes(made.at, made.count);
    expect_vertices(&file, 3, three);
    expect_triangles(&file, 1, first_three);
    ck_assert(file.counts_bytes);
    ck_assert_int_eq(file.triangle_place.item[0], (int)made.count - 13);
    ck_assert_int_eq(file.vertex_place.item[1], (int)made.count - 13 - 48);
    tf_mesh_file_free(&file);
}
END_TEST

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
    for (long i = 0; i < cases(10000); i++) {
        double x[9];
        char text[1000] = HEADER;
        bytes made = binary(i % 2, VERTICES FACES);
        for (int j = 0; j < 9; j++) {
            x[j] = any_double(&random);
            put_double(&made, x[j]);
            sprintf(text + strlen(text), i % 2 ? "%a%c" : "%.17g%c", x[j],
                    j % 3 < 2 ? ' ' : '\n');
        }
        put_face(&made);
        strcat(text, "3 0 1 2\n");
        tf_mesh_file file = good_mesh(text);
        expect_vertices(&file, 3, x);
        tf_mesh_file_free(&file);
        file = good_bytes(made.at, made.count);
        expect_vertices(&file, 3, x);
        tf_mesh_file_free(&file);
    }
}
END_TEST

START_TEST(random_floats_come_back_to_the_last_bit)
{
    generator random = generator_new(2);
    for (long i = 0; i < cases(10000); i++) {
        bytes made = binary(i % 2, "element vertex 1\nproperty float x\n"
                                   "property float32 y\nproperty float z\n"
                                   "element edge 1\nproperty int vertex1\n"
                                   "property int vertex2\n");
        double x[3];
        for (int k = 0; k < 3; k++) {
            float single = INFINITY;
            while (!isfinite(single)) {
                uint32_t bits = (uint32_t)next_bits(&random);
                memcpy(&single, &bits, sizeof single);
            }
            put_float(&made, single);
            x[k] = (double)single;
        }
        put_int(&made, 4, 0);
        put_int(&made, 4, 0);
        tf_mesh_file file = good_bytes(made.at, made.count);
        expect_vertices(&file, 1, x);
        tf_mesh_file_free(&file);
    }
}
END_TEST

/// Every type of integers, its size, and its least and largest index.
static const struct {
    const char *names[2];
    int size;
    int64_t least, most;
} integers[] = {
    {{"char", "int8"}, 1, -128, 127},
    {{"uchar", "uint8"}, 1, 0, 255},
    {{"short", "int16"}, 2, -32768, 32767},
    {{"ushort", "uint16"}, 2, 0, 65535},
    {{"int", "int32"}, 4, INT32_MIN, INT32_MAX},
    {{"uint", "uint32"}, 4, 0, UINT32_MAX},
};

static void try_integers(int i, int name, bool big)
{
    char declarations[500];
    const char *type = integers[i].names[name];
    snprintf(declarations, sizeof declarations,
             "element vertex 1\nproperty %s x\nproperty %s y\n"
             "property %s z\nelement face 1\n"
             "property list %s %s vertex_index\n",
             type, type, type, type, type);
    bytes made = binary(big, declarations);
    int size = integers[i].size;
    put_int(&made, size, integers[i].least);
    put_int(&made, size, integers[i].most);
    put_int(&made, size, 100);
    put_int(&made, size, 3);
    put_int(&made, size, 0);
    put_int(&made, size, 127);
    put_int(&made, size, integers[i].most & INT32_MAX);
    tf_mesh_file file = good_bytes(made.at, made.count);
    expect_vertices(
        &file, 1,
        (double[]){(double)integers[i].least, (double)integers[i].most, 100});
    expect_triangles(&file, 1,
                     (int[]){0, 127, (int)(integers[i].most & INT32_MAX)});
    tf_mesh_file_free(&file);
}

START_TEST(all_types_of_integers_are_read)
{
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 4; j++)
            try_integers(i, j / 2, j % 2);
}
END_TEST

START_TEST(edges_are_read)
{
    static const char declarations[] =
        "element vertex 3\nproperty float x\nproperty float y\n"
        "element edge 2\nproperty uchar red\nproperty uint vertex2\n"
        "property short vertex1\n";
    char text[400];
    snprintf(text, sizeof text,
             "ply\nformat ascii 1.0\n%send_header\n0 0\n1 0\n0 1\n255 1 0\n"
             "0 2 1\n",
             declarations);
    tf_mesh_file file = good_mesh(text);
    expect_vertices(&file, 3, three);
    expect_edges(&file, 2, (int[]){0, 1, 1, 2});
    ck_assert_int_eq(file.edge_place.item[1], 15);
    ck_assert(tf_mesh_file_is_flat(&file));
    tf_mesh_file_free(&file);

    bytes made = binary(true, declarations);
    for (int i = 0; i < 6; i++)
        put_float(&made, (float)three[i / 2 * 3 + i % 2]);
    for (int i = 0; i < 2; i++) {
        put_int(&made, 1, 255);
        put_int(&made, 4, i + 1);
        put_int(&made, 2, i);
    }
    file = good_bytes(made.at, made.count);
    expect_vertices(&file, 3, three);
    expect_edges(&file, 2, (int[]){0, 1, 1, 2});
    tf_mesh_file_free(&file);
}
END_TEST

// All that is not asked for: normals, colors, lists, elements.
#define MORE                                                                   \
    "comment x\nobj_info y\nelement camera 1\n"                                \
    "property list uchar float x\nproperty double y\n"                         \
    "element nothing 1000000000\n"                                             \
    "element vertex 3\nproperty list int uchar a\nproperty uchar red\n"        \
    "property double z\nproperty float nx\nproperty double y\n"                \
    "property double x\n\n"                                                    \
    "element face 1\nproperty list uint double texcoord\n"                     \
    "property list uchar int vertex_indices\nproperty int vertex_index\n"      \
    "element material 2\nproperty int id\n"

START_TEST(what_is_unknown_is_skipped_as_text)
{
    tf_mesh_file file =
        good_mesh("ply\nformat ascii 1.0\n" MORE "end_header\n"
                  "2 1.5 nan -inf\n"
                  "1 7 255 0 nan 0 0\n0 x 0 inf 0 1\n2 5 5 1 0 nan 1 0\n"
                  "2 0.5 NaN 3 0 1 2 -9\n"
                  "none\n18446744073709551616\n");
    expect_vertices(&file, 3, three);
    expect_triangles(&file, 1, first_three);
    tf_mesh_file_free(&file);
}
END_TEST

static void put_more_vertex(bytes *to, int list, const double x[3])
{
    put_int(to, 4, list);
    for (int i = 0; i < list; i++)
        put_int(to, 1, i);
    put_int(to, 1, 255);
    put_double(to, x[2]);
    put_float(to, NAN);
    put_double(to, x[1]);
    put_double(to, x[0]);
}

static bytes binary_more(bool big)
{
    bytes made = binary(big, MORE);
    put_int(&made, 1, 1);
    put_float(&made, INFINITY);
    put_double(&made, NAN);
    for (int i = 0; i < 3; i++)
        put_more_vertex(&made, 5 * i, three + 3 * i);
    put_int(&made, 4, 1);
    put_double(&made, NAN);
    put_face(&made);
    put_int(&made, 4, -9);
    put_int(&made, 4, 1);
    put_int(&made, 4, 2);
    return made;
}

START_TEST(what_is_unknown_is_skipped_in_binary)
{
    bytes made = binary_more(_i);
    tf_mesh_file file = good_bytes(made.at, made.count);
    expect_vertices(&file, 3, three);
    expect_triangles(&file, 1, first_three);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(windows_text_is_read)
{
    static const char text[] = HEADER THREE "3 0 1 2\n";
    char windows[2 * sizeof text], *to = windows;
    for (const char *from = text; *from; from++) {
        if (*from == '\n')
            *to++ = '\r';
        *to++ = *from;
    }
    *to = '\0';
    tf_mesh_file file = good_mesh(windows);
    expect_vertices(&file, 3, three);
    expect_triangles(&file, 1, first_three);
    ck_assert_int_eq(file.triangle_place.item[0], 13);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(a_windows_header_of_binary_is_read)
{
    bytes made = {0};
    put_text(&made, "ply\r\nformat binary_little_endian 1.0\r\n"
                    "element vertex 3\r\nproperty double x\r\n"
                    "property double y\r\nproperty double z\r\n"
                    "element face 1\r\n"
                    "property list uchar int vertex_indices\r\nend_header\r\n");
    for (int i = 0; i < 9; i++)
        put_double(&made, three[i]);
    put_face(&made);
    tf_mesh_file file = good_bytes(made.at, made.count);
    expect_vertices(&file, 3, three);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(blanks_and_blank_lines_are_skipped)
{
    expect_triangles_of(HEADER "\n 0  0\t0 \n1 0 0\n\n \t\n0 1 0\n3 0 1 2", 1,
                        first_three);
    expect_triangles_of("ply\n format\tascii  1.0 \n\n\t" VERTICES FACES
                        "end_header \n" THREE "3 0 1 2\n\n \n",
                        1, first_three);
}
END_TEST

START_TEST(faces_may_precede_vertices)
{
    expect_triangles_of("ply\nformat ascii 1.0\n" FACES VERTICES "end_header\n"
                        "3 0 1 2\n" THREE,
                        1, first_three);
}
END_TEST

// Faults of the header --------------------------------------------------------

static const struct {
    const char *text;
    long line;
    const char *words;
} headers[] = {
    {"ply\n", 2, "the header ends too early; the file may be cut short"},
    {"ply\r", 2, "the header ends too early"},
    {"ply\nformat ascii 1.0\n" VERTICES FACES, 9, "the header ends too early"},
    {"ply\nformat ascii 1.0\n" VERTICES FACES "end_header", 9,
     "nothing follows the header; the file may be cut short"},
    {"ply\n" VERTICES FACES "end_header\n" THREE "3 0 1 2\n", 8,
     "the header has no format; add"},
    {"ply\nformat ascii 1.0\nelement tristrips 1\nend_header\n", 3,
     "the strips have no corners; declare the property list int int"},
    {"ply\nformat ascii 1.0\nelement vertex 3\nproperty int x\n"
     "property int y\n" STRIPS "end_header\n",
     3, "vertices without z; the vertices of triangles must have three"},
    {"ply\nformat utf8 1.0\n", 2, "unknown format 'utf8'; write ascii"},
    {"ply\nformat\n", 2, "unknown format ''; write ascii"},
    {"ply\nformat binary_little_endian_and_more_than_that 1.0\n", 2,
     "unknown format 'binary_little_endian_and_mor...'"},
    {"ply\nformat ascii 1.0\nversion 7\n", 3,
     "a header line cannot begin with 'version'; begin comments"},
    {"ply\nformat ascii 1.0\nelement vertex\n", 3,
     "'' is not a number of elements; write an integer from 0 to 2147483647"},
    {"ply\nformat ascii 1.0\nelement vertex -1\n", 3, "'-1' is not a number"},
    {"ply\nformat ascii 1.0\nelement vertex 3x\n", 3, "'3x' is not a number"},
    {"ply\nformat ascii 1.0\nelement vertex 1e3\n", 3, "'1e3' is not a number"},
    {"ply\nformat ascii 1.0\nelement vertex 2147483648\n", 3,
     "'2147483648' is not a number"},
    {"ply\nformat ascii 1.0\nelement vertex 99999999999999999999\n", 3,
     "'99999999999999999999' is not a number"},
    {"ply\nformat ascii 1.0\nelement a 1\nproperty real x\n", 4,
     "unknown type 'real'; use one of PLY's"},
    {"ply\nformat ascii 1.0\nelement a 1\nproperty\n", 4, "unknown type ''"},
    {"ply\nformat ascii 1.0\nelement a 1\nproperty list uchar\n", 4,
     "unknown type ''"},
    {"ply\nformat ascii 1.0\nelement a 1\nproperty list x int a\n", 4,
     "unknown type 'x'"},
    {"ply\nformat ascii 1.0\nproperty float x\n", 3,
     "a property before all elements; write an element line first"},
    {"ply\nformat ascii 1.0\n" VERTICES VERTICES, 7,
     "a second element vertex; declare it once"},
    {"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
     "property float z\nend_header\n0 0\n",
     3, "the vertices have no x or no y; declare the properties"},
    {"ply\nformat ascii 1.0\nelement vertex 3\nproperty list uchar float x\n"
     "property float y\nend_header\n0 0\n",
     3, "the vertices have no x or no y"},
    {"ply\nformat ascii 1.0\n" VERTICES
     "element face 1\nproperty int vertex_indices\nend_header\n" THREE
     "3 0 1 2\n",
     7, "the faces have no corners; declare the property list"},
    {"ply\nformat ascii 1.0\n" VERTICES
     "element edge 1\nproperty int vertex1\nend_header\n" THREE "0 1\n",
     7, "the edges have no ends; declare the properties int vertex1"},
    {"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
     "property float y\n" FACES "end_header\n0 0\n1 0\n0 1\n3 0 1 2\n",
     3,
     "vertices without z; the vertices of triangles must have three "
     "coordinates"},
    {"ply\nformat binary_little_endian 1.0\nelement vertex 3\n"
     "property float x\nproperty float y\nproperty list int int z\n" FACES
     "end_header\n",
     3, "vertices without z"},
};

START_TEST(bad_headers_are_refused)
{
    expect_bad_mesh(headers[_i].text, headers[_i].line, headers[_i].words);
}
END_TEST

START_TEST(too_many_declarations_are_refused)
{
    char text[4000] = "ply\nformat ascii 1.0\n";
    for (int i = 0; i < 17; i++)
        strcat(text, "element a 0\n");
    expect_bad_mesh(text, 19, "more than 16 elements; delete");
    strcpy(text, "ply\nformat ascii 1.0\nelement a 0\n");
    for (int i = 0; i < 65; i++)
        strcat(text, "property int a\n");
    expect_bad_mesh(text, 68, "more than 64 properties; delete");
}
END_TEST

START_TEST(sixteen_elements_of_sixty_four_properties_are_read)
{
    char text[20000] = "ply\nformat ascii 1.0\n" VERTICES;
    for (int i = 3; i < 64; i++)
        sprintf(text + strlen(text), "property int a%d\n", i);
    strcat(text, FACES);
    for (int i = 2; i < 16; i++)
        strcat(text, "element a 0\n");
    strcat(text, "end_header\n");
    for (int v = 0; v < 3; v++) {
        sprintf(text + strlen(text), "%g %g %g", three[3 * v], three[3 * v + 1],
                three[3 * v + 2]);
        for (int i = 3; i < 64; i++)
            strcat(text, " 7");
        strcat(text, "\n");
    }
    strcat(text, "3 0 1 2\n");
    tf_mesh_file file = good_mesh(text);
    expect_vertices(&file, 3, three);
    tf_mesh_file_free(&file);
}
END_TEST

#define FLAT                                                                   \
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"              \
    "property float y\n"

// Line 5 declares y.
static const struct {
    const char *text;
    long line;
    const char *words;
} doubled[] = {
    {FLAT "property float x\n", 6, "a second property 'x'; declare it once"},
    {FLAT "property \tdouble  y\t\r\n", 6,
     "a second property 'y'; declare it once"},
    {FLAT "property list uchar int x\n", 6,
     "a second property 'x'; declare it once"},
    {FLAT "property uchar red\nproperty list uint int a\n"
          "property list uchar int red\n",
     8, "a second property 'red'; declare it once"},
    {FLAT "property uchar \033[7m\nproperty uchar \033[7m\n", 7,
     "a second property '?[7m'; declare it once"},
    {FLAT FACES "property list uchar int vertex_indices\n", 8,
     "a second property 'vertex_indices'; declare it once"},
    {FLAT FACES "property list uchar uint vertex_index\n", 8,
     "a second list of corners, 'vertex_index'; declare one"},
    {FLAT "element edge 1\nproperty int vertex1\nproperty uint vertex1\n", 8,
     "a second property 'vertex1'; declare it once"},
    {FLAT "element vertex 3\n", 6, "a second element vertex; declare it once"},
    {FLAT FACES "element face 1\n", 8,
     "a second element face; declare it once"},
    {FLAT "element edge 1\nelement edge 1\n", 7,
     "a second element edge; declare it once"},
};

START_TEST(doubled_declarations_are_refused)
{
    for (int kept = 0; kept < 2; kept++) {
        tf_columns columns;
        read_columns(kept ? &columns : NULL);
        tf_mesh_file file;
        ck_assert(
            !parse_mesh(&file, doubled[_i].text, strlen(doubled[_i].text)));
        ck_assert_str_eq(file.fault->text, doubled[_i].words);
        ck_assert_int_eq(file.fault->place, doubled[_i].line);
        if (kept)
            tf_columns_free(&columns);
        tf_mesh_file_free(&file);
    }
    read_columns(NULL);
}
END_TEST

// In another letter case, cut short or made longer, in another element or in
// one that is skipped.
START_TEST(names_that_differ_are_accepted)
{
    tf_mesh_file file = good_mesh(
        "ply\nformat ascii 1.0\nelement camera 1\nproperty float x\n"
        "property float x\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float X\nproperty float xx\n"
        "property float z\nproperty float\nelement face 1\n"
        "property list uchar int vertex_indices\nproperty float x\n"
        "property list uchar int vertex\nproperty int vertex_index\n"
        "element none 0\nelement none 0\nend_header\n7 8\n0 0 9 9 0 9\n"
        "1 0 9 9 0 9\n0 1 9 9 0 9\n3 0 1 2 9 0 9\n");
    expect_vertices(&file, 3, three);
    expect_triangles(&file, 1, first_three);
    tf_mesh_file_free(&file);
}
END_TEST

// Faults of what follows, as text ---------------------------------------------

static const struct {
    const char *rows;
    long line;
    const char *words;
} texts[] = {
    {"", 10, "the file ends too early; it may be cut short, or the header"},
    {"0 0 0\n1 0", 11, "the file ends too early"},
    {THREE, 13, "the file ends too early"},
    {THREE "3 0 1", 13, "the file ends too early"},
    {THREE "3", 13, "the file ends too early"},
    {"0 0\n1 0 0\n", 10,
     "the line ends too early; it must have all that the header"},
    {THREE "3 0 1\n", 13, "the line ends too early"},
    {"0 0 0 0\n", 10, "'0' is more than the header declares"},
    {THREE "3 0 1 2 2\n", 13, "'2' is more than the header declares"},
    {THREE "3 0 1 2\n3 0 1 2\n", 14,
     "more follows than the header declares; correct"},
    {THREE "0 0 1\n3 0 1 2\n", 13,
     "a face with 0 corners; each must have three"},
    {"0 0 nan\n", 10, "'nan' is not a finite number; write a decimal"},
    {"0 0 0\n0 inf 0\n", 11, "'inf' is not a finite number"},
    {"0 0 0\n0 1e999 0\n", 11, "'1e999' is beyond the largest double; scale"},
    {"0 0 0\n0 x 0\n", 11, "'x' is not a finite number"},
    {"0 0 0\n0 1,5 0\n", 11,
     "'1,5' is not a finite number; write a point in place of the comma"},
    {"0 0 0\n0 1.5.5 0\n", 11, "'1.5.5' is not a finite number"},
    {THREE "4 0 1 2 0\n", 13, "vertex 0 is a corner twice; divide the face"},
    {THREE "4 0 1 2 3\n", 13,
     "there is no vertex 3; they are numbered from 0 to 2"},
    {THREE "4 0 1 2\n", 13, "the line ends too early; it must have all"},
    {THREE "2 0 1\n", 13, "a face with 2 corners; each must have three"},
    {THREE "-3 0 1 2\n", 13,
     "-3 is not an index or a length; write an integer from 0"},
    {THREE "3.5 0 1 2\n", 13, "3.5 is not an index or a length"},
    {THREE "3 0 1 -2\n", 13, "-2 is not an index or a length"},
    {THREE "3 0 1 1.5\n", 13, "1.5 is not an index or a length"},
    {THREE "3 0 1 2147483648\n", 13, "2147483648 is not an index or a length"},
    {THREE "3 0 1 1e30\n", 13, "1e+30 is not an index"},
    {THREE "3 0 1 two\n", 13, "'two' is not a finite number"},
    {THREE "3 0 1 2;\n", 13, "'2;' is not a finite number"},
    {THREE "three 0 1 2\n", 13, "'three' is not a finite number"},
};

START_TEST(bad_texts_are_refused)
{
    char text[500];
    snprintf(text, sizeof text, HEADER "%s", texts[_i].rows);
    expect_bad_mesh(text, texts[_i].line, texts[_i].words);
}
END_TEST

START_TEST(wrong_counts_are_refused)
{
    static const struct {
        const char *vertices;
        long line;
        const char *words;
    } counts[] = {
        {"4", 13, "'2' is more than the header declares for an element"},
        {"2147483647", 13, "'2' is more than the header declares"},
        {"2", 12, "a face with 0 corners"},
        {"0", 10, "a face with 0 corners"},
    };
    for (int i = 0; i < 4; i++) {
        char text[500];
        snprintf(text, sizeof text,
                 "ply\nformat ascii 1.0\nelement vertex %s\n"
                 "property float x\nproperty float y\nproperty float z\n" FACES
                 "end_header\n" THREE "3 0 1 2\n",
                 counts[i].vertices);
        expect_bad_mesh(text, counts[i].line, counts[i].words);
    }
}
END_TEST

START_TEST(nul_bytes_are_refused)
{
    static const char text[] = HEADER THREE "3 0 1 2\n";
    size_t header = strlen(HEADER);
    for (size_t at = 4; at < sizeof text - 1; at++) {
        char broken[sizeof text];
        memcpy(broken, text, sizeof text);
        broken[at] = '\0';
        tf_mesh_file file;
        bool good = parse_mesh(&file, broken, sizeof text - 1);
        ck_assert_msg(!good || at < header, "byte %zu", at);
        ck_assert_msg(good || strstr(file.fault->text, "; "), "%s",
                      file.fault->text);
        tf_mesh_file_free(&file);
    }
    expect_bad_bytes(HEADER "0 0 0\n1 0 0\0\n", strlen(HEADER) + 13, 11,
                     "a NUL byte; the file must be plain text");
}
END_TEST

// Faults of what follows, in binary -------------------------------------------

START_TEST(files_cut_short_at_any_byte_are_refused)
{
    bytes made = _i < 2 ? binary_triangle(_i) : binary_more(_i - 2);
    size_t header = (size_t)(strstr(made.at, "end_header\n") - made.at) + 11;
    for (size_t size = 4; size < made.count; size++) {
        tf_mesh_file file;
        ck_assert_msg(!parse_mesh(&file, made.at, size), "%zu bytes", size);
        ck_assert_msg(strstr(file.fault->text, "; "), "%s", file.fault->text);
        ck_assert(file.counts_bytes == (size >= header));
        if (size >= header) {
            ck_assert_msg(strstr(file.fault->text, "the file ends too early"),
                          "%zu: %s", size, file.fault->text);
            ck_assert_int_ge(file.fault->place, (long)size - 7);
            ck_assert_int_le(file.fault->place, (long)size);
        }
        tf_mesh_file_free(&file);
    }
}
END_TEST

START_TEST(bytes_to_spare_are_refused)
{
    bytes made = binary_triangle(_i);
    put_int(&made, 1, 0);
    expect_bad_bytes(made.at, made.count, (long)made.count - 1,
                     "more follows than the header declares; correct");
}
END_TEST

START_TEST(bad_numbers_in_binary_are_refused)
{
    bytes made = binary(_i, VERTICES FACES);
    bytes rows = made;
    put_double(&rows, 1);
    put_double(&rows, NAN);
    put_double(&rows, 1);
    expect_bad_bytes(rows.at, rows.count, (long)made.count + 8,
                     "a coordinate is infinite or NaN; write");
    rows = made;
    put_double(&rows, -INFINITY);
    expect_bad_bytes(rows.at, rows.count, (long)made.count,
                     "a coordinate is infinite or NaN");
    rows = binary_triangle(_i);
    rows.count -= 4;
    put_int(&rows, 4, -2);
    expect_bad_bytes(rows.at, rows.count, (long)rows.count - 4,
                     "-2 is not an index or a length");
    rows.count -= 13;
    put_int(&rows, 1, 4);
    for (int i = 0; i < 4; i++)
        put_int(&rows, 4, i);
    expect_bad_bytes(rows.at, rows.count, (long)rows.count - 17,
                     "there is no vertex 3; they are numbered from 0 to 2");
}
END_TEST

START_TEST(counts_that_no_file_has_are_refused)
{
    // Neither memory nor time is spent on what is declared alone.
    bytes made =
        binary(_i, "element a 2147483647\nproperty list uint double b\n"
                   "element vertex 2147483647\nproperty char x\n"
                   "property char y\n");
    bytes rows = made;
    put_int(&rows, 4, INT32_MAX);
    put_double(&rows, 1);
    expect_bad_bytes(rows.at, rows.count, (long)rows.count,
                     "the file ends too early; it may be cut short");
    rows = made;
    put_int(&rows, 4, UINT32_MAX);
    expect_bad_bytes(rows.at, rows.count, (long)made.count,
                     "4294967295 is not an index or a length");
}
END_TEST

// Columns ---------------------------------------------------------------------

#define MANY                                                                   \
    "element vertex 2\nproperty uint8 red\nproperty float x\n"                 \
    "property double y\nproperty list uchar short skipped\n"                   \
    "property short label\nproperty float z\nproperty float32 quality\n"       \
    "property double s\n"                                                      \
    "element face 0\nproperty list uchar int vertex_indices\n"                 \
    "property uchar flags\nelement edge 1\nproperty int vertex1\n"             \
    "property int vertex2\nproperty int weight\n"

static void expect_column(const tf_columns *columns, int i, const char *name,
                          tf_number_type type, int after)
{
    ck_assert_str_eq(columns->column[i].name, name);
    ck_assert_int_eq(columns->column[i].type, type);
    ck_assert_int_eq(columns->column[i].after, after);
}

static void expect_many(const tf_columns *columns, const double first[4],
                        const double second[4])
{
    ck_assert_int_eq(columns->count, 4);
    expect_column(columns, 0, "red", TF_UCHAR, 0);
    expect_column(columns, 1, "label", TF_SHORT, 2);
    expect_column(columns, 2, "quality", TF_FLOAT, 3);
    expect_column(columns, 3, "s", TF_DOUBLE, 3);
    ck_assert_uint_eq(columns->rows, 2);
    ck_assert_mem_eq(tf_columns_row(columns, 0), first, 32);
    ck_assert_mem_eq(tf_columns_row(columns, 1), second, 32);
}

START_TEST(columns_are_read_as_text)
{
    static const double first[] = {255, -7, 0.1, 1e300};
    static const double second[] = {0, 32767, 3, 0.5};
    static const double places[] = {1, 2, 3, 4, 5, 6};
    tf_columns columns;
    read_columns(&columns);
    tf_mesh_file file = good_mesh("ply\nformat ascii 1.0\n" MANY "end_header\n"
                                  "255 1 2 2 8 9 -7 3 0.1 1e300\n"
                                  "0 4 5 0 32767 6 3 0x1p-1\n0 1 5\n");
    expect_many(&columns, first, second);
    expect_vertices(&file, 2, places);
    tf_columns_free(&columns);
    tf_mesh_file_free(&file);
    read_columns(NULL);
}
END_TEST

START_TEST(columns_are_read_in_binary)
{
    static const double first[] = {255, -7, 0.5, 0.1};
    static const double second[] = {128, -32768, -2, NAN};
    bytes made = binary(_i, MANY);
    tf_columns columns;
    read_columns(&columns);
    for (int v = 0; v < 2; v++) {
        const double *row = v ? second : first;
        put_int(&made, 1, (int64_t)row[0]);
        put_float(&made, 1);
        put_double(&made, 2);
        put_int(&made, 1, 1);
        put_int(&made, 2, 5);
        put_int(&made, 2, (int64_t)row[1]);
        put_float(&made, 3);
        put_float(&made, (float)row[2]);
        put_double(&made, row[3]);
    }
    for (int i = 0; i < 3; i++)
        put_int(&made, 4, i);
    tf_mesh_file file = good_bytes(made.at, made.count);
    expect_many(&columns, first, second);
    tf_columns_free(&columns);
    tf_mesh_file_free(&file);
    read_columns(NULL);
}
END_TEST

// They were no fault before anyone wanted to keep them.
START_TEST(words_that_are_no_numbers_are_kept_as_none)
{
    tf_columns columns;
    read_columns(&columns);
    tf_mesh_file file = good_mesh(
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
        "property float y\nproperty float q\nproperty uchar r\nelement edge 1\n"
        "property int vertex1\nproperty int vertex2\nend_header\n0 0 nan 7x\n"
        "1 1 -inf 8\n0 1\n");
    for (int i = 0; i < 3; i++)
        ck_assert(isnan(columns.value[i]));
    ck_assert_double_eq(columns.value[3], 8);
    tf_columns_free(&columns);
    tf_mesh_file_free(&file);
    read_columns(NULL);
}
END_TEST

#define LETTERS "abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyz"

START_TEST(names_are_kept_to_a_limit)
{
    static const char *const text =
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty  float \t" LETTERS
        "012345678-%s\r\nproperty float x\nproperty float y\nend_header\n";
    tf_columns columns;
    char made[500];
    read_columns(&columns);
    sprintf(made, text, "1");
    tf_mesh_file file;
    parse_mesh(&file, made, strlen(made));
    ck_assert_int_eq(columns.count, 1);
    ck_assert_str_eq(columns.column[0].name, LETTERS "012345678-1");
    tf_mesh_file_free(&file);
    read_columns(&columns);
    sprintf(made, text, "12");
    expect_bad_mesh(made, 4, "the name of a property has 64 bytes; shorten it");
    read_columns(NULL);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("formats/ply_file");
    TCase *good = tcase_create("good files");
    tcase_add_test(good, a_file_is_ply_by_its_first_line);
    tcase_add_test(good, a_triangle_is_read_as_text);
    tcase_add_loop_test(good, faces_have_any_number_of_corners, 0, 2);
    tcase_add_test(good, strips_are_triangles_of_one_side);
    tcase_add_loop_test(good, strips_are_read_in_binary, 0, 2);
    tcase_add_loop_test(good, a_triangle_is_read_in_binary, 0, 2);
    tcase_add_test(good, random_doubles_come_back_to_the_last_bit);
    tcase_add_test(good, random_floats_come_back_to_the_last_bit);
    tcase_add_test(good, all_types_of_integers_are_read);
    tcase_add_test(good, edges_are_read);
    tcase_add_test(good, what_is_unknown_is_skipped_as_text);
    tcase_add_loop_test(good, what_is_unknown_is_skipped_in_binary, 0, 2);
    tcase_add_test(good, windows_text_is_read);
    tcase_add_test(good, a_windows_header_of_binary_is_read);
    tcase_add_test(good, blanks_and_blank_lines_are_skipped);
    tcase_add_test(good, faces_may_precede_vertices);
    suite_add_tcase(suite, good);

    TCase *header = tcase_create("faults of the header");
    tcase_add_loop_test(header, bad_headers_are_refused, 0,
                        sizeof headers / sizeof *headers);
    tcase_add_test(header, too_many_declarations_are_refused);
    tcase_add_loop_test(header, doubled_declarations_are_refused, 0,
                        sizeof doubled / sizeof *doubled);
    tcase_add_test(header, names_that_differ_are_accepted);
    tcase_add_test(header, sixteen_elements_of_sixty_four_properties_are_read);
    suite_add_tcase(suite, header);

    TCase *text = tcase_create("faults of text");
    tcase_add_loop_test(text, bad_texts_are_refused, 0,
                        sizeof texts / sizeof *texts);
    tcase_add_test(text, wrong_counts_are_refused);
    tcase_add_test(text, nul_bytes_are_refused);
    suite_add_tcase(suite, text);

    TCase *cut = tcase_create("faults of binary");
    tcase_add_loop_test(cut, files_cut_short_at_any_byte_are_refused, 0, 4);
    tcase_add_loop_test(cut, bytes_to_spare_are_refused, 0, 2);
    tcase_add_loop_test(cut, bad_numbers_in_binary_are_refused, 0, 2);
    tcase_add_loop_test(cut, counts_that_no_file_has_are_refused, 0, 2);
    suite_add_tcase(suite, cut);
    TCase *kept = tcase_create("columns");
    tcase_add_test(kept, columns_are_read_as_text);
    tcase_add_loop_test(kept, columns_are_read_in_binary, 0, 2);
    tcase_add_test(kept, words_that_are_no_numbers_are_kept_as_none);
    tcase_add_test(kept, names_are_kept_to_a_limit);
    suite_add_tcase(suite, kept);
    return suite;
}

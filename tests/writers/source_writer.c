// A file that is written again with other coordinates.

#define _GNU_SOURCE // open_memstream

#include "writers/source_writer.h"

#include "formats/mesh_reader.h"
#include "support/matrices.h"
#include "support/program.h"
#include "support/support.h"
#include "writers/encoder.h"

#include <stdlib.h>
#include <string.h>

static tf_fault fault;
static tf_mesh_file file;
static tf_source source;

/// Reads bytes as a file with its source.
static void read_bytes(const void *bytes, size_t size)
{
    fault = (tf_fault){0};
    source = (tf_source){0};
    make_binary_file("in", bytes, size);
    ck_assert_msg(tf_mesh_file_read_all(&file, "in", NULL, &source, &fault),
                  "%ld: %s", fault.place, fault.text);
}

static void read_text(const char *text)
{
    read_bytes(text, strlen(text));
}

static void free_file(void)
{
    tf_mesh_file_free(&file);
    tf_source_free(&source);
}

/// What is written of the file now; to be freed.
static char *written(size_t *size)
{
    char *text = NULL;
    FILE *stream = open_memstream(&text, size);
    tf_source_write(stream, &file, file.position.item);
    ck_assert_int_eq(fclose(stream), 0);
    return text;
}

static void expect_written(const void *bytes, size_t size)
{
    size_t found;
    char *text = written(&found);
    ck_assert_msg(found == size && memcmp(text, bytes, size) == 0,
                  "wanted:\n%.*s\ngot:\n%.*s", (int)size, (const char *)bytes,
                  (int)found, text);
    free(text);
}

static void expect_text(const char *text)
{
    expect_written(text, strlen(text));
}

static void set(int vertex, int axis, double x)
{
    file.position.item[3 * vertex + axis] = x;
}

// OBJ ---------------------------------------------------------------------------

#define OBJ_OF(first, second)                                                  \
    "\xEF\xBB\xBF# by hand\r\nmtllib a.mtl\no body\n\n  v\t" first             \
    " 0x1.8p1 -0 1 0 0\r\n"                                                    \
    "v 1e0 .5 \\\n +3 1\nvn 0 0 1\nvt 0 1\nv " second                          \
    " 0 1#last\nv 7 8 9\nusemtl red\ng under arms\ns 1\nf 1/1/1 2/1 3//1 4\n"  \
    "unknown word\nf -1 -2 -3\nl 1 2 3\nend"

START_TEST(an_unchanged_obj_is_the_same_bytes)
{
    read_text(OBJ_OF("0.10", "00.1"));
    expect_text(OBJ_OF("0.10", "00.1"));
    free_file();
}
END_TEST

START_TEST(changed_coordinates_of_obj_are_replaced)
{
    read_text(OBJ_OF("0.10", "00.1"));
    set(0, 0, 1.0 / 3);
    set(2, 0, -1e300);
    expect_text(OBJ_OF("0.3333333333333333", "-1e+300"));
    free_file();
}
END_TEST

START_TEST(a_z_that_is_missing_in_obj_is_added_where_it_is_not_0)
{
    read_text("v 1 2\nv 3 4#x\nv 5 6 \\\n\nv 7 8 9\nl 1 2 3 4\n");
    set(1, 2, 0.5);
    set(2, 2, -0.0);
    expect_text("v 1 2\nv 3 4 0.5#x\nv 5 6 -0 \\\n\nv 7 8 9\nl 1 2 3 4\n");
    free_file();
}
END_TEST

START_TEST(zeros_of_either_sign_are_told_apart)
{
    read_text("v 0 -0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expect_text("v 0 -0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    set(0, 0, -0.0);
    set(0, 1, 0.0);
    expect_text("v -0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    free_file();
}
END_TEST

// PLY ---------------------------------------------------------------------------

#define PLY_OF(type, x)                                                        \
    "ply\r\nformat ascii 1.0\r\ncomment TextureFile a.png\r\nobj_info x\r\n"   \
    "element material 1\r\nproperty list uchar int vertex_indices\r\n"         \
    "element vertex 4\r\nproperty uchar red\r\nproperty " type " x\r\n"        \
    "property  " type "  z \r\nproperty float nx\r\nproperty " type            \
    " y\r\nelement face 1\r\nproperty uchar label\r\n"                         \
    "property list uchar int vertex_index\r\n"                                 \
    "property list uchar float texcoord\r\n"                                   \
    "element edge 1\r\nproperty int vertex1\r\nproperty int vertex2\r\n"       \
    "property float length\r\nend_header\r\n2 7 8\r\n"                         \
    "255 0.1 1 nan 0 \r\n1 " x " 0 0 .1\r\n\r\n2 0 1 0 0\r\n3  1 1 0 1\r\n"    \
    "9 4 0 1 2 3 2 .5 .5\r\n0 1 1.5\r\n"

START_TEST(an_unchanged_ply_is_the_same_bytes)
{
    read_text(PLY_OF("float32", "1.1"));
    expect_text(PLY_OF("float32", "1.1"));
    free_file();
}
END_TEST

START_TEST(types_of_ply_become_double_if_they_must)
{
    read_text(PLY_OF("float32", "1.1"));
    set(1, 0, 0.75);
    expect_text(PLY_OF("float32", "0.75"));
    set(1, 0, 1.0 / 3);
    expect_text(PLY_OF("double", "0.3333333333333333"));
    free_file();
    read_text(PLY_OF("int16", "1.1"));
    set(1, 0, 77);
    expect_text(PLY_OF("int16", "77"));
    set(1, 0, 40000);
    expect_text(PLY_OF("double", "40000"));
    free_file();
    read_text(PLY_OF("float64", "1.1"));
    set(1, 0, 1.0 / 3);
    expect_text(PLY_OF("float64", "0.3333333333333333"));
    free_file();
}
END_TEST

#define FLAT_OF(z, a, b)                                                       \
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float y\n" z            \
    "property float x\nproperty uchar red\nelement edge 1\n"                   \
    "property int vertex1\nproperty int vertex2\nend_header\n0 " a             \
    "1 255\n2 " b "3 255\n0 1\n"

START_TEST(a_z_that_is_missing_in_ply_is_added)
{
    read_text(FLAT_OF("", "", ""));
    expect_text(FLAT_OF("", "", ""));
    set(1, 2, 0.5);
    size_t size;
    char *text = written(&size);
    ck_assert_str_eq(text,
                     "ply\nformat ascii 1.0\nelement vertex 2\n"
                     "property double y\nproperty double z\n"
                     "property double x\nproperty uchar red\nelement edge 1\n"
                     "property int vertex1\nproperty int vertex2\nend_header\n"
                     "0 0 1 255\n2 0.5 3 255\n0 1\n");
    free(text);
    free_file();
}
END_TEST

// Binary PLY --------------------------------------------------------------------

static const char *const types[] = {"char", "uchar", "short", "ushort",
                                    "int",  "uint",  "float", "double"};

/// A file with two vertices and an edge, in that order of properties.
typedef struct layout {
    bool big, has_z;
    char order[4]; ///< x, y, z
    tf_number_type type[3];
} layout;

/// Writes numbers between others, coordinates in these types.
static char *binary(const layout *how, const tf_number_type type[3], bool has_z,
                    const double x[6], size_t *size)
{
    char *text = NULL;
    FILE *stream = open_memstream(&text, size);
    tf_encoder to = {stream, false, how->big};
    fprintf(stream,
            "ply\nformat binary_%s_endian 1.0\nelement vertex 2\n"
            "property short before\n",
            how->big ? "big" : "little");
    for (int i = 0; i < 3; i++)
        if (how->order[i] != 'z' || has_z)
            fprintf(stream, "property %s %c\n",
                    types[type[how->order[i] - 'x']], how->order[i]);
    fputs("property float after\nelement edge 1\nproperty int vertex1\n"
          "property int vertex2\nend_header\n",
          stream);
    for (int v = 0; v < 2; v++) {
        tf_encode(&to, TF_SHORT, 5);
        for (int i = 0; i < 3; i++)
            if (how->order[i] != 'z' || has_z)
                tf_encode(&to, type[how->order[i] - 'x'],
                          x[3 * v + how->order[i] - 'x']);
        tf_encode(&to, TF_FLOAT, 0.25);
    }
    tf_encode_integer(&to, 0, 4);
    tf_encode_integer(&to, 1, 4);
    fclose(stream);
    return text;
}

static layout any_layout(generator *random)
{
    static const char *const orders[] = {"xyz", "xzy", "yxz",
                                         "yzx", "zxy", "zyx"};
    layout how = {.big = below(random, 2), .has_z = below(random, 4) > 0};
    strcpy(how.order, orders[below(random, 6)]);
    if (!how.has_z) // where it would be added
        strcpy(how.order, below(random, 2) ? "xyz" : "yzx");
    for (int k = 0; k < 3; k++)
        how.type[k] = (tf_number_type)below(random, 8);
    return how;
}

START_TEST(binary_numbers_are_replaced_in_all_types_and_orders)
{
    static const tf_number_type wide[] = {TF_DOUBLE, TF_DOUBLE, TF_DOUBLE};
    generator random = generator_new(5);
    for (long i = 0; i < cases(2000); i++) {
        layout how = any_layout(&random);
        double x[6];
        for (int k = 0; k < 6; k++)
            x[k] = k % 3 == 2 && !how.has_z ? 0 : below(&random, 100);
        size_t size;
        char *before = binary(&how, how.type, how.has_z, x, &size);
        read_bytes(before, size);
        ck_assert_mem_eq(file.position.item, x, sizeof x);
        expect_written(before, size);
        free(before);

        int k = below(&random, 6);
        bool small = below(&random, 2) && (how.has_z || k % 3 < 2);
        x[k] = small ? below(&random, 100) : 1.0 / 3 + below(&random, 5);
        set(k / 3, k % 3, x[k]);
        bool widens = !tf_number_fits(how.type[k % 3], x[k]) ||
                      (k % 3 == 2 && !how.has_z);
        char *after = binary(&how, widens ? wide : how.type,
                             how.has_z || (widens && k % 3 == 2), x, &size);
        expect_written(after, size);
        free(after);
        free_file();
    }
}
END_TEST

// Other formats ------------------------------------------------------------------

#define SOLID_OF(x, y)                                                         \
    "solid by hand\n facet normal 0 0 1\n  outer loop\n   vertex 0 -0 " x      \
    "\n   vertex 1 0 0\n   vertex 0 1.0 0\n  endloop\n endfacet\n"             \
    "facet normal 0 0 1 \nouter loop\n vertex 1 1 " y                          \
    " vertex 0 1 0 vertex 1 0 0 endloop endfacet\nendsolid by hand\n"          \
    "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 " x "\nvertex 1 1 " y   \
    "\nvertex 0 0 " x "\nendloop\nendfacet\nendsolid\n"

START_TEST(each_corner_of_stl_is_replaced)
{
    read_text(SOLID_OF("0", "00"));
    ck_assert_int_eq(tf_mesh_file_vertices(&file), 4);
    expect_text(SOLID_OF("0", "00"));
    set(0, 2, 0.1);
    set(3, 2, -7);
    expect_text(SOLID_OF("0.1", "-7"));
    free_file();
}
END_TEST

/// A binary STL of two triangles; its vertices are at (0 0 x), (1 0 0), (0 1 0),
/// and (1 1 y), some with a negative 0.
static void binary_stl(char bytes[185], double x, double y)
{
    const double corner[] = {0, 0, x, 1, 0, 0,    0, 1,    0,
                             1, 1, y, 0, 1, -0.0, 1, -0.0, 0};
    FILE *stream = fmemopen(bytes, 185, "wb");
    tf_encoder to = {.stream = stream};
    fprintf(stream, "%80s", "colors");
    tf_encode_integer(&to, 2, 4);
    for (int t = 0; t < 2; t++) {
        for (int k = 0; k < 3; k++)
            tf_encode(&to, TF_FLOAT, 0.5);
        for (int k = 0; k < 9; k++)
            tf_encode(&to, TF_FLOAT, corner[9 * t + k]);
        tf_encode_integer(&to, 0x801f, 2);
    }
    ck_assert_int_eq(ftell(stream), 184);
    fclose(stream);
}

START_TEST(floats_of_binary_stl_are_replaced)
{
    char before[185], after[185];
    binary_stl(before, 0, 0);
    read_bytes(before, 184);
    ck_assert_int_eq(tf_mesh_file_vertices(&file), 4);
    expect_written(before, 184);
    set(0, 2, 0.5);
    set(3, 2, 0.1); // which is rounded
    binary_stl(after, 0.5, 0.1);
    expect_written(after, 184);
    free_file();
}
END_TEST

#define OFF_OF(x)                                                              \
    "# head\nCOFF # colors\n4 2 0\n\n0 0 " x                                   \
    " 255 0 0 255\n1 0 0 1 1 1 1 # b\n"                                        \
    "1 1 0 0 0 0 0\n0 1 0 0 0 0 0\n4 0 1 2 3 255 255 0\n3 0 1 2\n"

START_TEST(vertices_of_off_are_replaced)
{
    read_text(OFF_OF("0.0"));
    expect_text(OFF_OF("0.0"));
    set(0, 2, 0.1);
    expect_text(OFF_OF("0.1"));
    free_file();
}
END_TEST

#define MSH_OF(x)                                                              \
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"skin\"\n"  \
    "$EndPhysicalNames\n$Nodes\n3\n70 0 0 " x                                  \
    "\n5 1 0 0\n6 0 1 0\n$EndNodes\n"                                          \
    "$Elements\n2\n1 15 2 0 1 5\n2 2 2 1 1 70 5 6\n$EndElements\n"

#define MSH4_OF(x)                                                             \
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 3 1 3\n2 1 1 "            \
    "3\n1\n2\n3\n"                                                             \
    "0 0 " x " .5 .5\n1 0 0 .5 .5\n0 1 0 .5 .5\n$EndNodes\n$Elements\n"        \
    "1 1 1 1\n2 1 2 1\n1 1 2 3\n$EndElements\n"

START_TEST(nodes_of_gmsh_are_replaced)
{
    read_text(MSH_OF("0.0"));
    expect_text(MSH_OF("0.0"));
    set(0, 2, 0.1);
    expect_text(MSH_OF("0.1"));
    free_file();
    read_text(MSH4_OF("0.0"));
    expect_text(MSH4_OF("0.0"));
    set(0, 2, 0.1);
    expect_text(MSH4_OF("0.1"));
    free_file();
}
END_TEST

/// Gmsh's binary format of version 2.
static char *binary_msh(bool big, double x, size_t *size)
{
    static const int element[] = {2, 1, 2, 1, 0, 0, 1, 2, 3};
    char *bytes = NULL;
    FILE *stream = open_memstream(&bytes, size);
    tf_encoder to = {stream, false, big};
    fputs("$MeshFormat\n2.2 1 8\n", stream);
    tf_encode_integer(&to, 1, 4);
    fputs("\n$EndMeshFormat\n$Nodes\n3\n", stream);
    for (int i = 0; i < 3; i++) {
        tf_encode_integer(&to, i + 1, 4);
        tf_encode_double(&to, i == 1 ? x : 0);
        tf_encode_double(&to, i == 2);
        tf_encode_double(&to, 0);
    }
    fputs("\n$EndNodes\n$Elements\n1\n", stream);
    for (int i = 0; i < 9; i++)
        tf_encode_integer(&to, element[i], 4);
    fputs("\n$EndElements\n", stream);
    fclose(stream);
    return bytes;
}

START_TEST(binary_nodes_of_gmsh_are_replaced)
{
    for (int big = 0; big < 2; big++) {
        size_t before_size, size;
        char *before = binary_msh(big, 1, &before_size);
        char *after = binary_msh(big, 0.1, &size);
        read_bytes(before, before_size);
        expect_written(before, before_size);
        set(1, 0, 0.1);
        expect_written(after, size);
        free(before);
        free(after);
        free_file();
    }
}
END_TEST

START_TEST(lines_of_old_macs_keep_their_ends)
{
    read_text("# a\rv 0 0 0\rv 1 0 0\r\rv 0 1 0\rf 1 2 3\r");
    expect_text("# a\rv 0 0 0\rv 1 0 0\r\rv 0 1 0\rf 1 2 3\r");
    set(1, 0, 0.5);
    expect_text("# a\rv 0 0 0\rv 0.5 0 0\r\rv 0 1 0\rf 1 2 3\r");
    free_file();
    read_text("ply\rformat ascii 1.0\relement vertex 2\rproperty float x\r"
              "property float y\relement edge 1\rproperty int vertex1\r"
              "property int vertex2\rend_header\r0 0\r1 1\r0 1\r");
    set(1, 2, 2);
    expect_text("ply\rformat ascii 1.0\relement vertex 2\r"
                "property double x\rproperty double y\rproperty double z\r"
                "element edge 1\rproperty int vertex1\rproperty int vertex2\r"
                "end_header\r0 0 0\r1 1 2\r0 1\r");
    free_file();
}
END_TEST

START_TEST(compressed_files_are_written_decompressed)
{
    make_file("plain", OFF_OF("0.0"));
    expect(run("gzip -c plain >packed"), 0, "", "");
    source = (tf_source){0};
    ck_assert(tf_mesh_file_read_all(&file, "packed", NULL, &source, &fault));
    expect_text(OFF_OF("0.0"));
    free_file();
}
END_TEST

// Anything ----------------------------------------------------------------------

/// A mesh in a random format with things between.
static char *any_file(generator *random, int vertices, bool ply)
{
    static const char *const blanks[] = {" ", "  ", "\t", " \t "};
    static const char *const spellings[] = {"%g", "%.17g", "%a", "%e", "%.3f"};
    char *text = NULL;
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    if (ply)
        fprintf(stream,
                "ply\nformat ascii 1.0\ncomment c\nelement vertex %d\nproperty "
                "float q\nproperty float x\nproperty float y\nproperty double "
                "z\nelement face 1\nproperty list int int vertex_index\n"
                "end_header\n",
                vertices);
    for (int v = 0; v < vertices; v++) {
        if (!ply && below(random, 5) == 0)
            fprintf(stream, "vt 0.5 %d\n\n#v 1 2 3\n", v);
        fputs(ply ? "7" : "v", stream);
        for (int k = 0; k < 3; k++) {
            fputs(blanks[below(random, 4)], stream);
            fprintf(stream, spellings[below(random, 5)],
                    uniform(random, -10, 10));
        }
        fputs(below(random, 2) ? " \r\n" : "\n", stream);
    }
    fputs(ply ? "3 0 1 2\n" : "f 1 2 3\n", stream);
    fclose(stream);
    return text;
}

/// Reads a text without its source.
static tf_mesh_file reread(const char *text, size_t size)
{
    tf_mesh_file mesh;
    make_binary_file("out", text, size);
    ck_assert_msg(tf_mesh_file_read(&mesh, "out", NULL, &fault), "%s",
                  fault.text);
    return mesh;
}

START_TEST(what_is_written_is_read_as_the_new_doubles_and_nothing_else)
{
    generator random = generator_new(6);
    for (long i = 0; i < cases(500); i++) {
        int vertices = 3 + below(&random, 20);
        char *before = any_file(&random, vertices, i % 2);
        read_text(before);
        for (int j = 0; j < below(&random, 3 * vertices); j++)
            file.position.item[below(&random, 3 * vertices)] =
                any_double(&random);
        size_t size, again;
        char *after = written(&size);
        tf_mesh_file mesh = reread(after, size);
        ck_assert_mem_eq(mesh.position.item, file.position.item,
                         sizeof(double) * (size_t)(3 * vertices));
        tf_mesh_file old = reread(before, strlen(before));
        tf_doubles changed = file.position;
        file.position = old.position; // back again
        char *back = written(&again);
        ck_assert_str_eq(back, before);
        file.position = changed;
        free(before);
        free(after);
        free(back);
        tf_mesh_file_free(&mesh);
        tf_mesh_file_free(&old);
        free_file();
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("writers/source_writer");
    TCase *tcase = tcase_create("sources");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_test(tcase, an_unchanged_obj_is_the_same_bytes);
    tcase_add_test(tcase, changed_coordinates_of_obj_are_replaced);
    tcase_add_test(tcase,
                   a_z_that_is_missing_in_obj_is_added_where_it_is_not_0);
    tcase_add_test(tcase, zeros_of_either_sign_are_told_apart);
    tcase_add_test(tcase, an_unchanged_ply_is_the_same_bytes);
    tcase_add_test(tcase, types_of_ply_become_double_if_they_must);
    tcase_add_test(tcase, a_z_that_is_missing_in_ply_is_added);
    tcase_add_test(tcase, binary_numbers_are_replaced_in_all_types_and_orders);
    tcase_add_test(tcase,
                   what_is_written_is_read_as_the_new_doubles_and_nothing_else);
    tcase_add_test(tcase, each_corner_of_stl_is_replaced);
    tcase_add_test(tcase, floats_of_binary_stl_are_replaced);
    tcase_add_test(tcase, vertices_of_off_are_replaced);
    tcase_add_test(tcase, nodes_of_gmsh_are_replaced);
    tcase_add_test(tcase, binary_nodes_of_gmsh_are_replaced);
    tcase_add_test(tcase, lines_of_old_macs_keep_their_ends);
    tcase_add_test(tcase, compressed_files_are_written_decompressed);
    suite_add_tcase(suite, tcase);
    return suite;
}

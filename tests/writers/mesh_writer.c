#define _GNU_SOURCE // open_memstream

#include "writers/mesh_writer.h"

#include "support/generator.h"
#include "support/matrices.h"
#include "support/meshes.h"
#include "support/support.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const tf_mesh_format formats[] = {
    TF_OBJ, TF_PLY_TEXT, TF_PLY_LITTLE_ENDIAN, TF_PLY_BIG_ENDIAN, TF_OFF};

enum {
    PLY_FORMATS = 4,
    FORMATS = 5 // of these, OFF has no edges
};

/// Writes a mesh and reads it again.
static tf_mesh_file rewritten(const tf_mesh_file *mesh, tf_mesh_format format)
{
    char *text = NULL;
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    ck_assert_ptr_nonnull(stream);
    tf_mesh_content content = content_of(mesh);
    content.from = mesh;
    tf_mesh_write(stream, &content, format);
    ck_assert_int_eq(fclose(stream), 0);
    tf_mesh_file read = good_bytes(text, size);
    ck_assert_int_eq(read.format, format);
    free(text);
    return read;
}

static void expect_same_ints(const tf_ints *a, const tf_ints *b)
{
    ck_assert_uint_eq(a->count, b->count);
    for (size_t i = 0; i < a->count; i++)
        ck_assert_int_eq(a->item[i], b->item[i]);
}

/// Expects that a mesh is written, in each format, as what is read again.
static void expect_rewritten(const tf_mesh_file *mesh)
{
    int count = tf_mesh_file_triangles(mesh) > 0 ? FORMATS : PLY_FORMATS;
    for (int f = 0; f < count; f++) {
        tf_mesh_file read = rewritten(mesh, formats[f]);
        expect_vertices(&read, tf_mesh_file_vertices(mesh),
                        mesh->position.item);
        expect_same_ints(&mesh->triangle, &read.triangle);
        expect_same_ints(&mesh->polygon, &read.polygon);
        expect_same_ints(&mesh->corner, &read.corner);
        if (formats[f] == TF_OFF)
            ck_assert_int_eq(tf_mesh_file_edges(&read), 0);
        else
            expect_same_ints(&mesh->edge, &read.edge);
        tf_mesh_file_free(&read);
    }
}

START_TEST(a_mesh_of_all_elements_comes_back)
{
    tf_mesh_file mesh = good_mesh(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 7 7 7\nl 4 1 2\nf 3 1 2\nf 2 1 4\nl 3 4\n"
        "v 5 5 5\n");
    expect_rewritten(&mesh);
    tf_mesh_file_free(&mesh);
}
END_TEST

START_TEST(meshes_of_one_element_come_back)
{
    tf_mesh_file mesh = good_mesh("v 0 0 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expect_rewritten(&mesh);
    tf_mesh_file_free(&mesh);
    mesh = good_mesh("v 0 0 1\nv 1 0 0\nl 2 1\n");
    expect_rewritten(&mesh);
    tf_mesh_file_free(&mesh);
}
END_TEST

START_TEST(a_curve_of_the_plane_comes_back)
{
    tf_mesh_file mesh = good_mesh("v 0 0.1\nv 1 0\nv 0 1\nl 1 2 3 1\n");
    expect_rewritten(&mesh);
    for (int f = 0; f < PLY_FORMATS; f++) {
        tf_mesh_file read = rewritten(&mesh, formats[f]);
        ck_assert(tf_mesh_file_is_flat(&read));
        tf_mesh_file_free(&read);
    }
    tf_mesh_file_free(&mesh);
}
END_TEST

START_TEST(polygons_come_back)
{
    tf_mesh_file mesh = good_mesh(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.4 0.3 0\nv 7 7 7\n"
        "f 1 2 3 4\nf 6 1 2\nf 4 3 5 2 1\nf 3 4 5\nf 2 3 4 5\nl 1 6\n");
    expect_rewritten(&mesh);
    tf_mesh_file_free(&mesh);
}
END_TEST

/// A mesh whose vertices are in the order in which triangles have them.
static tf_mesh_file any_mesh(generator *random, int vertices, bool floats)
{
    tf_mesh_file mesh = empty_mesh("mesh");
    for (int v = 0; v < vertices; v++) {
        double x[3] = {v, 0, 0};
        for (int k = 1; k < 3; k++)
            x[k] = floats ? (double)(float)uniform(random, -1, 1)
                          : uniform(random, -1, 1);
        ck_assert(tf_mesh_file_add_vertex(&mesh, x, 0));
    }
    for (int v = 2; v < vertices; v++) {
        int corner[] = {v - 2, v - 1, v};
        ck_assert(tf_mesh_file_add_triangle(&mesh, corner, 0));
    }
    return mesh;
}

// The triangles come back, and floats, of which doubles are rounded.
START_TEST(floats_come_back_from_stl)
{
    generator random = generator_new(2);
    for (int floats = 0; floats < 2; floats++) {
        tf_mesh_file mesh = any_mesh(&random, 1000, floats);
        tf_mesh_file read = rewritten(&mesh, TF_STL_BINARY);
        for (size_t i = 0; i < mesh.position.count; i++)
            mesh.position.item[i] = (double)(float)mesh.position.item[i];
        expect_vertices(&read, 1000, mesh.position.item);
        expect_same_ints(&mesh.triangle, &read.triangle);
        tf_mesh_file_free(&read);
        tf_mesh_file_free(&mesh);
    }
}
END_TEST

START_TEST(doubles_of_any_size_come_back)
{
    static const double extremes[] = {0.0,
                                      -0.0,
                                      0.1,
                                      1.0 / 3,
                                      DBL_MAX,
                                      -DBL_MAX,
                                      DBL_MIN,
                                      -DBL_MIN,
                                      0x1p-1074,
                                      -0x1p-1074,
                                      0x1.fffffffffffffp-1,
                                      1 + 0x1p-52};
    enum {
        EXTREMES = sizeof extremes / sizeof *extremes,
        COUNT = 3000
    };
    generator random = generator_new(1);
    tf_mesh_file mesh = empty_mesh("mesh");
    for (int v = 0; v < COUNT; v++) {
        double x[3];
        for (int k = 0; k < 3; k++)
            x[k] = 3 * v + k < EXTREMES ? extremes[3 * v + k]
                                        : any_double(&random);
        ck_assert(tf_mesh_file_add_vertex(&mesh, x, 0));
    }
    int corner[3] = {COUNT - 1, 0, 300};
    ck_assert(tf_mesh_file_add_triangle(&mesh, corner, 0));
    expect_rewritten(&mesh);
    tf_mesh_file_free(&mesh);
}
END_TEST

START_TEST(each_format_is_written_to_the_letter)
{
    char *text = NULL;
    size_t size;
    tf_mesh_file mesh =
        good_mesh("v 0.5 0 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 3 1");
    FILE *stream = open_memstream(&text, &size);
    tf_mesh_content content = content_of(&mesh);
    tf_mesh_write(stream, &content, TF_OBJ);
    tf_mesh_write(stream, &content, TF_PLY_TEXT);
    fclose(stream);
    ck_assert_str_eq(
        text, "v 0.5 0 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 3 1\n"
              "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n"
              "property double y\nproperty double z\nelement face 1\n"
              "property list uchar int vertex_indices\nelement edge 1\n"
              "property int vertex1\nproperty int vertex2\nend_header\n"
              "0.5 0 1\n1 0 0\n0 1 0\n3 0 1 2\n2 0\n");
    free(text);
    tf_mesh_file_free(&mesh);
}
END_TEST

// Columns ---------------------------------------------------------------------

static tf_mesh_file columns_rewritten(const tf_mesh_file *mesh,
                                      const tf_columns *columns,
                                      tf_mesh_format format, tf_columns *read)
{
    char *text = NULL;
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    tf_mesh_content content = content_of(mesh);
    content.columns = columns;
    tf_mesh_write(stream, &content, format);
    fclose(stream);
    read_columns(read);
    tf_mesh_file file = good_bytes(text, size);
    read_columns(NULL);
    free(text);
    return file;
}

/// A random number of a type, at times its least or greatest.
static double number_of(generator *random, tf_number_type type)
{
    static const double least[] = {-128, 0, -32768, 0, -2147483648.0, 0};
    static const double most[] = {127,   255,        32767,
                                  65535, 2147483647, 4294967295};
    if (type == TF_DOUBLE)
        return any_double(random);
    if (type == TF_FLOAT)
        return (double)(float)uniform(random, -1e3, 1e3);
    int which = below(random, 4);
    return which == 0   ? least[type]
           : which == 1 ? most[type]
                        : floor(uniform(random, least[type], most[type]));
}

/// Columns of all types, in all places.
static tf_columns some_columns(generator *random, int rows)
{
    tf_columns made = {.count = 24};
    for (int i = 0; i < 24; i++) {
        made.column[i] =
            (tf_column){.type = (tf_number_type)(i % 8), .after = i / 6};
        sprintf(made.column[i].name, "value_%d", i);
    }
    for (int row = 0; row < rows; row++) {
        double value[24];
        for (int i = 0; i < 24; i++)
            value[i] = number_of(random, made.column[i].type);
        ck_assert(tf_columns_add(&made, value));
    }
    return made;
}

START_TEST(columns_come_back_with_their_names_types_and_order)
{
    generator random = generator_new(3);
    tf_mesh_file mesh = empty_mesh("mesh");
    for (int v = 0; v < 100; v++) {
        const double x[] = {any_double(&random), any_double(&random), v};
        ck_assert(tf_mesh_file_add_vertex(&mesh, x, 0));
    }
    ck_assert(tf_mesh_file_add_triangle(&mesh, (const int[]){0, 9, 5}, 0));
    tf_columns columns = some_columns(&random, 100), read;
    for (int f = TF_PLY_TEXT; f < PLY_FORMATS; f++) {
        tf_mesh_file again =
            columns_rewritten(&mesh, &columns, formats[f], &read);
        expect_vertices(&again, 100, mesh.position.item);
        ck_assert_int_eq(read.count, 24);
        ck_assert_mem_eq(read.column, columns.column, 24 * sizeof *read.column);
        ck_assert_uint_eq(read.rows, 100);
        for (int i = 0; i < 2400; i++) // text has the digits of a float
            ck_assert(columns.column[i % 24].type == TF_FLOAT
                          ? (float)read.value[i] == (float)columns.value[i]
                          : read.value[i] == columns.value[i]);
        tf_columns_free(&read);
        tf_mesh_file_free(&again);
    }
    tf_columns_free(&columns);
    tf_mesh_file_free(&mesh);
}
END_TEST

static tf_columns colors_of(tf_number_type type, const double color[3])
{
    static const char *const names[] = {"blue", "red", "green"};
    tf_columns made = {.count = 3};
    for (int i = 0; i < 3; i++) {
        made.column[i].type = type;
        sprintf(made.column[i].name, "%s", names[i]);
    }
    ck_assert(tf_columns_add(&made, color));
    return made;
}

START_TEST(obj_has_colors_from_zero_to_one)
{
    static const struct {
        tf_number_type type;
        double color[3], wanted[3];
    } kinds[] = {{TF_UCHAR, {51, 255, 0}, {1, 0, 0.2}},
                 {TF_USHORT, {65535, 13107, 0}, {0.2, 0, 1}},
                 {TF_FLOAT, {0.5, 0.25, 1}, {0.25, 1, 0.5}},
                 {TF_DOUBLE, {0.1, 0.2, 0.3}, {0.2, 0.3, 0.1}}};
    tf_mesh_file mesh = good_mesh("v 1 2 3\nv 4 5 6\nv 7 8 8\nf 1 2 3\n");
    for (int i = 0; i < 4; i++) {
        tf_columns columns = colors_of(kinds[i].type, kinds[i].color), read;
        for (int v = 0; v < 2; v++)
            ck_assert(tf_columns_add(&columns, kinds[i].color));
        tf_mesh_file again = columns_rewritten(&mesh, &columns, TF_OBJ, &read);
        ck_assert_int_eq(read.count, 3);
        ck_assert_mem_eq(read.value + 3, kinds[i].wanted, 24);
        tf_columns_free(&read);
        tf_columns_free(&columns);
        tf_mesh_file_free(&again);
    }
    tf_mesh_file_free(&mesh);
}
END_TEST

START_TEST(what_a_type_cannot_hold_becomes_what_it_can)
{
    static const double values[] = {NAN, 1e30, -1e30};
    static const double wanted[] = {0, 255, 0};
    tf_mesh_file mesh = good_mesh("v 1 2 3\nv 4 5 6\nv 7 8 8\nf 1 2 3\n");
    tf_columns columns = {.count = 1, .column = {{"a", TF_UCHAR, 3}}}, read;
    for (int v = 0; v < 3; v++)
        ck_assert(tf_columns_add(&columns, &values[v]));
    for (int f = TF_PLY_TEXT; f < PLY_FORMATS; f++) {
        tf_mesh_file again =
            columns_rewritten(&mesh, &columns, formats[f], &read);
        ck_assert_mem_eq(read.value, wanted, sizeof wanted);
        tf_columns_free(&read);
        tf_mesh_file_free(&again);
    }
    tf_columns_free(&columns);
    tf_mesh_file_free(&mesh);
}
END_TEST

// What cannot be written ------------------------------------------------------

static tf_fault fault;

static bool is_writable(const tf_mesh_file *file, tf_mesh_format format,
                        const char *path)
{
    tf_mesh_content content = content_of(file);
    content.from = file;
    fault = (tf_fault){0};
    return tf_mesh_check_writable(&content, format, path, &fault);
}

static void expect_refused(const tf_mesh_file *file, tf_mesh_format format,
                           const char *path, const char *words)
{
    ck_assert(!is_writable(file, format, path));
    ck_assert_str_eq(fault.file, path);
    ck_assert_str_eq(fault.text, words);
}

START_TEST(curves_are_not_written_as_faces)
{
    tf_mesh_file mesh = good_mesh("v 0 0 0\nv 1 0 0\nl 1 2\n");
    ck_assert(is_writable(&mesh, TF_OBJ, "a.obj"));
    ck_assert(is_writable(&mesh, TF_PLY_TEXT, "a.ply"));
    ck_assert(is_writable(&mesh, TF_VTP, "a.vtp"));
    expect_refused(&mesh, TF_OFF, "a.off",
                   "OFF holds faces, and this mesh has only edges; end the "
                   "name in .obj, .ply or .vtp");
    expect_refused(&mesh, TF_STL_BINARY, "a.stl",
                   "STL holds faces, and this mesh has only edges; end the "
                   "name in .obj, .ply or .vtp");
    tf_mesh_file_free(&mesh);
}
END_TEST

START_TEST(stl_holds_no_coordinates_beyond_floats)
{
    tf_mesh_file mesh = good_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    mesh.position.item[4] = -FLT_MAX;
    ck_assert(is_writable(&mesh, TF_STL_BINARY, "a.stl"));
    mesh.position.item[4] = -0x1.fffffefp127; // would be rounded down
    ck_assert(is_writable(&mesh, TF_OBJ, "a.obj"));
    expect_refused(&mesh, TF_STL_BINARY, "a.stl",
                   "the coordinate -3.4028235614590836e+38 is beyond the "
                   "floats of STL; scale the mesh down, or end the name in "
                   ".obj, .ply or .vtp");
    tf_mesh_file_free(&mesh);
}
END_TEST

START_TEST(stl_has_floats_unless_it_is_text_that_is_kept)
{
    tf_source source = {0};
    tf_mesh_file mesh = good_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    tf_mesh_content content = content_of(&mesh);
    content.from = &mesh;
    ck_assert(tf_mesh_has_floats(&content, TF_STL_BINARY));
    ck_assert(tf_mesh_has_floats(&content, TF_STL_TEXT));
    ck_assert(!tf_mesh_has_floats(&content, TF_PLY_TEXT));
    mesh.source = &source;
    mesh.format = TF_STL_TEXT;
    ck_assert(!tf_mesh_has_floats(&content, TF_STL_TEXT));
    mesh.format = TF_STL_BINARY;
    ck_assert(tf_mesh_has_floats(&content, TF_STL_BINARY));
    tf_mesh_file_free(&mesh);
}
END_TEST

START_TEST(other_formats_are_not_written)
{
    tf_mesh_file mesh = good_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expect_refused(&mesh, TF_OBJ, "a.glb",
                   ".glb is not written; end the name in .obj, .ply, .stl, "
                   ".off or .vtp");
    expect_refused(&mesh, TF_MSH, "a.msh",
                   "Gmsh's .msh is written only if the mesh comes from one, "
                   "with its triangles; end the name in .obj, .ply or .vtp");
    tf_mesh_file_free(&mesh);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("writers/mesh_writer");
    TCase *written = tcase_create("what is written");
    tcase_add_test(written, a_mesh_of_all_elements_comes_back);
    tcase_add_test(written, meshes_of_one_element_come_back);
    tcase_add_test(written, a_curve_of_the_plane_comes_back);
    tcase_add_test(written, polygons_come_back);
    tcase_add_test(written, floats_come_back_from_stl);
    tcase_add_test(written, doubles_of_any_size_come_back);
    tcase_add_test(written, each_format_is_written_to_the_letter);
    tcase_add_test(written, columns_come_back_with_their_names_types_and_order);
    tcase_add_test(written, obj_has_colors_from_zero_to_one);
    tcase_add_test(written, what_a_type_cannot_hold_becomes_what_it_can);
    suite_add_tcase(suite, written);
    TCase *refused = tcase_create("what is not written");
    tcase_add_test(refused, curves_are_not_written_as_faces);
    tcase_add_test(refused, stl_holds_no_coordinates_beyond_floats);
    tcase_add_test(refused, stl_has_floats_unless_it_is_text_that_is_kept);
    tcase_add_test(refused, other_formats_are_not_written);
    suite_add_tcase(suite, refused);
    return suite;
}

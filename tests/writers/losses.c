#include "writers/losses.h"

#include "formats/mesh_reader.h"
#include "support/program.h"
#include "support/support.h"

#include <float.h>
#include <stdio.h>

static tf_fault fault;

/// Expects these losses of a text in a format.
static void expect_losses(const char *text, tf_mesh_format format,
                          const char *words)
{
    tf_mesh_file file;
    tf_columns columns = {0};
    tf_source source = {0};
    make_file("in", text);
    ck_assert_msg(tf_mesh_file_read_all(&file, "in", &columns, &source, &fault),
                  "%s", fault.text);
    ck_assert_str_eq(tf_find_losses(&file, format).text, words);
    tf_mesh_file_free(&file);
    tf_columns_free(&columns);
    tf_source_free(&source);
}

#define OBJ "v 0 0 0\nv 1 0 0\n\nv 0 1 0\nf 1 2 3\n"

START_TEST(a_mesh_with_nothing_else_loses_nothing)
{
    static const tf_mesh_format formats[] = {TF_OBJ, TF_PLY_TEXT, TF_OFF,
                                             TF_STL_BINARY, TF_VTP};
    for (int i = 0; i < 5; i++)
        expect_losses(OBJ, formats[i], "");
}
END_TEST

START_TEST(lines_of_obj_are_lost)
{
    static const struct {
        const char *line, *words;
    } cases[] = {{"# x", "comments"},
                 {"#x", "comments"},
                 {" o cloth\r", "names"},
                 {"g", "groups"},
                 {"usemtl red", "materials"},
                 {"mtllib a.mtl", "materials"},
                 {"s off", "smoothing groups"},
                 {"vt 0 0", "texture coordinates"},
                 {"vn\t0 0 1", "normals"},
                 {"curv 0 1", "other lines"},
                 {"\t ", ""}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[200];
        sprintf(text, "%s\n" OBJ, cases[i].line);
        expect_losses(text, TF_PLY_LITTLE_ENDIAN, cases[i].words);
        sprintf(text, OBJ "%s", cases[i].line);
        expect_losses(text, TF_OBJ, cases[i].words);
    }
    expect_losses("s 1\ng a\n# b\n" OBJ, TF_VTP,
                  "comments, groups and smoothing groups");
}
END_TEST

START_TEST(formats_lose_elements_that_they_do_not_hold)
{
    static const char text[] = "v 0 0 0 1 1 1\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                               "f 1 2 3 4\nl 1 3\n";
    expect_losses(text, TF_OBJ, "");
    expect_losses(text, TF_PLY_TEXT, "");
    expect_losses(text, TF_VTP, "polygons");
    expect_losses(text, TF_OFF, "edges");
    expect_losses(text, TF_STL_BINARY, "colors, polygons and edges");
}
END_TEST

#define PLY_OF(head, vertex, more, numbers, face, other)                       \
    "ply\nformat ascii 1.0\n" head                                             \
    "element vertex 3\nproperty float x\nproperty float y\n"                   \
    "property float z\n" vertex "element face 1\n"                             \
    "property list uchar int vertex_indices\n" more "end_header\n"             \
    "0 0 0 " numbers "\n1 0 0 " numbers "\n0 1 0 " numbers "\n3 0 1 2 " face   \
    "\n" other

START_TEST(properties_of_vertices_are_lost_where_there_are_none)
{
    static const char text[] =
        PLY_OF("",
               "property uchar red\nproperty uchar green\nproperty uchar blue\n"
               "property float nx\nproperty float ny\nproperty float nz\n"
               "property float s\nproperty double heat\n",
               "", "1 2 3 4 5 6 7 8", "", "");
    expect_losses(text, TF_PLY_TEXT, "");
    expect_losses(text, TF_VTP, "");
    expect_losses(text, TF_OBJ,
                  "texture coordinates, normals and properties of vertices");
    expect_losses(text, TF_STL_BINARY,
                  "texture coordinates, normals, colors and properties of "
                  "vertices");
}
END_TEST

START_TEST(what_ply_has_besides_vertices_is_lost)
{
    expect_losses(PLY_OF("comment x\n", "", "", "", "", ""), TF_PLY_TEXT,
                  "comments");
    expect_losses(PLY_OF("obj_info x\n", "", "", "", "", ""), TF_OBJ,
                  "comments");
    expect_losses(PLY_OF("", "property list uchar int near\n", "", "0", "", ""),
                  TF_PLY_TEXT, "properties of vertices");
    expect_losses(PLY_OF("", "", "property uchar red\n", "", "5", ""),
                  TF_PLY_TEXT, "properties of faces");
    expect_losses(
        PLY_OF("", "", "property list uchar float texcoord\n", "", "0", ""),
        TF_PLY_TEXT, "texture coordinates");
    expect_losses(PLY_OF("", "",
                         "element edge 1\nproperty int vertex1\n"
                         "property int vertex2\nproperty float length\n",
                         "", "", "0 1 5\n"),
                  TF_PLY_TEXT, "properties of edges");
    expect_losses(
        PLY_OF("", "", "element material 1\nproperty int x\n", "", "", "0\n"),
        TF_PLY_TEXT, "other elements");
    expect_losses(PLY_OF("", "",
                         "element edge 0\nproperty int vertex1\n"
                         "property int vertex2\n",
                         "", "", ""),
                  TF_STL_BINARY, "");
}
END_TEST

START_TEST(floats_are_not_rounded)
{
    static const double x[] = {0, -0.0, 0.5, 0.1, FLT_MAX, 1e-50, 16777217};
    ck_assert_uint_eq(tf_count_rounded(x, 7), 3);
    ck_assert_uint_eq(tf_count_rounded(x, 3), 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("writers/losses");
    TCase *tcase = tcase_create("losses");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_test(tcase, a_mesh_with_nothing_else_loses_nothing);
    tcase_add_test(tcase, lines_of_obj_are_lost);
    tcase_add_test(tcase, formats_lose_elements_that_they_do_not_hold);
    tcase_add_test(tcase, properties_of_vertices_are_lost_where_there_are_none);
    tcase_add_test(tcase, what_ply_has_besides_vertices_is_lost);
    tcase_add_test(tcase, floats_are_not_rounded);
    suite_add_tcase(suite, tcase);
    return suite;
}

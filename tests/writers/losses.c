#include "writers/losses.h"

#include "formats/mesh_reader.h"
#include "support/program.h"
#include "support/support.h"

#include <float.h>
#include <stdio.h>

static tf_fault fault;

static bool keeps_faces;

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
    ck_assert_str_eq(tf_find_losses(&file, format, keeps_faces).text, words);
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

START_TEST(what_faces_have_may_be_kept)
{
    keeps_faces = true;
    expect_losses(
        "# x\no a\ng b\nusemtl c\nmtllib d\ns 1\nvt 0 0\nvn 0 0 1\n" OBJ,
        TF_OBJ, "comments, smoothing groups and normals");
    static const char *const kept[] = {"int", "uchar", "int16", "uint32"};
    static const char *const lost[] = {"float", "double", "float32",
                                       "list uchar int"};
    for (int i = 0; i < 8; i++) {
        char text[400];
        sprintf(text,
                "ply\nformat ascii 1.0\nelement vertex 3\nproperty int x\n"
                "property int y\nproperty int z\nelement face 1\n"
                "property list uchar int vertex_indices\nproperty %s a\n"
                "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 0\n",
                i < 4 ? kept[i] : lost[i - 4]);
        expect_losses(text, TF_PLY_TEXT, i < 4 ? "" : "properties of faces");
    }
    keeps_faces = false;
}
END_TEST

START_TEST(lines_of_obj_are_lost)
{
    static const struct {
        const char *line, *words;
    } cases[] = {{"# x", "comments"},
                 {"#x", "comments"},
                 {" o cloth\r", "object names"},
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

START_TEST(what_stl_has_besides_triangles_is_lost)
{
    static const char loop[] = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                               "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
                               "endsolid\n";
    char text[300];
    sprintf(text, "solid \n%s", loop);
    expect_losses(text, TF_PLY_TEXT, "");
    sprintf(text, "solid\n%ssolid foot\n%s", loop, loop);
    expect_losses(text, TF_PLY_TEXT, "object names");
    char bytes[134] = {[80] = 1, [99] = 1, [109] = 64, [125] = 65};
    make_binary_file("in", bytes, 134);
    for (int color = 0; color < 2; color++) {
        tf_mesh_file file;
        tf_source source = {0};
        bytes[133] = (char)color;
        make_binary_file("in", bytes, 134);
        ck_assert_msg(tf_mesh_file_read_all(&file, "in", NULL, &source, &fault),
                      "%s", fault.text);
        ck_assert_str_eq(tf_find_losses(&file, TF_OBJ, false).text,
                         color ? "colors" : "");
        tf_mesh_file_free(&file);
        tf_source_free(&source);
    }
}
END_TEST

#define POINTS_OF(more)                                                        \
    "3 1 0\n0 0 0 " more "\n1 0 0 " more "\n0 1 0 " more "\n"

START_TEST(what_off_has_besides_faces_is_lost)
{
    expect_losses("OFF\n" POINTS_OF("") "3 0 1 2\n", TF_PLY_TEXT, "");
    expect_losses("OFF " POINTS_OF("") "3 0 1 2\n", TF_PLY_TEXT, "");
    expect_losses("\xef\xbb\xbfOFF\n" POINTS_OF("") "3 0 1 2\n", TF_PLY_TEXT,
                  "");
    expect_losses("\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                  TF_PLY_TEXT, "");
    expect_losses("OFF\n# x\n" POINTS_OF("") "3 0 1 2 # 5\n\n", TF_PLY_TEXT,
                  "comments");
    expect_losses("# x\nCOFF\n" POINTS_OF("1 2 3 4") "3 0 1 2\n", TF_PLY_TEXT,
                  "comments and colors");
    expect_losses("STNOFF\n" POINTS_OF("0 0 1 5 5") "3 0 1 2\n", TF_PLY_TEXT,
                  "texture coordinates and normals");
    expect_losses("OFF\n" POINTS_OF("") "3 0 1 2 255 0 0\n", TF_PLY_TEXT,
                  "colors");
}
END_TEST

START_TEST(what_gmsh_has_besides_surfaces_is_lost)
{
    static const char nodes[] = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n"
                                "4 0 0 1\n$EndNodes\n$Elements\n";
    char text[400];
    sprintf(text,
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n%s1\n1 2 2 0 1 1 2 3\n"
            "$EndElements\n",
            nodes);
    expect_losses(text, TF_PLY_TEXT, "");
    sprintf(text,
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 "
            "1 \"a\"\n$EndPhysicalNames\n%s2\n1 2 2 0 1 1 2 3\n2 4 2 0 1 "
            "1 2 3 4\n$EndElements\n",
            nodes);
    expect_losses(text, TF_PLY_TEXT, "groups and other elements");
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
    tcase_add_test(tcase, what_faces_have_may_be_kept);
    tcase_add_test(tcase, lines_of_obj_are_lost);
    tcase_add_test(tcase, formats_lose_elements_that_they_do_not_hold);
    tcase_add_test(tcase, properties_of_vertices_are_lost_where_there_are_none);
    tcase_add_test(tcase, what_ply_has_besides_vertices_is_lost);
    tcase_add_test(tcase, what_stl_has_besides_triangles_is_lost);
    tcase_add_test(tcase, what_off_has_besides_faces_is_lost);
    tcase_add_test(tcase, what_gmsh_has_besides_surfaces_is_lost);
    tcase_add_test(tcase, floats_are_not_rounded);
    suite_add_tcase(suite, tcase);
    return suite;
}

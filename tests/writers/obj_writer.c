#include "writers/obj_writer.h"

#include "support/meshes.h"
#include "support/support.h"

START_TEST(obj_is_written_to_the_letter)
{
    tf_mesh_file file = good_mesh("v 0.5 0 1\nv 1 0 0\nv 0 1 0.1\nv 2 2 2\n"
                                  "f 1 2 3\nf 1 2 3 4\nl 3 1\n");
    tf_mesh_content content = content_of(&file);
    expect_mesh_text(&content, TF_OBJ,
                     "v 0.5 0 1\nv 1 0 0\nv 0 1 0.1\nv 2 2 2\n"
                     "f 1 2 3\nf 1 2 3\nf 1 3 4\nl 3 1\n");
    content.from = &file;
    expect_mesh_text(&content, TF_OBJ,
                     "v 0.5 0 1\nv 1 0 0\nv 0 1 0.1\nv 2 2 2\n"
                     "f 1 2 3\nf 1 2 3 4\nl 3 1\n");
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(colors_follow_the_positions)
{
    tf_columns columns;
    read_columns(&columns);
    tf_mesh_file file =
        good_mesh("v 0 0 1 .5 .25 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    read_columns(NULL);
    tf_mesh_content content = content_of(&file);
    content.columns = &columns;
    expect_mesh_text(&content, TF_OBJ,
                     "v 0 0 1 0.5 0.25 0\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\n"
                     "f 1 2 3\n");
    tf_columns_free(&columns);
    tf_mesh_file_free(&file);
}
END_TEST

// A heading is written where it changes, and only what changes of it; a face has
// texture coordinates at all of its corners, or at none.
START_TEST(faces_have_headings_and_textures)
{
    static const char lines[] = "mtllib a\ng a\nusemtl b\nusemtl c\n";
    static tf_excerpt library[] = {{0, 8}},
                      heading[] = {{0, 0},  {0, 0}, {0, 0}, {0, 0}, {9, 3},
                                   {13, 8}, {0, 0}, {9, 3}, {22, 8}};
    static double number[] = {0, 1, 1, 2}, uv[] = {0, 1, 0, .5, .25, 0};
    static int texture[] = {-1, -1, -1, 1, 0, 1, 1, 0, -1, 0, 0, 0};
    tf_mesh_file file = good_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
                                  "f 1 2 3\nf 1 2 3\nf 1 2 3\n");
    tf_mesh_content content = content_of(&file);
    const tf_face_attributes faces = {
        .text = lines,
        .library = {library, 1, 1},
        .heading = {heading, 9, 9},
        .row = {.count = 1, .value = number, .rows = 4},
        .texture = {.count = 3, .value = uv, .rows = 2},
        .texture_axes = 2,
        .corner = {texture, 12, 12}};
    content.faces = &faces;
    expect_mesh_text(
        &content, TF_OBJ,
        "mtllib a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 1\nvt 0.5 0.25\n"
        "f 1 2 3\ng a\nusemtl b\nf 1/2 2/1 3/2\nf 1 2 3\n"
        "usemtl c\nf 1/1 2/1 3/1\n");
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(the_third_coordinate_of_the_plane_is_0)
{
    static const double x[] = {1, 2, 3, 4};
    static const int edge[] = {0, 1};
    tf_mesh_content content = {
        .mesh = {.axes = 2, .vertices = 2, .edges = 1, .edge = edge},
        .position = x};
    expect_mesh_text(&content, TF_OBJ, "v 1 2 0\nv 3 4 0\nl 1 2\n");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("writers/obj_writer");
    TCase *tcase = tcase_create("OBJ");
    tcase_add_test(tcase, obj_is_written_to_the_letter);
    tcase_add_test(tcase, colors_follow_the_positions);
    tcase_add_test(tcase, faces_have_headings_and_textures);
    tcase_add_test(tcase, the_third_coordinate_of_the_plane_is_0);
    suite_add_tcase(suite, tcase);
    return suite;
}

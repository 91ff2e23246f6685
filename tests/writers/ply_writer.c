#include "writers/ply_writer.h"

#include "support/meshes.h"
#include "support/support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

START_TEST(polygons_are_faces_of_ply)
{
    tf_mesh_file file = good_mesh("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                  "f 4 1 2 3\nf 1 2 3\nl 1 3\n");
    tf_mesh_content content = content_of(&file);
    content.from = &file;
    expect_mesh_text(
        &content, TF_PLY_TEXT,
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\n"
        "property double y\nproperty double z\nelement face 2\n"
        "property list uchar int vertex_indices\nelement edge 1\n"
        "property int vertex1\nproperty int vertex2\nend_header\n"
        "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 3 0 1 2\n3 0 1 2\n0 2\n");
    tf_mesh_file_free(&file);
}
END_TEST

/// Faces with so many corners on a parabola.
static tf_mesh_file many_corners(int corners)
{
    tf_mesh_file file = empty_mesh("mesh");
    int *corner = malloc(sizeof *corner * (size_t)corners);
    for (int i = 0; i < corners; i++) {
        const double x[] = {i, (double)i * i, 0};
        corner[i] = i;
        ck_assert(tf_mesh_file_add_vertex(&file, x, 0));
    }
    ck_assert(tf_mesh_file_add_face(&file, corner, corners, 0));
    ck_assert(tf_mesh_file_add_face(&file, corner, 3, 0));
    ck_assert(tf_mesh_file_divide(&file));
    free(corner);
    return file;
}

START_TEST(faces_of_any_length_come_back)
{
    static const int corners[] = {4, 255, 256, 70000};
    for (int i = 0; i < 4; i++)
        for (int f = TF_PLY_TEXT; f <= TF_PLY_BIG_ENDIAN; f++) {
            tf_mesh_file file = many_corners(corners[i]);
            tf_mesh_content content = content_of(&file);
            content.from = &file;
            size_t size;
            char *text = bytes_of_mesh(&content, (tf_mesh_format)f, &size);
            ck_assert_ptr_nonnull(
                strstr(text, i < 2 ? "list uchar int" : "list int int"));
            tf_mesh_file read = good_bytes(text, size);
            ck_assert_int_eq(tf_mesh_file_polygons(&read), 1);
            ck_assert_uint_eq(read.corner.count, (size_t)corners[i]);
            ck_assert_mem_eq(read.triangle.item, file.triangle.item,
                             sizeof(int) * file.triangle.count);
            free(text);
            tf_mesh_file_free(&read);
            tf_mesh_file_free(&file);
        }
}
END_TEST

START_TEST(comments_and_velocities_are_written)
{
    static const double x[] = {1, 2, 3, 4}, velocity[] = {5, 6, 7, 8};
    static const int edge[] = {0, 1};
    tf_mesh_content content = {
        .mesh = {.axes = 2, .vertices = 2, .edges = 1, .edge = edge},
        .position = x,
        .velocity = velocity,
        .comment = "by hand",
        .notes = "up y\nand so on"};
    expect_mesh_text(
        &content, TF_PLY_TEXT,
        "ply\nformat ascii 1.0\ncomment by hand\ncomment up y\n"
        "comment and so on\nelement vertex 2\n"
        "property double x\nproperty double y\nproperty double z\n"
        "property double vx\nproperty double vy\nproperty double vz\n"
        "element edge 1\nproperty int vertex1\nproperty int vertex2\n"
        "end_header\n1 2 0 5 6 0\n3 4 0 7 8 0\n0 1\n");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("writers/ply_writer");
    TCase *tcase = tcase_create("PLY");
    tcase_add_test(tcase, polygons_are_faces_of_ply);
    tcase_add_test(tcase, faces_of_any_length_come_back);
    tcase_add_test(tcase, comments_and_velocities_are_written);
    suite_add_tcase(suite, tcase);
    return suite;
}

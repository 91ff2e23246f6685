#include "writers/mesh_content.h"

#include "support/meshes.h"
#include "support/support.h"

#include <stdio.h>

static const char text[] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 2 0\n"
                           "f 1 2 3\nf 1 2 3 4 5\nf 3 4 5\nf 1 2 3 4\n";

static void expect_faces(const tf_mesh_content *content, int count,
                         const int corners[])
{
    tf_face face = {0};
    ck_assert_int_eq(tf_mesh_content_faces(content), count);
    for (int i = 0; i < count; i++) {
        ck_assert(tf_mesh_content_next_face(content, &face));
        ck_assert_int_eq(face.corners, corners[i]);
    }
    ck_assert(!tf_mesh_content_next_face(content, &face));
}

START_TEST(faces_are_those_of_the_file_or_triangles)
{
    tf_mesh_file file = good_mesh(text);
    tf_mesh_content content = content_of(&file);
    expect_faces(&content, 7, (const int[]){3, 3, 3, 3, 3, 3, 3});
    tf_face face = {0};
    for (int i = 0; i < 7; i++) {
        ck_assert(tf_mesh_content_next_face(&content, &face));
        ck_assert_ptr_eq(face.corner, file.triangle.item + 3 * i);
    }
    content.from = &file;
    expect_faces(&content, 4, (const int[]){3, 5, 3, 4});
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(a_mesh_of_edges_has_no_faces)
{
    tf_mesh_file file = good_mesh("v 0 0\nv 1 0\nl 1 2\n");
    tf_mesh_content content = content_of(&file);
    expect_faces(&content, 0, NULL);
    content.from = &file;
    expect_faces(&content, 0, NULL);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(colors_are_parts_of_one)
{
    static const struct {
        tf_number_type type;
        double value[3], color[3];
    } kinds[] = {{TF_UCHAR, {51, 255, 0}, {0.2, 1, 0}},
                 {TF_USHORT, {65535, 13107, 0}, {1, 0.2, 0}},
                 {TF_FLOAT, {0.5, 0.25, 1}, {0.5, 0.25, 1}}};
    static const char *const names[] = {"red", "green", "blue"};
    for (int i = 0; i < 3; i++) {
        tf_columns columns = {.count = 3};
        tf_mesh_content content = {.columns = &columns};
        double color[3];
        for (int k = 0; k < 3; k++) {
            columns.column[k].type = kinds[i].type;
            sprintf(columns.column[k].name, "%s", names[k]);
        }
        ck_assert(tf_columns_add(&columns, kinds[i].value));
        ck_assert(tf_mesh_content_color(&content, 0, color));
        ck_assert_mem_eq(color, kinds[i].color, sizeof color);
        sprintf(columns.column[1].name, "grey");
        ck_assert(!tf_mesh_content_color(&content, 0, color));
        tf_columns_free(&columns);
    }
    double unused[3];
    ck_assert(!tf_mesh_content_color(&(tf_mesh_content){0}, 0, unused));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("writers/mesh_content");
    TCase *tcase = tcase_create("contents");
    tcase_add_test(tcase, faces_are_those_of_the_file_or_triangles);
    tcase_add_test(tcase, a_mesh_of_edges_has_no_faces);
    tcase_add_test(tcase, colors_are_parts_of_one);
    suite_add_tcase(suite, tcase);
    return suite;
}

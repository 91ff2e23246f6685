// What faces have, as files tell it.
#include "formats/face_attributes.h"

#include "formats/mesh_reader.h"
#include "support/support.h"

#include <stdlib.h>
#include <string.h>

static tf_fault fault;
static tf_mesh_file file;
static tf_source source;
static tf_face_attributes faces;

static void begin(const char *text)
{
    size_t size = strlen(text);
    char *copy = malloc(size + 1);
    ck_assert_ptr_nonnull(copy);
    memcpy(copy, text, size + 1);
    faces = (tf_face_attributes){0};
    source = (tf_source){.faces = &faces};
    ck_assert(tf_mesh_file_parse_all(&file, "mesh", copy, size, NULL, &source,
                                     &fault));
}

static void end(void)
{
    tf_face_attributes_free(&faces);
    tf_source_free(&source);
    tf_mesh_file_free(&file);
    ck_assert_ptr_null(faces.heading.item);
}

static void expect_excerpt(tf_excerpt found, const char *text)
{
    ck_assert_int_eq((int)found.length, (int)strlen(text));
    ck_assert_mem_eq(faces.text + found.at, text, strlen(text));
}

static void expect_heading(int face, const char *object, const char *group,
                           const char *material)
{
    int heading = (int)*tf_columns_row(&faces.row, face);
    const tf_excerpt *line = faces.heading.item + 3 * heading;
    expect_excerpt(line[TF_OBJECT_LINE], object);
    expect_excerpt(line[TF_GROUP_LINE], group);
    expect_excerpt(line[TF_MATERIAL_LINE], material);
}

START_TEST(headings_of_obj_are_kept)
{
    begin("mtllib a b.mtl \r\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\ng x y\t\r\n"
          "f 1 2 3\n  o two words\nusemtl m\nf 1 2 3\ngroup z\nf 3 2 1\ng\n"
          "f 1 2 3\n\tg x y\nf 1 2 3");
    ck_assert_int_eq((int)faces.library.count, 1);
    expect_excerpt(faces.library.item[0], "mtllib a b.mtl");
    expect_heading(0, "", "", "");
    expect_heading(1, "", "g x y", "");
    expect_heading(2, "o two words", "g x y", "usemtl m");
    ck_assert(tf_face_attributes_agree(&faces, 2, 3));
    expect_heading(4, "o two words", "g", "usemtl m");
    ck_assert(!tf_face_attributes_agree(&faces, 4, 3));
    ck_assert(tf_face_attributes_agree(&faces, 2, 5));
    ck_assert_int_eq((int)faces.heading.count, 3 * 4);
    end();
}
END_TEST

// The excerpts are of the text as it was.
START_TEST(lines_of_old_macs_have_headings)
{
    begin("v 0 0 0\rv 1 0 0\rv 0 1 0\rusemtl m\rf 1 2 3\r");
    expect_heading(0, "", "", "usemtl m");
    end();
}
END_TEST

START_TEST(texture_coordinates_of_obj_are_kept)
{
    static const int rows[] = {0, 1, 2, 2, -1, 0, 2, 1, 0, 1};
    begin("vt 1\nvt 2 3\nvt 4 5 6 7\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
          "f 1/1 2/2/8 3/3\nf 1/-1/9 2//3 3/1\nf 1/-1 2/-2 3/1 4/2\n");
    ck_assert_int_eq((int)faces.texture.rows, 3);
    ck_assert_int_eq(faces.texture_axes, 3);
    ck_assert_mem_eq(faces.texture.value,
                     ((double[]){1, 0, 0, 2, 3, 0, 4, 5, 6}),
                     9 * sizeof(double));
    ck_assert_int_eq((int)faces.corner.count, 10);
    ck_assert_mem_eq(faces.corner.item, rows, sizeof rows);
    end();
}
END_TEST

START_TEST(integers_of_faces_of_ply_are_kept)
{
    begin("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
          "property float y\nproperty float z\nproperty int own\n"
          "element face 3\nproperty short label\nproperty float heat\n"
          "property list uchar int vertex_indices\n"
          "property list uchar int more\nproperty uint id\nend_header\n"
          "0 0 0 1\n1 0 0 2\n0 1 0 3\n-3 1 3 0 1 2 1 7 4294967295\n"
          "-3 2 3 0 1 2 1 8 4294967295\n-3 1 3 0 1 2 1 7 4294967294\n");
    ck_assert_int_eq(faces.row.count, 2);
    ck_assert_str_eq(faces.row.column[0].name, "label");
    ck_assert_str_eq(faces.row.column[1].name, "id");
    ck_assert_int_eq(faces.row.column[1].type, TF_UINT);
    ck_assert_int_eq((int)faces.row.rows, 3);
    ck_assert_double_eq(tf_columns_row(&faces.row, 2)[0], -3);
    ck_assert_double_eq(tf_columns_row(&faces.row, 2)[1], 4294967294);
    ck_assert(tf_face_attributes_agree(&faces, 0, 1));
    ck_assert(!tf_face_attributes_agree(&faces, 0, 2));
    end();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("formats/face_attributes");
    TCase *tcase = tcase_create("faces");
    tcase_add_test(tcase, headings_of_obj_are_kept);
    tcase_add_test(tcase, lines_of_old_macs_have_headings);
    tcase_add_test(tcase, texture_coordinates_of_obj_are_kept);
    tcase_add_test(tcase, integers_of_faces_of_ply_are_kept);
    suite_add_tcase(suite, tcase);
    return suite;
}

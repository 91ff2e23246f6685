// What faces have, and its borders.
#include "scenes/carried_faces.h"

#include "formats/mesh_reader.h"
#include "remesh/remesh.h"
#include "support/support.h"

#include <stdlib.h>
#include <string.h>

static tf_fault fault;
static tf_mesh_file file;
static tf_source source;
static tf_carried_faces faces;
static tf_kept_edges kept;

/// Reads a text, and finds the borders in it.
static void begin(const char *text)
{
    size_t size = strlen(text);
    char *copy = malloc(size + 1);
    ck_assert_ptr_nonnull(copy);
    memcpy(copy, text, size + 1);
    faces = (tf_carried_faces){0};
    source = (tf_source){.faces = &faces.from};
    kept = (tf_kept_edges){0};
    ck_assert(tf_mesh_file_parse_all(&file, "mesh", copy, size, NULL, &source,
                                     &fault));
    ck_assert(tf_carried_faces_begin(&faces, &file, &kept));
}

static void end(void)
{
    tf_carried_faces_free(&faces);
    tf_kept_edges_free(&kept);
    tf_source_free(&source);
    tf_mesh_file_free(&file);
}

/// Expects the edge between two vertices as the only border, or none.
static void expect_border(int a, int b)
{
    ck_assert_int_eq(kept.count, a != b);
    if (a != b)
        ck_assert((kept.vertex[0] == a && kept.vertex[1] == b) ||
                  (kept.vertex[0] == b && kept.vertex[1] == a));
}

#define SQUARE "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
#define UVS "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 1 1\nvt .5 .5 1\n"

START_TEST(faces_that_differ_have_a_border)
{
    static const struct {
        const char *faces;
        bool border;
    } cases[] = {
        {"f 1 2 3\nf 1 3 4\n", false},
        {"g a\nf 1 2 3\ng b\nf 1 3 4\n", true},
        {"g a\nf 1 2 3\ng a \nf 1 3 4\n", false},
        {"g a\nf 1 2 3\ng a b\nf 1 3 4\n", true},
        {"f 1 2 3\no b\nf 1 3 4\n", true},
        {"f 1 2 3\r\nusemtl b\r\nf 1 3 4\r\n", true},
        {"usemtl b\r\nf 1 2 3\nusemtl b\nf 1 3 4\n", false},
        {"usemtl b\nf 1 2 3\nusemtl c\nusemtl b\nf 1 3 4\n", false},
        {"s 1\nf 1 2 3\ns 2\nf 1 3 4\n", false},
        {UVS "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n", false},
        {UVS "f 1/1 2/2 3/3\nf 1/1 3/5 4/4\n", false}, // the same numbers
        {UVS "f 1/1 2/2 3/3\nf 1/1 3/6 4/4\n", true},
        {UVS "f 1/1 2/2 3/3\nf 1/6 3/3 4/4\n", true},
        {UVS "f 1/1 2/2 3/3\nf 1 3 4\n", true},
        {UVS "f 1/-6 2/-5 3/-4/\nf 1/1/7 3/3 4\n", false},
        {"f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n" UVS, false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[512] = SQUARE;
        begin(strcat(text, cases[i].faces));
        expect_border(0, cases[i].border ? 2 : 0);
        end();
    }
}
END_TEST

// Those of the hexagon are three more triangles; each has the corners of its
// face.
START_TEST(polygons_are_divided_with_what_they_have)
{
    begin("v 0 0 0\nv 2 0 0\nv 3 1 0\nv 2 2 0\nv 0 2 0\nv -1 1 0\nv 1 9 0\n"
          "vt 1 1\nvt 2 2\nvt 3 3\nvt 4 4\nvt 5 5\nvt 6 6\nvt 7 7\n"
          "g a\nf 1/1 2/2 3/3 4/4 5/5 6/6\ng b\nf 5/5 4/4 7/7\n");
    expect_border(3, 4);
    for (int c = 0; c < 15; c++) {
        ck_assert_int_eq(faces.texture[c], file.triangle.item[c]);
        ck_assert_int_eq(faces.face[c / 3], c >= 12);
    }
    end();
}
END_TEST

START_TEST(other_formats_have_no_borders)
{
    begin("OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n"
          "3 0 2 3 0 0 255\n");
    expect_border(0, 0);
    ck_assert_int_eq((int)faces.from.row.rows, 0);
    end();
}
END_TEST

#define STRIPS                                                                 \
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"              \
    "property float y\nproperty float z\nelement face 1\n"                     \
    "property list uchar int vertex_indices\nproperty int label\n"             \
    "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"  \
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 5\n3 0 2 3\n"

START_TEST(strips_have_no_labels)
{
    begin(STRIPS);
    expect_border(0, 0);
    ck_assert_int_eq((int)faces.from.row.rows, 0);
    end();
}
END_TEST

// Without other borders, a texture that jumps at x = 1 is one on either side.
START_TEST(a_seam_divides_textures)
{
    begin("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\n"
          "vt 0 0\nvt 1 0\nvt 5 0\nvt 6 0\nvt 0 1\nvt 1 1\nvt 5 1\nvt 6 1\n"
          "f 1/1 2/2 5/6\nf 1/1 5/6 4/5\nf 2/3 3/4 6/8\nf 2/3 6/8 5/7\n");
    expect_border(1, 4);
    tf_mesh mesh = tf_mesh_file_elements(&file, 3);
    tf_adaptive_surface *surface;
    ck_assert_int_eq(
        tf_adaptive_create(&mesh, file.position.item, &surface, NULL), TF_OK);
    const tf_remesh_options how = {.size = sizeof how,
                                   .edge = 0.3,
                                   .keeps = kept.count,
                                   .keep = kept.vertex};
    ck_assert_int_eq(tf_adaptive_remesh(surface, &how, NULL, NULL), TF_OK);
    ck_assert(tf_carried_faces_make(&faces, &file, surface));
    int triangles = tf_adaptive_mesh(surface)->triangles;
    ck_assert_int_gt(triangles, 30);
    for (int t = 0; t < triangles; t++) {
        const double *x[3];
        for (int i = 0; i < 3; i++)
            x[i] = tf_adaptive_positions(surface) +
                   3 * (size_t)faces.triangle[3 * t + i];
        double middle = (x[0][0] + x[1][0] + x[2][0]) / 3;
        for (int i = 0; i < 3; i++) {
            const double *uv = tf_columns_row(
                &faces.made.texture, faces.made.corner.item[3 * t + i]);
            ck_assert_double_eq_tol(uv[0], x[i][0] + (middle > 1 ? 4 : 0),
                                    1e-12);
            ck_assert_double_eq_tol(uv[1], x[i][1], 1e-12);
        }
    }
    tf_adaptive_free(surface);
    end();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("scenes/carried_faces");
    TCase *tcase = tcase_create("faces");
    tcase_add_test(tcase, faces_that_differ_have_a_border);
    tcase_add_test(tcase, polygons_are_divided_with_what_they_have);
    tcase_add_test(tcase, other_formats_have_no_borders);
    tcase_add_test(tcase, strips_have_no_labels);
    tcase_add_test(tcase, a_seam_divides_textures);
    suite_add_tcase(suite, tcase);
    return suite;
}

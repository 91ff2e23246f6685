// Meshes whose coincident vertices are joined.
#include "scenes/weld.h"

#include "scenes/coincident.h"
#include "support/meshes.h"
#include "support/support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static tf_mesh_file file, welded;
static tf_columns columns, carried;
static tf_weld_report report;
static int number[100];

/// Welds a text.
static void weld(const char *text, double within)
{
    read_columns(&columns);
    file = good_mesh(text);
    read_columns(NULL);
    ck_assert_msg(
        tf_weld(&file, within, &columns, number, &welded, &carried, &report),
        "%s", file.fault->text);
}

static void free_all(void)
{
    tf_mesh_file_free(&file);
    tf_mesh_file_free(&welded);
    tf_columns_free(&columns);
    tf_columns_free(&carried);
}

static void expect_report(tf_weld_report right)
{
    ck_assert_int_eq(report.vertices_before, right.vertices_before);
    ck_assert_int_eq(report.vertices, right.vertices);
    ck_assert_int_eq(report.joined, right.joined);
    ck_assert_int_eq(report.triangles_before, right.triangles_before);
    ck_assert_int_eq(report.triangles, right.triangles);
    ck_assert_int_eq(report.collapsed, right.collapsed);
    ck_assert_int_eq(report.edges_before, right.edges_before);
    ck_assert_int_eq(report.edges, right.edges);
    ck_assert_int_eq(report.collapsed_edges, right.collapsed_edges);
    ck_assert_msg(report.farthest == right.farthest, "%a", report.farthest);
}

// Single meshes ---------------------------------------------------------------

START_TEST(a_seam_is_closed)
{
    weld("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
         "v 1 -0 0\nv 1 1 0\nv 0 1 0\nf 4 5 6\nl 6 2\nv 7 7 7\n",
         0);
    expect_vertices(
        &welded, 5,
        (const double[]){0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 7, 7, 7});
    expect_triangles(&welded, 2, (const int[]){0, 1, 2, 1, 3, 2});
    expect_edges(&welded, 1, (const int[]){2, 1});
    expect_report((tf_weld_report){.vertices_before = 7,
                                   .vertices = 5,
                                   .joined = 2,
                                   .triangles_before = 2,
                                   .triangles = 2,
                                   .edges_before = 1,
                                   .edges = 1});
    ck_assert(welded.format == TF_OBJ && welded.first_index == 1);
    ck_assert_int_eq(welded.triangle_place.item[1], 8);
    free_all();
}
END_TEST

START_TEST(what_collapses_is_left_out)
{
    // A needle of which nothing is left, and a sliver beside a triangle.
    weld("v 9 9 9\nv 9 9 9.25\nv 9 9.25 9\nf 1 2 3\n"
         "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 1 0.25\nf 4 5 6\nf 6 5 7\n"
         "l 6 7\nl 7 4\nv 5 5 5\nl 1 2\n",
         0.25);
    expect_vertices(&welded, 4,
                    (const double[]){0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 5, 5});
    expect_triangles(&welded, 1, (const int[]){0, 1, 2});
    expect_edges(&welded, 1, (const int[]){2, 0});
    static const int numbers[] = {-1, -1, -1, 0, 1, 2, 2, 3};
    ck_assert_mem_eq(number, numbers, sizeof numbers);
    expect_report((tf_weld_report){.vertices_before = 8,
                                   .vertices = 4,
                                   .joined = 3,
                                   .triangles_before = 3,
                                   .triangles = 1,
                                   .collapsed = 2,
                                   .edges_before = 3,
                                   .edges = 1,
                                   .collapsed_edges = 2,
                                   .farthest = 0.25});
    free_all();
}
END_TEST

/// The corners of the faces of the welded mesh, in brackets.
static const char *faces(void)
{
    static char text[200];
    text[0] = '\0';
    for (tf_face face = {0}; tf_mesh_file_next_face(&welded, &face);) {
        strcat(text, "(");
        for (int i = 0; i < face.corners; i++)
            sprintf(text + strlen(text), "%d", face.corner[i]);
        strcat(text, ")");
    }
    return text;
}

#define PENTAGON "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\n"

START_TEST(polygons_stay_polygons)
{
    static const struct {
        const char *text, *faces;
    } polygons[] = {
        {PENTAGON "f 1 2 3 4 5\n", "(01234)"},
        {PENTAGON "v 2 1 0\nv 3 1 0\nv 3 2 0\nv 1 2 0\nf 1 2 3 4 5\n"
                  "f 6 7 8 9\n",
         "(01234)(2563)"},
        // Neighbors are joined: the first and the last, others.
        {PENTAGON "v 0 0 0\nf 1 2 3 4 5 6\n", "(01234)"},
        {PENTAGON "v 2 1 0\nf 1 2 3 6 4 5\n", "(01234)"},
        // A quad becomes a triangle; nothing is left of one.
        {"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 1 1 0\nf 1 2 3 4\n", "(012)"},
        {"v 0 0 0\nv 1 0 0\nv 1 0 0\nv 0 0 0\nf 1 2 3 4\nv 5 5 5\nf 1 2 5\n",
         "(012)"},
        // Nothing is left of a quad either if corners across are joined.
        {"v 0 0 0\nv 1 0 0\nv 0 0 0\nv 0 1 0\nf 1 2 3 4\n"
         "v 5 5 5\nv 5 6 5\nf 1 5 6\n",
         "(012)"},
        // A hexagon becomes a pentagon.
        {"v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\n"
         "f 3 4 5 6 1 2\n",
         "(23401)"},
        // Corners across are joined, and the triangles of the polygon stay.
        {"v 0 0 0\nv 2 0 0\nv 1 1 0\nv 2 2 0\nv 0 2 0\nv 1 1 0\n"
         "f 1 2 3 4 5 6\n",
         "(012)(023)(034)(042)"},
    };
    for (size_t i = 0; i < sizeof polygons / sizeof *polygons; i++) {
        weld(polygons[i].text, 0);
        ck_assert_str_eq(faces(), polygons[i].faces);
        free_all();
    }
}
END_TEST

START_TEST(columns_are_those_of_what_is_left)
{
    weld("ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\n"
         "property double y\nproperty double z\nproperty uchar red\n"
         "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0 0 10\n1 0 0 20\n0 1 0 30\n1 0 0 40\n3 0 1 2\n3 0 3 2\n",
         0);
    ck_assert_int_eq(carried.count, 1);
    ck_assert_str_eq(carried.column[0].name, "red");
    ck_assert_uint_eq(carried.rows, 3);
    for (int v = 0; v < 3; v++)
        ck_assert(tf_columns_row(&carried, v)[0] == 10 * (v + 1));
    ck_assert_ptr_eq(welded.columns, &carried);
    free_all();
}
END_TEST

START_TEST(columns_need_not_be_there)
{
    file = good_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    ck_assert(tf_weld(&file, 0, NULL, number, &welded, NULL, &report));
    ck_assert_ptr_null(welded.columns);
    expect_triangles(&welded, 1, (const int[]){0, 1, 2});
    tf_mesh_file_free(&file);
    tf_mesh_file_free(&welded);
}
END_TEST

// Any mesh --------------------------------------------------------------------

/// A text of triangles and edges upon a small lattice.
static void make_soup(generator *random, char text[20000])
{
    int vertices = 3 + below(random, 40), at = 0;
    for (int v = 0; v < vertices; v++)
        at += sprintf(text + at, "v %d %d %g\n", below(random, 3),
                      below(random, 3), 0.25 * below(random, 5));
    for (int t = 0; t < vertices; t++) {
        int a = below(random, vertices), b = below(random, vertices),
            c = below(random, vertices);
        if (a != b && b != c && c != a)
            at += sprintf(text + at, "f %d %d %d\n", a + 1, b + 1, c + 1);
        if (a != b && t % 3 == 0)
            at += sprintf(text + at, "l %d %d\n", a + 1, b + 1);
    }
    sprintf(text + at, "f 1 2 3\n");
}

/// Expects the items of the file, each corner by the position that it is moved
/// to, but for those that collapse.
static void expect_items(const int first[], const tf_ints *before,
                         const tf_ints *after, int corners)
{
    size_t kept = 0;
    for (size_t i = 0; i < before->count; i += (size_t)corners) {
        const int *own = before->item + i;
        bool collapsed = false;
        for (int j = 0; j < corners; j++)
            for (int k = 0; k < j; k++)
                collapsed = collapsed || first[own[j]] == first[own[k]];
        for (int j = 0; j < corners && !collapsed; j++)
            ck_assert_mem_eq(welded.position.item +
                                 3 * (size_t)after->item[kept++],
                             file.position.item + 3 * (size_t)first[own[j]],
                             3 * sizeof(double));
    }
    ck_assert_uint_eq(after->count, kept);
}

START_TEST(every_corner_is_where_its_vertex_is_left)
{
    generator random = generator_new(0x3e1);
    for (long i = 0; i < cases(3000); i++) {
        static const double within[] = {0, 0.25, 0.5, 1};
        static char text[20000];
        int first[50];
        double distance = within[below(&random, 4)];
        make_soup(&random, text);
        weld(text, distance);
        ck_assert(tf_find_coincident(tf_mesh_file_vertices(&file),
                                     file.position.item, distance, first));
        expect_items(first, &file.triangle, &welded.triangle, 3);
        expect_items(first, &file.edge, &welded.edge, 2);
        ck_assert_int_eq(report.triangles + report.collapsed,
                         report.triangles_before);
        ck_assert_int_eq(report.edges + report.collapsed_edges,
                         report.edges_before);
        ck_assert(report.farthest <= distance);
        // What is welded stays as it is.
        tf_mesh_file again;
        tf_columns unused = {0};
        tf_weld_report second;
        ck_assert(tf_weld(&welded, distance, &carried, number, &again, &unused,
                          &second));
        ck_assert(second.joined == 0 && second.collapsed == 0);
        ck_assert_int_eq(second.vertices, report.vertices);
        ck_assert_uint_eq(again.triangle.count, welded.triangle.count);
        tf_mesh_file_free(&again);
        tf_columns_free(&unused);
        free_all();
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("scenes/weld");
    TCase *single = tcase_create("single meshes");
    tcase_add_test(single, a_seam_is_closed);
    tcase_add_test(single, what_collapses_is_left_out);
    tcase_add_test(single, polygons_stay_polygons);
    tcase_add_test(single, columns_are_those_of_what_is_left);
    tcase_add_test(single, columns_need_not_be_there);
    suite_add_tcase(suite, single);

    TCase *any = tcase_create("any mesh");
    tcase_add_test(any, every_corner_is_where_its_vertex_is_left);
    suite_add_tcase(suite, any);
    return suite;
}

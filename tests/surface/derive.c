// What is derived from a mesh, against a table of all pairs of vertices.
#include "surface/derive.h"

#include "support/support.h"
#include "support/surfaces.h"

#include <limits.h>
#include <signal.h>
#include <string.h>

static bool joined[SURFACE_VERTICES][SURFACE_VERTICES];

static void join(int a, int b)
{
    joined[a < b ? a : b][a < b ? b : a] = true;
}

static void join_all(const tf_mesh *mesh)
{
    memset(joined, 0, sizeof joined);
    for (int i = 0; i < mesh->triangles; i++)
        for (int c = 0; c < 3; c++)
            join(mesh->triangle[3 * i + c],
                 mesh->triangle[3 * i + (c + 1) % 3]);
    for (int i = 0; i < mesh->edges; i++)
        join(mesh->edge[2 * i], mesh->edge[2 * i + 1]);
}

START_TEST(edges_are_those_of_the_elements)
{
    static surface_case given;
    generator random = generator_new(0);
    for (int i = 0; i < (int)cases(2000); i++) {
        random_surface(&random, 2 + i % 2, 1 + i % 40, ANYWHERE, &given);
        tf_elements triangles = {0}, edges = {0};
        tf_sort_workspace workspace = {0};
        ck_assert(tf_mesh_triangles(&given.mesh, &triangles, &workspace));
        ck_assert(tf_mesh_edges(&given.mesh, &triangles, &edges, &workspace));
        join_all(&given.mesh);
        int count = 0;
        for (int a = 0; a < given.mesh.vertices; a++)
            for (int b = 0; b < given.mesh.vertices; b++)
                if (joined[a][b]) {
                    ck_assert_int_eq(edges.corner[2 * count], a);
                    ck_assert_int_eq(edges.corner[2 * count + 1], b);
                    count++;
                }
        ck_assert_int_eq(edges.count, count);
        tf_buffer_free(&triangles.storage);
        tf_buffer_free(&edges.storage);
        tf_sort_workspace_free(&workspace);
    }
}
END_TEST

// Three triangles at one edge, one of them listed twice.
START_TEST(triangles_are_listed_once)
{
    static const int triangle[] = {4, 0, 1, 1, 0, 2, 0, 1, 3, 1, 2, 0};
    static const int expected[] = {0, 1, 2, 0, 1, 3, 0, 1, 4};
    tf_mesh mesh = {
        .axes = 3, .vertices = 5, .triangles = 4, .triangle = triangle};
    tf_elements triangles = {0}, edges = {0};
    tf_sort_workspace workspace = {0};
    ck_assert(tf_mesh_triangles(&mesh, &triangles, &workspace));
    ck_assert_int_eq(triangles.count, 3);
    ck_assert_mem_eq(triangles.corner, expected, sizeof expected);
    ck_assert(tf_mesh_edges(&mesh, &triangles, &edges, &workspace));
    ck_assert_int_eq(edges.count, 7);
    tf_buffer_free(&triangles.storage);
    tf_buffer_free(&edges.storage);
    tf_sort_workspace_free(&workspace);
}
END_TEST

static void expect_flaw(const tf_mesh *mesh, tf_status expected,
                        tf_subject element, int index, int vertex)
{
    tf_error error = {0};
    ck_assert_int_eq(tf_mesh_check(mesh, &error), expected);
    ck_assert_int_eq(error.subject, element);
    if (element != TF_NO_SUBJECT) {
        ck_assert_uint_eq(error.index, (size_t)(index));
        ck_assert_int_eq(error.vertex[0], vertex);
    }
}

START_TEST(flaws_are_named)
{
    static const int triangle[] = {0, 1, 2, 2, 1, 3}, edge[] = {3, 4, 0, 5};
    static const int twice[] = {0, 1, 2, 3, 1, 3};
    tf_mesh mesh = {3, 6, 2, triangle, 2, edge};
    expect_flaw(&mesh, TF_OK, TF_NO_SUBJECT, 0, 0);
    mesh.vertices = 5;
    expect_flaw(&mesh, TF_BAD_INDEX, TF_EDGE, 1, 5);
    mesh.vertices = 3;
    expect_flaw(&mesh, TF_BAD_INDEX, TF_TRIANGLE, 1, 3);
    mesh.vertices = 6;
    mesh.triangle = twice;
    expect_flaw(&mesh, TF_BAD_INDEX, TF_TRIANGLE, 1, 3);
    mesh.triangle = (int[]){0, -1, 2, 0, 1, 2};
    expect_flaw(&mesh, TF_BAD_INDEX, TF_TRIANGLE, 0, -1);
    mesh.triangles = INT_MAX / 3;
    expect_flaw(&mesh, TF_BAD_COUNT, TF_NO_SUBJECT, 0, 0);
    mesh.triangles = mesh.edges = 0;
    expect_flaw(&mesh, TF_NO_ELEMENTS, TF_NO_SUBJECT, 0, 0);
}
END_TEST

static const int three[] = {0, 1, 2};

/// The axes, and the counts.  No list is as long.
static const tf_mesh absurd[] = {
    {3, -1, 1, three, 0, NULL},
    {3, INT_MIN, 1, three, 0, NULL},
    {3, INT_MAX, 1, three, 0, NULL},
    {3, INT_MAX / 3 + 1, 1, three, 0, NULL},
    {3, 3, -1, three, 0, NULL},
    {3, 3, INT_MAX, three, 0, NULL},
    {3, 3, INT_MAX / 3 + 1, three, 0, NULL},
    {3, 3, 1, three, -1, NULL},
    {3, 3, 1, three, 1, NULL},
    {3, 3, 1, NULL, 0, NULL},
    {3, 3, 0, NULL, INT_MAX, three},
    {2, 3, 0, NULL, INT_MAX / 2 + 1, three},
    {2, INT_MAX / 2 + 1, 0, NULL, 1, three},
};

START_TEST(absurd_counts_are_refused)
{
    expect_flaw(&absurd[_i], TF_BAD_COUNT, TF_NO_SUBJECT, 0, 0);
    tf_mesh other = absurd[_i];
    static const int axes[] = {0, 1, 4, -1, INT_MAX, INT_MIN};
    for (int i = 0; i < 6; i++) {
        other.axes = axes[i];
        expect_flaw(&other, TF_BAD_AXES, TF_NO_SUBJECT, 0, 0);
    }
}
END_TEST

START_TEST(the_plane_has_no_triangles)
{
    tf_mesh mesh = {
        .axes = 2, .vertices = 3, .triangles = 1, .triangle = (int[]){0, 1, 2}};
    expect_flaw(&mesh, TF_BAD_AXES, TF_NO_SUBJECT, 0, 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/derive");
    TCase *tcase = tcase_create("derive");
    tcase_add_test(tcase, edges_are_those_of_the_elements);
    tcase_add_test(tcase, triangles_are_listed_once);
    tcase_add_test(tcase, flaws_are_named);
    tcase_add_test(tcase, the_plane_has_no_triangles);
    tcase_add_loop_test(tcase, absurd_counts_are_refused, 0,
                        sizeof absurd / sizeof *absurd);
    suite_add_tcase(suite, tcase);
    return suite;
}

// Meshes that are joined, and taken apart again.
#include "scenes/joined.h"

#include "support/meshes.h"
#include "support/support.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#define FIRST "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nf 1 2 3\n"
#define SECOND "v 0 0\nv 1 1\nl 2 1\n"
#define THIRD "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 3 2 1\nf 1 2 3\nl 1 3\n"

static tf_mesh_file file[3];
static const tf_mesh_file *const files[] = {&file[0], &file[1], &file[2]};
static tf_joined joined;

static void join_three(void)
{
    static const char *const texts[] = {FIRST, SECOND, THIRD};
    for (int i = 0; i < 3; i++)
        file[i] = good_mesh(texts[i]);
    ck_assert(tf_joined_make(&joined, 3, files));
}

static void free_three(void)
{
    for (int i = 0; i < 3; i++)
        tf_mesh_file_free(&file[i]);
    tf_joined_free(&joined);
    ck_assert(!joined.first_vertex && joined.meshes == 0);
}

// Joined ----------------------------------------------------------------------

START_TEST(elements_follow_each_other)
{
    static const int triangles[] = {0, 1, 2, 8, 7, 6, 6, 7, 8};
    static const int edges[] = {5, 4, 6, 8};
    int *triangle, *edge;
    ck_assert_int_eq(tf_joined_vertices(&joined), 9);
    ck_assert_int_eq(joined.first_triangle[3], 3);
    ck_assert_int_eq(joined.first_edge[3], 2);
    ck_assert(tf_joined_elements(&joined, files, &triangle, &edge));
    ck_assert_mem_eq(triangle, triangles, sizeof triangles);
    ck_assert_mem_eq(edge, edges, sizeof edges);
    free(triangle);
    free(edge);
}
END_TEST

START_TEST(a_mesh_may_have_no_vertex_of_another)
{
    static const char *const texts[] = {FIRST "f 1 2 5\n", SECOND "l 2 3\n"};
    static const struct {
        long line;
        const char *fault;
    } faults[] = {{6, "there is no vertex 5; they are numbered from 1 to 4"},
                  {4, "there is no vertex 3; they are numbered from 1 to 2"}};
    for (int i = 0; i < 2; i++) {
        tf_mesh_file bad = good_mesh(texts[i]), next = good_mesh(THIRD);
        tf_joined other;
        ck_assert(
            !tf_joined_make(&other, 2, (const tf_mesh_file *[]){&bad, &next}));
        ck_assert_str_eq(bad.fault->text, faults[i].fault);
        ck_assert_int_eq(bad.fault->place, faults[i].line);
        tf_joined_free(&other);
        tf_mesh_file_free(&bad);
        tf_mesh_file_free(&next);
    }
}
END_TEST

START_TEST(too_many_vertices_are_a_fault)
{
    // Only the counts are looked at.
    tf_mesh_file large = empty_mesh("large"), small = empty_mesh("small");
    tf_joined other;
    large.vertex_place.count = INT_MAX / 4;
    small.vertex_place.count = 1;
    ck_assert(tf_joined_make(&other, 1, (const tf_mesh_file *[]){&large}));
    tf_joined_free(&other);
    ck_assert(
        !tf_joined_make(&other, 2, (const tf_mesh_file *[]){&large, &small}));
    ck_assert_str_eq(small.fault->text,
                     "with the meshes before it, more than 536870911 vertices, "
                     "triangles or edges; divide the scene");
    ck_assert_str_eq(small.fault->file, "small");
    tf_joined_free(&other);
}
END_TEST

// Taken apart -----------------------------------------------------------------

START_TEST(each_vertex_has_a_mesh)
{
    static const int meshes[] = {0, 0, 0, 0, 1, 1, 2, 2, 2};
    for (int v = 0; v < 9; v++) {
        int mesh[2], vertex = v;
        ck_assert_int_eq(tf_joined_mesh(&joined, v), meshes[v]);
        tf_joined_localize(&joined, 1, &vertex, 1, mesh);
        ck_assert(mesh[0] == meshes[v] && mesh[1] == meshes[v]);
        ck_assert_int_eq(vertex, v - joined.first_vertex[meshes[v]]);
    }
}
END_TEST

START_TEST(each_of_two_elements_has_a_mesh)
{
    int mesh[2], edges[] = {5, 4, 0, 3}, point[] = {8, 4, 5, -1};
    tf_joined_localize(&joined, 4, edges, 2, mesh);
    ck_assert(mesh[0] == 1 && mesh[1] == 0);
    ck_assert_mem_eq(edges, ((int[]){1, 0, 0, 3}), sizeof edges);
    tf_joined_localize(&joined, 4, point, 1, mesh);
    ck_assert(mesh[0] == 2 && mesh[1] == 1);
    ck_assert_mem_eq(point, ((int[]){2, 0, 1, -1}), sizeof point);
}
END_TEST

/// Compares with meshes of random sizes, some without vertices, and a search
/// from the front.
START_TEST(any_number_of_meshes_is_told_apart)
{
    generator random = generator_new(0x101);
    for (long i = 0; i < cases(2000); i++) {
        int first[10] = {0}, meshes = 1 + below(&random, 9);
        for (int m = 0; m < meshes; m++)
            first[m + 1] = first[m] + below(&random, 4);
        tf_joined many = {meshes, first, first, first};
        for (int v = 0, m = 0; v < first[meshes]; v++) {
            while (first[m + 1] <= v)
                m++;
            ck_assert_int_eq(tf_joined_mesh(&many, v), m);
        }
    }
}
END_TEST

static const struct {
    tf_error joined, own;
    int mesh[2];
} errors[] = {
    {{.subject = TF_NO_SUBJECT, .vertex = {-1, -1, -1, -1, -1}},
     {.subject = TF_NO_SUBJECT, .vertex = {-1, -1, -1, -1, -1}},
     {0, 0}},
    {{.subject = TF_VERTEX, .index = 5, .vertex = {5, -1, -1, -1, -1}},
     {.subject = TF_VERTEX,
      .index = 1,
      .vertex = {1, -1, -1, -1, -1},
      .vertices = 2},
     {1, 1}},
    {{.subject = TF_TRIANGLE, .index = 2, .vertex = {7, -1, -1, -1, -1}},
     {.subject = TF_TRIANGLE,
      .index = 1,
      .vertex = {1, -1, -1, -1, -1},
      .vertices = 3},
     {2, 2}},
    {{.subject = TF_EDGE, .index = 0, .vertex = {4, 5, -1, -1, -1}},
     {.subject = TF_EDGE,
      .index = 0,
      .vertex = {0, 1, -1, -1, -1},
      .vertices = 2},
     {1, 1}},
    {{.subject = TF_POINT_TRIANGLE_PAIR, .vertex = {3, 6, 7, 8, -1}},
     {.subject = TF_POINT_TRIANGLE_PAIR, .vertex = {3, 0, 1, 2, -1}},
     {0, 2}},
    {{.subject = TF_EDGE_EDGE_PAIR, .vertex = {4, 5, 6, 8, -1}},
     {.subject = TF_EDGE_EDGE_PAIR, .vertex = {0, 1, 0, 2, -1}},
     {1, 2}},
    {{.subject = TF_EDGE_TRIANGLE_PAIR, .vertex = {6, 8, 0, 1, 2}},
     {.subject = TF_EDGE_TRIANGLE_PAIR, .vertex = {0, 2, 0, 1, 2}},
     {2, 0}},
    {{.subject = TF_POINT_EDGE_PAIR, .vertex = {5, 0, 1, -1, -1}},
     {.subject = TF_POINT_EDGE_PAIR, .vertex = {1, 0, 1, -1, -1}},
     {1, 0}},
};

START_TEST(errors_are_those_of_a_mesh)
{
    tf_error error = errors[_i].joined;
    const tf_error *right = &errors[_i].own;
    int mesh[2];
    tf_joined_localize_error(&joined, &error, mesh);
    ck_assert_uint_eq(error.index, right->index);
    ck_assert_int_eq(error.vertices, right->vertices);
    ck_assert_mem_eq(error.vertex, right->vertex, sizeof error.vertex);
    ck_assert_mem_eq(mesh, errors[_i].mesh, sizeof mesh);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("scenes/joined");
    TCase *join = tcase_create("joined");
    tcase_add_checked_fixture(join, join_three, free_three);
    tcase_add_test(join, elements_follow_each_other);
    tcase_add_test(join, a_mesh_may_have_no_vertex_of_another);
    tcase_add_test(join, too_many_vertices_are_a_fault);
    suite_add_tcase(suite, join);

    TCase *apart = tcase_create("taken apart");
    tcase_add_checked_fixture(apart, join_three, free_three);
    tcase_add_test(apart, each_vertex_has_a_mesh);
    tcase_add_test(apart, each_of_two_elements_has_a_mesh);
    tcase_add_test(apart, any_number_of_meshes_is_told_apart);
    tcase_add_loop_test(apart, errors_are_those_of_a_mesh, 0,
                        sizeof errors / sizeof *errors);
    suite_add_tcase(suite, apart);
    return suite;
}

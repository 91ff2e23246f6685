// What makes a surface, and what is wrong with what does not.
#include "surface/surface.h"

#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"
#include "surface/detect.h"

#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

static tf_status create(const tf_mesh *mesh, tf_error *error)
{
    tf_surface *surface = NULL;
    tf_status status = tf_surface_create(mesh, &surface, error);
    ck_assert_int_eq(surface != NULL, status == TF_OK);
    tf_surface_free(surface);
    return status;
}

// Elements --------------------------------------------------------------------

static void check_list(int corners, int count, const int list[], int expected,
                       const int expected_list[])
{
    ck_assert_int_eq(count, expected);
    ck_assert_mem_eq(list, expected_list,
                     sizeof *list * (size_t)(corners * count));
}

START_TEST(elements_are_sorted_and_listed_once)
{
    static const int triangle[] = {4, 2, 0, 3, 1, 2, 0, 4, 2, 2, 4, 3};
    static const int edge[] = {5, 6, 1, 3, 6, 5, 0, 5};
    tf_mesh mesh = {.axes = 3,
                    .vertices = 7,
                    .triangles = 4,
                    .triangle = triangle,
                    .edges = 4,
                    .edge = edge};
    tf_surface *surface = surface_of(&mesh);
    int count;
    const int *list = tf_surface_triangles(surface, &count);
    static const int triangles[] = {0, 2, 4, 1, 2, 3, 2, 3, 4};
    check_list(3, count, list, 3, triangles);
    list = tf_surface_edges(surface, &count);
    static const int edges[] = {0, 2, 0, 4, 0, 5, 1, 2, 1,
                                3, 2, 3, 2, 4, 3, 4, 5, 6};
    check_list(2, count, list, 9, edges);
    ck_assert_int_eq(tf_surface_axes(surface), 3);
    ck_assert_int_eq(tf_surface_vertices(surface), 7);
    ck_assert_uint_gt(tf_surface_memory(surface), 0);
    tf_surface_free(surface);
}
END_TEST

static int compare_edges(const void *first, const void *second)
{
    const int *a = first, *b = second;
    return a[0] != b[0] ? a[0] - b[0] : a[1] - b[1];
}

static void add_edge(int *list, int *count, int a, int b)
{
    list[2 * *count] = a < b ? a : b;
    list[2 * (*count)++ + 1] = a < b ? b : a;
}

/// The edges of a mesh by sorting all of them.
static int list_edges(const tf_mesh *mesh, int list[])
{
    int count = 0, kept = 0;
    for (int i = 0; i < 3 * mesh->triangles; i++)
        add_edge(list, &count, mesh->triangle[i],
                 mesh->triangle[i - i % 3 + (i + 1) % 3]);
    for (int i = 0; i < mesh->edges; i++)
        add_edge(list, &count, mesh->edge[2 * i], mesh->edge[2 * i + 1]);
    qsort(list, (size_t)count, 2 * sizeof *list, compare_edges);
    for (int i = 0; i < count; i++)
        if (i == 0 || compare_edges(list + 2 * i, list + 2 * (kept - 1)) != 0)
            memmove(list + 2 * kept++, list + 2 * i, 2 * sizeof *list);
    return kept;
}

START_TEST(edges_of_random_surfaces_are_complete)
{
    static surface_case given;
    static int expected[8 * SURFACE_ELEMENTS];
    generator random = generator_new(1);
    for (int i = 0; i < (int)cases(200); i++) {
        random_surface(&random, 2 + i % 2, SURFACE_ELEMENTS, ANYWHERE, &given);
        tf_surface *surface = surface_of(&given.mesh);
        int count;
        const int *list = tf_surface_edges(surface, &count);
        check_list(2, count, list, list_edges(&given.mesh, expected), expected);
        tf_surface_free(surface);
    }
}
END_TEST

// Trouble ---------------------------------------------------------------------

START_TEST(bad_indices_are_named)
{
    static const int worse[] = {-1, 3, INT_MAX, INT_MIN};
    static const int good[6] = {0, 1, 2, 1, 2, 0};
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 4; j++) {
            int bad[6];
            memcpy(bad, good, sizeof bad);
            bad[i] = worse[j];
            tf_mesh triangles = {
                .axes = 3, .vertices = 3, .triangles = 2, .triangle = bad};
            tf_error error;
            ck_assert_int_eq(create(&triangles, &error), TF_BAD_INDEX);
            ck_assert_int_eq(error.subject, TF_TRIANGLE);
            ck_assert_uint_eq(error.index, (size_t)(i / 3));
            ck_assert_int_eq(error.vertex[0], worse[j]);
            tf_mesh edges = {.axes = 2, .vertices = 3, .edges = 3, .edge = bad};
            ck_assert_int_eq(create(&edges, &error), TF_BAD_INDEX);
            ck_assert_int_eq(error.subject, TF_EDGE);
            ck_assert_uint_eq(error.index, (size_t)(i / 2));
            ck_assert_int_eq(error.vertex[0], worse[j]);
        }
}
END_TEST

START_TEST(repeated_vertices_are_named)
{
    static const int bad[][3] = {{0, 0, 1}, {1, 0, 1}, {2, 1, 1}};
    for (int i = 0; i < 3; i++) {
        tf_mesh mesh = {
            .axes = 3, .vertices = 3, .triangles = 1, .triangle = bad[i]};
        tf_error error;
        ck_assert_int_eq(create(&mesh, &error), TF_BAD_INDEX);
        ck_assert_int_eq(error.subject, TF_TRIANGLE);
        ck_assert_int_eq(error.vertex[0], i == 0 ? 0 : 1);
        ck_assert_int_eq(create(&mesh, NULL), TF_BAD_INDEX);
    }
}
END_TEST

START_TEST(a_surface_has_elements)
{
    tf_mesh mesh = {.axes = 3, .vertices = 5};
    tf_error error;
    ck_assert_int_eq(create(&mesh, &error), TF_NO_ELEMENTS);
    ck_assert_int_eq(error.subject, TF_NO_SUBJECT);
}
END_TEST

START_TEST(impossible_meshes_are_refused)
{
    static const int corner[] = {0, 1, 2};
    const tf_mesh good = {
        .axes = 3, .vertices = 3, .triangles = 1, .triangle = corner};
    tf_mesh flat = good, higher = good, unlisted = good, negative = good;
    flat.axes = 2;
    higher.axes = 4;
    unlisted.triangle = NULL;
    negative.edges = -1;
    ck_assert_int_eq(create(&flat, NULL), TF_BAD_AXES);
    ck_assert_int_eq(create(&higher, NULL), TF_BAD_AXES);
    ck_assert_int_eq(create(&unlisted, NULL), TF_BAD_COUNT);
    ck_assert_int_eq(create(&negative, NULL), TF_BAD_COUNT);
}
END_TEST

// Filters ---------------------------------------------------------------------

static const int one_corner[] = {0, 1, 2};
static const tf_mesh one_triangle = {
    .axes = 3, .vertices = 4, .triangles = 1, .triangle = one_corner};

static bool wants(void *context, const tf_element_pair *pair)
{
    (void)context;
    (void)pair;
    return true;
}

START_TEST(groups_are_as_many_as_vertices)
{
    static const int group[5] = {0};
    const tf_pair_filter bad[] = {{.group = group},
                                  {.vertices = 4},
                                  {.vertices = 3, .group = group},
                                  {.vertices = 5, .group = group},
                                  {.vertices = -4, .group = group},
                                  {.vertices = 1, .wanted = wants}};
    const tf_pair_filter good[] = {
        {0},
        {.vertices = 4, .group = group},
        {.wanted = wants},
        {.size = sizeof(tf_pair_filter), .vertices = 4, .group = group}};
    tf_surface *surface = surface_of(&one_triangle);
    tf_error error;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        ck_assert_int_eq(tf_surface_set_filter(surface, &bad[i], &error),
                         TF_BAD_COUNT);
        ck_assert_int_eq(error.status, TF_BAD_COUNT);
    }
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        ck_assert_int_eq(tf_surface_set_filter(surface, &good[i], &error),
                         TF_OK);
        ck_assert_int_eq(error.status, TF_OK);
    }
    ck_assert_int_eq(
        tf_surface_set_filter(surface, &(tf_pair_filter){.size = 8}, &error),
        TF_BAD_OPTION);
    ck_assert_str_eq(error.option, "size");
    tf_surface_free(surface);
}
END_TEST

/// A vertex that goes through the triangle.
static size_t count_contacts(tf_surface *surface)
{
    static const double start[] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 1};
    static const double end[] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, -1};
    const tf_motion motion = {3, 4, start, end};
    tf_contacts found;
    ck_assert_int_eq(tf_detect(surface, &motion, NULL, &found, NULL), TF_OK);
    return found.count;
}

START_TEST(groups_are_copied)
{
    int group[] = {1, 1, 1, 1};
    tf_surface *surface = surface_of(&one_triangle);
    size_t bytes = tf_surface_memory(surface);
    tf_pair_filter filter = {.vertices = 4, .group = group};
    ck_assert_uint_eq(count_contacts(surface), 1);
    ck_assert_int_eq(tf_surface_set_filter(surface, &filter, NULL), TF_OK);
    ck_assert_uint_ge(tf_surface_memory(surface), bytes + sizeof group);
    for (int i = 0; i < 4; i++)
        group[i] = i;
    ck_assert_uint_eq(count_contacts(surface), 0);
    ck_assert_int_eq(tf_surface_set_filter(surface, &filter, NULL), TF_OK);
    ck_assert_uint_eq(count_contacts(surface), 1);
    tf_surface_free(surface);
}
END_TEST

START_TEST(a_bad_filter_leaves_the_last_one)
{
    static const int group[] = {1, 1, 1, 1};
    tf_surface *surface = surface_of(&one_triangle);
    tf_pair_filter filter = {.vertices = 4, .group = group};
    ck_assert_int_eq(tf_surface_set_filter(surface, &filter, NULL), TF_OK);
    filter.vertices = 3;
    ck_assert_int_eq(tf_surface_set_filter(surface, &filter, NULL),
                     TF_BAD_COUNT);
    ck_assert_uint_eq(count_contacts(surface), 0);
    tf_surface_free(surface);
}
END_TEST

START_TEST(a_filter_of_no_surface_breaks_the_contract)
{
    tf_surface_set_filter(NULL, NULL, NULL);
}
END_TEST

START_TEST(freeing_nothing_does_nothing)
{
    tf_surface_free(NULL);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/surface");
    TCase *tcase = tcase_create("surface");
    tcase_add_test(tcase, elements_are_sorted_and_listed_once);
    tcase_add_test(tcase, edges_of_random_surfaces_are_complete);
    tcase_add_test(tcase, bad_indices_are_named);
    tcase_add_test(tcase, repeated_vertices_are_named);
    tcase_add_test(tcase, a_surface_has_elements);
    tcase_add_test(tcase, impossible_meshes_are_refused);
    tcase_add_test(tcase, freeing_nothing_does_nothing);
    suite_add_tcase(suite, tcase);

    TCase *filters = tcase_create("filters");
    tcase_add_test(filters, groups_are_as_many_as_vertices);
    tcase_add_test(filters, groups_are_copied);
    tcase_add_test(filters, a_bad_filter_leaves_the_last_one);
    tcase_add_test_raise_signal(
        filters, a_filter_of_no_surface_breaks_the_contract, SIGABRT);
    suite_add_tcase(suite, filters);
    return suite;
}

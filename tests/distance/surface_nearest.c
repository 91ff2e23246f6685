// The nearest point of a surface, against distances in rational numbers.
#include "distance/surface_nearest.h"

#include "support/environments.h"
#include "support/exact_distance.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const double *place(const surface_case *given, int vertex)
{
    return given->start + (ptrdiff_t)given->mesh.axes * vertex;
}

/// Whether an element, with its last vertex repeated, is nearer than a length.
static bool is_nearer(const surface_case *given, const double point[],
                      int corners, const int corner[], double length)
{
    int axes = given->mesh.axes;
    const double *x[4] = {point};
    for (int i = 0; i < axes; i++)
        x[1 + i] = place(given, corner[i < corners ? i : corners - 1]);
    tf_kind kind = axes == 2 ? TF_POINT_EDGE : TF_POINT_TRIANGLE;
    return exact_distance_compare(kind, x, length) < 0;
}

static void expect_none_nearer(const surface_case *given,
                               const tf_surface *surface, const double point[],
                               double length)
{
    int edges, triangles;
    const int *edge = tf_surface_edges(surface, &edges);
    const int *triangle = tf_surface_triangles(surface, &triangles);
    for (int i = 0; i < triangles; i++)
        ck_assert(!is_nearer(given, point, 3, triangle + 3 * i, length));
    for (int i = 0; i < edges; i++)
        ck_assert(!is_nearer(given, point, 2, edge + 2 * i, length));
    for (int v = 0; v < given->mesh.vertices; v++)
        ck_assert(!is_nearer(given, point, 1, &v, length));
}

START_TEST(no_element_is_nearer)
{
    static surface_case given;
    generator random = generator_new((uint64_t)_i);
    for (long i = cases(20); i > 0; i--) {
        random_surface(&random, 2 + (int)(i % 2), 8, (placement)_i, &given);
        tf_surface *surface = surface_of(&given.mesh);
        // A point that another vertex moves to, so of the same size.
        const double *point = given.end;
        tf_surface_point found;
        ck_assert_int_eq(tf_surface_nearest(surface, given.mesh.vertices,
                                            given.start, point, &found, NULL),
                         TF_OK);
        expect_none_nearer(&given, surface, point, found.lower);
        ck_assert(isinf(found.upper) ||
                  is_nearer(&given, point, found.corners, found.vertex,
                            nextafter(found.upper, INFINITY)));
        double sum = 0;
        for (int j = 0; j < 3; j++)
            sum += found.barycentric[j];
        ck_assert_double_eq_tol(sum, 1, 1e-14);
        tf_surface_free(surface);
    }
}
END_TEST

// A triangle, an edge and a particle.
static const int triangle[] = {0, 1, 2}, edge[] = {3, 4};
static const double at[] = {0, 0, 0, 4, 0, 0, 0, 4,  0,
                            9, 0, 0, 9, 4, 0, 0, 20, 0};

static tf_surface *new_surface(void)
{
    return surface_of(&(tf_mesh){.axes = 3,
                                 .vertices = 6,
                                 .triangles = 1,
                                 .triangle = triangle,
                                 .edges = 1,
                                 .edge = edge});
}

START_TEST(elements_of_all_kinds_are_found)
{
    static const double points[3][3] = {{1, 1, 2}, {9, 2, 3}, {0, 20, 5}};
    static const double distances[] = {2, 3, 5};
    tf_surface *surface = new_surface();
    for (int i = 0; i < 3; i++) {
        tf_surface_point found;
        ck_assert_int_eq(
            tf_surface_nearest(surface, 6, at, points[i], &found, NULL), TF_OK);
        ck_assert_int_eq(found.corners, 3 - i);
        ck_assert(found.lower <= distances[i] && distances[i] <= found.upper);
        ck_assert_double_eq(found.barycentric[0], i < 2 ? 0.5 : 1);
        ck_assert_int_eq(found.vertex[0], i == 0 ? 0 : 1 + 2 * i);
        for (int j = found.corners; j < 3; j++)
            ck_assert_int_eq(found.vertex[j], -1);
    }
    tf_surface_free(surface);
}
END_TEST

// Of several that are as near, a triangle comes before an edge, this before a
// vertex, and of a kind the first one.
START_TEST(the_first_of_the_nearest_is_found)
{
    static const int triangles[] = {0, 1, 2, 0, 1, 3};
    static const double place[] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 0, -4, 0};
    static const double points[2][3] = {{-1, -1, 1}, {2, 0, 1}};
    tf_surface *surface = surface_of(&(tf_mesh){
        .axes = 3, .vertices = 4, .triangles = 2, .triangle = triangles});
    for (int i = 0; i < 2; i++) {
        static const int first[] = {0, 1, 2};
        tf_surface_point found;
        const double *point = points[i];
        ck_assert_int_eq(
            tf_surface_nearest(surface, 4, place, point, &found, NULL), TF_OK);
        if (i > 0)
            ck_assert_mem_eq(found.vertex, first, sizeof first);
        ck_assert_int_eq(found.corners, 3);
    }
    tf_surface_free(surface);
}
END_TEST

/// What is nearest to the origin: an edge, or one of the particles behind it.
static tf_surface_point nearest_to_origin(int vertices, const double place[])
{
    static const double origin[3] = {0};
    static const int first[] = {0, 1};
    tf_surface *surface = surface_of(
        &(tf_mesh){.axes = 3, .vertices = vertices, .edges = 1, .edge = first});
    tf_surface_point found;
    ck_assert_int_eq(
        tf_surface_nearest(surface, vertices, place, origin, &found, NULL),
        TF_OK);
    tf_surface_free(surface);
    return found;
}

START_TEST(a_nearer_particle_stays)
{
    static const double place[] = {9, 9, 9, 8, 8, 8, 0, 0, 7, 0, 5, 0, 4, 4, 4};
    tf_surface_point found = nearest_to_origin(5, place);
    ck_assert_int_eq(found.corners, 1);
    ck_assert_int_eq(found.vertex[0], 3);
    ck_assert(found.lower <= 5 && found.upper >= 5);
}
END_TEST

START_TEST(a_distance_beyond_all_doubles_has_a_point)
{
    static const double place[] = {DBL_MAX, DBL_MAX, DBL_MAX,
                                   DBL_MAX, DBL_MAX, DBL_MAX / 2};
    tf_surface_point found = nearest_to_origin(2, place);
    ck_assert_int_eq(found.corners, 2);
    ck_assert_int_eq(found.vertex[1], 1);
    ck_assert(isinf(found.upper) && found.lower == DBL_MAX);
}
END_TEST

START_TEST(bad_positions_are_told)
{
    tf_surface *surface = new_surface();
    tf_surface_point found;
    tf_error error;
    ck_assert_int_eq(tf_surface_nearest(surface, 5, at, at, &found, &error),
                     TF_BAD_COUNT);
    for (int i = 0; i < 18; i++) {
        double bad[18];
        memcpy(bad, at, sizeof bad);
        bad[i] = i % 2 ? NAN : INFINITY;
        ck_assert_int_eq(
            tf_surface_nearest(surface, 6, bad, at, &found, &error),
            TF_NOT_FINITE);
        ck_assert_int_eq(error.vertex[0], i / 3);
        ck_assert_int_eq(error.time, -1);
        if (i < 3)
            ck_assert_int_eq(
                tf_surface_nearest(surface, 6, at, bad, &found, &error),
                TF_NOT_FINITE);
    }
    tf_surface_free(surface);
}
END_TEST

START_TEST(a_broken_environment_is_told)
{
    tf_surface *surface = new_surface();
    tf_surface_point found = {.corners = 42};
    environment_break(_i);
    tf_status status = tf_surface_nearest(surface, 6, at, at, &found, NULL);
    environment_restore();
    ck_assert_int_eq(status, TF_BAD_ENVIRONMENT);
    ck_assert_int_eq(found.corners, 42);
    tf_surface_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("distance/surface_nearest");
    TCase *tcase = tcase_create("surface_nearest");
    tcase_add_loop_test(tcase, no_element_is_nearer, 0, PLACEMENTS);
    tcase_add_test(tcase, elements_of_all_kinds_are_found);
    tcase_add_test(tcase, the_first_of_the_nearest_is_found);
    tcase_add_test(tcase, a_nearer_particle_stays);
    tcase_add_test(tcase, a_distance_beyond_all_doubles_has_a_point);
    tcase_add_test(tcase, bad_positions_are_told);
    tcase_add_loop_test(tcase, a_broken_environment_is_told, 0, environments());
    suite_add_tcase(suite, tcase);
    return suite;
}

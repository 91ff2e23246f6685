// Where vertices come from after remeshing: their places are interpolated from
// the old ones, on the sheet that they are on.
#include "remesh/origins.h"

#include "remesh/remesh.h"
#include "support/adaptive_surfaces.h"
#include "support/support.h"
#include "support/surgery_runs.h"
#include "surgery/adaptive_surface.h"
#include "surgery/collapse.h"
#include "surgery/move.h"
#include "surgery/split.h"
#include "surgery/star.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// The old surface -------------------------------------------------------------

/// A surface as it was before it is remeshed.
static struct {
    int vertices;
    double *position;
    int *triangle;
} old;

static void *copy_of(const void *from, size_t size)
{
    void *made = malloc(size);
    ck_assert_ptr_nonnull(made);
    return memcpy(made, from, size);
}

static void note(const tf_adaptive_surface *surface)
{
    const tf_mesh *mesh = tf_adaptive_mesh(surface);
    old.vertices = mesh->vertices;
    old.position =
        copy_of(tf_adaptive_positions(surface), 24 * (size_t)mesh->vertices);
    old.triangle = copy_of(mesh->triangle, 12 * (size_t)mesh->triangles);
}

static void forget(void)
{
    free(old.position);
    free(old.triangle);
}

/// Remeshes a surface, and notes how it was.
static void remesh(tf_adaptive_surface *surface, double edge)
{
    const tf_remesh_options how = {.edge = edge};
    note(surface);
    ck_assert_int_eq(tf_adaptive_remesh(surface, &how, NULL, NULL), TF_OK);
}

static double value_at(const tf_origin *origin, const double value[], int size,
                       int k)
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        int vertex = old.triangle[3 * origin->triangle + i];
        sum += origin->barycentric[i] * value[size * vertex + k];
    }
    return sum;
}

// Places ----------------------------------------------------------------------

static void expect_weights(const tf_origin *origin)
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        ck_assert_double_ge(origin->barycentric[i], 0);
        sum += origin->barycentric[i];
    }
    ck_assert_double_eq_tol(sum, 1, 1e-15);
}

/// How far a vertex is from where it comes from.
static double error_of(const tf_adaptive_surface *surface, int vertex)
{
    const tf_origin *origin = tf_adaptive_origins(surface) + vertex;
    double square = 0;
    expect_weights(origin);
    for (int k = 0; k < 3; k++) {
        double x = coordinates_of(surface, vertex)[k];
        double off = value_at(origin, old.position, 3, k) - x;
        square += off * off;
    }
    return sqrt(square);
}

/// The greatest error.
static double error_in(const tf_adaptive_surface *surface)
{
    double most = 0;
    for (int v = 0; v < surface->vertices; v++)
        most = fmax(most, error_of(surface, v));
    return most;
}

START_TEST(vertices_are_where_they_come_from)
{
    static surgery_run run;
    static surgery_counts counts;
    static const double fractions[] = {2, 1, 0.5, 0.25};
    for (int i = 0; i < 4; i++) {
        surgery_run_begin(&run, generator_new((uint64_t)_i),
                          (adaptive_scene_kind)_i, &counts);
        remesh(run.surface, run.scene.unit * fractions[i]);
        ck_assert_double_lt(error_in(run.surface), 1e-15 * 5);
        forget();
        surgery_run_end(&run);
    }
}
END_TEST

static bool is_corner(const tf_origin *origin)
{
    return origin->barycentric[0] == 1 || origin->barycentric[1] == 1 ||
           origin->barycentric[2] == 1;
}

static int old_vertex_of(const tf_origin *origin)
{
    int most = 0;
    for (int i = 1; i < 3; i++)
        if (origin->barycentric[i] > origin->barycentric[most])
            most = i;
    return old.triangle[3 * origin->triangle + most];
}

// A box keeps its corners; a vertex that does not come from a corner is new.
START_TEST(a_vertex_that_has_not_moved_comes_from_a_corner)
{
    static adaptive_scene scene;
    static const int low[] = {0, 0, 0}, high[] = {1, 2, 3};
    scene = (adaptive_scene){0};
    add_box(&scene, low, high);
    tf_mesh mesh = adaptive_scene_mesh(&scene);
    tf_adaptive_surface *surface = NULL;
    ck_assert_int_eq(tf_adaptive_create(&mesh, scene.position, &surface, NULL),
                     TF_OK);
    remesh(surface, 0.6);
    int corners = 0, found = 0;
    for (int v = 0; v < surface->vertices; v++) {
        const tf_origin *origin = tf_adaptive_origins(surface) + v;
        const double *x = coordinates_of(surface, v);
        found += (x[0] == 0 || x[0] == 1) && (x[1] == 0 || x[1] == 2) &&
                 (x[2] == 0 || x[2] == 3);
        if (!is_corner(origin))
            continue;
        corners++;
        ck_assert_mem_eq(x, old.position + 3 * old_vertex_of(origin), 24);
        ck_assert_double_eq(origin->barycentric[0] + origin->barycentric[1] +
                                origin->barycentric[2],
                            1);
    }
    ck_assert_int_eq(found, 8);
    ck_assert_int_ge(corners, 8);
    ck_assert_int_lt(corners, surface->vertices);
    forget();
    tf_adaptive_free(surface);
}
END_TEST

// Whatever is linear in the position is carried over as that.
START_TEST(linear_functions_are_carried_over)
{
    static surgery_run run;
    static surgery_counts counts;
    static double value[LABELLED];
    surgery_run_begin(&run, generator_new((uint64_t)_i), LINKED_TORI, &counts);
    generator random = generator_new(50 + (uint64_t)_i);
    double slope[3], most = 0;
    for (int k = 0; k < 3; k++)
        slope[k] = uniform(&random, -2, 2);
    remesh(run.surface, run.scene.unit * uniform(&random, 0.3, 1.5));
    for (int v = 0; v < old.vertices; v++) {
        const double *x = old.position + 3 * v;
        value[v] = 1 + slope[0] * x[0] + slope[1] * x[1] + slope[2] * x[2];
    }
    for (int v = 0; v < run.surface->vertices; v++) {
        const double *x = coordinates_of(run.surface, v);
        double wanted = 1 + slope[0] * x[0] + slope[1] * x[1] + slope[2] * x[2];
        double got =
            value_at(tf_adaptive_origins(run.surface) + v, value, 1, 0);
        most = fmax(most, fabs(got - wanted));
    }
    ck_assert_double_lt(most, 1e-14);
    forget();
    surgery_run_end(&run);
}
END_TEST

// Sharp edges and the boundary ------------------------------------------------

/// Whether an origin is on the boundary, exactly.
static bool is_on_boundary(const tf_adaptive_surface *before,
                           const tf_origin *origin)
{
    for (int i = 0; i < 3; i++) {
        int corner = 3 * origin->triangle + i, apex = (i + 2) % 3;
        if (origin->barycentric[apex] == 0 &&
            tf_is_boundary_edge(before, corner))
            return true;
        if (origin->barycentric[i] == 1 &&
            tf_is_boundary_vertex(before, tf_vertex_at(before, corner)))
            return true;
    }
    return false;
}

/// A flat disc, its boundary a polygon of so many sides, with rings of triangles.
static tf_adaptive_surface *disc(int sides)
{
    enum {
        MOST = 64,
        RINGS = 4
    };
    static double position[RINGS * MOST + 1][3];
    static int triangle[6 * RINGS * MOST];
    int count = 0;
    for (int i = 0; i < RINGS * sides; i++) {
        int ring = i / sides,
            next = i % sides == sides - 1 ? i + 1 - sides : i + 1;
        double turn = 2 * acos(-1) * i / sides, r = (ring + 1.0) / RINGS;
        position[1 + i][0] = r * cos(turn);
        position[1 + i][1] = r * sin(turn);
        const int out[] = {1 + i, 1 + i + sides,    1 + next + sides,
                           1 + i, 1 + next + sides, 1 + next};
        const int in[] = {0, 1 + i, 1 + next};
        for (int k = 0; ring == 0 && k < 3; k++)
            triangle[count++] = in[k];
        for (int k = 0; ring + 1 < RINGS && k < 6; k++)
            triangle[count++] = out[k];
    }
    return adaptive_of(RINGS * sides + 1, position, count / 3, triangle);
}

START_TEST(the_boundary_comes_from_the_boundary)
{
    static const int sides[] = {5, 13, 40};
    static const double edges[] = {0.08, 0.3, 0.1};
    tf_adaptive_surface *surface = disc(sides[_i]), *before = disc(sides[_i]);
    remesh(surface, edges[_i]);
    int count = 0;
    for (int v = 0; v < surface->vertices; v++) {
        const tf_origin *origin = tf_adaptive_origins(surface) + v;
        bool outside = tf_is_boundary_vertex(surface, v);
        count += outside && !is_corner(origin);
        ck_assert_int_eq(is_on_boundary(before, origin), outside);
        ck_assert_double_lt(error_of(surface, v), 1e-15);
    }
    ck_assert_int_gt(count, 2);
    forget();
    tf_adaptive_free(before);
    tf_adaptive_free(surface);
}
END_TEST

// A new vertex on an edge of a box comes from a point of one of its edges.
START_TEST(a_sharp_edge_comes_from_a_sharp_edge)
{
    static adaptive_scene scene;
    static const int low[] = {0, 0, 0}, high[] = {2, 2, 2};
    scene = (adaptive_scene){0};
    add_box(&scene, low, high);
    tf_mesh mesh = adaptive_scene_mesh(&scene);
    tf_adaptive_surface *surface = NULL;
    ck_assert_int_eq(tf_adaptive_create(&mesh, scene.position, &surface, NULL),
                     TF_OK);
    remesh(surface, 0.31);
    int count = 0;
    for (int v = 0; v < surface->vertices; v++) {
        const tf_origin *origin = tf_adaptive_origins(surface) + v;
        const double *x = coordinates_of(surface, v);
        int sides = 0, zeros = 0;
        for (int k = 0; k < 3; k++) {
            sides += x[k] == 0 || x[k] == 2;
            zeros += origin->barycentric[k] == 0;
        }
        if (sides >= 2)
            ck_assert_int_ge(zeros, 1);
        count += sides == 2 && zeros == 1;
    }
    ck_assert_int_gt(count, 20);
    forget();
    tf_adaptive_free(surface);
}
END_TEST

// Sheets ----------------------------------------------------------------------

static int old_part(const int part[], const tf_origin *origin)
{
    return part[old.triangle[3 * origin->triangle]];
}

/// Expects that each part comes from one part, and a different one each, and
/// exactly so where a vertex has not moved.
static void expect_parts(const tf_adaptive_surface *surface, int parts,
                         const int before[])
{
    static int now[LABELLED], from[SCENE_PARTS];
    ck_assert_int_eq(label_parts(surface, now), parts);
    for (int i = 0; i < parts; i++)
        from[i] = -1;
    for (int v = 0; v < surface->vertices; v++) {
        int part = old_part(before, tf_adaptive_origins(surface) + v);
        int *own = &from[now[v]];
        *own = *own < 0 ? part : *own;
        ck_assert_int_eq(*own, part);
    }
    for (int i = 0; i < parts; i++)
        for (int j = 0; j < i; j++)
            ck_assert_int_ne(from[i], from[j]);
}

// Three spheres, one in another, with a gap of 0.02, 1e-4 or 1e-9.  The finest
// take most of the time.
START_TEST(a_sphere_comes_from_itself)
{
    static surgery_run run;
    static surgery_counts counts;
    static const double fractions[] = {2, 1, 0.5, 0.25, 0.1};
    for (int i = 0; i < (cases(100) < 100 ? 4 : 5); i++) {
        surgery_run_begin(&run, generator_new((uint64_t)_i), NESTED_SPHERES,
                          &counts);
        remesh(run.surface, run.scene.unit * fractions[i]);
        expect_parts(run.surface, 3, run.part);
        forget();
        surgery_run_end(&run);
    }
}
END_TEST

enum {
    ALONG = 12, ///< squares of a sheet
    ACROSS = 8,
    SHEET = (ALONG + 1) * (ACROSS + 1)
};

/// Where a vertex of a bent sheet is, so far along its normals.
static void place(double x[3], int i, int j, double up)
{
    double turn = 2.0 * i / ALONG;
    x[0] = (1 + up) * sin(turn);
    x[1] = 2.0 * j / ACROSS;
    x[2] = (1 + up) * cos(turn);
}

static int add_squares(int triangle[], int first, bool over)
{
    int count = 0;
    for (int i = 0; i < ALONG; i++)
        for (int j = 0; j < ACROSS; j++) {
            int a = first + i * (ACROSS + 1) + j, b = a + ACROSS + 1;
            const int square[] = {a, b, b + 1, a, b + 1, a + 1};
            for (int k = 0; k < 6; k++)
                triangle[count++] = square[over ? 5 - k : k];
        }
    return count;
}

/// Two bent sheets with a gap; if they are one, folded at the end.
static tf_adaptive_surface *two_sheets(double gap, bool folded)
{
    static double position[2 * SHEET][3];
    static int triangle[24 * SHEET];
    for (int v = 0; v < 2 * SHEET; v++)
        place(position[v], v % SHEET / (ACROSS + 1), v % SHEET % (ACROSS + 1),
              v < SHEET ? 0 : gap);
    int count = add_squares(triangle, 0, folded);
    count += add_squares(triangle + count, SHEET, false);
    for (int j = 0; folded && j < ACROSS; j++) {
        int a = SHEET - ACROSS - 1 + j, b = a + SHEET;
        const int square[] = {a, a + 1, b + 1, a, b + 1, b};
        for (int k = 0; k < 6; k++)
            triangle[count++] = square[k];
    }
    return adaptive_of(2 * SHEET, position, count / 3, triangle);
}

START_TEST(a_sheet_comes_from_itself_and_not_from_one_beside)
{
    static const double gaps[] = {1e-9, 1e-6, 1e-3}, edges[] = {0.05, 0.3, 0.6};
    static int before[LABELLED];
    for (int i = 0; i < 3; i++) {
        tf_adaptive_surface *surface = two_sheets(gaps[_i], false);
        ck_assert_int_eq(label_parts(surface, before), 2);
        remesh(surface, edges[i]);
        expect_parts(surface, 2, before);
        ck_assert_double_lt(error_in(surface), 3 * gaps[_i]);
        forget();
        tf_adaptive_free(surface);
    }
}
END_TEST

/// Whether the triangles at a vertex face away from the axis of the sheets: as
/// all of the upper one do, and none of the lower one.
static double outward(const tf_adaptive_surface *surface, int vertex)
{
    double sum = 0;
    int c = tf_first_corner(surface, vertex);
    for (; c != TF_NONE; c = tf_next_corner(surface, c)) {
        const int *v = tf_triangle(surface, c / 3);
        const double *x = coordinates_of(surface, v[0]),
                     *y = coordinates_of(surface, v[1]),
                     *z = coordinates_of(surface, v[2]);
        double u[3], w[3];
        for (int k = 0; k < 3; k++) {
            u[k] = y[k] - x[k];
            w[k] = z[k] - x[k];
        }
        sum += (u[1] * w[2] - u[2] * w[1]) * x[0] +
               (u[0] * w[1] - u[1] * w[0]) * x[2];
    }
    return sum;
}

// At the fold itself a vertex may come from either, or from between.
START_TEST(a_folded_sheet_comes_from_the_same_side)
{
    static const double gaps[] = {1e-9, 1e-6, 1e-3}, edges[] = {0.05, 0.3, 0.6};
    for (int i = 0; i < 3; i++) {
        tf_adaptive_surface *surface = two_sheets(gaps[_i], true);
        remesh(surface, edges[i]);
        int moved = 0;
        for (int v = 0; v < surface->vertices; v++) {
            const tf_origin *origin = tf_adaptive_origins(surface) + v;
            const double *x = coordinates_of(surface, v);
            bool at_fold = atan2(x[0], x[2]) > 1.99;
            bool upper = old.triangle[3 * origin->triangle] >= SHEET;
            if (!at_fold)
                ck_assert_int_eq(upper, outward(surface, v) > 0);
            moved += !is_corner(origin);
        }
        ck_assert_int_gt(moved, 10);
        forget();
        tf_adaptive_free(surface);
    }
}
END_TEST

// Numbers ---------------------------------------------------------------------

// A collapsed edge leaves gaps among the numbers of triangles.
START_TEST(triangles_have_the_numbers_that_the_caller_knows)
{
    tf_adaptive_surface *surface = adaptive_sheet(6, 6);
    tf_outcome outcome;
    double place[3] = {1.5, 1, 0};
    int vertex;
    for (int i = 0; i < 2; i++) {
        ck_assert_int_eq(tf_adaptive_split(surface, 8 + 7 * i, 9 + 7 * i, place,
                                           &vertex, &outcome),
                         TF_OK);
        ck_assert_int_eq(outcome, TF_COMMITTED);
        ck_assert_int_eq(
            tf_adaptive_collapse(surface, 24 + i, 31 + i, &outcome), TF_OK);
        ck_assert_int_eq(outcome, TF_COMMITTED);
        place[1] = 2;
    }
    ck_assert_int_lt(triangles_of(surface), surface->triangles);
    remesh(surface, 0.4);
    ck_assert_double_lt(error_in(surface), 1e-15);
    forget();
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(there_are_origins_until_the_surface_is_changed)
{
    tf_adaptive_surface *surface = adaptive_sheet(2, 2);
    const double place[] = {1, 1, 0.125};
    const tf_remesh_options how = {.edge = 1}, bad = {.edge = -1};
    tf_outcome outcome;
    ck_assert_ptr_null(tf_adaptive_origins(surface));
    for (int i = 0; i < 2; i++) {
        ck_assert_int_eq(tf_adaptive_remesh(surface, &how, NULL, NULL), TF_OK);
        const tf_origin *lent = tf_adaptive_origins(surface);
        ck_assert_ptr_nonnull(lent);
        ck_assert_int_ne(tf_adaptive_remesh(surface, &bad, NULL, NULL), TF_OK);
        ck_assert_ptr_eq(tf_adaptive_origins(surface), lent);
        int inside = 0;
        while (tf_is_boundary_vertex(surface, inside))
            inside++;
        if (i == 0)
            tf_adaptive_move(surface, inside, place, &outcome);
        else
            tf_adaptive_compact(surface, NULL);
        ck_assert_ptr_null(tf_adaptive_origins(surface));
    }
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/origins");
    TCase *tcase = tcase_create("places");
    tcase_add_loop_test(tcase, vertices_are_where_they_come_from, DUST,
                        ADAPTIVE_SCENES);
    tcase_add_test(tcase, a_vertex_that_has_not_moved_comes_from_a_corner);
    tcase_add_loop_test(tcase, linear_functions_are_carried_over, 0, 5);
    suite_add_tcase(suite, tcase);
    tcase = tcase_create("edges");
    tcase_add_loop_test(tcase, the_boundary_comes_from_the_boundary, 0, 3);
    tcase_add_test(tcase, a_sharp_edge_comes_from_a_sharp_edge);
    suite_add_tcase(suite, tcase);
    tcase = tcase_create("sheets");
    tcase_add_loop_test(tcase, a_sphere_comes_from_itself, 0, 6);
    tcase_add_loop_test(
        tcase, a_sheet_comes_from_itself_and_not_from_one_beside, 0, 3);
    tcase_add_loop_test(tcase, a_folded_sheet_comes_from_the_same_side, 0, 3);
    suite_add_tcase(suite, tcase);
    tcase = tcase_create("numbers");
    tcase_add_test(tcase, triangles_have_the_numbers_that_the_caller_knows);
    tcase_add_test(tcase, there_are_origins_until_the_surface_is_changed);
    suite_add_tcase(suite, tcase);
    return suite;
}

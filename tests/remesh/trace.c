// Traces: where a vertex comes from is found along the original, on its sheet.
#include "remesh/trace.h"

#include "support/adaptive_surfaces.h"
#include "support/support.h"
#include "surgery/adaptive.h"
#include "surgery/collapse.h"
#include "surgery/star.h"

#include <math.h>

static tf_adaptive_surface *original, *surface;
static tf_original found;
static tf_trace trace;
static tf_sharp_edges edges;

/// Traces a surface that begins as the original.
static void begin(tf_adaptive_surface *make(void))
{
    const tf_sharpness sharpness = {.cosine = 0.9, .depth = INFINITY};
    original = make();
    surface = make();
    edges = (tf_sharp_edges){0};
    found = (tf_original){0};
    trace = (tf_trace){0};
    ck_assert(!tf_trace_goes(&trace));
    ck_assert_int_eq(tf_original_begin(&found, original, NULL), TF_OK);
    ck_assert_int_eq(tf_sharp_edges_find(&edges, original, &sharpness, NULL),
                     TF_OK);
    ck_assert(tf_trace_begin(&trace, &found, &edges));
    ck_assert(tf_trace_goes(&trace));
}

static void end(void)
{
    tf_trace_free(&trace);
    tf_sharp_edges_free(&edges);
    tf_original_free(&found);
    tf_adaptive_free(surface);
    tf_adaptive_free(original);
}

static tf_origin *origin_of(int vertex)
{
    return (tf_origin *)trace.origin.data + vertex;
}

/// Moves a vertex without a test, and traces it.
static const tf_origin *put(int vertex, tf_vector position, bool sharp,
                            const tf_projection *projection)
{
    static const tf_projection none = {.distance = INFINITY};
    tf_placement placed = {
        vertex, {vertex, vertex}, sharp, projection ? projection : &none};
    tf_vertex_put(surface, vertex, position.x);
    ck_assert(tf_trace_place(&trace, surface, &placed));
    return origin_of(vertex);
}

static void expect_origin(const tf_origin *origin, int triangle, double a,
                          double b, double c)
{
    ck_assert_int_eq(origin->triangle, triangle);
    ck_assert_double_eq(origin->barycentric[0], a);
    ck_assert_double_eq(origin->barycentric[1], b);
    ck_assert_double_eq(origin->barycentric[2], c);
}

// Sheets ----------------------------------------------------------------------

/// A sheet of squares from 0 to 3, the vertex i + 4 j at (i, j).
static tf_adaptive_surface *sheet(void)
{
    return adaptive_sheet(3, 3);
}

START_TEST(a_trace_begins_at_the_corners)
{
    begin(sheet);
    for (int v = 0; v < 16; v++) {
        const tf_origin *origin = origin_of(v);
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            sum += origin->barycentric[i];
            if (origin->barycentric[i] == 1)
                ck_assert_int_eq(
                    tf_vertex_at(original, 3 * origin->triangle + i), v);
        }
        ck_assert_double_eq(sum, 1);
    }
    end();
}
END_TEST

// The square from (1, 1) has the triangles 8, below the diagonal, and 9.
START_TEST(a_vertex_inside_comes_from_the_nearest_point)
{
    begin(sheet);
    expect_origin(put(5, (tf_vector){{1.5, 1.25, 0.125}}, false, NULL), 8, 0.5,
                  0.25, 0.25);
    expect_origin(put(5, (tf_vector){{1.25, 1.5, 0}}, false, NULL), 9, 0.5,
                  0.25, 0.25);
    end();
}
END_TEST

// Above the boundary, and beyond it.
START_TEST(a_vertex_on_a_sharp_edge_comes_from_one)
{
    begin(sheet);
    expect_origin(put(1, (tf_vector){{1.25, 0.125, 0}}, true, NULL), 2, 0.75,
                  0.25, 0);
    expect_origin(put(1, (tf_vector){{1.5, -0.125, 0}}, true, NULL), 2, 0.5,
                  0.5, 0);
    end();
}
END_TEST

// The nearest sharp edge is too far away: it has become sharp.
START_TEST(a_vertex_on_a_new_sharp_edge_comes_from_a_triangle)
{
    begin(sheet);
    expect_origin(put(1, (tf_vector){{1.5, 0.75, 0}}, true, NULL), 3, 0.25, 0.5,
                  0.25);
    expect_origin(put(6, (tf_vector){{1.75, 1.5, 0}}, true, NULL), 8, 0.25,
                  0.25, 0.5);
    end();
}
END_TEST

static const double gap = 1e-9;

/// A sheet that is folded at x = 3: the lower half has the vertices i + 3 j for
/// i < 3, and the upper one 6 more; those of the fold are the last two.
static tf_adaptive_surface *folded(void)
{
    static double position[14][3];
    static const int lower[] = {0, 1, 2, 12}, upper[] = {6, 7, 8, 12};
    static int triangle[36];
    int count = 0;
    for (int v = 0; v < 14; v++) {
        int i = v < 12 ? v % 3 : 3;
        position[v][0] = i;
        position[v][1] = v < 12 ? v % 6 / 3 : v - 12;
        position[v][2] = v < 6 ? 0 : gap * (3 - i);
    }
    for (int i = 0; i < 3; i++) {
        int a = lower[i], b = lower[i + 1], c = upper[i], d = upper[i + 1];
        int up = i == 2 ? 1 : 3;
        const int square[] = {a, a + 3, b + up, a, b + up, b,
                              c, d,     d + up, c, d + up, c + 3};
        for (int k = 0; k < 12; k++)
            triangle[count++] = square[k];
    }
    return adaptive_of(14, position, 12, triangle);
}

static bool is_upper(const tf_origin *origin)
{
    return origin->triangle % 4 >= 2;
}

// It is exactly where the lower sheet was, next to the fold.
START_TEST(a_vertex_stays_on_the_sheet_that_faces_as_it_does)
{
    begin(folded);
    tf_vector place = {{2.5, 0.25, 0}};
    tf_projection lowest = tf_original_project(&found, place);
    ck_assert(!is_upper(&lowest.origin));
    ck_assert_double_eq(lowest.distance, 0);
    for (int i = 0; i < 2; i++) {
        *origin_of(8) = (tf_origin){10, {0, 1, 0}}; // at the fold
        const tf_origin *origin = put(8, place, false, i ? &lowest : NULL);
        ck_assert(is_upper(origin));
        ck_assert_double_eq_tol(origin->barycentric[0], 0.5, 1e-8);
        *origin_of(2) = (tf_origin){8, {0, 0, 1}};
        ck_assert(!is_upper(put(2, place, false, i ? &lowest : NULL)));
    }
    end();
}
END_TEST

// What it was projected to is taken as it is where that is surely right.
START_TEST(a_projection_at_hand_is_taken)
{
    begin(sheet);
    tf_vector place = {{1.3, 1.1, 0}};
    tf_projection projection = tf_original_project(&found, place);
    projection.origin.barycentric[0] = 7;
    projection.point = place;
    expect_origin(put(5, place, false, &projection), 8, 7,
                  projection.origin.barycentric[1],
                  projection.origin.barycentric[2]);
    projection.distance = INFINITY; // it is none
    ck_assert_double_lt(put(5, place, false, &projection)->barycentric[0], 1);
    projection.distance = 0; // it is that of another vertex
    projection.point.x[0] = 1;
    ck_assert_double_lt(put(5, place, false, &projection)->barycentric[0], 1);
    end();
}
END_TEST

static tf_adaptive_surface *huge(void)
{
    static double position[][3] = {{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}};
    static const int triangle[] = {0, 1, 2};
    return adaptive_of(3, position, 1, triangle);
}

START_TEST(where_distances_overflow_a_vertex_comes_from_its_neighbor)
{
    begin(huge);
    expect_origin(put(0, (tf_vector){{0, 0, 1e200}}, false, NULL), 0, 1, 0, 0);
    end();
}
END_TEST

// Compaction ------------------------------------------------------------------

START_TEST(origins_follow_their_vertices)
{
    begin(sheet);
    tf_outcome outcome;
    tf_origin last = *origin_of(15), middle = *origin_of(6);
    ck_assert_int_eq(tf_adaptive_collapse(surface, 5, 6, &outcome), TF_OK);
    ck_assert_int_eq(outcome, TF_COMMITTED);
    int map[16];
    ck_assert_int_eq(tf_adaptive_compact(surface, map), TF_OK);
    tf_trace_compact(&trace, 16, map);
    ck_assert_int_eq(surface->vertices, 15);
    ck_assert_mem_eq(origin_of(14), &last, sizeof last);
    ck_assert_mem_eq(origin_of(5), &middle, sizeof middle);
    end();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/trace");
    TCase *tcase = tcase_create("traces");
    tcase_add_test(tcase, a_trace_begins_at_the_corners);
    tcase_add_test(tcase, a_vertex_inside_comes_from_the_nearest_point);
    tcase_add_test(tcase, a_vertex_on_a_sharp_edge_comes_from_one);
    tcase_add_test(tcase, a_vertex_on_a_new_sharp_edge_comes_from_a_triangle);
    tcase_add_test(tcase, a_vertex_stays_on_the_sheet_that_faces_as_it_does);
    tcase_add_test(tcase, a_projection_at_hand_is_taken);
    tcase_add_test(tcase,
                   where_distances_overflow_a_vertex_comes_from_its_neighbor);
    tcase_add_test(tcase, origins_follow_their_vertices);
    suite_add_tcase(suite, tcase);
    return suite;
}

#include "kit/surface_shape.h"

#include "kit/worlds.h"
#include "support/queries.h"
#include "support/surface_of.h"
#include "support/surfaces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SLACK 1e-12

/// A random surface and its shape, which borrows from `surface`.
typedef struct trial {
    surface_case made;
    tf_surface *surface;
    fig_shape shape;
} trial;

static void begin(trial *tried, generator *random, int axes, int elements,
                  placement placed)
{
    random_surface(random, axes, elements, placed, &tried->made);
    tried->surface = surface_of(&tried->made.mesh);
    ck_assert(fig_shape_make(&tried->shape, tried->surface, axes,
                             &tried->made.motion, FIG_UP_Z));
}

static void end(trial *tried)
{
    fig_shape_free(&tried->shape);
    tf_surface_free(tried->surface);
}

static void expect_place(tf_vector found, tf_vector expected)
{
    for (int k = 0; k < 3; k++)
        ck_assert_msg(fabs(found.x[k] - expected.x[k]) <= SLACK,
                      "axis %d: %.17g, not %.17g", k, found.x[k],
                      expected.x[k]);
}

/// The way of a vertex, in the box.
static tf_worldline way_of(const fig_shape *shape, int vertex)
{
    return tf_worldline_between(3, shape->at[0][vertex].x,
                                shape->at[1][vertex].x);
}

// The box ---------------------------------------------------------------------

START_TEST(shapes_are_similar_and_fill_the_box)
{
    generator random = generator_new(1);
    static trial tried;
    for (long n = cases(50); n > 0; n--) {
        begin(&tried, &random, 3, 20, ANYWHERE);
        const double *given[2] = {tried.made.start, tried.made.end};
        double lo[3] = {1, 1, 1}, hi[3] = {-1, -1, -1};
        double scale = fig_length(fig_difference(tried.shape.at[1][1],
                                                 tried.shape.at[0][0])) /
                       fig_length(fig_difference(fig_vector_of(given[1] + 3),
                                                 fig_vector_of(given[0])));
        for (int i = 0; i < tried.shape.vertices; i++)
            for (int t = 0; t < 2; t++) {
                tf_vector at = tried.shape.at[t][i];
                tf_vector off = fig_difference(at, tried.shape.at[0][0]);
                tf_vector from =
                    fig_difference(fig_vector_of(given[t] + 3 * (size_t)i),
                                   fig_vector_of(given[0]));
                expect_place(off, tf_vector_scaled(scale, from));
                for (int k = 0; k < 3; k++) {
                    lo[k] = fmin(lo[k], at.x[k]);
                    hi[k] = fmax(hi[k], at.x[k]);
                }
            }
        double most = 0;
        for (int k = 0; k < 3; k++) {
            ck_assert_double_eq_tol(lo[k] + hi[k], 0, SLACK);
            most = fmax(most, hi[k] - lo[k]);
        }
        ck_assert_double_eq_tol(most, 1, SLACK);
        end(&tried);
    }
}
END_TEST

START_TEST(any_axis_may_point_up)
{
    const int corner[] = {0, 1, 2};
    const double at[] = {0, 0, 0, 1, 2, 3, 0, 0, 4};
    const tf_mesh mesh = {3, 3, 1, corner, 0, NULL};
    const tf_motion rest = {3, 3, at, at};
    tf_surface *surface = surface_of(&mesh);
    for (int up = 0; up < 3; up++) {
        fig_shape shape;
        ck_assert(fig_shape_make(&shape, surface, 3, &rest, (fig_up)up));
        // The axes are turned, not mirrored.
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(shape.at[0][1].x[(k + 2 - up) % 3] -
                                        shape.at[0][0].x[(k + 2 - up) % 3],
                                    at[3 + k] / 4, SLACK);
        fig_shape_free(&shape);
    }
    tf_surface_free(surface);
}
END_TEST

// Neighbors -------------------------------------------------------------------

static bool has(const int corner[3], const int edge[2])
{
    int found = 0;
    for (int i = 0; i < 3; i++)
        found += corner[i] == edge[0] || corner[i] == edge[1];
    return found == 2;
}

START_TEST(neighbors_are_those_of_all_pairs)
{
    generator random = generator_new(2);
    static trial tried;
    for (long n = cases(50); n > 0; n--) {
        begin(&tried, &random, 3, 30, ON_LATTICE);
        const fig_shape *shape = &tried.shape;
        for (int e = 0; e < shape->edges; e++) {
            int degree = 0;
            for (int i = 0; i < shape->triangles; i++) {
                if (!has(shape->triangle + 3 * i, shape->edge + 2 * e))
                    continue;
                if (degree < 2)
                    ck_assert_int_eq(shape->beside[e][degree], i);
                degree++;
                const int *side = shape->side + 3 * i;
                ck_assert(side[0] == e || side[1] == e || side[2] == e);
            }
            ck_assert_int_eq(shape->degree[e], degree < 3 ? degree : 3);
            ck_assert_int_eq(fig_shape_edge(shape, shape->edge + 2 * e), e);
        }
        for (int i = 0; i < shape->triangles; i++)
            ck_assert_int_eq(fig_shape_triangle(shape, shape->triangle + 3 * i),
                             i);
        end(&tried);
    }
}
END_TEST

/// The parts by passing the lowest number along edges until none changes.
static void flood(const fig_shape *shape, int lowest[])
{
    bool changed = true;
    for (int i = 0; i < shape->vertices; i++)
        lowest[i] = i;
    while (changed) {
        changed = false;
        for (int e = 0; e < shape->edges; e++) {
            int a = shape->edge[2 * e], b = shape->edge[2 * e + 1];
            int low = lowest[a] < lowest[b] ? lowest[a] : lowest[b];
            changed |= lowest[a] != low || lowest[b] != low;
            lowest[a] = lowest[b] = low;
        }
    }
}

START_TEST(parts_are_connected)
{
    generator random = generator_new(3);
    static trial tried;
    for (long n = cases(100); n > 0; n--) {
        begin(&tried, &random, 2 + below(&random, 2), 60, ANYWHERE);
        const fig_shape *shape = &tried.shape;
        int lowest[SURFACE_VERTICES], parts = 0;
        bool used[SURFACE_VERTICES] = {false};
        for (int i = 0; i < 2 * shape->edges; i++)
            used[shape->edge[i]] = true;
        flood(shape, lowest);
        for (int i = 0; i < shape->vertices; i++) {
            int expected = !used[i]         ? -1
                           : lowest[i] == i ? parts++
                                            : shape->part[lowest[i]];
            ck_assert_int_eq(shape->part[i], expected);
        }
        ck_assert_int_eq(shape->parts, parts);
        end(&tried);
    }
}
END_TEST

// Motion ----------------------------------------------------------------------

static double area(const tf_vector a, const tf_vector b, const tf_vector c)
{
    return fig_length(fig_cross(fig_difference(b, a), fig_difference(c, a)));
}

static void expect_among(tf_vector place, int count, const fig_slice slice[])
{
    for (int i = 0; i < count; i++)
        for (int j = 0; j < slice[i].count; j++)
            if (fig_length(fig_difference(place, slice[i].corner[j])) < SLACK)
                return;
    ck_abort_msg("a corner is in no slice");
}

/// The area of slices, up to a factor.
static double slices_area(int count, const fig_slice slice[])
{
    double sum = 0;
    for (int i = 0; i < count; i++)
        for (int j = 2; j < slice[i].count; j++)
            sum += area(slice[i].corner[0], slice[i].corner[j - 1],
                        slice[i].corner[j]);
    return sum;
}

START_TEST(bent_triangles_are_the_slices_of_their_sweeps)
{
    generator random = generator_new(4);
    static trial tried;
    for (long n = cases(50); n > 0; n--) {
        begin(&tried, &random, 3, 10, ANYWHERE);
        double t = below(&random, 9) / 8.0;
        for (int i = 0; i < tried.shape.triangles; i++) {
            const int *corner = tried.shape.triangle + 3 * i;
            tf_worldline way[3];
            tf_simplex sweep[3];
            fig_slice slice[3];
            tf_vector piece[FIG_BENT_PIECES][3];
            for (int c = 0; c < 3; c++)
                way[c] = way_of(&tried.shape, corner[c]);
            tf_sweep(3, way, sweep);
            for (int k = 0; k < 3; k++)
                slice[k] = fig_slice_of(&sweep[k], 3, t);
            int pieces = fig_shape_pieces(&tried.shape, i, FIG_BENT, t, piece);
            double sum = 0;
            for (int k = 0; k < pieces; k++) {
                sum += area(piece[k][0], piece[k][1], piece[k][2]);
                for (int c = 0; c < 3; c++)
                    expect_among(piece[k][c], 3, slice);
            }
            ck_assert_double_eq_tol(sum, slices_area(3, slice), 1e-9);
        }
        end(&tried);
    }
}
END_TEST

START_TEST(points_are_on_the_staircase)
{
    generator random = generator_new(5);
    static trial tried;
    for (long n = cases(50); n > 0; n--) {
        begin(&tried, &random, 3, 10, ANYWHERE);
        double t = uniform(&random, 0, 1), along = uniform(&random, 0, 1);
        for (int e = 0; e < tried.shape.edges; e++) {
            const int *end_of = tried.shape.edge + 2 * e;
            const double weight[2] = {1 - along, along};
            // The edge bends where its second vertex has the weight t.
            const double bend[2] = {1 - t, t};
            tf_worldline way[2] = {way_of(&tried.shape, end_of[0]),
                                   way_of(&tried.shape, end_of[1])};
            tf_vector expected = {{0}}, line[3];
            staircase_point(3, 2, way, weight, t, expected.x);
            expect_place(
                fig_shape_point(&tried.shape, 2, end_of, weight, FIG_BENT, t),
                expected);
            ck_assert_int_eq(fig_shape_line(&tried.shape, e, FIG_BENT, t, line),
                             3);
            expect_place(line[0], fig_shape_place(&tried.shape, end_of[0], t));
            staircase_point(3, 2, way, bend, t, expected.x);
            expect_place(line[1], expected);
            expect_place(line[2], fig_shape_place(&tried.shape, end_of[1], t));
        }
        end(&tried);
    }
}
END_TEST

START_TEST(straight_elements_are_flat)
{
    generator random = generator_new(6);
    static trial tried;
    begin(&tried, &random, 3, 20, ANYWHERE);
    tf_vector piece[FIG_BENT_PIECES][3], line[3];
    for (int i = 0; i < tried.shape.triangles; i++) {
        const double weight[3] = {0.5, 0.25, 0.25};
        const int *corner = tried.shape.triangle + 3 * i;
        ck_assert_int_eq(
            fig_shape_pieces(&tried.shape, i, FIG_STRAIGHT, 0.3, piece), 1);
        tf_vector middle = {{0}};
        for (int c = 0; c < 3; c++)
            middle = fig_combination(middle, weight[c], piece[0][c]);
        expect_place(
            fig_shape_point(&tried.shape, 3, corner, weight, FIG_STRAIGHT, 0.3),
            middle);
    }
    ck_assert_int_eq(fig_shape_line(&tried.shape, 0, FIG_STRAIGHT, 0.3, line),
                     2);
    end(&tried);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("kit/surface_shape");
    TCase *shapes = tcase_create("shapes");
    tcase_add_test(shapes, shapes_are_similar_and_fill_the_box);
    tcase_add_test(shapes, any_axis_may_point_up);
    tcase_add_test(shapes, neighbors_are_those_of_all_pairs);
    tcase_add_test(shapes, parts_are_connected);
    tcase_add_test(shapes, bent_triangles_are_the_slices_of_their_sweeps);
    tcase_add_test(shapes, points_are_on_the_staircase);
    tcase_add_test(shapes, straight_elements_are_flat);
    suite_add_tcase(s, shapes);
    return s;
}

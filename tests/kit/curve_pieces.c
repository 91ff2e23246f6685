// Curves of intersection, pair by pair of triangles, and counted where one knows
// how many there are.
#define _GNU_SOURCE // M_PI

#include "kit/curve_pieces.h"

#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"

#include <math.h>
#include <stdlib.h>

// Random surfaces -------------------------------------------------------------

typedef struct trial {
    tf_surface *surface;
    fig_shape shape;
    tf_crossings found;
    fig_curve_pieces pieces;
} trial;

static void begin(trial *tried, const tf_mesh *mesh, const double x[])
{
    const tf_motion rest = {3, mesh->vertices, x, x};
    tried->surface = surface_of(mesh);
    ck_assert(
        fig_shape_make(&tried->shape, tried->surface, 3, &rest, FIG_UP_Z));
    ck_assert_int_eq(tf_surface_check(tried->surface, mesh->vertices, x, NULL,
                                      &tried->found, NULL),
                     TF_OK);
    ck_assert(fig_curve_pieces_find(&tried->pieces, &tried->shape,
                                    tried->shape.at[0], &tried->found));
}

static void end(trial *tried)
{
    fig_curve_pieces_free(&tried->pieces);
    fig_shape_free(&tried->shape);
    tf_surface_free(tried->surface);
}

static const int *corners(const trial *tried, int triangle)
{
    return tried->shape.triangle + 3 * (ptrdiff_t)triangle;
}

static int shared(const int a[3], const int b[3])
{
    int count = 0;
    for (int i = 0; i < 9; i++)
        count += a[i / 3] == b[i % 3];
    return count;
}

static bool has(const int v[3], int vertex)
{
    return v[0] == vertex || v[1] == vertex || v[2] == vertex;
}

/// How many edges of one of two triangles pass through the other.
static int passages(const trial *tried, const int a[3], const int b[3])
{
    int count = 0;
    for (size_t i = 0; i < tried->found.count; i++) {
        const int *v = tried->found.crossing[i].vertex;
        if (tried->found.crossing[i].kind == TF_EDGE_THROUGH_TRIANGLE)
            for (int k = 0; k < 2; k++) {
                const int *own = k == 0 ? a : b, *other = k == 0 ? b : a;
                count += has(own, v[0]) && has(own, v[1]) && has(other, v[2]) &&
                         has(other, v[3]) && has(other, v[4]);
            }
    }
    return count;
}

/// How many pairs of triangles intersect in a piece of a curve.
static int count_pairs(const trial *tried)
{
    int count = 0;
    for (int i = 0; i < tried->shape.triangles; i++)
        for (int j = 0; j < i; j++) {
            const int *a = corners(tried, i), *b = corners(tried, j);
            int through = passages(tried, a, b);
            count += through == 2 || (through == 1 && shared(a, b) == 1);
        }
    return count;
}

/// How far a point is from the nearest triangle that has a vertex, about.
static double distance(const trial *tried, int vertex, tf_vector from)
{
    enum {
        STEPS = 60
    };
    double least = INFINITY;
    for (int t = 0; t < tried->shape.triangles; t++) {
        const int *v = corners(tried, t);
        if (!has(v, vertex))
            continue;
        for (int i = 0; i <= STEPS; i++)
            for (int j = 0; i + j <= STEPS; j++) {
                const double w[3] = {1 - (double)(i + j) / STEPS,
                                     (double)i / STEPS, (double)j / STEPS};
                tf_vector at =
                    fig_shape_point(&tried->shape, 3, v, w, FIG_STRAIGHT, 0);
                least = fmin(least, fig_length(fig_difference(at, from)));
            }
    }
    return least;
}

START_TEST(pieces_are_where_two_triangles_are)
{
    generator random = generator_new(1);
    static surface_case made;
    int all = 0;
    for (long n = cases_at_least(10, 30); n > 0; n--) {
        trial tried;
        random_surface(&random, 3, 14, n % 3 ? ANYWHERE : ON_LATTICE, &made);
        begin(&tried, &made.mesh, made.start);
        ck_assert_msg(tried.pieces.count == count_pairs(&tried),
                      "%d, not %d, seed %llu", tried.pieces.count,
                      count_pairs(&tried), (unsigned long long)seed());
        for (int i = 0; i < tried.pieces.count; i++) {
            const fig_curve_piece *piece = &tried.pieces.piece[i];
            for (int k = 0; k < 4; k++)
                ck_assert_double_lt(
                    distance(&tried, piece->vertex[k % 2], piece->at[k / 2]),
                    0.05);
        }
        all += tried.pieces.count;
        end(&tried);
    }
    ck_assert_int_gt(all, 0);
}
END_TEST

// Known curves ----------------------------------------------------------------

enum {
    SIDE = 24,
    SHEET = SIDE * SIDE,
    HALVES = 2 * (SIDE - 1) * (SIDE - 1)
};

static double x[2 * SHEET][3];
static int triangle[2 * HALVES][3];

static void set_sheet(int which, int bumps)
{
    int count = which * HALVES, first = which * SHEET;
    for (int i = 0; i < SHEET; i++) {
        double u = (i / SIDE + 0.1 * which) / (SIDE - 1);
        double v = (i % SIDE + 0.17 * which) / (SIDE - 1);
        double *at = x[first + i];
        at[0] = u;
        at[1] = v;
        at[2] = which == 0 ? 0 : 0.501 - sin(M_PI * bumps * u) * sin(M_PI * v);
        if (i / SIDE == SIDE - 1 || i % SIDE == SIDE - 1)
            continue;
        const int a = first + i, b = a + SIDE;
        const int two[2][3] = {{a, b, a + 1}, {b, b + 1, a + 1}};
        for (int k = 0; k < 6; k++)
            triangle[count + k / 3][k % 3] = two[k / 3][k % 3];
        count += 2;
    }
}

/// Each dip of a sheet through another one is a closed curve: there are as many
/// of them as dips, and each end is that of two pieces.
START_TEST(dips_are_closed_curves)
{
    for (int bumps = 1; bumps <= 5; bumps++) {
        static int ends[100000];
        const tf_mesh mesh = {3, 2 * SHEET, 2 * HALVES, *triangle, 0, NULL};
        trial tried;
        set_sheet(0, 0);
        set_sheet(1, bumps);
        begin(&tried, &mesh, *x);
        ck_assert_int_eq(tried.pieces.curves, (bumps + 1) / 2);
        ck_assert_int_eq(tried.pieces.count, (int)tried.found.count);
        for (int i = 0; i < 100000; i++)
            ends[i] = 0;
        for (int i = 0; i < 2 * tried.pieces.count; i++)
            ends[tried.pieces.piece[i / 2].end[i % 2]]++;
        for (int i = 0; i < (int)tried.found.count; i++)
            ck_assert_int_eq(ends[i], 2);
        end(&tried);
    }
}
END_TEST

START_TEST(a_clear_surface_has_no_curves)
{
    const tf_mesh mesh = {3, 2 * SHEET, 2 * HALVES, *triangle, 0, NULL};
    trial tried;
    set_sheet(0, 0);
    set_sheet(1, 0);
    begin(&tried, &mesh, *x);
    ck_assert_int_eq(tried.pieces.count, 0);
    ck_assert_int_eq(tried.pieces.curves, 0);
    end(&tried);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("kit/curve_pieces");
    TCase *tcase = tcase_create("curves");
    tcase_add_test(tcase, pieces_are_where_two_triangles_are);
    tcase_add_test(tcase, dips_are_closed_curves);
    tcase_add_test(tcase, a_clear_surface_has_no_curves);
    suite_add_tcase(suite, tcase);
    return suite;
}

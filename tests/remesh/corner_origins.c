// Where corners come from after remeshing: on their own side of sharp edges.
#include "remesh/corner_origins.h"

#include "remesh/origins.h"
#include "remesh/remesh.h"
#include "support/adaptive_surfaces.h"
#include "support/support.h"
#include "surgery/split.h"
#include "surgery/star.h"

#include <math.h>
#include <string.h>

// A cut sheet -----------------------------------------------------------------

enum {
    SIDE = 7,
    TRIANGLES = 2 * SIDE * SIDE,
    EDGES = 3 * TRIANGLES
};

/// A flat sheet that is cut along random edges: each corner has a value, which
/// jumps at a cut and nowhere else.
static struct {
    tf_adaptive_surface *surface;
    int vertex[3 * TRIANGLES];
    double position[(SIDE + 1) * (SIDE + 1)][3];
    int keep[2 * EDGES], keeps;
    int region[TRIANGLES]; // equal where no cut is between
    double value[3 * TRIANGLES];
} sheet;

static int after(int corner)
{
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

static bool is_kept(int a, int b)
{
    for (int i = 0; i < sheet.keeps; i++) {
        const int *v = sheet.keep + 2 * i;
        if ((v[0] == a && v[1] == b) || (v[0] == b && v[1] == a))
            return true;
    }
    return false;
}

/// Whether the edges that begin at two corners are one, without a cut.
static bool are_joined(int c, int d)
{
    int a = sheet.vertex[c], b = sheet.vertex[after(c)];
    return sheet.vertex[d] == b && sheet.vertex[after(d)] == a &&
           !is_kept(a, b);
}

static double least(double a, double b)
{
    return a < b ? a : b;
}

/// Makes what differs across no cut the same, again and again.
static void join_values(void)
{
    for (int round = 0; round < TRIANGLES; round++)
        for (int c = 0; c < 3 * TRIANGLES; c++)
            for (int d = 0; d < c; d++) {
                if (!are_joined(c, d))
                    continue;
                int *r = &sheet.region[c / 3], *s = &sheet.region[d / 3];
                *r = *s = *r < *s ? *r : *s;
                double *v = sheet.value;
                v[c] = v[after(d)] = least(v[c], v[after(d)]);
                v[d] = v[after(c)] = least(v[d], v[after(c)]);
            }
}

/// Each vertex is off the lattice by so much at most.
static void cut_sheet(generator *random, double part, double off)
{
    tf_adaptive_surface *lattice = adaptive_sheet(SIDE, SIDE);
    sheet.keeps = 0;
    memcpy(sheet.vertex, tf_adaptive_mesh(lattice)->triangle,
           sizeof sheet.vertex);
    memcpy(sheet.position, tf_adaptive_positions(lattice),
           sizeof sheet.position);
    tf_adaptive_free(lattice);
    for (int v = 0; v < (SIDE + 1) * (SIDE + 1); v++)
        for (int k = 0; k < 2; k++)
            sheet.position[v][k] += uniform(random, -off, off);
    sheet.surface = adaptive_of((SIDE + 1) * (SIDE + 1), sheet.position,
                                TRIANGLES, sheet.vertex);
    for (int c = 0; c < 3 * TRIANGLES; c++) {
        int a = sheet.vertex[c], b = sheet.vertex[after(c)];
        sheet.region[c / 3] = c / 3;
        sheet.value[c] = uniform(random, 0, 1);
        if (a < b && tf_find_edge(sheet.surface, b, a) != TF_NONE &&
            uniform(random, 0, 1) < part) {
            sheet.keep[2 * sheet.keeps] = a;
            sheet.keep[2 * sheet.keeps++ + 1] = b;
        }
    }
    join_values();
}

/// Twice the area of a triangle in the plane.
static double area(const double *a, const double *b, const double *c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// The triangle of the old sheet with a point of the plane inside, of which it
/// is on no edge.
static int find_old(const double *x)
{
    int found = -1;
    for (int t = 0; t < TRIANGLES; t++) {
        const double *p[3];
        for (int i = 0; i < 3; i++)
            p[i] = sheet.position[sheet.vertex[3 * t + i]];
        if (area(x, p[0], p[1]) > 0 && area(x, p[1], p[2]) > 0 &&
            area(x, p[2], p[0]) > 0)
            found = t;
    }
    ck_assert_int_ge(found, 0);
    return found;
}

/// The value that the old sheet has at a vertex of the new one, if that is
/// approached from a point.
static double old_value(const double *x, const double *from, int *region)
{
    double near[2];
    for (int k = 0; k < 2; k++)
        near[k] = x[k] + 1e-5 * (from[k] - x[k]);
    int t = find_old(near);
    const int *v = sheet.vertex + 3 * t;
    const double *a = sheet.position[v[0]], *b = sheet.position[v[1]],
                 *c = sheet.position[v[2]];
    *region = sheet.region[t];
    return (area(x, b, c) * sheet.value[3 * t] +
            area(x, c, a) * sheet.value[3 * t + 1] +
            area(x, a, b) * sheet.value[3 * t + 2]) /
           area(a, b, c);
}

static double carried_value(const tf_origin *origin)
{
    double sum = 0;
    for (int i = 0; i < 3; i++)
        sum += origin->barycentric[i] * sheet.value[3 * origin->triangle + i];
    return sum;
}

static void expect_triangle(int triangle)
{
    const double *x[3];
    double middle[2] = {0};
    for (int i = 0; i < 3; i++) {
        x[i] = coordinates_of(sheet.surface,
                              tf_vertex_at(sheet.surface, 3 * triangle + i));
        // Not the center, which may be on a diagonal of the lattice.
        for (int k = 0; k < 2; k++)
            middle[k] += (double[]){0.31, 0.33, 0.36}[i] * x[i][k];
    }
    for (int i = 0; i < 3; i++) {
        const tf_origin *origin =
            tf_adaptive_corner_origins(sheet.surface) + 3 * triangle + i;
        int region;
        double wanted = old_value(x[i], middle, &region);
        ck_assert_double_eq_tol(carried_value(origin), wanted, 1e-12);
        ck_assert_int_eq(sheet.region[origin->triangle], region);
    }
}

// Cuts end inside, cross, and go around: whatever side a corner is on, it has the
// value of that side.
START_TEST(a_corner_stays_on_its_side_of_cuts)
{
    static const double parts[] = {0.03, 0.1, 0.2, 0.4, 0.7};
    static const double edges[] = {0.29, 0.6, 1.3, 3};
    generator random = generator_new((uint64_t)_i);
    for (long run = 0; run < cases(20); run++) {
        cut_sheet(&random, parts[run % 5], 0);
        const tf_remesh_options how = {.size = sizeof how,
                                       .edge = edges[_i],
                                       .keeps = sheet.keeps,
                                       .keep = sheet.keep};
        ck_assert_int_eq(tf_adaptive_remesh(sheet.surface, &how, NULL, NULL),
                         TF_OK);
        for (int t = 0; t < sheet.surface->triangles; t++)
            expect_triangle(t);
        tf_adaptive_free(sheet.surface);
    }
}
END_TEST

// Where cuts become straighter, a vertex may be beyond them; its corners still
// come from the region of their triangle.
START_TEST(a_triangle_comes_from_one_region)
{
    static const double edges[] = {0.1, 0.2, 0.3, 0.6};
    generator random = generator_new((uint64_t)_i);
    for (long run = 0; run < cases(20); run++) {
        cut_sheet(&random, 0.6, 0.02);
        const tf_remesh_options how = {.size = sizeof how,
                                       .edge = edges[_i],
                                       .keeps = sheet.keeps,
                                       .keep = sheet.keep};
        ck_assert_int_eq(tf_adaptive_remesh(sheet.surface, &how, NULL, NULL),
                         TF_OK);
        const tf_origin *origin = tf_adaptive_corner_origins(sheet.surface);
        for (int c = 0; c < 3 * sheet.surface->triangles; c++) {
            ck_assert_int_eq(sheet.region[origin[c].triangle],
                             sheet.region[origin[c / 3 * 3].triangle]);
            const double *x =
                coordinates_of(sheet.surface, tf_vertex_at(sheet.surface, c));
            for (int k = 0; k < 2; k++) {
                double from = 0;
                for (int i = 0; i < 3; i++)
                    from +=
                        origin[c].barycentric[i] *
                        sheet.position[sheet.vertex[3 * origin[c].triangle + i]]
                                      [k];
                ck_assert_double_eq_tol(from, x[k], 0.02);
            }
        }
        tf_adaptive_free(sheet.surface);
    }
}
END_TEST

// On a sheet of 4 x 4 squares that is cut across its middle, a vertex in the lower
// half, and one on the cut, seem to come from the upper half.
START_TEST(no_corner_comes_from_beyond_a_cut)
{
    static const int keep[] = {10, 11, 11, 12, 12, 13, 13, 14};
    const tf_sharpness sharpness = {-2, INFINITY, 4, keep};
    tf_adaptive_surface *surface = adaptive_sheet(4, 4);
    tf_adaptive_surface *before = adaptive_sheet(4, 4);
    tf_remesher remesher = {.surface = surface, .original.surface = before};
    ck_assert_int_eq(
        tf_sharp_edges_find(&remesher.sharp_before, before, &sharpness, NULL),
        TF_OK);
    ck_assert(tf_sharp_edges_copy(&remesher.sharp, &remesher.sharp_before));
    ck_assert(tf_trace_begin(&remesher.trace, &remesher.original,
                             &remesher.sharp_before));
    tf_origin *of = remesher.trace.origin.data;
    of[6] = of[12] = (tf_origin){29, {0.25, 0.25, 0.5}};
    ck_assert_int_eq(tf_corner_origins_find(&remesher, &remesher.corner_origin),
                     TF_OK);
    const tf_origin *origin = remesher.corner_origin.data;
    for (int c = 0; c < 3 * surface->triangles; c++) {
        ck_assert_int_eq(origin[c].triangle / 16, c / 3 / 16);
        for (int k = 0; k < 3; k++) {
            double x = 0;
            for (int i = 0; i < 3; i++)
                x += origin[c].barycentric[i] *
                     coordinates_of(
                         before,
                         tf_vertex_at(before, 3 * origin[c].triangle + i))[k];
            ck_assert_double_eq(
                x, coordinates_of(surface, tf_vertex_at(surface, c))[k]);
        }
    }
    remesher.original.surface = NULL;
    tf_remesher_free(&remesher);
    tf_adaptive_free(surface);
    tf_adaptive_free(before);
}
END_TEST

// A globe ---------------------------------------------------------------------

enum {
    MERIDIANS = 24,
    PARALLELS = 11,
    GLOBE = MERIDIANS * PARALLELS + 2
};

/// A globe with the vertex i + MERIDIANS j on a meridian and a parallel, and with
/// its poles last.
static tf_adaptive_surface *globe(void)
{
    static double position[GLOBE][3];
    static int triangle[6 * MERIDIANS * PARALLELS];
    int count = 0;
    for (int v = 0; v < GLOBE - 2; v++) {
        double turn = 2 * acos(-1) * (v % MERIDIANS) / MERIDIANS;
        double up = acos(-1) * (v / MERIDIANS + 1) / (PARALLELS + 1);
        position[v][0] = sin(up) * cos(turn);
        position[v][1] = sin(up) * sin(turn);
        position[v][2] = -cos(up);
        int east = v % MERIDIANS == MERIDIANS - 1 ? v + 1 - MERIDIANS : v + 1;
        bool first = v < MERIDIANS, last = v >= GLOBE - 2 - MERIDIANS;
        const int cap[] = {GLOBE - 2, east, v}, top[] = {GLOBE - 1, v, east};
        const int square[] = {
            v, east, v + MERIDIANS, east, east + MERIDIANS, v + MERIDIANS};
        for (int k = 0; k < 3 && first; k++)
            triangle[count++] = cap[k];
        for (int k = 0; k < 6; k++)
            if (last ? k < 3 : true)
                triangle[count++] = last ? top[k] : square[k];
    }
    position[GLOBE - 2][2] = -1;
    position[GLOBE - 1][2] = 1;
    return adaptive_of(GLOBE, position, count / 3, triangle);
}

/// The longitude at a corner of the old globe, from 0 to MERIDIANS; in the middle
/// of its triangle at a pole.
static double longitude_at(const tf_adaptive_surface *before, int corner)
{
    int a = tf_vertex_at(before, after(corner));
    int b = tf_vertex_at(before, after(after(corner)));
    int v = tf_vertex_at(before, corner);
    double x = v % MERIDIANS, y = a % MERIDIANS, z = b % MERIDIANS;
    bool wraps = (v < GLOBE - 2 && fabs(x - (a < GLOBE - 2 ? y : z)) > 2) ||
                 (a < GLOBE - 2 && b < GLOBE - 2 && fabs(y - z) > 2);
    y += wraps && y == 0 ? MERIDIANS : 0;
    z += wraps && z == 0 ? MERIDIANS : 0;
    if (v >= GLOBE - 2)
        return (y + z) / 2;
    return wraps && x == 0 ? MERIDIANS : x;
}

// At the seam of a globe, where the longitude jumps by all of them, no triangle
// has longitudes of both sides, and each is nearly right.
START_TEST(a_seam_of_a_globe_stays_one)
{
    static const double edges[] = {0.1, 0.2, 0.5};
    tf_adaptive_surface *surface = globe(), *before = globe();
    int keep[2 * (PARALLELS + 1)] = {GLOBE - 2, 0};
    for (int j = 0; j < PARALLELS; j++) {
        keep[2 * j + 2] = MERIDIANS * j;
        keep[2 * j + 3] = j + 1 < PARALLELS ? MERIDIANS * (j + 1) : GLOBE - 1;
    }
    const tf_remesh_options how = {.size = sizeof how,
                                   .edge = edges[_i],
                                   .keeps = PARALLELS + 1,
                                   .keep = keep};
    ck_assert_int_eq(tf_adaptive_remesh(surface, &how, NULL, NULL), TF_OK);
    const tf_origin *origin = tf_adaptive_corner_origins(surface);
    int on_seam = 0;
    for (int c = 0; c < 3 * surface->triangles; c++) {
        const double *x = coordinates_of(surface, tf_vertex_at(surface, c));
        double got = 0, turn = atan2(x[1], x[0]) / (2 * acos(-1));
        for (int i = 0; i < 3; i++)
            got += origin[c].barycentric[i] *
                   longitude_at(before, 3 * origin[c].triangle + i);
        if (x[0] * x[0] + x[1] * x[1] < 0.1)
            continue;
        double wanted = turn < 0 ? MERIDIANS * (turn + 1) : MERIDIANS * turn;
        if (fabs(x[1]) < 1e-9 && x[0] > 0) { // on the seam, by its triangle
            double y = 0;
            for (int i = 0; i < 3; i++)
                y += coordinates_of(surface,
                                    tf_vertex_at(surface, c / 3 * 3 + i))[1];
            wanted = y > 0 ? 0 : MERIDIANS;
            on_seam++;
        }
        ck_assert_double_eq_tol(got, wanted, 0.3);
    }
    ck_assert_int_gt(on_seam, 10);
    tf_adaptive_free(surface);
    tf_adaptive_free(before);
}
END_TEST

// Without sharp edges there are no sides.
START_TEST(elsewhere_corners_come_from_where_vertices_do)
{
    tf_adaptive_surface *surface = globe();
    const int corner_kept[] = {40, 40}; // a corner alone is no sharp edge
    const tf_remesh_options how = {.size = sizeof how,
                                   .edge = 0.2,
                                   .crease = 60,
                                   .keeps = 1,
                                   .keep = corner_kept};
    ck_assert_ptr_null(tf_adaptive_corner_origins(surface));
    ck_assert_int_eq(tf_adaptive_remesh(surface, &how, NULL, NULL), TF_OK);
    const tf_origin *origin = tf_adaptive_origins(surface);
    const tf_origin *corner = tf_adaptive_corner_origins(surface);
    for (int c = 0; c < 3 * surface->triangles; c++)
        ck_assert_mem_eq(&corner[c], &origin[tf_vertex_at(surface, c)],
                         sizeof *corner);
    int vertex;
    tf_outcome outcome;
    int a = tf_vertex_at(surface, 0), b = tf_vertex_at(surface, 1);
    double middle[3];
    for (int k = 0; k < 3; k++)
        middle[k] =
            (coordinates_of(surface, a)[k] + coordinates_of(surface, b)[k]) / 2;
    ck_assert_int_eq(
        tf_adaptive_split(surface, a, b, middle, &vertex, &outcome), TF_OK);
    ck_assert_int_eq(outcome, TF_COMMITTED);
    ck_assert_ptr_null(tf_adaptive_corner_origins(surface));
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/corner_origins");
    TCase *tcase = tcase_create("corners");
    tcase_add_loop_test(tcase, a_corner_stays_on_its_side_of_cuts, 0, 4);
    tcase_add_loop_test(tcase, a_triangle_comes_from_one_region, 0, 4);
    tcase_add_test(tcase, no_corner_comes_from_beyond_a_cut);
    tcase_add_loop_test(tcase, a_seam_of_a_globe_stays_one, 0, 3);
    tcase_add_test(tcase, elsewhere_corners_come_from_where_vertices_do);
    suite_add_tcase(suite, tcase);
    return suite;
}

// Tangles that are untangled, or are not, and say so.
#include "untangle/untangle.h"

#include "response/resolve.h"
#include "support/failing_memory.h"
#include "support/hash.h"
#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "surface/check.h"

#include <math.h>
#include <string.h>

// Inputs ----------------------------------------------------------------------

enum {
    SIDE = 9, ///< vertices of a sheet
    MOST = 2 * SIDE * SIDE,
    LOOP = 24
};

static double in[3 * MOST], out[3 * MOST];
static int triangle[3 * 4 * SIDE * SIDE], edge[2 * 2 * LOOP];
static bool fixed[MOST];
static tf_mesh mesh;

/// Adds a sheet, whose vertices are at i u + j v + from.
static void add_sheet(const double u[3], const double v[3],
                      const double from[3])
{
    int first = mesh.vertices;
    for (int i = 0; i < SIDE * SIDE; i++)
        for (int k = 0; k < 3; k++)
            in[3 * (first + i) + k] =
                i / SIDE * u[k] + i % SIDE * v[k] + from[k];
    for (int i = 0; i < SIDE * SIDE; i++) {
        int a = first + i;
        if (i % SIDE == SIDE - 1 || i / SIDE == SIDE - 1)
            continue;
        const int corner[6] = {a,     a + 1,        a + SIDE,
                               a + 1, a + SIDE + 1, a + SIDE};
        memcpy(triangle + 3 * mesh.triangles, corner, sizeof corner);
        mesh.triangles += 2;
    }
    mesh.vertices += SIDE * SIDE;
}

static void begin_mesh(int axes)
{
    mesh = (tf_mesh){.axes = axes, .triangle = triangle, .edge = edge};
    memset(fixed, 0, sizeof fixed);
}

/// A sheet, and another one that a bump of it passes through.
static void make_bump(void)
{
    begin_mesh(3);
    add_sheet((double[]){1, 0, 0}, (double[]){0, 1, 0},
              (double[]){-6, -6, 0.4});
    add_sheet((double[]){1, 0, 0}, (double[]){0, 1, 0},
              (double[]){-5.9, -5.8, 0});
    for (int i = 0; i < SIDE * SIDE; i++) {
        double *x = in + 3 * i;
        x[2] -= 3 / (1 + x[0] * x[0] + x[1] * x[1]);
    }
}

/// Two sheets that pass through each other from one side to the other.
static void make_cross(void)
{
    begin_mesh(3);
    add_sheet((double[]){1, 0, 0}, (double[]){0, 1, 0.03},
              (double[]){-6, -6, 0});
    add_sheet((double[]){0.9, 0, 0.4}, (double[]){0.03, 1, 0},
              (double[]){-5.8, -5.9, -2.3});
}

/// Two copies of a sheet at the same place.
static void make_copies(void)
{
    begin_mesh(3);
    for (int i = 0; i < 2; i++)
        add_sheet((double[]){1, 0, 0}, (double[]){0, 1, 0},
                  (double[]){0, 0, 0});
}

/// In the plane: two loops that overlap.
static void make_loops(void)
{
    begin_mesh(2);
    for (int i = 0; i < 2 * LOOP; i++) {
        int first = i / LOOP * LOOP;
        double angle = 6.283185307179586 * (i - first) / LOOP + 0.1;
        in[2 * i] = 4 * cos(angle) + (first > 0 ? 6.1 : 0);
        in[2 * i + 1] = 4 * sin(angle) + (first > 0 ? 0.3 : 0);
        edge[2 * i] = i;
        edge[2 * i + 1] = first + (i - first + 1) % LOOP;
    }
    mesh.vertices = mesh.edges = 2 * LOOP;
}

/// A Klein bottle, of which every embedding in space crosses itself: a figure 8
/// that turns around by half while it goes around a circle.
static void make_klein_bottle(void)
{
    enum {
        LONG = 12,
        AROUND = 8
    };
    const double turn = 6.283185307179586;
    begin_mesh(3);
    for (int i = 0; i < LONG; i++)
        for (int j = 0; j < AROUND; j++) {
            double u = turn * i / LONG, v = turn * (j + 0.5) / AROUND;
            double up = sin(v), off = sin(2 * v);
            double radius = 3 + cos(u / 2) * up - sin(u / 2) * off;
            double *x = in + 3 * (AROUND * i + j);
            x[0] = radius * cos(u);
            x[1] = radius * sin(u);
            x[2] = sin(u / 2) * up + cos(u / 2) * off;
        }
    mesh.vertices = LONG * AROUND;
    for (int i = 0; i < LONG; i++)
        for (int j = 0; j < AROUND; j++) {
            // Once around, v has become -v.
            int next = (j + 1) % AROUND, last = i == LONG - 1;
            int a = AROUND * i + j, b = AROUND * i + next;
            int row = AROUND * ((i + 1) % LONG);
            int c = row + (last ? AROUND - 1 - j : j);
            int d = row + (last ? AROUND - 1 - next : next);
            const int corner[6] = {a, b, c, b, d, c};
            memcpy(triangle + 3 * mesh.triangles, corner, sizeof corner);
            mesh.triangles += 2;
        }
}

static void (*const makers[])(void) = {make_bump, make_cross, make_copies,
                                       make_loops};
enum {
    MAKERS = sizeof makers / sizeof *makers
};

// Calls -----------------------------------------------------------------------

typedef struct answer {
    tf_status status;
    tf_untangle_report report;
    size_t left;
} answer;

static size_t bytes_of_mesh_positions(void)
{
    return (size_t)(mesh.axes * mesh.vertices) * sizeof(double);
}

static answer untangle(const tf_untangle_options *options)
{
    tf_surface *surface = surface_of(&mesh);
    tf_resolver *resolver = NULL;
    ck_assert_int_eq(tf_resolver_create(surface, &resolver), TF_OK);
    answer own = {.left = 0};
    tf_crossings left = {.count = 0};
    tf_error error;
    own.status = tf_untangle(resolver, mesh.vertices, in, out, options,
                             &own.report, &left, &error);
    ck_assert_int_eq(error.status, own.status);
    own.left = left.count;
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    return own;
}

static size_t crossings_of(const double x[])
{
    tf_surface *surface = surface_of(&mesh);
    tf_crossings found;
    ck_assert_int_eq(
        tf_surface_check(surface, mesh.vertices, x, NULL, &found, NULL), TF_OK);
    tf_surface_free(surface);
    return found.count;
}

// Tangles that are cleared ----------------------------------------------------

START_TEST(tangles_are_cleared)
{
    makers[_i]();
    answer own = untangle(NULL);
    ck_assert_int_eq(own.status, TF_OK);
    ck_assert_uint_gt(own.report.before, 0);
    ck_assert_uint_eq(own.report.before, crossings_of(in));
    ck_assert_uint_eq(own.left, 0);
    ck_assert_uint_eq(own.report.left, 0);
    ck_assert_uint_eq(crossings_of(out), 0);
    ck_assert_int_eq(own.report.parts, 2);
    ck_assert_int_gt(own.report.moved, 0);
    ck_assert_double_gt(own.report.farthest, 0);
}
END_TEST

/// The sum of the squares of all movements.
static double effort(void)
{
    double sum = 0;
    for (int i = 0; i < mesh.axes * mesh.vertices; i++)
        sum += (out[i] - in[i]) * (out[i] - in[i]);
    return sum;
}

START_TEST(the_return_saves_effort)
{
    makers[_i]();
    ck_assert_uint_eq(untangle(NULL).left, 0);
    double less = effort();
    answer own = untangle(&(tf_untangle_options){.without = TF_RUNG_RETURN});
    ck_assert_uint_eq(own.left, 0);
    ck_assert_int_eq(own.report.rungs & TF_RUNG_RETURN, 0);
    ck_assert_double_lt(less, effort());
}
END_TEST

// Fixed vertices --------------------------------------------------------------

START_TEST(fixed_vertices_stay)
{
    make_bump();
    for (int v = SIDE * SIDE; v < mesh.vertices; v++)
        fixed[v] = true;
    answer own = untangle(&(tf_untangle_options){.fixed = fixed});
    ck_assert_uint_eq(own.left, 0);
    ck_assert_mem_eq(in + (ptrdiff_t)3 * SIDE * SIDE,
                     out + (ptrdiff_t)3 * SIDE * SIDE, sizeof in / 2);
}
END_TEST

START_TEST(where_all_is_fixed_nothing_is_tried)
{
    makers[_i]();
    memset(fixed, 1, sizeof fixed);
    answer own = untangle(&(tf_untangle_options){.fixed = fixed});
    ck_assert_int_eq(own.status, TF_OK);
    ck_assert_uint_eq(own.left, own.report.before);
    ck_assert_uint_eq(own.report.beyond, own.left);
    ck_assert_int_eq(own.report.rounds, 0);
    ck_assert_mem_eq(in, out, bytes_of_mesh_positions());
}
END_TEST

// What cannot be cleared -------------------------------------------------------

START_TEST(a_klein_bottle_is_left_with_its_fewest_crossings)
{
    make_klein_bottle();
    answer own = untangle(NULL);
    ck_assert_int_eq(own.status, TF_OK);
    ck_assert_uint_gt(own.left, 0);
    ck_assert_uint_le(own.left, own.report.before);
    ck_assert_uint_eq(own.left, crossings_of(out));
    ck_assert_uint_eq(own.report.beyond, 0);
    ck_assert_double_eq(own.report.found, 0);
    ck_assert_int_eq(own.report.rungs & TF_RUNG_RETURN, 0);
}
END_TEST

START_TEST(each_rung_may_be_left_out)
{
    int rung = 1 << _i;
    make_bump();
    answer own = untangle(&(tf_untangle_options){.without = rung});
    ck_assert_int_eq(own.report.rungs & rung, 0);
    ck_assert_uint_le(own.left, own.report.before);
    ck_assert_uint_eq(own.left, crossings_of(out));
}
END_TEST

// Inputs that need nothing, or that are bad -----------------------------------

START_TEST(what_is_clear_stays)
{
    make_bump();
    for (int v = 0; v < SIDE * SIDE; v++)
        in[3 * v + 2] = 1.0 / 3;
    in[3 * (6 * SIDE + 6)] = -0.0;
    answer own = untangle(NULL);
    ck_assert_int_eq(own.status, TF_OK);
    ck_assert_uint_eq(own.report.before, 0);
    ck_assert_mem_eq(in, out, bytes_of_mesh_positions());
}
END_TEST

START_TEST(a_triangle_stays)
{
    begin_mesh(3);
    add_sheet((double[]){1, 0, 0}, (double[]){0, 1, 0}, (double[]){0, 0, 0});
    mesh.triangles = 1;
    ck_assert_int_eq(untangle(NULL).status, TF_OK);
    ck_assert_mem_eq(in, out, bytes_of_mesh_positions());
}
END_TEST

START_TEST(bad_calls_change_nothing)
{
    static const tf_untangle_options bad[] = {
        {.rounds = -1}, {.without = -1}, {.without = 64}, {.size = 3}};
    make_bump();
    memset(out, 1, sizeof out);
    static double before[3 * MOST];
    memcpy(before, out, sizeof out);
    for (int i = 0; i < 4; i++)
        ck_assert_int_eq(untangle(&bad[i]).status, TF_BAD_OPTION);
    in[7] = NAN;
    ck_assert_int_eq(untangle(NULL).status, TF_NOT_FINITE);
    ck_assert_mem_eq(out, before, sizeof out);
}
END_TEST

// The same bits ---------------------------------------------------------------

START_TEST(threads_find_the_same)
{
    static double expected[3 * MOST];
    makers[_i]();
    untangle(NULL);
    memcpy(expected, out, sizeof out);
    for (int workers = 2; workers < 9; workers += 6) {
        tf_parallel parallel = scrambled_workers(&workers);
        untangle(&(tf_untangle_options){.parallel = &parallel});
        ck_assert_mem_eq(out, expected, bytes_of_mesh_positions());
    }
}
END_TEST

START_TEST(scales_find_the_same)
{
    static const int powers[] = {-900, 1, 900};
    static double expected[3 * MOST];
    makers[_i]();
    untangle(NULL);
    memcpy(expected, out, sizeof out);
    for (int i = 0; i < 3; i++) {
        makers[_i]();
        for (int j = 0; j < mesh.axes * mesh.vertices; j++)
            in[j] = ldexp(in[j], powers[i]);
        ck_assert_uint_eq(untangle(NULL).left, 0);
        for (int j = 0; j < mesh.axes * mesh.vertices; j++)
            ck_assert_double_eq(ldexp(expected[j], powers[i]), out[j]);
    }
}
END_TEST

START_TEST(the_output_may_be_the_input)
{
    static double expected[3 * MOST];
    make_bump();
    untangle(NULL);
    memcpy(expected, out, sizeof out);
    tf_surface *surface = surface_of(&mesh);
    tf_resolver *resolver = NULL;
    ck_assert_int_eq(tf_resolver_create(surface, &resolver), TF_OK);
    ck_assert_int_eq(
        tf_untangle(resolver, mesh.vertices, in, in, NULL, NULL, NULL, NULL),
        TF_OK);
    ck_assert_mem_eq(in, expected, bytes_of_mesh_positions());
    tf_resolver_free(resolver);
    tf_surface_free(surface);
}
END_TEST

// Calls that end early --------------------------------------------------------

typedef struct patience {
    long told, last;
} patience;

static bool lose_patience(void *context, const tf_stage *stage)
{
    patience *own = context;
    ck_assert_ptr_nonnull(stage->name);
    return ++own->told != own->last;
}

START_TEST(cancelled_calls_change_nothing)
{
    static double before[3 * MOST];
    makers[_i]();
    patience all = {0, 0};
    untangle(
        &(tf_untangle_options){.progress = lose_patience, .context = &all});
    memset(out, 1, sizeof out);
    memcpy(before, out, sizeof out);
    for (long i = 1; i < 12; i += 4) {
        patience some = {0, 1 + all.told * i / 12};
        answer own = untangle(&(tf_untangle_options){.progress = lose_patience,
                                                     .context = &some});
        ck_assert_int_eq(own.status, TF_CANCELLED);
        ck_assert_int_eq(some.told, some.last);
        ck_assert_mem_eq(out, before, sizeof out);
    }
}
END_TEST

static uint64_t untangle_without_memory(void)
{
    tf_surface *surface = NULL;
    tf_resolver *resolver = NULL;
    while (lacks_memory(tf_surface_create(&mesh, &surface, NULL)))
        ;
    while (lacks_memory(tf_resolver_create(surface, &resolver)))
        ;
    while (lacks_memory(tf_untangle(
        resolver, mesh.vertices, in, out,
        &(tf_untangle_options){.rounds = 1, .without = TF_RUNG_RELAX}, NULL,
        NULL, NULL)))
        ;
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    return hash_bytes(HASH_OF_NOTHING, out, bytes_of_mesh_positions());
}

START_TEST(calls_lack_memory)
{
    makers[_i]();
    let_each_fail(untangle_without_memory);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/untangle");
    TCase *tcase = tcase_create("tangles");
    tcase_add_loop_test(tcase, tangles_are_cleared, 0, MAKERS);
    tcase_add_loop_test(tcase, the_return_saves_effort, 0, MAKERS);
    tcase_add_test(tcase, fixed_vertices_stay);
    tcase_add_loop_test(tcase, where_all_is_fixed_nothing_is_tried, 0, MAKERS);
    tcase_add_test(tcase, a_klein_bottle_is_left_with_its_fewest_crossings);
    tcase_add_loop_test(tcase, each_rung_may_be_left_out, 0, 6);
    tcase_add_test(tcase, what_is_clear_stays);
    tcase_add_test(tcase, a_triangle_stays);
    tcase_add_test(tcase, bad_calls_change_nothing);
    tcase_add_loop_test(tcase, threads_find_the_same, 0, MAKERS);
    tcase_add_loop_test(tcase, scales_find_the_same, 0, MAKERS);
    tcase_add_test(tcase, the_output_may_be_the_input);
    tcase_add_loop_test(tcase, cancelled_calls_change_nothing, 0, MAKERS);
    tcase_add_loop_test(tcase, calls_lack_memory, 0, 1);
    suite_add_tcase(suite, tcase);
    return suite;
}

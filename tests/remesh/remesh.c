// Remeshing: it never tangles, keeps the shape, and makes good triangles.
#include "remesh/remesh.h"

#include "remesh/keep_shape.h"
#include "remesh/origins.h"
#include "remesh/passes.h"
#include "remesh/reach.h"
#include "support/adaptive_surfaces.h"
#include "support/cancelling.h"
#include "support/damage.h"
#include "support/flows.h"
#include "support/remeshers.h"
#include "support/support.h"
#include "support/surgery_runs.h"
#include "surgery/adaptive_surface.h"
#include "surgery/collapse.h"
#include "surgery/star.h"

#include <math.h>
#include <signal.h>
#include <string.h>

static surgery_run run;
static surgery_counts counts;

/// Gives new vertices the part of a neighbor that has one.
static void inherit_parts(int before)
{
    tf_mesh mesh = *tf_adaptive_mesh(run.surface);
    for (int v = before; v < mesh.vertices; v++)
        run.part[v] = -1;
    for (int changes = 1; changes > 0;) {
        changes = 0;
        for (int i = 0; i < 3 * mesh.triangles; i++) {
            const int *t = mesh.triangle + i / 3 * 3;
            int own = t[i % 3], next = t[(i + 1) % 3];
            if (run.part[own] < 0 && run.part[next] >= 0) {
                run.part[own] = run.part[next];
                changes++;
            }
        }
    }
}

static const char *first_fault(void)
{
    const char *fault = NULL;
    for (int part = 0; part < run.scene.parts && !fault; part++) {
        run.changed = part;
        fault = surgery_run_fault(&run);
    }
    return fault;
}

// The passes that add vertices or move them, without the compaction that would
// lose track of the parts.
START_TEST(no_close_surfaces_are_tangled_by_passes)
{
    surgery_run_begin(&run, generator_new((uint64_t)_i),
                      (adaptive_scene_kind)_i, &counts);
    static const tf_operation passes[] = {TF_SPLIT, TF_SPLIT, TF_SPLIT, TF_FLIP,
                                          TF_SMOOTH};
    tf_remesher *remesher =
        remesher_begin(run.surface, &tf_keep_shape, run.scene.unit / 3);
    for (int i = 0; i < 5; i++)
        ck_assert_int_eq(tf_remesh_pass(remesher, passes[i]), TF_OK);
    inherit_parts(run.scene.vertices);
    const char *fault = first_fault();
    ck_assert_msg(!fault, "%s", fault);
    remesher_end(remesher);
}
END_TEST

/// The scene as a surface of one part.
static void begin_unlabelled(void)
{
    memset(run.part, 0, sizeof run.part);
    run.scene.kind = SHEETS;
    run.changed = 0;
}

START_TEST(no_scene_is_tangled_by_remeshing)
{
    static const double fractions[] = {2, 1, 0.5};
    for (int i = 0; i < 3; i++) {
        surgery_run_begin(&run, generator_new((uint64_t)_i),
                          (adaptive_scene_kind)_i, &counts);
        tf_remesh_options how = {.edge = run.scene.unit * fractions[i]};
        const tf_remesh_report *report;
        ck_assert_int_eq(tf_adaptive_remesh(run.surface, &how, &report, NULL),
                         TF_OK);
        ck_assert_int_eq(report->rounds, 5);
        begin_unlabelled();
        const char *fault = surgery_run_fault(&run);
        ck_assert_msg(!fault, "%s", fault);
        surgery_run_end(&run);
    }
}
END_TEST

enum {
    MOST_TANGLES = 20000
};

/// Numbers the vertices that are left alone, in their order.
static int number_frozen(const tf_adaptive_surface *surface, int number[])
{
    int count = 0;
    for (int v = 0; v < surface->vertices; v++)
        number[v] = tf_is_frozen(surface, v) ? count++ : -1;
    return count;
}

/// Gives what meets these numbers.
static int number_tangles(const tf_adaptive_surface *surface, tangle found[])
{
    static int number[LABELLED];
    number_frozen(surface, number);
    int count = tangles_of(surface, MOST_TANGLES, found);
    for (int i = 0; i < 5 * count; i++) {
        int *v = &found[i / 5].vertex[i % 5];
        ck_assert(*v < 0 || number[*v] >= 0);
        *v = *v < 0 ? -1 : number[*v];
    }
    return count;
}

// Sheets have sharp edges and boundaries in defects, and so have slabs.
START_TEST(no_damaged_scene_is_tangled_more)
{
    static tangle before[MOST_TANGLES], after[MOST_TANGLES];
    static int number[LABELLED];
    generator random = generator_new((uint64_t)_i + 50);
    adaptive_scene_make(&random, (adaptive_scene_kind)(_i % ADAPTIVE_SCENES),
                        &run.scene);
    for (int i = 1 + below(&random, 5); i > 0; i--)
        damage(&random, &run.scene);
    tf_mesh mesh = adaptive_scene_mesh(&run.scene);
    tf_adaptive_surface *surface = NULL;
    ck_assert_int_eq(tf_adaptive_create_around(&mesh, run.scene.position,
                                               &surface, NULL, NULL),
                     TF_OK);
    int count = number_tangles(surface, before);
    int frozen = number_frozen(surface, number);
    tf_remesh_options how = {
        .size = sizeof how, .edge = run.scene.unit / (1 + _i % 3), .rounds = 2};
    ck_assert_int_eq(tf_adaptive_remesh(surface, &how, NULL, NULL), TF_OK);
    ck_assert_int_eq(number_frozen(surface, number), frozen);
    ck_assert_int_eq(number_tangles(surface, after), count);
    ck_assert_mem_eq(after, before, (size_t)count * sizeof *before);
    tf_adaptive_free(surface);
}
END_TEST

// The middle of a sheet of 8 x 8 squares has a fin on a diagonal of its own, ten
// times as long as edges are to be.
START_TEST(triangles_beside_a_long_edge_stay_fair)
{
    static const double corner[] = {0, 0, 0, 8, 0, 0, 8, 8,
                                    0, 0, 8, 0, 4, 4, 9};
    static const int triangle[] = {0, 1, 2, 2, 3, 0, 0, 2, 4};
    tf_mesh mesh = {
        .axes = 3, .vertices = 5, .triangles = 3, .triangle = triangle};
    tf_adaptive_surface *surface = NULL;
    ck_assert_int_eq(
        tf_adaptive_create_around(&mesh, corner, &surface, NULL, NULL), TF_OK);
    tf_remesh_options how = {.size = sizeof how, .edge = 1};
    const tf_remesh_report *report;
    ck_assert_int_eq(tf_adaptive_remesh(surface, &how, &report, NULL), TF_OK);
    ck_assert_int_gt(triangles_of(surface), 100);
    ck_assert_double_gt(report->least_after, 0.02);
    ck_assert_double_gt(report->mean_after, 0.8);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(a_sphere_gets_good_triangles)
{
    static adaptive_scene scene;
    scene = (adaptive_scene){0};
    add_sphere(&scene, 1);
    tf_mesh mesh = adaptive_scene_mesh(&scene);
    tf_adaptive_surface *surface = NULL;
    ck_assert_int_eq(tf_adaptive_create(&mesh, scene.position, &surface, NULL),
                     TF_OK);
    tf_remesh_options how = {.edge = 0.2};
    const tf_remesh_report *report;
    ck_assert_int_eq(tf_adaptive_remesh(surface, &how, &report, NULL), TF_OK);
    ck_assert_double_gt(report->mean_before, 0.9);
    ck_assert_double_gt(report->least_after, 0.5);
    ck_assert_double_gt(report->mean_after, 0.9);
    ck_assert_double_lt(report->distance, 0.1);
    ck_assert_double_lt(longest_edge(surface), 0.3);
    ck_assert_int_gt(triangles_of(surface), 400);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(a_box_stays_a_box)
{
    static adaptive_scene scene;
    static const int low[] = {0, 0, 0}, high[] = {1, 2, 3};
    scene = (adaptive_scene){0};
    add_box(&scene, low, high);
    tf_mesh mesh = adaptive_scene_mesh(&scene);
    tf_adaptive_surface *surface = NULL;
    ck_assert_int_eq(tf_adaptive_create(&mesh, scene.position, &surface, NULL),
                     TF_OK);
    for (int i = 1; i < 4; i++) {
        tf_remesh_options how = {.edge = 0.3 * i, .rounds = 3};
        const tf_remesh_report *report;
        ck_assert_int_eq(tf_adaptive_remesh(surface, &how, &report, NULL),
                         TF_OK);
        ck_assert_double_lt(report->distance, 1e-12);
        ck_assert_int_eq(report->rounds, 3);
    }
    tf_adaptive_free(surface);
}
END_TEST

// Sharp edges -----------------------------------------------------------------

/// How long the edges are at which a surface turns by more than 20 degrees.
static double sharp_length(const tf_adaptive_surface *surface)
{
    const tf_sharpness sharpness = {.cosine = 0.94, .depth = INFINITY};
    tf_sharp_edges sharp = {0};
    double sum = 0;
    ck_assert_int_eq(tf_sharp_edges_find(&sharp, surface, &sharpness, NULL),
                     TF_OK);
    for (int v = 0; v < surface->vertices; v++)
        for (int w = 0; w < v; w++)
            if (tf_find_sharp_edge(&sharp, v, w))
                sum += tf_length_of(surface, v, w) / surface->scale;
    tf_sharp_edges_free(&sharp);
    return sum;
}

static bool has_vertex_at(const tf_adaptive_surface *surface, const double *x)
{
    for (int v = 0; v < surface->vertices; v++)
        if (memcmp(coordinates_of(surface, v), x, 3 * sizeof *x) == 0)
            return true;
    return false;
}

// The edges of prisms of 3 to 12 sides are all longer than the loss of 1/1000.
START_TEST(prisms_keep_their_edges)
{
    static const double edges[] = {0.07, 0.2, 0.6, 2};
    for (int sides = 3; sides < 13; sides++)
        for (int i = 0; i < 4; i++) {
            tf_adaptive_surface *surface = adaptive_prism(sides);
            tf_adaptive_surface *before = adaptive_prism(sides);
            tf_remesh_options how = {.edge = edges[i]};
            const tf_remesh_report *report;
            ck_assert_int_eq(tf_adaptive_remesh(surface, &how, &report, NULL),
                             TF_OK);
            double right = sharp_length(before);
            ck_assert_double_eq_tol(sharp_length(surface), right,
                                    1e-12 * right);
            for (int v = 0; v < 2 * sides; v++)
                ck_assert(has_vertex_at(surface, coordinates_of(before, v)));
            ck_assert_double_lt(report->distance, 1e-14);
            ck_assert_double_lt(report->most_distance, 1e-3 * edges[i]);
            tf_adaptive_free(surface);
            tf_adaptive_free(before);
        }
}
END_TEST

START_TEST(the_crease_angle_decides)
{
    // The sides of a prism of 20 turn by 18 degrees.
    for (int i = 0; i < 2; i++) {
        tf_adaptive_surface *surface = adaptive_prism(20);
        tf_remesh_options how = {
            .size = sizeof how, .edge = 0.13, .crease = i ? 19 : 17};
        const tf_remesh_report *report;
        ck_assert_int_eq(tf_adaptive_remesh(surface, &how, &report, NULL),
                         TF_OK);
        ck_assert_msg((report->distance > 1e-3) == (i == 1), "%d: %g", i,
                      report->distance);
        tf_adaptive_free(surface);
    }
}
END_TEST

START_TEST(kept_edges_stay)
{
    // Two edges of a flat sheet, and a corner inside.
    static const int keep[] = {10, 11, 11, 12, 18, 18};
    tf_adaptive_surface *sheet = adaptive_sheet(4, 4);
    tf_adaptive_surface *before = adaptive_sheet(4, 4);
    tf_remesh_options how = {
        .size = sizeof how, .edge = 1.7, .keeps = 3, .keep = keep};
    ck_assert_int_eq(tf_adaptive_remesh(sheet, &how, NULL, NULL), TF_OK);
    ck_assert(has_vertex_at(sheet, coordinates_of(before, 10)));
    ck_assert(has_vertex_at(sheet, coordinates_of(before, 12)));
    ck_assert(has_vertex_at(sheet, coordinates_of(before, 18)));
    ck_assert_int_lt(triangles_of(sheet), 32);
    tf_adaptive_free(sheet);
    tf_adaptive_free(before);
}
END_TEST

// Sizes -----------------------------------------------------------------------

START_TEST(lengths_vary_over_a_sheet)
{
    double lengths[64];
    for (int v = 0; v < 64; v++)
        lengths[v] = v % 8 < 3 ? 0.3 : 3;
    tf_adaptive_surface *sheet = adaptive_sheet(7, 7);
    tf_remesh_options how = {.size = sizeof how, .lengths = lengths};
    ck_assert_int_eq(tf_adaptive_remesh(sheet, &how, NULL, NULL), TF_OK);
    int left = 0, right = 0;
    for (int v = 0; v < sheet->vertices; v++) {
        left += coordinates_of(sheet, v)[0] < 2;
        right += coordinates_of(sheet, v)[0] > 5;
    }
    ck_assert_int_gt(left, 120);
    ck_assert_int_lt(right, left / 4);
    ck_assert_double_lt(longest_edge(sheet), 4.01 * sheet->scale);
    tf_adaptive_free(sheet);
}
END_TEST

/// The farthest of many random points of a surface from another one.
static double sampled_distance(const tf_adaptive_surface *from,
                               const tf_adaptive_surface *to, generator *random)
{
    tf_original original = {0};
    double far = 0;
    ck_assert_int_eq(tf_original_begin(&original, to, NULL), TF_OK);
    for (long i = 0; i < cases(100000); i++) {
        int t = (int)uniform(random, 0, from->triangles);
        double a = uniform(random, 0, 1), b = uniform(random, 0, 1 - a);
        tf_shape shape = tf_shape_of(from, t);
        tf_vector point = tf_vector_scaled(1 - a - b, shape.corner[0]);
        point = tf_vector_sum(point, a, shape.corner[1]);
        point = tf_vector_sum(point, b, shape.corner[2]);
        far = fmax(far, tf_original_project(&original, point).distance);
    }
    tf_original_free(&original);
    return far / from->scale;
}

START_TEST(a_distance_is_kept_both_ways)
{
    static const double errors[] = {0.1, 0.03, 0.01};
    generator random = generator_new(2);
    for (int i = 0; i < 3; i++) {
        tf_adaptive_surface *surface = adaptive_bumpy_sphere(8, 0.05, 3);
        tf_adaptive_surface *before = adaptive_bumpy_sphere(8, 0.05, 3);
        tf_remesh_options how = {.size = sizeof how, .error = errors[i]};
        const tf_remesh_report *report;
        ck_assert_int_eq(tf_adaptive_remesh(surface, &how, &report, NULL),
                         TF_OK);
        ck_assert_double_le(report->most_distance, errors[i]);
        tf_choose_scale(before);
        ck_assert_double_eq(before->scale, surface->scale);
        ck_assert_double_le(sampled_distance(surface, before, &random),
                            errors[i]);
        ck_assert_double_le(sampled_distance(before, surface, &random),
                            errors[i]);
        tf_adaptive_free(surface);
        tf_adaptive_free(before);
    }
}
END_TEST

// A box needs no more triangles than it has, however small the distance.
START_TEST(flat_sides_need_few_triangles)
{
    static adaptive_scene scene;
    static const int low[] = {0, 0, 0}, high[] = {3, 3, 3};
    scene = (adaptive_scene){0};
    add_box(&scene, low, high);
    tf_mesh mesh = adaptive_scene_mesh(&scene);
    tf_adaptive_surface *surface = NULL;
    ck_assert_int_eq(tf_adaptive_create(&mesh, scene.position, &surface, NULL),
                     TF_OK);
    tf_remesh_options how = {.size = sizeof how, .error = 1e-6};
    ck_assert_int_eq(tf_adaptive_remesh(surface, &how, NULL, NULL), TF_OK);
    ck_assert_int_le(triangles_of(surface), 24);
    tf_adaptive_free(surface);
}
END_TEST

// All or nothing --------------------------------------------------------------

/// A bumpy sphere with gaps among its numbers.
static tf_adaptive_surface *sphere_with_gaps(void)
{
    tf_adaptive_surface *surface = adaptive_bumpy_sphere(6, 0.02, 3);
    for (int v = 10; v < 100; v += 30) {
        int to =
            tf_vertex_at(surface, tf_corner_after(tf_first_corner(surface, v)));
        tf_outcome outcome;
        ck_assert_int_eq(tf_adaptive_collapse(surface, v, to, &outcome), TF_OK);
        ck_assert_int_eq(outcome, TF_COMMITTED);
    }
    ck_assert_int_gt(surface->free_triangle, 0);
    return surface;
}

static tf_status remesh_finely(tf_adaptive_surface *surface,
                               cancellation *cancelling, tf_error *error)
{
    const tf_remesh_options how = {.edge = 0.15,
                                   .rounds = 2,
                                   .progress = tell_cancellation,
                                   .context = cancelling};
    return tf_adaptive_remesh(surface, &how, NULL, error);
}

static tf_status remesh_coarsely(tf_adaptive_surface *surface,
                                 cancellation *cancelling, tf_error *error)
{
    const tf_remesh_options how = {
        .edge = 0.5, .progress = tell_cancellation, .context = cancelling};
    return tf_adaptive_remesh(surface, &how, NULL, error);
}

START_TEST(a_cancelled_remeshing_changes_nothing)
{
    expect_cancelling(sphere_with_gaps, remesh_finely, cases(60));
    expect_cancelling(sphere_with_gaps, remesh_coarsely, cases(60));
}
END_TEST

/// The stages that a remeshing goes through.
typedef struct stages {
    char names[2000];
    const char *last;
} stages;

static bool note_stage(void *context, const tf_stage *stage)
{
    stages *all = context;
    if (stage->total > 0)
        ck_assert_uint_le(stage->done, stage->total + 16);
    if (stage->name == all->last)
        return true;
    all->last = stage->name;
    strcat(strcat(all->names, stage->name), " ");
    return true;
}

START_TEST(progress_goes_through_the_stages)
{
    stages all = {.names = ""};
    tf_remesh_options how = {
        .edge = 0.15, .rounds = 1, .progress = note_stage, .context = &all};
    tf_adaptive_surface *surface = sphere_with_gaps();
    ck_assert_int_eq(tf_adaptive_remesh(surface, &how, NULL, NULL), TF_OK);
    ck_assert_str_eq(
        all.names,
        "copying splitting collapsing flipping smoothing measuring ");
    tf_adaptive_free(surface);
}
END_TEST

// The report ------------------------------------------------------------------

START_TEST(the_report_is_lent_until_the_next_call)
{
    tf_adaptive_surface *surface = adaptive_bumpy_sphere(6, 0.02, 3);
    const tf_remesh_options how = {.edge = 0.3, .rounds = 2}, bad = {.edge = 0};
    const tf_remesh_report *report = NULL, *other = NULL;
    ck_assert_int_eq(tf_adaptive_remesh(surface, &how, &report, NULL), TF_OK);
    tf_remesh_report copy = *report;
    size_t memory = tf_adaptive_memory(surface);
    ck_assert_int_eq(tf_adaptive_remesh(surface, &bad, &other, NULL),
                     TF_BAD_OPTION);
    ck_assert_ptr_null(other);
    ck_assert_mem_eq(report, &copy, sizeof copy);
    ck_assert_uint_eq(tf_adaptive_memory(surface), memory);
    ck_assert_int_eq(tf_adaptive_remesh(surface, &how, &report, NULL), TF_OK);
    ck_assert_double_eq(report->least_before, copy.least_after);
    tf_adaptive_free(surface);
}
END_TEST

// Options ---------------------------------------------------------------------

START_TEST(negative_rounds_are_none)
{
    tf_adaptive_surface *surface = sphere_with_gaps();
    const tf_remesh_options none = {.edge = 0.1, .rounds = -1};
    const tf_remesh_report *report;
    int triangles = triangles_of(surface);
    ck_assert_int_eq(tf_adaptive_remesh(surface, &none, &report, NULL), TF_OK);
    ck_assert_int_eq(report->rounds, 0);
    ck_assert_double_eq(report->least_before, report->least_after);
    ck_assert_double_lt(report->distance, 1e-15);
    ck_assert_int_eq(surface->triangles, triangles); // the gaps are closed
    ck_assert_ptr_nonnull(tf_adaptive_origins(surface));
    tf_adaptive_free(surface);
}
END_TEST

static void expect_bad(tf_adaptive_surface *surface,
                       const tf_remesh_options *how, const char *option)
{
    tf_error error;
    ck_assert_int_eq(tf_adaptive_remesh(surface, how, NULL, &error),
                     TF_BAD_OPTION);
    ck_assert_int_eq(error.status, TF_BAD_OPTION);
    ck_assert_str_eq(error.option, option);
    ck_assert_ptr_nonnull(error.range);
    if (strcmp(option, "edge") == 0 && !isnan(how->edge))
        ck_assert_double_eq(error.value, how->edge);
}

START_TEST(bad_options_are_refused)
{
    static const double edges[] = {0, -1, NAN, INFINITY, 1e-9, 5e-324};
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    for (int i = 0; i < 6; i++)
        expect_bad(surface, &(tf_remesh_options){.edge = edges[i]}, "edge");
    expect_bad(surface, &(tf_remesh_options){.size = 8, .edge = 1}, "size");
    tf_remesh_options how = {.size = sizeof how, .edge = 1};
    static const double creases[] = {-1, 180.1, NAN};
    for (int i = 0; i < 3; i++) {
        how.crease = creases[i];
        expect_bad(surface, &how, "crease");
    }
    how.crease = 0;
    how.keeps = -1;
    expect_bad(surface, &how, "keeps");
    static const int keep[][2] = {{0, 4}, {-1, 0}, {4, 4}};
    for (int i = 0; i < 3; i++) {
        how.keeps = 1;
        how.keep = keep[i];
        expect_bad(surface, &how, "keep");
    }
    how.keeps = 0;
    static const double lengths[][4] = {{1, 1, 1, 0}, {1, NAN, 1, 1}};
    for (int i = 0; i < 2; i++) {
        how.lengths = lengths[i];
        expect_bad(surface, &how, "lengths");
    }
    how.lengths = NULL;
    how.error = -1;
    expect_bad(surface, &how, "error");
    how.error = 1e-300;
    expect_bad(surface, &how, "error");
    how.error = 0;
    ck_assert_int_eq(tf_adaptive_remesh(surface, &how, NULL, NULL), TF_OK);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(remeshing_needs_options)
{
    tf_adaptive_remesh(adaptive_tetrahedron(), NULL, NULL, NULL);
}
END_TEST

/// An octahedron of a size, remeshed, or refused as it was.
static tf_adaptive_surface *remeshed_octahedron(int exponent, double flat)
{
    static const int triangle[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                   2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    double x[18] = {1, 0,     0, -1, 0, 0,    0, flat, 0,
                    0, -flat, 0, 0,  0, flat, 0, 0,    -flat};
    for (int i = 0; i < 18; i++)
        x[i] = ldexp(x[i], exponent);
    tf_mesh mesh = {
        .axes = 3, .vertices = 6, .triangles = 8, .triangle = triangle};
    tf_adaptive_surface *surface = NULL;
    ck_assert_int_eq(tf_adaptive_create(&mesh, x, &surface, NULL), TF_OK);
    tf_remesh_options options = {.edge = ldexp(0.3, exponent)};
    const tf_remesh_report *report = NULL;
    tf_status status = tf_adaptive_remesh(surface, &options, &report, NULL);
    ck_assert_int_eq(status, exponent > 1000 ? TF_OUT_OF_RANGE : TF_OK);
    if (status != TF_OK) {
        ck_assert_mem_eq(tf_adaptive_positions(surface), x, sizeof x);
        return surface;
    }
    ck_assert(isfinite(report->least_before) && isfinite(report->least_after));
    ck_assert(isfinite(report->mean_before) && isfinite(report->mean_after));
    return surface;
}

START_TEST(the_unit_of_length_changes_no_bit)
{
    tf_adaptive_surface *one = remeshed_octahedron(0, 1);
    tf_mesh mesh = *tf_adaptive_mesh(one);
    const double *x = tf_adaptive_positions(one);
    for (int k = -1000; k <= 1000; k += 50) {
        tf_adaptive_surface *other = remeshed_octahedron(k, 1);
        tf_mesh same = *tf_adaptive_mesh(other);
        ck_assert_int_eq(same.vertices, mesh.vertices);
        ck_assert_int_eq(same.triangles, mesh.triangles);
        for (int i = 0; i < 3 * mesh.triangles; i++)
            ck_assert_int_eq(same.triangle[i], mesh.triangle[i]);
        for (int i = 0; i < 3 * mesh.vertices; i++)
            ck_assert_double_eq(tf_adaptive_positions(other)[i],
                                ldexp(x[i], k));
        tf_adaptive_free(other);
    }
    for (int k = 1001; k <= 1023; k++)
        tf_adaptive_free(remeshed_octahedron(k, 1));
    tf_adaptive_free(one);
}
END_TEST

START_TEST(needles_have_no_quality_but_a_number)
{
    tf_adaptive_free(remeshed_octahedron(0, 1e-170));
}
END_TEST

START_TEST(no_triangles_have_the_best_quality)
{
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    tf_remesh_options options = {.edge = 1};
    const tf_remesh_report *report;
    for (int t = 0; t < 4; t++)
        tf_triangle_remove(surface, t);
    ck_assert_int_eq(tf_adaptive_remesh(surface, &options, &report, NULL),
                     TF_OK);
    ck_assert_double_eq(report->least_before, 1);
    ck_assert_double_eq(report->mean_before, 1);
    ck_assert_double_eq(report->least_after, 1);
    ck_assert_double_eq(report->mean_after, 1);
    ck_assert_double_eq(report->distance, 0);
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/remesh");
    TCase *tcase = tcase_create("remeshing");
    tcase_add_loop_test(tcase, no_close_surfaces_are_tangled_by_passes, 0,
                        ADAPTIVE_SCENES);
    tcase_add_loop_test(tcase, no_scene_is_tangled_by_remeshing, 0,
                        ADAPTIVE_SCENES);
    tcase_add_loop_test(tcase, no_damaged_scene_is_tangled_more, 0, 20);
    tcase_add_test(tcase, triangles_beside_a_long_edge_stay_fair);
    tcase_add_test(tcase, a_sphere_gets_good_triangles);
    tcase_add_test(tcase, prisms_keep_their_edges);
    tcase_add_test(tcase, the_crease_angle_decides);
    tcase_add_test(tcase, kept_edges_stay);
    tcase_add_test(tcase, lengths_vary_over_a_sheet);
    tcase_add_test(tcase, a_distance_is_kept_both_ways);
    tcase_add_test(tcase, flat_sides_need_few_triangles);
    tcase_add_test(tcase, a_box_stays_a_box);
    tcase_add_test(tcase, a_cancelled_remeshing_changes_nothing);
    tcase_add_test(tcase, progress_goes_through_the_stages);
    tcase_add_test(tcase, the_report_is_lent_until_the_next_call);
    tcase_add_test(tcase, the_unit_of_length_changes_no_bit);
    tcase_add_test(tcase, no_triangles_have_the_best_quality);
    tcase_add_test(tcase, needles_have_no_quality_but_a_number);
    tcase_add_test(tcase, negative_rounds_are_none);
    tcase_add_test(tcase, bad_options_are_refused);
    tcase_add_test_raise_signal(tcase, remeshing_needs_options, SIGABRT);
    suite_add_tcase(suite, tcase);
    return suite;
}

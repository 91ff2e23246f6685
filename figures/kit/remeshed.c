#include "kit/remeshed.h"

#include "base/require.h"
#include "experiments/leave_out.h"
#include "remesh/keep_shape.h"
#include "remesh/passes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// Meshes ----------------------------------------------------------------------

static fig_some_mesh with_room(int vertices, int triangles)
{
    fig_some_mesh mesh = {
        .x = malloc(3 * (size_t)vertices * sizeof *mesh.x),
        .triangle = malloc(3 * (size_t)triangles * sizeof *mesh.triangle)};
    TF_REQUIRE(mesh.x && mesh.triangle);
    return mesh;
}

static void place_next(fig_some_mesh *mesh, double x, double y, double z)
{
    const double at[] = {x, y, z};
    memcpy(mesh->x + 3 * (ptrdiff_t)mesh->vertices++, at, sizeof at);
}

static void join(fig_some_mesh *mesh, int a, int b, int c)
{
    const int corner[] = {a, b, c};
    memcpy(mesh->triangle + 3 * (ptrdiff_t)mesh->triangles++, corner,
           sizeof corner);
}

/// A face between two vertical edges, seen with `left` on the left; upper
/// vertices follow lower ones.
static void join_upright(fig_some_mesh *mesh, int left, int right)
{
    join(mesh, left, right, right + 1);
    join(mesh, left, right + 1, left + 1);
}

/// A triangle of the upper face, and below it one of the lower face.
static void join_faces(fig_some_mesh *mesh, int a, int b, int c)
{
    join(mesh, a + 1, b + 1, c + 1);
    join(mesh, a, c, b);
}

static void place_upright(fig_some_mesh *mesh, double x, double y)
{
    place_next(mesh, x, y, -0.15);
    place_next(mesh, x, y, 0.15);
}

fig_some_mesh fig_plate_with_hole(int around)
{
    const double tau = 2 * acos(-1), radius = 0.55;
    fig_some_mesh mesh = with_room(2 * around + 8, 4 * around + 16);
    for (int i = 0; i < around; i++)
        place_upright(&mesh, radius * cos(tau * i / around),
                      radius * sin(tau * i / around));
    static const int sign[] = {1, 1, -1, -1, 1};
    int corners = 2 * around;
    for (int k = 0; k < 4; k++)
        place_upright(&mesh, sign[k + 1], sign[k]);
    for (int i = 0; i < around; i++) {
        int next = (i + 1) % around;
        int corner = corners + 2 * (i * 4 / around);
        join_upright(&mesh, 2 * next, 2 * i);
        join_faces(&mesh, corner, 2 * next, 2 * i);
    }
    for (int k = 0; k < 4; k++) {
        int from = corners + 2 * k, to = corners + (2 * k + 2) % 8;
        join_upright(&mesh, from, to);
        join_faces(&mesh, 2 * (((k + 1) % 4) * around / 4), from, to);
    }
    return mesh;
}

fig_some_mesh fig_roll_of_sheet(double radius, double gap, double turns,
                                double edge)
{
    const double tau = 2 * acos(-1);
    double length = tau * turns * (radius + gap * turns / 2);
    // So tall that little of it is near the boundary, which keeps its edges.
    int along = (int)ceil(length / edge), across = 14;
    fig_some_mesh mesh =
        with_room((along + 1) * (across + 1), 2 * along * across);
    for (int i = 0; i <= along; i++)
        for (int j = 0; j <= across; j++) {
            double turn = turns * i / along, r = radius + gap * turn;
            place_next(&mesh, r * cos(tau * turn), r * sin(tau * turn),
                       edge * j);
        }
    for (int i = 0; i < along; i++)
        for (int j = 0; j < across; j++) {
            int a = i * (across + 1) + j, b = a + across + 1;
            join(&mesh, a, b, b + 1);
            join(&mesh, a, b + 1, a + 1);
        }
    return mesh;
}

// Remeshing -------------------------------------------------------------------

static fig_some_mesh copy_of(const tf_adaptive_surface *surface)
{
    tf_mesh now = *tf_adaptive_mesh(surface);
    fig_some_mesh mesh = with_room(now.vertices, now.triangles);
    mesh.vertices = now.vertices;
    memcpy(mesh.x, tf_adaptive_positions(surface),
           3 * sizeof *mesh.x * (size_t)now.vertices);
    for (int t = 0; t < now.triangles; t++) {
        const int *v = now.triangle + 3 * (ptrdiff_t)t;
        if (v[0] >= 0)
            join(&mesh, v[0], v[1], v[2]);
    }
    return mesh;
}

static void note_stage(fig_remeshing *all, const tf_remesher *remesher)
{
    TF_REQUIRE(all->stages <= FIG_REMESH_STAGES);
    all->stage[all->stages++] = copy_of(remesher->surface);
}

/// Repeats a pass as tf_remesh_round does, and notes each.
static void repeat_pass(fig_remeshing *all, tf_remesher *remesher,
                        tf_operation operation, int most)
{
    const size_t *done = &remesher->report.tried[operation][TF_COMMITTED];
    size_t before = *done - 1;
    for (int i = 0; i < most && *done != before; i++) {
        before = *done;
        TF_REQUIRE(tf_remesh_pass(remesher, operation) == TF_OK);
        note_stage(all, remesher);
    }
}

static void do_rounds(fig_remeshing *all, tf_remesher *remesher, int rounds)
{
    const tf_remesh_policy *policy = remesher->policy;
    note_stage(all, remesher);
    for (int i = 0; i < rounds; i++) {
        for (int k = 0; k < TF_REMESH_PASSES; k++)
            repeat_pass(all, remesher, policy->pass[k].operation,
                        policy->pass[k].most);
        TF_REQUIRE(tf_remesher_compact(remesher) == TF_OK);
        all->report[i] = remesher->report;
    }
}

void fig_remesh(const fig_some_mesh *mesh, double edge, int rounds,
                bool tangled, fig_remeshing *remeshing)
{
    TF_REQUIRE(rounds <= FIG_REMESH_ROUNDS);
    tf_remesher remesher = {.policy = &tf_keep_shape, .edge = edge};
    tf_adaptive_surface *original;
    tf_mesh given = fig_mesh_in_space(mesh);
    TF_REQUIRE(tf_adaptive_create(&given, mesh->x, &remesher.surface, NULL) ==
               TF_OK);
    TF_REQUIRE(tf_adaptive_create(&given, mesh->x, &original, NULL) == TF_OK);
    TF_REQUIRE(tf_original_begin(&remesher.original, original, NULL) == TF_OK);
    const tf_sharpness sharpness = {.cosine = 0x1.d0p-1, .depth = INFINITY};
    TF_REQUIRE(tf_sharp_edges_find(&remesher.sharp, original, &sharpness,
                                   NULL) == TF_OK);
    *remeshing = (fig_remeshing){0};
    if (tangled)
        leave_out(1U << TF_OVERLAPPED | 1U << TF_PASSED_VERTEX |
                  1U << TF_PASSED_EDGE | 1U << TF_PASSED_TRIANGLE);
    do_rounds(remeshing, &remesher, rounds);
    leave_out(0);
    tf_adaptive_free(remesher.surface);
    tf_adaptive_free(original);
    tf_remesher_free(&remesher);
}

void fig_remeshing_free(fig_remeshing *remeshing)
{
    for (int i = 0; i < remeshing->stages; i++)
        fig_some_mesh_free(&remeshing->stage[i]);
}

// Counting and measuring ------------------------------------------------------

double fig_remesh_done(const tf_remesh_report *report, tf_operation operation)
{
    return (double)report->tried[operation][TF_COMMITTED];
}

double fig_remesh_refused(const tf_remesh_report *report, tf_outcome outcome)
{
    double sum = 0;
    for (int i = 0; i < TF_OPERATIONS; i++)
        sum += (double)report->tried[i][outcome];
    return sum;
}

double fig_remesh_tried(const tf_remesh_report *report)
{
    double sum = 0;
    for (int i = TF_COMMITTED; i < TF_OUTCOMES; i++)
        sum += fig_remesh_refused(report, (tf_outcome)i);
    return sum;
}

static tf_vector corner_of(const fig_some_mesh *mesh, int corner)
{
    const double *x = mesh->x + 3 * (ptrdiff_t)mesh->triangle[corner];
    return (tf_vector){{x[0], x[1], x[2]}};
}

double fig_least_angle(const fig_some_mesh *mesh)
{
    double least = 180;
    for (int c = 0; c < 3 * mesh->triangles; c++) {
        tf_vector at = corner_of(mesh, c);
        tf_vector u = tf_vector_difference(
            corner_of(mesh, c / 3 * 3 + (c % 3 + 1) % 3), at);
        tf_vector v = tf_vector_difference(
            corner_of(mesh, c / 3 * 3 + (c % 3 + 2) % 3), at);
        tf_vector cross = tf_vector_cross(u, v);
        double angle =
            atan2(sqrt(tf_vector_dot(cross, cross)), tf_vector_dot(u, v));
        least = fmin(least, angle * 180 / acos(-1));
    }
    return least;
}

void fig_draw_triangles(fig_scene *scene, const fig_some_mesh *mesh,
                        fig_paint paint)
{
    for (int t = 0; t < mesh->triangles; t++) {
        tf_vector corner[3];
        for (int i = 0; i < 3; i++)
            corner[i] = corner_of(mesh, 3 * t + i);
        fig_scene_triangle(scene, corner, FIG_WIDTH_THIN, paint);
    }
}

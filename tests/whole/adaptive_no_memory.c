// Adaptive surfaces and flows without memory: each allocation fails in turn,
// which is reported, and the surface stays as it was.
#include "flow/flow.h"
#include "remesh/remesh.h"
#include "support/adaptive_scenes.h"
#include "support/adaptive_surfaces.h"
#include "support/blobs.h"
#include "support/failing_memory.h"
#include "support/hash.h"
#include "support/support.h"
#include "surgery/collapse.h"
#include "surgery/flip.h"
#include "surgery/move.h"
#include "surgery/split.h"
#include "topology/drop.h"
#include "topology/merge.h"
#include "topology/pinch.h"
#include "topology/reconnect.h"

#include <string.h>

// Adaptive surfaces -----------------------------------------------------------

static tf_error error;
static blobs parts;

static void make_scene(const adaptive_scene *scene)
{
    parts.vertices = scene->vertices;
    parts.triangles = scene->triangles;
    memcpy(parts.position, scene->position,
           3 * sizeof(double) * (size_t)scene->vertices);
    memcpy(parts.triangle, scene->triangle,
           3 * sizeof(int) * (size_t)scene->triangles);
}

/// Two by two squares.
static void make_sheet(void)
{
    static adaptive_scene scene;
    scene = (adaptive_scene){.unit = 1};
    add_sheet(&scene, 0, 0, 0, 2, 2);
    make_scene(&scene);
}

/// Two boxes of squares, one above the other.
static void make_boxes(void)
{
    static adaptive_scene scene;
    scene = (adaptive_scene){.unit = 1};
    add_box(&scene, (const int[]){0, 0, 0}, (const int[]){2, 2, 1});
    add_box(&scene, (const int[]){0, 0, 2}, (const int[]){2, 2, 3});
    make_scene(&scene);
}

static int vertex_at(double x, double y, double z)
{
    const double *at = parts.position[0];
    for (int v = 0; v < parts.vertices; v++, at += 3)
        if (at[0] == x && at[1] == y && at[2] == z)
            return v;
    ck_abort_msg("no vertex there");
}

/// Two necks, one beside the other: each can be pinched or dropped, and they
/// can merge.
static void make_necks(void)
{
    static const double radius[] = {1, 1, 0.3, 1, 1},
                        height[] = {0, 1, 2, 3, 4};
    parts.vertices = parts.triangles = 0;
    for (int i = 0; i < 2; i++) {
        int first = parts.vertices;
        add_turned(&parts, 3, 5, radius, height);
        for (int v = first; i == 1 && v < parts.vertices; v++)
            parts.position[v][2] += 4.7;
    }
}

static tf_adaptive_surface *make_adaptive(void)
{
    const tf_mesh mesh = {.axes = 3,
                          .vertices = parts.vertices,
                          .triangles = parts.triangles,
                          .triangle = parts.triangle};
    tf_adaptive_surface *surface = NULL;
    while (lacks_memory(
        tf_adaptive_create(&mesh, parts.position[0], &surface, &error))) {
        ck_assert_ptr_null(surface);
        ck_assert_int_eq(error.status, TF_OUT_OF_MEMORY);
    }
    return surface;
}

static uint64_t hash_of(const tf_adaptive_surface *surface)
{
    tf_mesh mesh = *tf_adaptive_mesh(surface);
    uint64_t hash =
        hash_bytes(HASH_OF_NOTHING, mesh.triangle,
                   3 * (size_t)mesh.triangles * sizeof *mesh.triangle);
    return hash_bytes(hash, tf_adaptive_positions(surface),
                      3 * (size_t)mesh.vertices * sizeof(double));
}

static const double place[] = {1, 1, 0.25};

static tf_status split(tf_adaptive_surface *surface, tf_outcome *outcome)
{
    int vertex, a = vertex_at(1, 1, 0), b = vertex_at(2, 1, 0);
    return tf_adaptive_split(surface, a, b, place, &vertex, outcome);
}

static tf_status move(tf_adaptive_surface *surface, tf_outcome *outcome)
{
    return tf_adaptive_move(surface, vertex_at(1, 1, 0), place, outcome);
}

static tf_status collapse(tf_adaptive_surface *surface, tf_outcome *outcome)
{
    return tf_adaptive_collapse(surface, vertex_at(1, 1, 0), vertex_at(2, 1, 0),
                                outcome);
}

static tf_status collapse_to(tf_adaptive_surface *surface, tf_outcome *outcome)
{
    return tf_adaptive_collapse_to(surface, vertex_at(1, 1, 0),
                                   vertex_at(2, 1, 0), place, outcome);
}

static tf_status flip(tf_adaptive_surface *surface, tf_outcome *outcome)
{
    return tf_adaptive_flip(surface, vertex_at(0, 0, 0), vertex_at(1, 1, 0),
                            outcome);
}

static tf_status drop(tf_adaptive_surface *surface, tf_outcome *outcome)
{
    return tf_adaptive_drop(surface, 0, outcome);
}

static tf_status merge(tf_adaptive_surface *surface, tf_outcome *outcome)
{
    const int low[] = {vertex_at(0, 0, 1), vertex_at(1, 1, 1)},
              high[] = {vertex_at(0, 1, 2), vertex_at(1, 0, 2)};
    return tf_adaptive_merge(surface, low, high, outcome);
}

static tf_status pinch(tf_adaptive_surface *surface, tf_outcome *outcome)
{
    static const int loop[] = {6, 7, 8};
    int vertex[3];
    double above[9];
    for (int i = 0; i < 9; i++)
        above[i] = coordinates_of(surface, loop[i / 3])[i % 3] +
                   (i % 3 == 2 ? 0.25 : 0);
    return tf_adaptive_pinch(surface, loop, above, vertex, outcome);
}

static tf_status remesh(tf_adaptive_surface *surface, tf_outcome *outcome)
{
    static const tf_remesh_options how = {.edge = 0.4, .rounds = 2};
    tf_status status = tf_adaptive_remesh(surface, &how, NULL, &error);
    ck_assert_int_eq(error.status, status);
    *outcome = status == TF_OK ? TF_COMMITTED : TF_NO_OUTCOME;
    return status;
}

static tf_status reconnect(tf_adaptive_surface *surface, tf_outcome *outcome)
{
    static const tf_reconnect_options how = {.edge = 1, .merge = 0.8};
    tf_status status = tf_adaptive_reconnect(surface, &how, NULL, &error);
    ck_assert_int_eq(error.status, status);
    *outcome = status == TF_OK ? TF_COMMITTED : TF_NO_OUTCOME;
    return status;
}

/// What is done, and to what.
typedef struct change {
    tf_status (*act)(tf_adaptive_surface *surface, tf_outcome *outcome);
    void (*make)(void);
} change;

static const change changes[] = {
    {split, make_sheet},       {move, make_sheet},  {collapse, make_sheet},
    {collapse_to, make_sheet}, {flip, make_sheet},  {drop, make_necks},
    {merge, make_boxes},       {pinch, make_necks}, {remesh, make_sheet},
    {reconnect, make_necks},
};

enum {
    CHANGES = sizeof changes / sizeof *changes
};

static const change *own;

static uint64_t change_and_compact(void)
{
    tf_adaptive_surface *surface = make_adaptive();
    uint64_t before = hash_of(surface);
    tf_outcome outcome;
    while (lacks_memory(own->act(surface, &outcome))) {
        ck_assert_int_eq(outcome, TF_NO_OUTCOME);
        ck_assert_uint_eq(hash_of(surface), before);
        ck_assert(is_sound(surface));
    }
    ck_assert_int_eq(outcome, TF_COMMITTED);
    uint64_t changed = hash_of(surface);
    ck_assert_uint_ne(changed, before);
    while (lacks_memory(tf_adaptive_compact(surface, NULL)))
        ck_assert_uint_eq(hash_of(surface), changed);
    expect_told(tf_adaptive_memory(surface));
    uint64_t compact = hash_of(surface);
    tf_adaptive_free(surface);
    return compact;
}

START_TEST(adaptive_surfaces_lack_memory)
{
    own = &changes[_i];
    own->make();
    let_each_fail(change_and_compact);
}
END_TEST

// Flows -----------------------------------------------------------------------

/// The upper parts sink onto the lower ones.
static void sink(void *context, double time, int points, const double point[],
                 const double normal[], double velocity[])
{
    (void)context, (void)time, (void)normal;
    for (int i = 0; i < 3 * points; i++)
        velocity[i] = i % 3 == 2 ? -0.1 * point[i] : 0;
}

static uint64_t let_flow(void)
{
    static const tf_flow_options how = {.edge = 1, .velocity = sink};
    tf_adaptive_surface *surface = make_adaptive();
    tf_flow *flow = NULL;
    while (lacks_memory(tf_flow_create(surface, &flow)))
        ck_assert_ptr_null(flow);
    for (int step = 0; step < 2; step++) {
        uint64_t before = hash_of(surface);
        while (lacks_memory(tf_flow_step(flow, step, 1, &how, NULL, &error))) {
            ck_assert_uint_eq(hash_of(surface), before);
            ck_assert_int_eq(error.status, TF_OUT_OF_MEMORY);
        }
    }
    expect_told(tf_adaptive_memory(surface) + tf_flow_memory(flow));
    uint64_t changed = hash_of(surface);
    tf_flow_free(flow);
    tf_adaptive_free(surface);
    return changed;
}

START_TEST(flows_lack_memory)
{
    make_necks();
    let_each_fail(let_flow);
}
END_TEST

/// The necks cross, and a triangle is turned over.
static void make_crossing_necks(void)
{
    make_necks();
    for (int v = 0; v < parts.vertices / 2; v++)
        parts.position[v][2] += 1.2;
    int first = parts.triangle[0];
    parts.triangle[0] = parts.triangle[1];
    parts.triangle[1] = first;
}

static uint64_t let_around(void)
{
    const tf_mesh mesh = {.axes = 3,
                          .vertices = parts.vertices,
                          .triangles = parts.triangles,
                          .triangle = parts.triangle};
    tf_adaptive_surface *surface = NULL;
    const tf_defects *defects;
    tf_outcome outcome;
    while (lacks_memory(tf_adaptive_create_around(
        &mesh, parts.position[0], &surface, &defects, &error))) {
        ck_assert_ptr_null(surface);
        ck_assert_int_eq(error.status, TF_OUT_OF_MEMORY);
    }
    ck_assert_uint_gt(defects->count, 0);
    ck_assert_int_eq(defects->turned, 1);
    uint64_t before = hash_of(surface);
    while (lacks_memory(remesh(surface, &outcome)))
        ck_assert_uint_eq(hash_of(surface), before);
    expect_told(tf_adaptive_memory(surface));
    uint64_t changed = hash_of(surface);
    ck_assert_uint_ne(changed, before);
    tf_adaptive_free(surface);
    return changed;
}

START_TEST(surfaces_around_defects_lack_memory)
{
    make_crossing_necks();
    let_each_fail(let_around);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/adaptive_no_memory");
    TCase *tcase = tcase_create("failures");
    tcase_add_loop_test(tcase, adaptive_surfaces_lack_memory, 0, CHANGES);
    tcase_add_test(tcase, flows_lack_memory);
    tcase_add_test(tcase, surfaces_around_defects_lack_memory);
    suite_add_tcase(suite, tcase);
    return suite;
}

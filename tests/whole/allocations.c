// Steps of cloth and of flows ask for no memory once they have had what they
// need: the calls of the allocator are counted.
#include "flow/flow.h"
#include "response/resolve.h"
#include "simulate/flow_fields.h"
#include "support/cloth.h"
#include "support/flows.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/watched_memory.h"
#include "surgery/star.h"

#include <stdlib.h>
#include <string.h>

static watched_memory memory;

// Cloth -----------------------------------------------------------------------

/// Plays a scene from its start; returns how many calls its steps made from
/// `begin` on.
static long play(cloth_scene which, int edges, int begin, int steps,
                 tf_surface **surface, tf_resolver **resolver)
{
    cloth_model *cloth = cloth_new(which, edges);
    if (!*surface) {
        *surface = surface_of(&cloth->mesh);
        ck_assert_int_eq(tf_resolver_create(*surface, resolver), TF_OK);
    }
    size_t numbers = (size_t)(cloth->mesh.axes * cloth->mesh.vertices);
    double *end = malloc(sizeof *end * numbers);
    ck_assert_ptr_nonnull(end);
    long all = 0;
    for (int i = 0; i < steps; i++) {
        cloth_propose(cloth, end);
        long before = memory.calls;
        tf_status status =
            tf_step_resolve(*resolver, cloth->mesh.vertices, cloth->position,
                            end, cloth->inverse_mass, NULL, NULL, NULL);
        all += i >= begin ? memory.calls - before : 0;
        ck_assert_int_eq(status, TF_OK);
        cloth_accept(cloth, tf_resolver_unpushed(*resolver), end);
    }
    free(end);
    cloth_free(cloth);
    return all;
}

static const int edges[CLOTH_SCENES] = {60, 20, 8, 8, 6, 2};
static const int steps[CLOTH_SCENES] = {100, 100, 60, 60, 120, 240};

START_TEST(a_scene_played_again_allocates_nothing)
{
    tf_surface *surface = NULL;
    tf_resolver *resolver = NULL;
    memory_watch(&memory);
    int count = (int)cases(steps[_i]);
    long first =
        play((cloth_scene)_i, edges[_i], 0, count, &surface, &resolver);
    ck_assert_int_gt(first, 0);
    long again =
        play((cloth_scene)_i, edges[_i], 0, count, &surface, &resolver);
    ck_assert_int_eq(again, 0);
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    memory_end(&memory);
}
END_TEST

START_TEST(the_second_half_of_a_fall_allocates_nothing)
{
    tf_surface *surface = NULL;
    tf_resolver *resolver = NULL;
    memory_watch(&memory);
    int half = steps[SPHERE] / 2;
    ck_assert_int_eq(
        play(SPHERE, edges[SPHERE], half, 2 * half, &surface, &resolver), 0);
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    memory_end(&memory);
}
END_TEST

// Flows -----------------------------------------------------------------------

/// Gives a surface the mesh and the positions of another one, in the memory
/// that it has.
static void reset(tf_adaptive_surface *surface, const tf_adaptive_surface *from)
{
    surface->vertices = from->vertices;
    surface->triangles = from->triangles;
    memcpy(surface->position.data, from->position.data,
           3 * sizeof(double) * (size_t)from->vertices);
    memcpy(surface->vertex.data, from->vertex.data,
           3 * sizeof(int) * (size_t)from->triangles);
    tf_stars_build(surface, surface->box.data);
}

/// Makes the steps of a flow from its start; returns how many calls they made,
/// and counts contacts.
static long let_flow(tf_flow *flow, tf_velocity_field *field, double edge,
                     size_t *contacts)
{
    enum {
        STEPS = 60
    };
    const tf_flow_options options = {
        .edge = edge, .velocity = tf_field_apply, .context = &field};
    const tf_flow_report *report;
    long all = 0;
    for (int i = 0; i < STEPS; i++) {
        long before = memory.calls;
        tf_status status = tf_flow_step(flow, 3.0 * i / STEPS, 3.0 / STEPS,
                                        &options, &report, NULL);
        all += memory.calls - before;
        ck_assert_int_eq(status, TF_OK);
        *contacts += report->response->contacts;
    }
    return all;
}

/// A ball in vortices that turn back, and a bumpy one that grows into itself.
static tf_adaptive_surface *ball_of(int which)
{
    static const double center[] = {0.35, 0.35, 0.35};
    return which == 0 ? adaptive_sphere(8, center, 0.15)
                      : adaptive_bumpy_sphere(8, 0.1, 2);
}

START_TEST(a_flow_played_again_allocates_nothing)
{
    static tf_velocity_field *const field[] = {tf_vortices, tf_growth};
    static const double edge[] = {0.03, 0.2};
    memory_watch(&memory);
    tf_adaptive_surface *ball = ball_of(_i), *start = ball_of(_i);
    size_t contacts = 0;
    tf_flow *flow;
    ck_assert_int_eq(tf_flow_create(ball, &flow), TF_OK);
    ck_assert_int_gt(let_flow(flow, field[_i], edge[_i], &contacts), 0);
    size_t bytes = tf_flow_memory(flow);
    reset(ball, start);
    ck_assert_int_eq(let_flow(flow, field[_i], edge[_i], &contacts), 0);
    ck_assert_uint_eq(tf_flow_memory(flow), bytes);
    ck_assert((contacts > 0) == (_i == 1));
    tf_flow_free(flow);
    tf_adaptive_free(ball);
    tf_adaptive_free(start);
    memory_end(&memory);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/allocations");
    TCase *tcase = tcase_create("steady state");
    tcase_add_loop_test(tcase, a_scene_played_again_allocates_nothing, 0,
                        CLOTH_SCENES);
    tcase_add_test(tcase, the_second_half_of_a_fall_allocates_nothing);
    tcase_add_loop_test(tcase, a_flow_played_again_allocates_nothing, 0, 2);
    suite_add_tcase(suite, tcase);
    return suite;
}

// Adaptive surfaces and responses without memory: each allocation fails in turn,
// which is reported, and what there was stays good.  The linker replaces those
// of the C library by the functions below: see tests/rules.mk.
#include "flow/flow.h"
#include "remesh/remesh.h"
#include "response/resolve.h"
#include "support/adaptive_surfaces.h"
#include "support/blobs.h"
#include "support/proposals.h"
#include "support/scrambled_workers.h"
#include "support/support.h"
#include "surface/surface_memory.h"
#include "surgery/collapse.h"
#include "surgery/flip.h"
#include "surgery/move.h"
#include "surgery/split.h"
#include "topology/drop.h"
#include "topology/merge.h"
#include "topology/pinch.h"
#include "topology/reconnect.h"

#include <stdlib.h>
#include <string.h>

/// How many allocations succeed before all fail; below 0: all succeed.
static long left = -1;

// The names are the linker's.
void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *old, size_t size);
void *__real_aligned_alloc(size_t alignment, size_t size);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *old, size_t size);
void *__wrap_aligned_alloc(size_t alignment, size_t size);

static int fails(void)
{
    return left == 0 || (left > 0 && left-- == 0);
}

void *__wrap_malloc(size_t size)
{
    return fails() ? NULL : __real_malloc(size);
}

void *__wrap_calloc(size_t count, size_t size)
{
    return fails() ? NULL : __real_calloc(count, size);
}

void *__wrap_realloc(void *old, size_t size)
{
    return fails() ? NULL : __real_realloc(old, size);
}

void *__wrap_aligned_alloc(size_t alignment, size_t size)
{
    return fails() ? NULL : __real_aligned_alloc(alignment, size);
}

/// Makes a surface of another one's mesh, which must be good.
static tf_status copy(const tf_adaptive_surface *from,
                      tf_adaptive_surface **made)
{
    tf_mesh mesh = tf_adaptive_mesh(from);
    *made = NULL;
    return tf_adaptive_create(&mesh, tf_adaptive_positions(from), made, NULL);
}

static void expect_good(tf_adaptive_surface *surface)
{
    tf_adaptive_surface *again;
    ck_assert_int_eq(tf_adaptive_compact(surface, NULL), TF_OK);
    ck_assert_int_eq(copy(surface, &again), TF_OK);
    tf_adaptive_free(again);
}

/// Lets each allocation of `act` fail in turn, each time for a new surface:
/// expects that it says so, and that the surface stays good.
static void act_without_memory(tf_adaptive_surface *make(void),
                               tf_status act(tf_adaptive_surface *surface),
                               int least_failures)
{
    tf_status status = TF_OUT_OF_MEMORY;
    int failures = 0;
    for (; status != TF_OK; failures++) {
        tf_adaptive_surface *surface = make();
        left = failures;
        status = act(surface);
        left = -1;
        ck_assert(status == TF_OK || status == TF_OUT_OF_MEMORY);
        expect_good(surface);
        tf_adaptive_free(surface);
    }
    ck_assert_int_gt(failures, least_failures);
}

START_TEST(a_surface_is_made_as_a_whole_or_not_at_all)
{
    tf_adaptive_surface *sheet = adaptive_sheet(2, 2), *made;
    tf_status status = TF_OUT_OF_MEMORY;
    int failures = 0;
    for (; status != TF_OK; failures++) {
        left = failures;
        status = copy(sheet, &made);
        left = -1;
        ck_assert(status == TF_OK || status == TF_OUT_OF_MEMORY);
        ck_assert((status == TF_OK) == (made != NULL));
    }
    ck_assert_int_gt(failures, 10);
    tf_adaptive_free(made);
    tf_adaptive_free(sheet);
}
END_TEST

static tf_adaptive_surface *two_by_two(void)
{
    return adaptive_sheet(2, 2);
}

static int operation;

static tf_status try_operation(tf_adaptive_surface *surface, int which,
                               tf_outcome *outcome)
{
    static const double place[] = {1, 1, 0.25};
    int vertex;
    switch (which) {
    case 0:
        return tf_adaptive_split(surface, 4, 5, place, &vertex, outcome);
    case 1:
        return tf_adaptive_move(surface, 4, place, outcome);
    case 2:
        return tf_adaptive_collapse(surface, 4, 5, outcome);
    case 3:
        return tf_adaptive_collapse_to(surface, 4, 5, place, outcome);
    default:
        return tf_adaptive_flip(surface, 0, 4, outcome);
    }
}

/// Expects that an operation without memory changes nothing.
static tf_status expect_all_or_nothing(
    tf_adaptive_surface *surface,
    tf_status act(tf_adaptive_surface *surface, int which, tf_outcome *outcome))
{
    int before = triangles_of(surface);
    tf_outcome outcome;
    tf_status status = act(surface, operation, &outcome);
    left = -1;
    ck_assert((status == TF_OK) == (outcome != TF_NO_OUTCOME));
    if (status != TF_OK)
        ck_assert_int_eq(triangles_of(surface), before);
    return status;
}

static tf_status operate(tf_adaptive_surface *sheet)
{
    return expect_all_or_nothing(sheet, try_operation);
}

START_TEST(an_operation_is_all_or_nothing)
{
    operation = _i;
    act_without_memory(two_by_two, operate, 1);
}
END_TEST

/// Two necks, one beside the other: each can be pinched, one can be dropped,
/// and they can merge.
static tf_adaptive_surface *two_necks(void)
{
    static const double radius[] = {1, 1, 0.3, 1, 1},
                        height[] = {0, 1, 2, 3, 4};
    static blobs made;
    made.vertices = made.triangles = 0;
    for (int i = 0; i < 2; i++) {
        int first = made.vertices;
        add_turned(&made, 3, 5, radius, height);
        for (int v = first; i == 1 && v < made.vertices; v++)
            made.position[v][2] += 4.7;
    }
    return blobs_surface(&made);
}

static tf_status try_reconnection(tf_adaptive_surface *surface, int which,
                                  tf_outcome *outcome)
{
    static const int loop[] = {6, 7, 8}, low[] = {12, 16}, high[] = {17, 33};
    int vertex[3];
    double place[9];
    if (which == 0)
        return tf_adaptive_drop(surface, 0, outcome);
    if (which == 1)
        return tf_adaptive_merge(surface, low, high, outcome);
    for (int i = 0; i < 9; i++)
        place[i] = coordinates_of(surface, loop[i / 3])[i % 3] +
                   (i % 3 == 2 ? 0.25 : 0);
    return tf_adaptive_pinch(surface, loop, place, vertex, outcome);
}

static tf_status reconnect_once(tf_adaptive_surface *surface)
{
    return expect_all_or_nothing(surface, try_reconnection);
}

START_TEST(a_reconnection_is_all_or_nothing)
{
    operation = _i;
    act_without_memory(two_necks, reconnect_once, 1);
}
END_TEST

static tf_status reconnect(tf_adaptive_surface *surface)
{
    static const tf_reconnect_options how = {.edge = 1, .merge = 0.8};
    return tf_adaptive_reconnect(surface, &how, NULL);
}

START_TEST(reconnecting_leaves_a_good_surface)
{
    act_without_memory(two_necks, reconnect, 6);
}
END_TEST

static tf_status remesh(tf_adaptive_surface *sheet)
{
    static const tf_remesh_options how = {.edge = 0.4, .rounds = 2};
    return tf_adaptive_remesh(sheet, &how, NULL);
}

START_TEST(remeshing_leaves_a_good_surface)
{
    act_without_memory(two_by_two, remesh, 20);
}
END_TEST

/// The upper parts sink onto the lower ones.
static void sink(void *context, double time, int points, const double point[],
                 const double normal[], double velocity[])
{
    (void)context, (void)time, (void)normal;
    for (int i = 0; i < 3 * points; i++)
        velocity[i] = i % 3 == 2 ? -0.1 * point[i] : 0;
}

/// With enough memory the flow goes on.
static tf_status flow(tf_adaptive_surface *surface)
{
    static const tf_flow_options how = {.edge = 1, .velocity = sink};
    long allocations = left;
    tf_flow *flow;
    left = -1;
    ck_assert_int_eq(tf_flow_create(surface, &flow), TF_OK);
    left = allocations;
    tf_status status = tf_flow_step(flow, &how, 0, 1, NULL);
    left = -1;
    expect_good(surface);
    ck_assert_int_eq(tf_flow_step(flow, &how, 1, 1, NULL), TF_OK);
    tf_flow_free(flow);
    return status;
}

START_TEST(flowing_leaves_a_good_surface)
{
    act_without_memory(two_necks, flow, 20);
}
END_TEST

// Filters ---------------------------------------------------------------------

START_TEST(a_filter_without_memory_leaves_the_last_one)
{
    static const int corner[] = {0, 1, 2}, group[] = {1, 1, 1};
    tf_mesh mesh = {
        .axes = 3, .vertices = 3, .triangles = 1, .triangle = corner};
    tf_pair_filter filter = {.vertices = 3, .group = group};
    tf_surface *surface;
    ck_assert_int_eq(tf_surface_create(&mesh, &surface, NULL), TF_OK);
    left = 0;
    tf_status status = tf_surface_set_filter(surface, &filter, NULL);
    left = -1;
    ck_assert_int_eq(status, TF_OUT_OF_MEMORY);
    ck_assert_ptr_null(surface->filter.group);
    ck_assert_int_eq(tf_surface_set_filter(surface, &filter, NULL), TF_OK);
    ck_assert_ptr_nonnull(surface->filter.group);
    tf_surface_free(surface);
}
END_TEST

// Responses -------------------------------------------------------------------

static proposal made;
static int workers = 2;

static tf_status resolve(tf_resolver *resolver, double end[])
{
    const tf_parallel parallel = scrambled_workers(&workers);
    const tf_response_options all_levels = {.impulse_rounds = 1,
                                            .zone_rounds = 1,
                                            .rigid = true,
                                            .check_start = true,
                                            .parallel = &parallel};
    return tf_step_resolve(resolver, made.mesh.vertices, made.start, end, NULL,
                           &all_levels, NULL, NULL);
}

/// Resolves with new memory, of which only some is to be had, and if that fails,
/// again with enough.  Returns the status of the first try.
static tf_status resolve_anew(int allocations, double end[])
{
    tf_surface *surface;
    tf_resolver *resolver;
    ck_assert_int_eq(tf_surface_create(&made.mesh, &surface, NULL), TF_OK);
    ck_assert_int_eq(tf_resolver_create(surface, &resolver), TF_OK);
    memcpy(end, made.end, sizeof made.end);
    left = allocations;
    tf_status status = resolve(resolver, end);
    left = -1;
    if (status != TF_OK) {
        ck_assert_int_eq(status, TF_OUT_OF_MEMORY);
        ck_assert_mem_eq(end, made.end, sizeof made.end);
        ck_assert_int_eq(resolve(resolver, end), TF_OK);
    }
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    return status;
}

START_TEST(a_response_is_all_or_nothing)
{
    static double expected[3 * PROPOSAL_VERTICES], end[3 * PROPOSAL_VERTICES];
    generator random = generator_new(5);
    proposal_make(&random, (proposal_shape)_i, 2, SHUFFLED, &made);
    ck_assert_int_eq(resolve_anew(-1, expected), TF_OK);
    ck_assert_mem_ne(expected, made.end, sizeof expected);
    int failures = 0;
    while (resolve_anew(failures, end) != TF_OK) {
        ck_assert_mem_eq(end, expected, sizeof end);
        failures++;
    }
    ck_assert_int_gt(failures, 20);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/no_memory");
    TCase *tcase = tcase_create("failures");
    tcase_add_test(tcase, a_surface_is_made_as_a_whole_or_not_at_all);
    tcase_add_loop_test(tcase, an_operation_is_all_or_nothing, 0, 5);
    tcase_add_loop_test(tcase, a_reconnection_is_all_or_nothing, 0, 3);
    tcase_add_test(tcase, reconnecting_leaves_a_good_surface);
    tcase_add_test(tcase, remeshing_leaves_a_good_surface);
    tcase_add_test(tcase, flowing_leaves_a_good_surface);
    tcase_add_test(tcase, a_filter_without_memory_leaves_the_last_one);
    tcase_add_loop_test(tcase, a_response_is_all_or_nothing, SHEETS,
                        PROPOSAL_SHAPES);
    suite_add_tcase(suite, tcase);
    return suite;
}

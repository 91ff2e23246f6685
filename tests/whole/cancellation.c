// Long calls that their caller cancels: they end soon and change nothing, and
// what they worked on is as good as new.
#include "bench/layers.h"
#include "fast/detect.h"
#include "response/conjugate_residuals.h"
#include "response/limit.h"
#include "response/minres.h"
#include "response/normal_residuals.h"
#include "response/resolve.h"
#include "support/memory.h"
#include "support/proposals.h"
#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "surface/candidates.h"
#include "surface/check.h"
#include "surface/surface_memory.h"
#include "threads/threads.h"

#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// A step ----------------------------------------------------------------------

enum {
    SIDE = 12, // vertices of a layer
    WALL = 60, // edges
    MOST_NUMBERS = 3 * 10 * SIDE * SIDE
};

static tf_mesh mesh;
static const double *start;
static double proposed[MOST_NUMBERS], ended[MOST_NUMBERS];
static const double *inverse_mass; ///< NULL: 1 for all

static size_t bytes_of_step(void)
{
    return (size_t)(mesh.axes * mesh.vertices) * sizeof(double);
}

/// In space: layers, whose vertices are scattered by two edge lengths.
static void make_layers(void)
{
    static layers cloth;
    generator random = generator_new(100);
    if (cloth.mesh.vertices == 0)
        cloth = layers_new(SIDE, 3, 1);
    mesh = cloth.mesh;
    start = cloth.motion.start;
    inverse_mass = NULL;
    for (int i = 0; i < 3 * mesh.vertices; i++)
        proposed[i] = start[i] + uniform(&random, -2, 2) / SIDE;
}

/// In the plane: loops, turned inside out.
static void make_loops(void)
{
    static proposal made;
    generator random = generator_new(200);
    proposal_make(&random, LOOPS, 4, INSIDE_OUT, &made);
    mesh = made.mesh;
    start = made.start;
    inverse_mass = NULL;
    memcpy(proposed, made.end, sizeof made.end);
}

/// In the plane: two scripted walls, at heights 0 and 2, close upon a free chain.
static void make_walls(void)
{
    static double from[6 * (WALL + 1)], mass[3 * (WALL + 1)];
    static int edge[6 * WALL];
    int next = 0;
    for (int v = 0; v < 3 * (WALL + 1); v++) {
        int height = v / (WALL + 1), i = v % (WALL + 1);
        from[2 * v] = (double)i / WALL * (1 + 0.01 * (1 - height));
        from[2 * v + 1] = height;
        mass[v] = height == 1;
        proposed[2 * v] = from[2 * v];
        proposed[2 * v + 1] = height + 1.5 * (1 - height);
        for (int k = 0; k < 2 && i < WALL; k++)
            edge[next++] = v + k;
    }
    mesh = (tf_mesh){
        .axes = 2, .vertices = 3 * (WALL + 1), .edges = 3 * WALL, .edge = edge};
    start = from;
    inverse_mass = mass;
}

// A caller --------------------------------------------------------------------

enum {
    STAGES = 16
};

/// Is told how a call goes on, and cancels it.
typedef struct caller {
    long calls, last; ///< how often it was told; when it cancels; 0: never
    const char *stage[STAGES];
    tf_watch *watch;      ///< if it is the test's own
    size_t work, longest; ///< units of work; the most between two calls
} caller;

static void note_stage(caller *own, const char *name)
{
    int i = 0;
    while (own->stage[i] && strcmp(own->stage[i], name) != 0)
        i++;
    ck_assert_int_lt(i, STAGES - 1);
    own->stage[i] = name;
}

static void note_work(caller *own)
{
    size_t work = atomic_load(&own->watch->work), more = work - own->work;
    own->longest = more > own->longest ? more : own->longest;
    own->work = work;
}

static bool listen(void *context, const tf_stage *stage)
{
    caller *own = context;
    own->calls++;
    // Who has cancelled hears nothing more.
    ck_assert(own->last == 0 || own->calls <= own->last);
    ck_assert(stage->total == 0 || stage->done <= stage->total);
    note_stage(own, stage->name);
    if (own->watch)
        note_work(own);
    return own->calls != own->last;
}

static bool has_heard(const caller *own, const char *name)
{
    for (int i = 0; own->stage[i]; i++)
        if (strcmp(own->stage[i], name) == 0)
            return true;
    return false;
}

// What calls work on, and what they answer ------------------------------------

typedef struct workplace {
    tf_surface *surface;
    tf_resolver *resolver;
} workplace;

static workplace workplace_new(void)
{
    workplace w = {.surface = surface_of(&mesh)};
    ck_assert_int_eq(tf_resolver_create(w.surface, &w.resolver), TF_OK);
    return w;
}

static void workplace_free(workplace *w)
{
    tf_resolver_free(w->resolver);
    tf_surface_free(w->surface);
}

/// All bytes of an answer, one piece after another.
typedef struct answer {
    tf_status status;
    tf_error error;
    unsigned char *bytes;
    size_t size;
} answer;

static void keep(answer *to, const void *piece, size_t size)
{
    unsigned char *bytes = allocate(to->size + size, 1);
    if (to->size > 0)
        memcpy(bytes, to->bytes, to->size);
    if (size > 0)
        memcpy(bytes + to->size, piece, size);
    free(to->bytes);
    to->bytes = bytes;
    to->size += size;
}

// Calls -----------------------------------------------------------------------

/// How a call is made.
typedef struct manner {
    const tf_response_options *options;
    const tf_parallel *parallel;
    tf_progress *progress;
    void *context;
} manner;

/// Whether a call that did not succeed has left these bytes as they were.
static void expect_untouched(tf_status status, const void *is, const void *was,
                             size_t size)
{
    if (status != TF_OK)
        ck_assert_mem_eq(is, was, size);
}

static void check(workplace *w, const manner *how, answer *to)
{
    const tf_check_options options = {.parallel = how->parallel,
                                      .progress = how->progress,
                                      .context = how->context};
    const tf_crossings before = {77, NULL};
    tf_crossings found = before;
    // What is proposed intersects.
    to->status = tf_surface_check(w->surface, mesh.vertices, proposed, &options,
                                  &found, &to->error);
    expect_untouched(to->status, &found, &before, sizeof found);
    if (to->status == TF_OK)
        keep(to, found.crossing, found.count * sizeof *found.crossing);
}

static tf_detect_options detection(const manner *how)
{
    return (tf_detect_options){.parallel = how->parallel,
                               .progress = how->progress,
                               .context = how->context};
}

static tf_motion motion(void)
{
    return (tf_motion){mesh.axes, mesh.vertices, start, proposed};
}

static void detect(workplace *w, const manner *how, answer *to)
{
    const tf_detect_options options = detection(how);
    const tf_motion moved = motion();
    const tf_contacts before = {.count = 77};
    tf_contacts found = before;
    to->status =
        tf_surface_detect(w->surface, &moved, &options, &found, &to->error);
    expect_untouched(to->status, &found.count, &before.count,
                     sizeof found.count);
    if (to->status == TF_OK)
        keep(to, found.contact, found.count * sizeof *found.contact);
}

static void list(workplace *w, const manner *how, answer *to)
{
    const tf_detect_options options = detection(how);
    const tf_motion moved = motion();
    tf_candidates found;
    to->status =
        tf_surface_candidates(w->surface, &moved, &options, &found, &to->error);
    if (to->status != TF_OK)
        return;
    keep(to, found.points, found.point_count * sizeof *found.points);
    keep(to, found.edges, found.edge_count * sizeof *found.edges);
}

static tf_response_options response(const manner *how)
{
    tf_response_options options = *how->options;
    options.parallel = how->parallel;
    options.progress = how->progress;
    options.context = how->context;
    return options;
}

static void limit(workplace *w, const manner *how, answer *to)
{
    const tf_response_options options = response(how);
    int halvings = 77;
    memcpy(ended, proposed, bytes_of_step());
    to->status = tf_step_limit(w->resolver, mesh.vertices, start, ended,
                               &options, &halvings, &to->error);
    expect_untouched(to->status, ended, proposed, bytes_of_step());
    ck_assert(to->status == TF_OK || halvings == 77);
    if (to->status == TF_OK)
        keep(to, ended, bytes_of_step());
}

static void resolve(workplace *w, const manner *how, answer *to)
{
    const tf_response_options options = response(how);
    const tf_response_report *report = NULL;
    const tf_answered_contact *contact;
    size_t count = 77;
    memcpy(ended, proposed, bytes_of_step());
    to->status = tf_step_resolve(w->resolver, mesh.vertices, start, ended,
                                 inverse_mass, &options, &report, &to->error);
    ck_assert_int_eq(tf_resolver_contacts(w->resolver, &count, &contact),
                     TF_OK);
    const unsigned char *flags = tf_resolver_vertices(w->resolver);
    const double *unpushed = tf_resolver_unpushed(w->resolver);
    ck_assert((to->status == TF_OK) == (report != NULL));
    ck_assert((to->status == TF_OK) == (unpushed != NULL));
    ck_assert((to->status == TF_OK) == (flags != NULL));
    expect_untouched(to->status, ended, proposed, bytes_of_step());
    if (to->status != TF_OK) {
        ck_assert_uint_eq(count, 0);
        return;
    }
    ck_assert((report->held > 0) == (inverse_mass != NULL));
    keep(to, ended, bytes_of_step());
    keep(to, contact, count * sizeof *contact);
    keep(to, flags, (size_t)mesh.vertices);
    keep(to, unpushed, bytes_of_step());
    keep(to, report->rounds, sizeof report->rounds);
}

static const struct {
    const char *name, *stage; ///< a stage that it has
    void (*run)(workplace *w, const manner *how, answer *to);
    tf_response_options options;
} call[] = {
    {"check", "crossings", check, {0}},
    {"detect", "contacts", detect, {0}},
    {"candidates", "pairs", list, {0}},
    {"limit", "trees", limit, {.check_start = true}},
    {"zones", "zones", resolve, {.check_start = true}},
    {"friction", "zones", resolve, {.friction = 0.5, .restitution = 0.5}},
    {"residuals", "zones", resolve, {.solver = &tf_conjugate_residuals}},
    {"minres", "zones", resolve, {.solver = &tf_minres}},
    {"normal residuals", "zones", resolve, {.solver = &tf_normal_residuals}},
    {"impulses", "impulses", resolve, {.impulse_rounds = 3, .zone_rounds = 2}},
    {"rigid", "rigid zones", resolve, {.zone_rounds = -1, .rigid = true}},
    {"failsafe", "failsafe", resolve, {.zone_rounds = -1}},
    {"held back", "failsafe", resolve, {.zone_rounds = 8}},
    {"substeps", "zones", resolve, {.zone_rounds = 8, .substeps = 2}},
    {"thickness", "pairs", resolve, {.zone_rounds = 8, .thickness = 0.1}},
};

enum {
    CALLS = sizeof call / sizeof *call
};

static answer run(int number, workplace *w, const tf_parallel *parallel,
                  caller *own)
{
    const manner how = {&call[number].options, parallel, own ? listen : NULL,
                        own};
    answer all = {.status = TF_OK};
    call[number].run(w, &how, &all);
    ck_assert_int_eq(all.error.status, all.status);
    return all;
}

// Cancelled at each call of the callback --------------------------------------

/// The last calls hold walls back, and of the others one in five works in the
/// plane.
static void make_scene(int number)
{
    if (number >= CALLS - 3)
        make_walls();
    else if (number % 5 == 4)
        make_loops();
    else
        make_layers();
}

static void expect_same(const answer *a, const answer *b, const char *name,
                        long moment)
{
    ck_assert_msg(a->status == TF_OK && b->status == TF_OK, "%s", name);
    ck_assert_msg(a->size == b->size &&
                      memcmp(a->bytes, b->bytes, a->size) == 0,
                  "%s, cancelled at %ld, then other bits", name, moment);
}

static void cancel(int number, workplace *w, const tf_parallel *parallel,
                   long moment)
{
    caller own = {.last = moment};
    answer none = run(number, w, parallel, &own);
    ck_assert_msg(none.status == TF_CANCELLED, "%s: %ld of %ld calls: %s",
                  call[number].name, own.calls, moment,
                  tf_status_message(none.status));
    ck_assert_int_eq(own.calls, moment);
    free(none.bytes);
}

static void repeat(int number, workplace *w, const tf_parallel *parallel,
                   long moment, const answer *expected)
{
    answer all = run(number, w, parallel, NULL);
    expect_same(&all, expected, call[number].name, moment);
    free(all.bytes);
}

/// Cancels at so many of the calls, and at the last one.  After it, and after
/// every third before, the same workplace does all of it.
static void cancel_and_repeat(int number, workplace *w,
                              const tf_parallel *parallel, long calls,
                              long tries, const answer *expected)
{
    long step = calls / tries + 1;
    for (long i = 0; 1 + i * step < calls; i++) {
        cancel(number, w, parallel, 1 + i * step);
        if (i % 3 == 0)
            repeat(number, w, parallel, 1 + i * step, expected);
    }
    cancel(number, w, parallel, calls);
    repeat(number, w, parallel, calls, expected);
}

START_TEST(each_call_of_the_callback_may_cancel)
{
    caller patient = {0};
    make_scene(_i);
    workplace fresh = workplace_new(), w = workplace_new();
    answer expected = run(_i, &fresh, NULL, NULL);
    answer watched = run(_i, &w, NULL, &patient);
    expect_same(&watched, &expected, call[_i].name, 0);
    ck_assert_msg(has_heard(&patient, call[_i].stage), "%s", call[_i].name);
    ck_assert_int_gt(patient.calls, 10);
    cancel_and_repeat(_i, &w, NULL, patient.calls, cases(60), &expected);
    free(expected.bytes);
    free(watched.bytes);
    workplace_free(&fresh);
    workplace_free(&w);
}
END_TEST

START_TEST(scrambled_workers_are_cancelled)
{
    static const int workers = 3;
    const tf_parallel parallel = scrambled_workers(&workers);
    caller patient = {0};
    make_scene(_i);
    workplace fresh = workplace_new(), w = workplace_new();
    answer expected = run(_i, &fresh, NULL, NULL);
    answer watched = run(_i, &w, &parallel, &patient);
    cancel_and_repeat(_i, &w, &parallel, patient.calls, cases(15), &expected);
    free(expected.bytes);
    free(watched.bytes);
    workplace_free(&fresh);
    workplace_free(&w);
}
END_TEST

// How often threads tell depends on how they run.
START_TEST(threads_are_cancelled)
{
    tf_threads *threads;
    make_scene(_i);
    ck_assert_int_eq(tf_threads_create(4, &threads), TF_OK);
    const tf_parallel *parallel = tf_threads_parallel(threads);
    workplace fresh = workplace_new(), w = workplace_new();
    answer expected = run(_i, &fresh, NULL, NULL);
    generator random = generator_new(200);
    for (int i = 0; i < (int)cases(15); i++) {
        caller own = {.last = 1 + below(&random, 40)};
        answer some = run(_i, &w, parallel, &own);
        ck_assert_int_eq(some.status,
                         own.calls < own.last ? TF_OK : TF_CANCELLED);
        answer all = run(_i, &w, parallel, NULL);
        expect_same(&all, &expected, call[_i].name, own.last);
        free(some.bytes);
        free(all.bytes);
    }
    free(expected.bytes);
    workplace_free(&fresh);
    workplace_free(&w);
    tf_threads_free(threads);
}
END_TEST

// How much is done ------------------------------------------------------------

// A watch of the test's own over a call that has no callback counts its work.
START_TEST(little_work_is_done_between_calls_and_after_the_last)
{
    caller patient = {0};
    tf_watch storage, *outer;
    make_scene(_i);
    workplace w = workplace_new();
    free(run(_i, &w, NULL, &patient).bytes);
    long tries = cases(40), step = patient.calls / tries + 1;
    for (long moment = 1; moment <= patient.calls; moment += step) {
        caller own = {.last = moment, .watch = &storage};
        outer = tf_workers_watch(&w.surface->workers, &storage, listen, &own);
        answer none = run(_i, &w, NULL, NULL);
        w.surface->workers.watch = outer;
        ck_assert_int_eq(none.status, TF_CANCELLED);
        ck_assert_int_eq(own.calls, moment);
        note_work(&own);
        // One item of a loop may be as much work as this again.
        ck_assert_uint_le(own.longest, 4 * TF_WATCHED_WORK + TF_WATCHED_WORK);
        free(none.bytes);
    }
    workplace_free(&w);
}
END_TEST

static size_t decided;

static tf_status count_queries(void *context, const tf_arithmetic *arithmetic,
                               const tf_queries *queries, tf_verdict verdict[],
                               size_t *separated)
{
    (void)context;
    decided += queries->count;
    return tf_reference.decide(NULL, arithmetic, queries, verdict, separated);
}

static const tf_narrow_phase counting = {.name = "counting",
                                         .decide = count_queries};

static bool cancel_after(void *context, const tf_stage *stage)
{
    long *left = context;
    (void)stage;
    if ((*left)-- > 0)
        return true;
    decided = 0;
    return false;
}

START_TEST(no_query_is_decided_after_the_last_call)
{
    make_scene(0);
    workplace w = workplace_new();
    for (long calls = 1; calls < 400; calls += 7) {
        long left = calls;
        const tf_response_options options = {.narrow_phase = &counting,
                                             .progress = cancel_after,
                                             .context = &left};
        memcpy(ended, proposed, bytes_of_step());
        tf_status status = tf_step_resolve(w.resolver, mesh.vertices, start,
                                           ended, NULL, &options, NULL, NULL);
        ck_assert_int_eq(status, TF_CANCELLED);
        ck_assert_uint_eq(decided, 0);
    }
    workplace_free(&w);
}
END_TEST

// A solver that never asks is done with its zone; no other zone is begun.
static int solved;

static int solve_slowly(tf_zone *zone)
{
    solved++;
    for (int i = 0; i < 100 * TF_WATCHED_WORK; i++)
        tf_watch_work(zone->watch, 1);
    return 1;
}

static size_t no_workspace(int axes, int vertices, int constraints)
{
    (void)axes, (void)vertices, (void)constraints;
    return 0;
}

static bool cancel_zones(void *context, const tf_stage *stage)
{
    (void)context;
    return strcmp(stage->name, "zones") != 0 || solved == 0;
}

START_TEST(no_zone_is_solved_after_the_last_call)
{
    static const tf_zone_solver slow = {"slow", no_workspace, solve_slowly};
    const tf_response_options options = {.solver = &slow,
                                         .progress = cancel_zones};
    static proposal made;
    // Specks that fall through edges, far from each other.
    proposal_begin(&made, 2);
    for (int i = 0; i < 20; i++) {
        int v = proposal_add_vertex(&made, 9 * i, 0, 0);
        proposal_add_edge(&made, v,
                          proposal_add_vertex(&made, 9 * i + 2, 0, 0));
        v = proposal_add_vertex(&made, 9 * i + 1, 1, 0);
        made.end[2 * v + 1] = -1;
    }
    mesh = made.mesh;
    start = made.start;
    memcpy(proposed, made.end, sizeof made.end);
    workplace w = workplace_new();
    solved = 0;
    memcpy(ended, proposed, bytes_of_step());
    ck_assert_int_eq(tf_step_resolve(w.resolver, mesh.vertices, start, ended,
                                     NULL, &options, NULL, NULL),
                     TF_CANCELLED);
    ck_assert_int_eq(solved, 1);
    workplace_free(&w);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("cancellation");
    TCase *tcase = tcase_create("calls");
    tcase_set_timeout(tcase, 600);
    tcase_add_loop_test(tcase, each_call_of_the_callback_may_cancel, 0, CALLS);
    tcase_add_loop_test(tcase, scrambled_workers_are_cancelled, 0, CALLS);
    tcase_add_loop_test(tcase, threads_are_cancelled, 0, CALLS);
    suite_add_tcase(suite, tcase);
    tcase = tcase_create("work");
    tcase_set_timeout(tcase, 600);
    tcase_add_loop_test(
        tcase, little_work_is_done_between_calls_and_after_the_last, 0, CALLS);
    tcase_add_test(tcase, no_query_is_decided_after_the_last_call);
    tcase_add_test(tcase, no_zone_is_solved_after_the_last_call);
    suite_add_tcase(suite, tcase);
    return suite;
}

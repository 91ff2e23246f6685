// What a resolver keeps.
#include "response/resolver.h"

#include "response/conjugate_residuals.h"
#include "response/limit.h"
#include "response/resolve.h"
#include "support/answers.h"
#include "support/proposals.h"
#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surface_of.h"

#include <signal.h>
#include <string.h>

static proposal made;

static void resolve(tf_resolver *resolver, const tf_response_options *options)
{
    static double end[3 * PROPOSAL_VERTICES];
    memcpy(end, made.end, sizeof end);
    ck_assert_int_eq(tf_step_resolve(resolver, made.mesh.vertices, made.start,
                                     end, NULL, options, NULL, NULL),
                     TF_OK);
}

// The same steps again take no memory; each level has had its turn.
START_TEST(a_steady_state_takes_no_memory)
{
    static const tf_response_options options[] = {
        {0},
        {.impulse_rounds = 2, .friction = 0.3},
        {.zone_rounds = -1, .rigid = true},
        {.zone_rounds = -1}};
    enum {
        WAYS = sizeof options / sizeof *options
    };
    generator random = generator_new(100);
    proposal_make(&random, BALLS, 3, SCATTERED, &made);
    tf_surface *surface = surface_of(&made.mesh);
    tf_resolver *resolver;
    ck_assert_int_eq(tf_resolver_create(surface, &resolver), TF_OK);
    size_t empty = tf_resolver_memory(resolver);
    for (int i = 0; i < WAYS; i++)
        resolve(resolver, &options[i]);
    size_t bytes = tf_resolver_memory(resolver);
    size_t surface_bytes = tf_surface_memory(surface);
    ck_assert_uint_gt(bytes, empty);
    for (int i = 0; i < 2 * WAYS; i++)
        resolve(resolver, &options[i % WAYS]);
    ck_assert_uint_eq(tf_resolver_memory(resolver), bytes);
    ck_assert_uint_eq(tf_surface_memory(surface), surface_bytes);
    tf_resolver_free(resolver);
    tf_surface_free(surface);
}
END_TEST

// What the last step did ------------------------------------------------------

/// What a resolver lends.
typedef struct told {
    const tf_answered_contact *contact;
    size_t count;
    const unsigned char *flags;
} told;

static told tell(tf_resolver *resolver)
{
    told all;
    ck_assert_int_eq(tf_resolver_contacts(resolver, &all.count, &all.contact),
                     TF_OK);
    all.flags = tf_resolver_vertices(resolver);
    return all;
}

static int count_flags(const told *all, unsigned flag)
{
    int count = 0;
    for (int v = 0; v < made.mesh.vertices; v++)
        count += (all->flags[v] & flag) != 0;
    return count;
}

/// Expects what answers_fault expects; returns how many vertices were pushed.
static int expect_good(tf_resolver *resolver,
                       const tf_response_options *options)
{
    static double end[3 * PROPOSAL_VERTICES];
    const tf_response_report *report;
    int pushed = 0;
    memcpy(end, made.end, sizeof end);
    ck_assert_int_eq(tf_step_resolve(resolver, made.mesh.vertices, made.start,
                                     end, made.inverse_mass, options, &report,
                                     NULL),
                     TF_OK);
    const answered_step step = {made.mesh.axes,
                                made.mesh.vertices,
                                made.start,
                                made.end,
                                end,
                                made.inverse_mass,
                                options,
                                report};
    const char *fault = answers_fault(resolver, &step, &pushed);
    ck_assert_msg(!fault, "%s", fault);
    return pushed;
}

static tf_resolver *begin(tf_surface **surface)
{
    tf_resolver *resolver;
    *surface = surface_of(&made.mesh);
    ck_assert_int_eq(tf_resolver_create(*surface, &resolver), TF_OK);
    return resolver;
}

static void finish(tf_resolver *resolver, tf_surface *surface)
{
    tf_resolver_free(resolver);
    tf_surface_free(surface);
}

START_TEST(pushes_explain_where_vertices_end)
{
    static const tf_response_options options[] = {
        {0},
        {.friction = 0.6, .restitution = 0.3},
        {.impulse_rounds = 2, .friction = 0.2},
        {.impulse_rounds = 40, .zone_rounds = -1},
        {.zone_rounds = 3, .rigid = true},
        {.solver = &tf_conjugate_residuals}};
    static const proposal_shape shapes[] = {SHEETS, BALLS, LOOPS, CHAINS};
    int pushed[4] = {0};
    for (int i = 0; i < 24; i++) {
        generator random = generator_new(300 + (uint64_t)i);
        proposal_make(&random, shapes[i / 6], 3, SCATTERED, &made);
        proposal_weigh(&random, &made);
        tf_surface *surface;
        tf_resolver *resolver = begin(&surface);
        pushed[i / 6] += expect_good(resolver, &options[i % 6]);
        finish(resolver, surface);
    }
    for (int shape = 0; shape < 4; shape++)
        ck_assert_int_gt(pushed[shape], 10);
}
END_TEST

/// In the plane: an edge upon which a vertex falls.
static void make_fall(double below)
{
    proposal_begin(&made, 2);
    proposal_add_edge(&made, proposal_add_vertex(&made, -4, 0, 0),
                      proposal_add_vertex(&made, 4, 0, 0));
    proposal_add_vertex(&made, -0.5, 1, 0);
    made.inverse_mass[0] = made.inverse_mass[1] = below;
    made.end[4] += 1;
    made.end[5] -= 2;
}

// The vertex meets the scripted edge at (0, 0) half way, and stops there.
START_TEST(a_vertex_that_falls_on_a_floor_is_pushed_once)
{
    const tf_response_options options = {.separation = -1, .friction = 0.25};
    tf_surface *surface;
    make_fall(0);
    made.inverse_mass[2] = 0.5;
    tf_resolver *resolver = begin(&surface);
    ck_assert_int_eq(expect_good(resolver, &options), 1);
    told all = tell(resolver);
    ck_assert_uint_eq(all.count, 1);
    const tf_answered_contact *row = all.contact;
    const int vertex[] = {2, 0, 1, -1};
    ck_assert_int_eq(row->kind, TF_POINT_EDGE);
    ck_assert_mem_eq(row->vertex, vertex, sizeof vertex);
    ck_assert_int_eq(row->level, TF_ZONES);
    ck_assert_int_eq(row->round, 0);
    ck_assert_double_eq_tol(row->toi, 0.5, 1e-9);
    ck_assert_double_eq_tol(row->normal[1], 1, 1e-12);
    ck_assert_double_eq_tol(row->coefficient[0], 1, 1e-12);
    ck_assert_double_eq_tol(row->coefficient[1], -0.5, 0.1);
    // Mass 2, a fall by 2, and a quarter of that across.
    ck_assert_double_eq_tol(row->impulse, 4, 1e-12);
    ck_assert_double_eq_tol(row->friction[0], -1, 1e-12);
    ck_assert_int_eq(all.flags[0] | all.flags[1], 0);
    ck_assert_int_eq(all.flags[2], TF_VERTEX_MOVED);
    finish(resolver, surface);
}
END_TEST

// The vertex starts 0.25 above the floor, and falls by 2 and to the side by 1: it
// is to be 1 above, half of its way, and a quarter of what is missing is 0.1875.
START_TEST(a_push_is_told_apart_from_the_motion)
{
    const tf_response_options options = {.separation = 8, .friction = 0.25};
    for (int rounds = -1; rounds <= 1; rounds += 2) {
        tf_response_options own = options;
        own.impulse_rounds = rounds;
        tf_surface *surface;
        make_fall(0);
        made.start[5] = 0.25;
        made.end[5] = -1.75;
        made.inverse_mass[2] = 0.5;
        tf_resolver *resolver = begin(&surface);
        ck_assert_int_eq(expect_good(resolver, &own), 1);
        const tf_answered_contact *row = tell(resolver).contact;
        size_t count;
        const double *push, *unpushed = tf_resolver_unpushed(resolver);
        ck_assert_int_eq(tf_resolver_pushes(resolver, &count, &push), TF_OK);
        ck_assert_uint_eq(count, 1);
        ck_assert_int_eq(row->level, rounds > 0 ? TF_IMPULSES : TF_ZONES);
        ck_assert_double_eq_tol(row->impulse, 4, 1e-12);
        ck_assert_double_eq_tol(row->friction[0], -1, 1e-12);
        ck_assert_double_eq_tol(push[0], 2 * 0.1875, 1e-12);
        ck_assert_double_eq_tol(unpushed[4], 0, 1e-12);
        ck_assert_double_eq_tol(unpushed[5], 0.25, 1e-12);
        finish(resolver, surface);
    }
}
END_TEST

START_TEST(levels_without_impulses_say_whom_they_moved)
{
    const tf_response_options rigid = {.zone_rounds = -1, .rigid = true},
                              failsafe = {.zone_rounds = -1};
    tf_surface *surface;
    make_fall(1);
    tf_resolver *resolver = begin(&surface);
    expect_good(resolver, &rigid);
    told all = tell(resolver);
    ck_assert_uint_ge(all.count, 1);
    ck_assert_int_eq(all.contact[0].level, TF_RIGID);
    ck_assert_double_eq_tol(all.contact[0].normal[1], 1, 1e-9);
    ck_assert_int_eq(count_flags(&all, TF_VERTEX_RIGID), 3);
    expect_good(resolver, &failsafe);
    all = tell(resolver);
    ck_assert_int_eq(all.contact[0].level, TF_FAILSAFE);
    ck_assert_int_eq(count_flags(&all, TF_VERTEX_GROUPED), 3);
    ck_assert_int_eq(count_flags(&all, TF_VERTEX_RIGID), 0);
    finish(resolver, surface);
}
END_TEST

// A lid closes upon a floor, with the vertex between them: it can go half of its
// way.
START_TEST(scripted_vertices_are_held)
{
    tf_surface *surface;
    make_fall(0);
    for (int i = 0; i < 2; i++) {
        int v = proposal_add_vertex(&made, 8 * i - 4, 2, 0);
        made.inverse_mass[v] = 0;
        made.end[2 * v + 1] = -2;
    }
    proposal_add_edge(&made, 3, 4);
    tf_resolver *resolver = begin(&surface);
    expect_good(resolver, &(tf_response_options){0});
    told all = tell(resolver);
    ck_assert_int_eq(count_flags(&all, TF_VERTEX_HELD), 2);
    const double *followed = tf_resolver_followed(resolver);
    for (int v = 0; v < 3; v++)
        ck_assert_double_eq(followed[v], 1);
    for (int v = 3; v < 5; v++) {
        ck_assert_double_le(followed[v], 0.5);
        ck_assert_double_ge(followed[v], 0.5 - 0x1p-7);
    }
    finish(resolver, surface);
}
END_TEST

static void expect_nothing(tf_resolver *resolver)
{
    told all = tell(resolver);
    size_t pushes;
    const double *push;
    ck_assert_uint_eq(all.count, 0);
    ck_assert_ptr_null(all.flags);
    ck_assert_ptr_null(tf_resolver_unpushed(resolver));
    ck_assert_int_eq(tf_resolver_pushes(resolver, &pushes, &push), TF_OK);
    ck_assert_uint_eq(pushes, 0);
}

START_TEST(a_clear_step_had_no_contacts)
{
    tf_surface *surface;
    make_fall(1);
    tf_resolver *resolver = begin(&surface);
    expect_nothing(resolver);
    expect_good(resolver, &(tf_response_options){0});
    ck_assert_uint_gt(tell(resolver).count, 0);
    memcpy(made.end, made.start, sizeof made.end);
    expect_good(resolver, &(tf_response_options){0});
    told all = tell(resolver);
    ck_assert_uint_eq(all.count, 0);
    for (int v = 0; v < 3; v++)
        ck_assert_int_eq(all.flags[v], 0);
    finish(resolver, surface);
}
END_TEST

START_TEST(what_was_told_ends_with_the_next_call)
{
    static double end[3 * PROPOSAL_VERTICES];
    tf_surface *surface;
    int halvings;
    make_fall(1);
    tf_resolver *resolver = begin(&surface);
    memcpy(end, made.end, sizeof end);
    expect_good(resolver, &(tf_response_options){0});
    ck_assert_int_eq(
        tf_step_limit(resolver, 3, made.start, end, NULL, &halvings, NULL),
        TF_OK);
    expect_nothing(resolver);
    expect_good(resolver, &(tf_response_options){0});
    memcpy(end, made.end, sizeof end);
    ck_assert_int_eq(tf_step_resolve(resolver, 3, made.start, end, NULL,
                                     &(tf_response_options){.friction = -1},
                                     NULL, NULL),
                     TF_BAD_OPTION);
    expect_nothing(resolver);
    finish(resolver, surface);
}
END_TEST

START_TEST(rows_are_the_same_for_any_number_of_workers)
{
    static const int workers = 3;
    const tf_parallel parallel = scrambled_workers(&workers);
    const tf_response_options alone = {.friction = 0.3, .impulse_rounds = 1};
    tf_response_options together = alone;
    together.parallel = &parallel;
    generator random = generator_new(400);
    proposal_make(&random, BALLS, 3, SCATTERED, &made);
    tf_surface *one, *other;
    tf_resolver *first = begin(&one), *second = begin(&other);
    expect_good(first, &alone);
    expect_good(second, &together);
    told a = tell(first), b = tell(second);
    ck_assert_uint_gt(a.count, 0);
    ck_assert_uint_eq(a.count, b.count);
    ck_assert_mem_eq(a.contact, b.contact, a.count * sizeof *a.contact);
    ck_assert_mem_eq(a.flags, b.flags, (size_t)made.mesh.vertices);
    finish(first, one);
    finish(second, other);
}
END_TEST

START_TEST(null_may_be_freed)
{
    tf_resolver_free(NULL);
}
END_TEST

START_TEST(a_resolver_needs_a_surface)
{
    tf_resolver *resolver;
    tf_resolver_create(NULL, &resolver);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/resolver");
    TCase *tcase = tcase_create("memory");
    tcase_add_test(tcase, a_steady_state_takes_no_memory);
    tcase_add_test(tcase, null_may_be_freed);
    tcase_add_test_raise_signal(tcase, a_resolver_needs_a_surface, SIGABRT);
    suite_add_tcase(suite, tcase);
    tcase = tcase_create("the last step");
    tcase_add_test(tcase, pushes_explain_where_vertices_end);
    tcase_add_test(tcase, a_vertex_that_falls_on_a_floor_is_pushed_once);
    tcase_add_test(tcase, a_push_is_told_apart_from_the_motion);
    tcase_add_test(tcase, levels_without_impulses_say_whom_they_moved);
    tcase_add_test(tcase, scripted_vertices_are_held);
    tcase_add_test(tcase, a_clear_step_had_no_contacts);
    tcase_add_test(tcase, what_was_told_ends_with_the_next_call);
    tcase_add_test(tcase, rows_are_the_same_for_any_number_of_workers);
    suite_add_tcase(suite, tcase);
    return suite;
}

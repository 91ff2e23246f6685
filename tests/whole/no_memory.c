// Surfaces and responses without memory: each allocation fails in turn, which is
// reported, and the same call with enough memory finds what it would have found
// at once.
#include "distance/near_pairs.h"
#include "fast/detect.h"
#include "response/limit.h"
#include "response/resolve.h"
#include "support/failing_memory.h"
#include "support/hash.h"
#include "support/proposals.h"
#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surfaces.h"
#include "support/watched_memory.h"
#include "surface/candidates.h"
#include "surface/check.h"
#include "untangle/tangled_zones.h"

#include <limits.h>
#include <string.h>

static tf_error error;

// Surfaces --------------------------------------------------------------------

static int workers = 2;
static tf_surface *make_surface(const tf_mesh *mesh)
{
    tf_surface *surface = NULL;
    while (lacks_memory(tf_surface_create(mesh, &surface, &error))) {
        ck_assert_ptr_null(surface);
        ck_assert_int_eq(error.status, TF_OUT_OF_MEMORY);
    }
    return surface;
}

static surface_case given;
static bool in_parallel;

static uint64_t examine(void)
{
    const tf_parallel all = scrambled_workers(&workers),
                      *parallel = in_parallel ? &all : NULL;
    const tf_check_options how_to_check = {.parallel = parallel};
    int zone[4 * SURFACE_ELEMENTS];
    const tf_detect_options how = {
        .size = sizeof how, .parallel = parallel, .zone = zone};
    tf_crossings crossings;
    tf_near_pairs near;
    tf_contacts contacts;
    tf_candidates candidates;
    uint64_t hash = HASH_OF_NOTHING;
    tf_surface *surface = make_surface(&given.mesh);
    while (
        lacks_memory(tf_surface_check(surface, given.mesh.vertices, given.start,
                                      &how_to_check, &crossings, &error)))
        ck_assert_int_eq(error.status, TF_OUT_OF_MEMORY);
    hash = hash_bytes(hash, crossings.crossing,
                      crossings.count * sizeof *crossings.crossing);
    while (lacks_memory(tf_surface_zones(surface, given.mesh.vertices,
                                         given.start, 0, &how_to_check, zone,
                                         NULL, NULL, &error)))
        ck_assert_int_eq(error.status, TF_OUT_OF_MEMORY);
    while (
        lacks_memory(tf_surface_near(surface, given.mesh.vertices, given.start,
                                     0.25, &how_to_check, &near, &error)))
        ck_assert_int_eq(error.status, TF_OUT_OF_MEMORY);
    hash = hash_bytes(hash, near.pair, near.count * sizeof *near.pair);
    while (lacks_memory(
        tf_surface_detect(surface, &given.motion, &how, &contacts, &error)))
        ck_assert_int_eq(error.status, TF_OUT_OF_MEMORY);
    hash = hash_bytes(hash, contacts.contact,
                      contacts.count * sizeof *contacts.contact);
    while (lacks_memory(tf_surface_candidates(surface, &given.motion, &how,
                                              &candidates, &error)))
        ck_assert_int_eq(error.status, TF_OUT_OF_MEMORY);
    hash = hash_bytes(hash, candidates.points,
                      candidates.point_count * sizeof *candidates.points);
    hash = hash_bytes(hash, candidates.edges,
                      candidates.edge_count * sizeof *candidates.edges);
    expect_told(tf_surface_memory(surface));
    tf_surface_free(surface);
    return hash;
}

START_TEST(surfaces_lack_memory)
{
    generator random = generator_new((uint64_t)_i);
    for (int placed = 0; placed < PLACEMENTS; placed++) {
        random_surface(&random, 2 + _i / 2, 15, (placement)placed, &given);
        in_parallel = _i % 2;
        let_each_fail(examine);
    }
}
END_TEST

static bool want_none(void *context, const tf_element_pair *pair)
{
    (void)context, (void)pair;
    return false;
}

static size_t count_contacts(tf_surface *surface)
{
    tf_contacts found;
    while (lacks_memory(
        tf_surface_detect(surface, &given.motion, NULL, &found, &error)))
        ck_assert_int_eq(error.status, TF_OUT_OF_MEMORY);
    return found.count;
}

/// A filter that cannot be set leaves the last one, without any contacts.
static uint64_t filter_pairs(void)
{
    static int group[SURFACE_VERTICES];
    for (int v = 0; v < given.mesh.vertices; v++)
        group[v] = v + 1; // no two of them are the same
    const tf_pair_filter none = {.wanted = want_none},
                         groups = {.vertices = given.mesh.vertices,
                                   .group = group};
    tf_surface *surface = make_surface(&given.mesh);
    ck_assert_int_eq(tf_surface_set_filter(surface, &none, NULL), TF_OK);
    while (lacks_memory(tf_surface_set_filter(surface, &groups, &error))) {
        ck_assert_int_eq(error.status, TF_OUT_OF_MEMORY);
        ck_assert_uint_eq(count_contacts(surface), 0);
    }
    size_t count = count_contacts(surface);
    ck_assert_uint_gt(count, 0);
    expect_told(tf_surface_memory(surface));
    tf_surface_free(surface);
    return count;
}

START_TEST(filters_lack_memory)
{
    generator random = generator_new(7);
    random_surface(&random, 3, 15, ANYWHERE, &given);
    in_parallel = false;
    let_each_fail(filter_pairs);
}
END_TEST

// On most machines malloc would promise even this.
START_TEST(absurd_sizes_lack_memory)
{
    const int corner[] = {0, 1, INT_MAX / 3 - 1};
    const tf_mesh mesh = {
        .axes = 3, .vertices = INT_MAX / 3, .triangles = 1, .triangle = corner};
    watched_memory memory;
    tf_surface *surface;
    memory_watch(&memory);
    memory.most = (size_t)1 << 30;
    ck_assert_int_eq(tf_surface_create(&mesh, &surface, &error),
                     TF_OUT_OF_MEMORY);
    ck_assert_int_eq(error.status, TF_OUT_OF_MEMORY);
    memory_end(&memory);
}
END_TEST

// Responses -------------------------------------------------------------------

static proposal made;
static int substeps;
static const double *inverse_mass; ///< NULL: 1 for all

static uint64_t respond(void)
{
    static int zone[PROPOSAL_TRIANGLES + PROPOSAL_EDGES]; // one
    const tf_parallel parallel = scrambled_workers(&workers);
    const tf_response_options zoned = {.size = sizeof zoned, .zone = zone};
    const tf_response_options all_levels = {.size = sizeof all_levels,
                                            .thickness = 0.05 * made.unit,
                                            .substeps = substeps,
                                            .impulse_rounds = 1,
                                            .zone_rounds = 1,
                                            .rigid = true,
                                            .again = true,
                                            .check_start = true,
                                            .parallel = &parallel};
    const tf_answered_contact *contact = NULL;
    const tf_response_report *report = NULL;
    const double *push = NULL;
    size_t count = 0;
    int vertices = made.mesh.vertices, halvings;
    double end[3 * PROPOSAL_VERTICES];
    uint64_t hash = HASH_OF_NOTHING;
    tf_surface *surface = make_surface(&made.mesh);
    tf_resolver *resolver = NULL;
    while (lacks_memory(tf_resolver_create(surface, &resolver)))
        ck_assert_ptr_null(resolver);
    memcpy(end, made.end, sizeof end);
    while (lacks_memory(tf_step_limit(resolver, vertices, made.start, end,
                                      &zoned, &halvings, &error)))
        ck_assert_int_eq(error.status, TF_OUT_OF_MEMORY);
    while (lacks_memory(tf_step_resolve(resolver, vertices, made.start, end,
                                        NULL, &zoned, NULL, &error)))
        ck_assert_int_eq(error.status, TF_OUT_OF_MEMORY);
    memcpy(end, made.end, sizeof end);
    while (lacks_memory(tf_step_resolve(resolver, vertices, made.start, end,
                                        inverse_mass, &all_levels, &report,
                                        &error))) {
        ck_assert_int_eq(error.status, TF_OUT_OF_MEMORY);
        ck_assert_mem_eq(end, made.end, sizeof end);
    }
    ck_assert((report->held > 0) == (inverse_mass != NULL));
    hash = hash_bytes(hash, end, sizeof end);
    while (lacks_memory(tf_resolver_pushes(resolver, &count, &push)))
        ck_assert_ptr_null(push);
    hash = hash_bytes(hash, push, count * sizeof *push);
    ck_assert_int_eq(tf_resolver_contacts(resolver, &count, &contact), TF_OK);
    hash = hash_bytes(hash, contact, count * sizeof *contact);
    memcpy(end, made.end, sizeof end);
    while (lacks_memory(tf_step_limit(resolver, vertices, made.start, end,
                                      &all_levels, &halvings, &error))) {
        ck_assert_int_eq(error.status, TF_OUT_OF_MEMORY);
        ck_assert_mem_eq(end, made.end, sizeof end);
    }
    hash = hash_bytes(hash, end, sizeof end);
    expect_told(tf_surface_memory(surface) + tf_resolver_memory(resolver));
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    return hash_bytes(hash, &halvings, sizeof halvings);
}

START_TEST(responses_lack_memory)
{
    generator random = generator_new(5);
    proposal_make(&random, (proposal_shape)_i, 2, SHUFFLED, &made);
    substeps = 0;
    inverse_mass = NULL;
    let_each_fail(respond);
}
END_TEST

// Two scripted edges close upon a free one.
START_TEST(responses_that_hold_back_lack_memory)
{
    proposal_begin(&made, 2);
    for (int i = 0; i < 6; i++) {
        int v = proposal_add_vertex(&made, i % 2 ? 1 : -1, i / 2, 0);
        made.inverse_mass[v] = i / 2 == 1;
        if (i / 2 != 1)
            made.end[2 * v + 1] += i < 2 ? 1.5 : -1.5;
    }
    for (int v = 0; v < 6; v += 2)
        proposal_add_edge(&made, v, v + 1);
    substeps = 1 + _i;
    inverse_mass = made.inverse_mass;
    let_each_fail(respond);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/no_memory");
    TCase *tcase = tcase_create("failures");
    tcase_add_loop_test(tcase, surfaces_lack_memory, 0, 4);
    tcase_add_test(tcase, filters_lack_memory);
    tcase_add_test(tcase, absurd_sizes_lack_memory);
    tcase_add_loop_test(tcase, responses_lack_memory, 0, PROPOSAL_SHAPES);
    tcase_add_loop_test(tcase, responses_that_hold_back_lack_memory, 0, 3);
    suite_add_tcase(suite, tcase);
    return suite;
}

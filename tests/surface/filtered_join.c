// Candidates, contacts and intersections of filtered surfaces: those of all
// pairs that the filter keeps.
#include "surface/filtered_join.h"

#include "arithmetic/exact.h"
#include "query/edge_edge.h"
#include "query/point_edge.h"
#include "query/point_triangle.h"
#include "support/contacts.h"
#include "support/crossings.h"
#include "support/pair_rules.h"
#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"
#include "support/zoned_facets.h"
#include "surface/candidates.h"
#include "surface/check.h"
#include "surface/detect.h"
#include "surface/surface_memory.h"

#include <stdlib.h>
#include <string.h>

static surface_case given;
static pair_rule rule;
static int zone[4 * SURFACE_ELEMENTS]; ///< of the facets, if there are zones
static zoned_facets zoned;             ///< with zones, or all zero

/// The given surface, filtered by a new rule.
static tf_surface *filtered_surface(generator *random)
{
    tf_surface *surface = surface_of(&given.mesh);
    tf_error error;
    pair_rule_make(random, given.mesh.axes, given.mesh.vertices, given.start,
                   &rule);
    ck_assert_int_eq(tf_surface_set_filter(surface, &rule.filter, &error),
                     TF_OK);
    ck_assert_int_eq(error.status, TF_OK);
    if (below(random, 2))
        surface->inverse_mass =
            pair_rule_weigh(random, given.mesh.vertices, &rule);
    zoned = (zoned_facets){0};
    if (below(random, 2)) {
        zones_draw(random, surface, zone);
        zoned = zoned_facets_of(surface, zone);
        ck_assert(tf_surface_enter_zones(surface, zone));
    }
    return surface;
}

/// Whether rule and zones keep a pair of a step.
static bool keeps(tf_kind kind, const int vertex[])
{
    int first = kind == TF_EDGE_EDGE ? 2 : 1;
    int second = kind == TF_POINT_TRIANGLE ? 3 : 2;
    return pair_rule_keeps(&rule, kind, vertex) &&
           !(zoned.zone &&
             zones_leave_out(&zoned, first, vertex, second, vertex + first));
}

static bool keeps_crossing(const tf_crossing *crossing)
{
    int first = crossing->kind == TF_POINT_ON_TRIANGLE ? 1 : 2;
    int second = crossing->kind == TF_EDGE_ON_EDGE ? 2 : 3;
    const int *v = crossing->vertex;
    return pair_rule_keeps_crossing(&rule, crossing) &&
           !(zoned.zone &&
             zones_leave_out(&zoned, first, v, second, v + first));
}

static int workers = 3;

/// In one thread, or by many tasks from the last to the first.
static const tf_parallel *parallel_of(int i)
{
    static tf_parallel parallel;
    parallel = scrambled_workers(&workers);
    return i % 2 ? &parallel : NULL;
}

// Candidates ------------------------------------------------------------------

/// The pairs that the rule keeps, moved to the front; returns how many.
static size_t keep_candidates(const tf_surface *surface, int corners,
                              size_t count, tf_candidate pair[])
{
    size_t kept = 0;
    int edges, triangles;
    const int *edge = tf_surface_edges(surface, &edges);
    const int *triangle = tf_surface_triangles(surface, &triangles);
    for (size_t i = 0; i < count; i++) {
        int vertex[4] = {pair[i].first, -1, -1, -1};
        tf_kind kind = TF_EDGE_EDGE;
        if (corners == 1) {
            kind = given.mesh.axes == 2 ? TF_POINT_EDGE : TF_POINT_TRIANGLE;
            memcpy(vertex + 1,
                   given.mesh.axes == 2 ? edge + 2 * pair[i].second
                                        : triangle + 3 * pair[i].second,
                   sizeof(int) * (size_t)given.mesh.axes);
        } else {
            const int *a = edge + 2 * pair[i].first;
            const int *b = edge + 2 * pair[i].second;
            memcpy(vertex, a[0] < b[0] ? a : b, 2 * sizeof *a);
            memcpy(vertex + 2, a[0] < b[0] ? b : a, 2 * sizeof *a);
        }
        pair[kept] = pair[i];
        kept += keeps(kind, vertex);
    }
    return kept;
}

/// Options with the zones of the surface, which it leaves; or without.
static tf_detect_options options_of(tf_surface *surface, int i)
{
    tf_detect_options options = {.size = sizeof options,
                                 .parallel = parallel_of(i)};
    if (i % 3 == 0)
        return options;
    tf_surface_leave_zones(surface);
    options.zone = zoned.zone;
    return options;
}

static void expect_candidates(tf_surface *surface, int i)
{
    tf_surface *whole = surface_of(&given.mesh);
    tf_detect_options options = options_of(surface, i);
    tf_candidates all, found;
    ck_assert_int_eq(
        tf_surface_candidates(whole, &given.motion, NULL, &all, NULL), TF_OK);
    ck_assert_int_eq(
        tf_surface_candidates(surface, &given.motion, &options, &found, NULL),
        TF_OK);
    // Written to, as it is the surface's own memory.
    tf_candidate *points = (tf_candidate *)all.points;
    tf_candidate *edges = (tf_candidate *)all.edges;
    size_t kept = keep_candidates(surface, 1, all.point_count, points);
    ck_assert_uint_eq(found.point_count, kept);
    if (kept > 0)
        ck_assert_mem_eq(found.points, points, kept * sizeof *points);
    kept = keep_candidates(surface, 2, all.edge_count, edges);
    ck_assert_uint_eq(found.edge_count, kept);
    if (kept > 0)
        ck_assert_mem_eq(found.edges, edges, kept * sizeof *edges);
    tf_surface_free(whole);
}

START_TEST(candidates_are_those_of_the_surface_that_are_kept)
{
    generator random = generator_new((uint64_t)_i);
    for (int i = 0; i < (int)cases(40); i++) {
        random_surface(&random, 2 + i / 2 % 2, SURFACE_ELEMENTS, (placement)_i,
                       &given);
        tf_surface *surface = filtered_surface(&random);
        expect_candidates(surface, i);
        tf_surface_free(surface);
    }
}
END_TEST

// Contacts --------------------------------------------------------------------

enum {
    MOST_ROWS = 100000
};

/// All pairs that are kept and in contact.
static struct {
    size_t count;
    tf_surface_contact row[MOST_ROWS];
} all;

static void query_pair(tf_kind kind, const int vertex[])
{
    tf_surface_contact row = {.kind = kind, .vertex = {-1, -1, -1, -1}};
    memcpy(row.vertex, vertex, sizeof(int) * (kind == TF_POINT_EDGE ? 3 : 4));
    tf_status status =
        kind == TF_EDGE_EDGE ? tf_edge_edge(&tf_exact, &given.motion, vertex,
                                            vertex + 2, &row.contact)
        : kind == TF_POINT_EDGE
            ? tf_point_edge(&tf_exact, &given.motion, vertex[0], vertex + 1,
                            &row.contact)
            : tf_point_triangle(&tf_exact, &given.motion, vertex[0], vertex + 1,
                                &row.contact);
    // Elements that share a vertex are refused.
    if (status != TF_OK || row.contact.verdict != TF_HIT ||
        !keeps(kind, vertex))
        return;
    ck_assert_uint_lt(all.count, MOST_ROWS);
    all.row[all.count++] = row;
}

static void query_all_pairs(const tf_surface *surface)
{
    int axes = given.mesh.axes, edges, others;
    const int *edge = tf_surface_edges(surface, &edges);
    const int *other = tf_surface_triangles(surface, &others);
    if (axes == 2) {
        others = edges;
        other = edge;
    }
    all.count = 0;
    for (int v = 0; v < given.mesh.vertices; v++)
        for (int i = 0; i < others; i++) {
            int vertex[4] = {v, -1, -1, -1};
            memcpy(vertex + 1, other + axes * i, sizeof(int) * (size_t)axes);
            query_pair(axes == 2 ? TF_POINT_EDGE : TF_POINT_TRIANGLE, vertex);
        }
    // Sorted, as the list of edges is.
    for (int i = 0; i < edges && axes == 3; i++)
        for (int j = i + 1; j < edges; j++) {
            int vertex[4];
            memcpy(vertex, edge + 2 * i, 2 * sizeof *vertex);
            memcpy(vertex + 2, edge + 2 * j, 2 * sizeof *vertex);
            query_pair(TF_EDGE_EDGE, vertex);
        }
}

static tf_status decide_slowly(void *context, const tf_arithmetic *arithmetic,
                               const tf_queries *queries, tf_verdict verdict[],
                               size_t *separated)
{
    ck_assert_ptr_eq(context, &workers);
    ck_assert(queries->count <= TF_BATCH);
    return tf_reference.decide(NULL, arithmetic, queries, verdict, separated);
}

static const tf_narrow_phase own = {
    .name = "own", .decide = decide_slowly, .context = &workers};

static void expect_contacts(tf_surface *surface, int i)
{
    tf_detect_options options = options_of(surface, i);
    tf_contacts found;
    tf_candidates candidates;
    ck_assert_int_eq(tf_surface_candidates(surface, &given.motion, &options,
                                           &candidates, NULL),
                     TF_OK);
    options.narrow_phase = i % 4 ? NULL : &own;
    size_t count = candidates.point_count + candidates.edge_count;
    ck_assert_int_eq(tf_detect(surface, &given.motion, &options, &found, NULL),
                     TF_OK);
    ck_assert_uint_eq(found.statistics.candidates, count);
    ck_assert_uint_eq(found.statistics.by_axis + found.statistics.by_filter +
                          found.statistics.by_signs,
                      count);
    ck_assert_uint_eq(found.count, all.count);
    for (size_t j = 0; j < all.count; j++) {
        ck_assert_int_eq(found.contact[j].kind, all.row[j].kind);
        ck_assert_mem_eq(found.contact[j].vertex, all.row[j].vertex,
                         sizeof all.row[j].vertex);
        ck_assert(
            contacts_are_same(&found.contact[j].contact, &all.row[j].contact));
    }
    options.selection = TF_ANY_CONTACT;
    ck_assert_int_eq(tf_detect(surface, &given.motion, &options, &found, NULL),
                     TF_OK);
    ck_assert_int_eq(found.any, all.count > 0);
}

START_TEST(contacts_are_those_of_all_pairs_that_are_kept)
{
    generator random = generator_new(100 + (uint64_t)_i);
    for (int i = 0; i < (int)cases(60); i++) {
        random_surface(&random, 2 + i / 6 % 2, 30, (placement)_i, &given);
        tf_surface *surface = filtered_surface(&random);
        query_all_pairs(surface);
        expect_contacts(surface, i);
        tf_surface_free(surface);
    }
}
END_TEST

// Intersections at rest -------------------------------------------------------

static oracle_crossings crossings;

static void expect_crossings(tf_surface *surface, int i)
{
    tf_check_options options = {.parallel = parallel_of(i)};
    tf_crossings found;
    oracle_crossings_find(&crossings, surface, given.mesh.axes,
                          given.mesh.vertices, given.start);
    ck_assert_int_eq(tf_surface_check(surface, given.mesh.vertices, given.start,
                                      &options, &found, NULL),
                     TF_OK);
    size_t kept = 0;
    for (int j = 0; j < crossings.count; j++) {
        const tf_crossing *expected = &crossings.row[j];
        if (!keeps_crossing(expected))
            continue;
        ck_assert_uint_lt(kept, found.count);
        ck_assert_int_eq(found.crossing[kept].kind, expected->kind);
        ck_assert_mem_eq(found.crossing[kept].vertex, expected->vertex,
                         sizeof expected->vertex);
        kept++;
    }
    ck_assert_uint_eq(found.count, kept);
}

START_TEST(intersections_are_those_of_all_pairs_that_are_kept)
{
    generator random = generator_new(200 + (uint64_t)_i);
    for (int i = 0; i < (int)cases(40); i++) {
        random_surface(&random, 2 + i / 2 % 2, 8, (placement)_i, &given);
        tf_surface *surface = filtered_surface(&random);
        expect_crossings(surface, i);
        tf_surface_free(surface);
    }
}
END_TEST

// Filters come and go ---------------------------------------------------------

static bool wants_none(void *context, const tf_element_pair *pair)
{
    (void)context;
    (void)pair;
    return false;
}

static tf_contacts detect(tf_surface *surface)
{
    tf_contacts found;
    ck_assert_int_eq(tf_detect(surface, &given.motion, NULL, &found, NULL),
                     TF_OK);
    return found;
}

START_TEST(a_filter_that_is_removed_leaves_no_trace)
{
    generator random = generator_new(300);
    for (int i = 0; i < (int)cases(30); i++) {
        random_surface(&random, 2 + i % 2, 40, (placement)(i % PLACEMENTS),
                       &given);
        tf_surface *surface = filtered_surface(&random),
                   *whole = surface_of(&given.mesh);
        detect(surface);
        surface->inverse_mass = NULL;
        tf_surface_leave_zones(surface);
        ck_assert_int_eq(tf_surface_set_filter(surface, NULL, NULL), TF_OK);
        tf_contacts expected = detect(whole), found = detect(surface);
        ck_assert_uint_eq(found.statistics.candidates,
                          expected.statistics.candidates);
        ck_assert_uint_eq(found.count, expected.count);
        if (found.count > 0)
            ck_assert_mem_eq(found.contact, expected.contact,
                             found.count * sizeof *found.contact);
        tf_pair_filter none = {.wanted = wants_none};
        ck_assert_int_eq(tf_surface_set_filter(surface, &none, NULL), TF_OK);
        found = detect(surface);
        ck_assert(!found.any && found.statistics.candidates == 0);
        tf_surface_free(surface);
        tf_surface_free(whole);
    }
}
END_TEST

/// The pairs of a step of an edge and a triangle: all but those without one of
/// the vertices.
START_TEST(groups_leave_out_pairs_of_one_group)
{
    static const int triangle[] = {0, 1, 2}, edge[] = {3, 4};
    static const double x[] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, -1, 1, 1, 1};
    tf_mesh mesh = {.axes = 3,
                    .vertices = 5,
                    .triangles = 1,
                    .triangle = triangle,
                    .edges = 1,
                    .edge = edge};
    static const struct {
        int group[5];
        size_t crossings;
    } given_groups[] = {
        {{1, 1, 1, 1, 1}, 0}, {{1, 1, 1, 1, 2}, 0},     {{1, 1, 1, 0, 1}, 0},
        {{1, 2, 1, 1, 1}, 0}, {{0, -1, -1, -1, -1}, 0}, {{0, 0, 0, 0, 0}, 1},
        {{1, 1, 1, 2, 2}, 1}, {{0, 1, 2, 1, 1}, 1},     {{1, 1, 0, 1, 0}, 1}};
    tf_surface *surface = surface_of(&mesh);
    for (size_t i = 0; i < sizeof given_groups / sizeof *given_groups; i++) {
        tf_pair_filter filter = {.vertices = 5, .group = given_groups[i].group};
        tf_crossings found;
        ck_assert_int_eq(tf_surface_set_filter(surface, &filter, NULL), TF_OK);
        ck_assert_int_eq(tf_surface_check(surface, 5, x, NULL, &found, NULL),
                         TF_OK);
        ck_assert_uint_eq(found.count, given_groups[i].crossings);
    }
    tf_surface_free(surface);
}
END_TEST

// A call is cancelled ---------------------------------------------------------

static bool count_call(void *context, const tf_stage *stage)
{
    (void)stage;
    ++*(int *)context;
    return true;
}

static int count_calls(tf_surface *surface, size_t *candidates)
{
    int calls = 0;
    tf_detect_options options = {.progress = count_call, .context = &calls};
    tf_contacts found;
    ck_assert_int_eq(tf_detect(surface, &given.motion, &options, &found, NULL),
                     TF_OK);
    *candidates = found.statistics.candidates;
    return calls;
}

/// A call whose pairs are all left out tells its caller once for each batch, too.
START_TEST(filtered_calls_are_watched)
{
    generator random = generator_new(400);
    do
        random_surface(&random, 3, SURFACE_ELEMENTS, IN_POINT, &given);
    while (given.mesh.triangles < 100);
    tf_surface *surface = surface_of(&given.mesh);
    tf_pair_filter none = {.wanted = wants_none};
    size_t candidates, left;
    ck_assert_int_gt(count_calls(surface, &candidates), 10);
    ck_assert_int_eq(tf_surface_set_filter(surface, &none, NULL), TF_OK);
    ck_assert_int_gt(count_calls(surface, &left), (int)(candidates / TF_BATCH));
    ck_assert_uint_gt(candidates, 2 * TF_BATCH);
    ck_assert_uint_eq(left, 0);
    tf_surface_free(surface);
}
END_TEST

static bool stop(void *context, const tf_stage *stage)
{
    (void)stage;
    return ++*(int *)context < 6;
}

static bool count_pair(void *context, const tf_element_pair *pair)
{
    (void)pair;
    ++*(size_t *)context;
    return false;
}

START_TEST(filtered_calls_can_be_cancelled)
{
    generator random = generator_new(400);
    do
        random_surface(&random, 3, SURFACE_ELEMENTS, IN_POINT, &given);
    while (given.mesh.triangles < 100);
    tf_surface *surface = surface_of(&given.mesh);
    size_t asked = 0;
    tf_pair_filter none = {.wanted = count_pair, .context = &asked};
    int calls = 0;
    tf_detect_options options = {.progress = stop, .context = &calls};
    tf_contacts found;
    ck_assert_int_eq(tf_surface_set_filter(surface, &none, NULL), TF_OK);
    ck_assert_int_eq(tf_detect(surface, &given.motion, &options, &found, NULL),
                     TF_CANCELLED);
    ck_assert_int_eq(calls, 6);
    // The first calls are about the trees and the task, the others about batches.
    ck_assert_uint_le(asked, 3 * TF_BATCH);
    tf_surface_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/filtered_join");
    TCase *c = tcase_create("all pairs");
    tcase_add_loop_test(c, candidates_are_those_of_the_surface_that_are_kept, 0,
                        PLACEMENTS);
    tcase_add_loop_test(c, contacts_are_those_of_all_pairs_that_are_kept, 0,
                        PLACEMENTS);
    tcase_add_loop_test(c, intersections_are_those_of_all_pairs_that_are_kept,
                        0, PLACEMENTS);
    suite_add_tcase(suite, c);

    TCase *filters = tcase_create("filters");
    tcase_add_test(filters, a_filter_that_is_removed_leaves_no_trace);
    tcase_add_test(filters, groups_leave_out_pairs_of_one_group);
    tcase_add_test(filters, filtered_calls_are_watched);
    tcase_add_test(filters, filtered_calls_can_be_cancelled);
    suite_add_tcase(suite, filters);
    return suite;
}

// A cache of pairs, against a detection by a surface of its own.
#include "surface/pair_cache.h"

#include "fast/estimate.h"
#include "fast/vectorized.h"
#include "support/proposal_steps.h"
#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/watches.h"
#include "surface/detect.h"
#include "surface/join.h"
#include "surface/surface_memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static proposal made;
static proposal_step s;
static tf_motion motion;
static tf_pair_cache cache;
static const tf_narrow_phase *narrow_phase = &tf_vectorized;

static void take_proposal(void)
{
    proposal_step_begin(&s, &made);
    motion = (tf_motion){s.step.axes, s.step.vertices, s.step.start, s.end};
}

static void drop_proposal(void)
{
    proposal_step_free(&s);
}

static void free_cache(void)
{
    ck_assert_uint_gt(tf_pair_cache_memory(&cache), 0);
    tf_pair_cache_free(&cache);
    ck_assert_uint_eq(tf_pair_cache_memory(&cache), 0);
}

static tf_contact_search search(const tf_parallel *parallel)
{
    return (tf_contact_search){.surface = s.surface,
                               .motion = &motion,
                               .narrow_phase = narrow_phase,
                               .estimate = tf_contact_estimate,
                               .parallel = parallel};
}

/// Moves some vertices on from where they end.
static void move_some(generator *random, double far)
{
    int axes = made.mesh.axes;
    for (int moved = 1 + below(random, 6); moved > 0; moved--) {
        int v = below(random, made.mesh.vertices);
        for (int k = 0; k < axes; k++)
            s.end[axes * v + k] += uniform(random, -far, far) * made.unit;
        if (below(random, 4) == 0) // to rest
            memcpy(s.end + (ptrdiff_t)axes * v,
                   made.start + (ptrdiff_t)axes * v,
                   sizeof(double) * (size_t)axes);
    }
}

static tf_contacts build(const tf_parallel *parallel)
{
    tf_contacts found;
    tf_error error;
    tf_contact_search all = search(parallel);
    ck_assert_int_eq(tf_pair_cache_build(&cache, &all, &found, &error), TF_OK);
    ck_assert(tf_pair_cache_is_current(&cache, &all));
    return found;
}

static tf_contacts update(const tf_parallel *parallel)
{
    tf_contacts found;
    tf_contact_search kept = search(parallel);
    ck_assert_int_eq(tf_pair_cache_update(&cache, &kept, &found), TF_OK);
    ck_assert(tf_pair_cache_is_current(&cache, &kept));
    return found;
}

// The pairs of the cache ------------------------------------------------------

/// The vertices of a pair, in the order in which a contact lists them.
typedef struct corners {
    int kind, vertex[4];
} corners;

static corners *cached;
static size_t cached_count;

static int compare_corners(const void *a, const void *b)
{
    return memcmp(a, b, sizeof(corners));
}

static corners corners_of(tf_kind kind, const int first[], int firsts,
                          const int second[], int seconds)
{
    corners all = {(int)kind, {-1, -1, -1, -1}};
    for (int i = 0; i < firsts; i++)
        all.vertex[i] = first[i];
    for (int i = 0; i < seconds; i++)
        all.vertex[firsts + i] = second[i];
    return all;
}

/// Notes pairs of two trees of a surface.
typedef struct note_sink {
    tf_pair_sink sink;
    tf_kind kind;
    const tf_tree *first, *second;
    const int *corner, *other; ///< of their elements; NULL: vertices
} note_sink;

static bool note(tf_pair_sink *sink, int count, const tf_candidate pair[])
{
    const note_sink *to = (const note_sink *)sink;
    int firsts = to->first->corners, seconds = to->second->corners;
    corners *more =
        realloc(cached, sizeof *cached * (cached_count + (size_t)count));
    ck_assert_ptr_nonnull(more);
    cached = more;
    for (int i = 0; i < count; i++) {
        const int *a =
            to->corner ? to->corner + firsts * pair[i].first : &pair[i].first;
        const int *b = to->other + seconds * pair[i].second;
        bool swap = to->kind == TF_EDGE_EDGE && b[0] < a[0];
        cached[cached_count++] =
            corners_of(to->kind, swap ? b : a, firsts, swap ? a : b, seconds);
    }
    return true;
}

static void note_pairs(note_sink to)
{
    to.sink.take = note;
    tf_tree_join(to.first, to.second, (tf_range){0, to.first->packs[0]},
                 &to.sink);
}

/// Lists all pairs whose swept boxes overlap, by a surface of its own.
static void note_cached(tf_surface *other)
{
    ck_assert_int_eq(tf_surface_move(other, &motion, true, NULL, NULL), TF_OK);
    bool plane = made.mesh.axes == 2;
    const int *edge = other->edges.corner;
    cached_count = 0;
    note_pairs(
        (note_sink){.kind = plane ? TF_POINT_EDGE : TF_POINT_TRIANGLE,
                    .first = &other->vertex_tree,
                    .second = plane ? &other->edge_tree : &other->triangle_tree,
                    .other = plane ? edge : other->triangles.corner});
    if (!plane)
        note_pairs((note_sink){.kind = TF_EDGE_EDGE,
                               .first = &other->edge_tree,
                               .second = &other->edge_tree,
                               .corner = edge,
                               .other = edge});
    if (cached_count > 0)
        qsort(cached, cached_count, sizeof *cached, compare_corners);
}

static bool is_cached(const tf_surface_contact *contact)
{
    corners key = corners_of(contact->kind, contact->vertex, 4, NULL, 0);
    return cached_count > 0 &&
           bsearch(&key, cached, cached_count, sizeof *cached, compare_corners);
}

/// Expects the contacts of a detection on a surface of its own: all of them, or
/// those of pairs of the cache.  They may be estimated.
static void compare_contact(const tf_surface_contact *found,
                            const tf_surface_contact *expected)
{
    ck_assert_int_eq(found->kind, expected->kind);
    ck_assert_mem_eq(found->vertex, expected->vertex, sizeof found->vertex);
    ck_assert_int_eq(found->contact.verdict, TF_HIT);
    ck_assert_double_eq_tol(found->contact.toi_lo, expected->contact.toi_lo,
                            1e-5);
}

static void compare(tf_surface *other, const tf_contacts *found, bool all)
{
    tf_contacts true_ones;
    ck_assert_int_eq(tf_detect(other, &motion, NULL, &true_ones, NULL), TF_OK);
    size_t expected = 0;
    for (size_t i = 0; i < true_ones.count; i++) {
        const tf_surface_contact *contact = &true_ones.contact[i];
        if (!all && !is_cached(contact))
            continue;
        ck_assert_uint_lt(expected, found->count);
        compare_contact(&found->contact[expected++], contact);
    }
    ck_assert_uint_eq(found->count, expected);
    ck_assert(found->any == (expected > 0));
}

static void search_while_moving(generator *random, const tf_parallel *parallel)
{
    tf_surface *other = surface_of(&made.mesh);
    take_proposal();
    tf_contacts found = build(parallel);
    compare(other, &found, true);
    note_cached(other);
    for (int round = 0; round < 12 && found.any; round++) {
        move_some(random, round % 4 == 3 ? 2 : 0.05);
        found = update(parallel);
        compare(other, &found, false);
        if (round % 5 != 4)
            continue;
        found = build(parallel);
        compare(other, &found, true);
        note_cached(other);
    }
    drop_proposal();
    tf_surface_free(other);
}

// Builds and updates ----------------------------------------------------------

START_TEST(contacts_of_cached_pairs_are_found)
{
    generator random = generator_new(100 + (uint64_t)_i);
    int workers = 3;
    tf_parallel parallel = scrambled_workers(&workers);
    for (int times = 0; times < (int)cases(40); times++) {
        proposal_make(&random, (proposal_shape)_i, 2,
                      below(&random, 2) ? SCATTERED : RESTING, &made);
        narrow_phase = times % 4 == 3 ? &tf_reference : &tf_vectorized;
        search_while_moving(&random, times % 2 ? &parallel : NULL);
    }
    free_cache();
    narrow_phase = &tf_vectorized;
}
END_TEST

static void expect_candidates(size_t contacts, size_t candidates)
{
    tf_contacts found = update(NULL);
    ck_assert_uint_eq(found.count, contacts);
    ck_assert_uint_eq(found.statistics.candidates, candidates);
}

static void expect_contact(tf_contacts found, int particle)
{
    ck_assert_uint_eq(found.count, 1);
    ck_assert_int_eq(found.contact->vertex[0], particle);
}

/// Two particles that fall through a triangle, 3 and 4, and one that falls past
/// it, but within its box.
static void begin_with_particles(void)
{
    proposal_begin(&made, 3);
    for (int i = 0; i < 6; i++) {
        proposal_add_vertex(&made, i == 1 ? 4 : 1, i == 2 ? 4 : 1, i > 2);
        made.end[3 * i] += 0.1;
    }
    made.start[0] = made.start[1] = 0;
    for (int i = 3; i < 6; i++)
        made.end[3 * i + 2] = -1;
    made.start[3 * 5] = made.start[3 * 5 + 1] = 3.5;
    made.end[3 * 5] = made.end[3 * 5 + 1] = 3.5;
    proposal_add_triangle(&made, 0, 1, 2);
    take_proposal();
    tf_contacts found = build(NULL);
    ck_assert_uint_eq(found.count, 2);
    ck_assert_uint_eq(found.statistics.candidates, 3);
}

// Only what has moved far enough is tested.
START_TEST(pairs_that_cannot_be_in_contact_are_not_checked)
{
    begin_with_particles();
    expect_candidates(2, 2); // those in contact, though nothing has moved

    s.end[3 * 3 + 2] = 0.5; // above the triangle
    tf_contact_search moved = search(NULL);
    ck_assert(!tf_pair_cache_is_current(&cache, &moved));
    expect_candidates(1, 2);
    expect_candidates(1, 1); // only the one in contact
    s.end[3 * 3 + 2] = 0.01;
    expect_candidates(1, 1); // it is still above the triangle for sure
    s.end[3 * 3 + 2] = -0.01;
    expect_candidates(2, 2);

    // The triangle may move as well, and movements add up.
    s.end[3 * 3 + 2] = 0.5;
    s.end[2] = 0.01;
    expect_candidates(1, 3);
    for (int i = 0; i < 12; i++) {
        s.end[2] += i % 2 ? 0.02 : -0.02;
        s.end[3 * 3] += i % 2 ? 0.02 : -0.02;
        expect_candidates(1, 1);
    }
    s.end[3 * 3] += 0.02;
    expect_candidates(1, 2);
    drop_proposal();
}
END_TEST

START_TEST(without_clearances_all_pairs_that_move_are_checked)
{
    narrow_phase = &tf_reference;
    begin_with_particles();
    s.end[3 * 3 + 2] = 0.5;
    expect_candidates(1, 2);
    expect_candidates(1, 1);
    s.end[3 * 3 + 2] = 0.49;
    expect_candidates(1, 2);
    s.end[2] = 0.01;
    expect_candidates(1, 3);
    expect_candidates(1, 1);
    drop_proposal();
    narrow_phase = &tf_vectorized;
}
END_TEST

// The sum of its movements is no number any more.
START_TEST(pairs_whose_movement_overflows_are_checked)
{
    begin_with_particles();
    s.end[3 * 3] = s.end[3 * 3 + 1] = 1.5e308;
    ck_assert_uint_eq(update(NULL).count, 1);
    s.end[3 * 3] = s.end[3 * 3 + 1] = 1;
    ck_assert_uint_eq(update(NULL).count, 2);
    s.end[3 * 3 + 2] = 0.5;
    ck_assert_uint_eq(update(NULL).count, 1);
    s.end[3 * 3 + 2] = -1;
    ck_assert_uint_eq(update(NULL).count, 2);
    drop_proposal();
}
END_TEST

// A particle through a triangle, and one that is pushed to a triangle that it
// didn't come near before.
START_TEST(contacts_of_other_pairs_are_not_found)
{
    proposal_begin(&made, 3);
    for (int i = 0; i < 5; i++)
        proposal_add_vertex(&made, i == 1 ? 4 : 0, i == 2 ? 4 : 0, i > 2);
    made.start[3 * 3] = made.end[3 * 3] = 9;
    for (int k = 0; k < 3; k++)
        made.end[3 * 4 + k] = k < 2 ? 1 : -1;
    proposal_add_triangle(&made, 0, 1, 2);
    take_proposal();
    expect_contact(build(NULL), 4);

    s.end[3 * 3] = -7; // through (1, 0, 0) at half time
    s.end[3 * 3 + 1] = 2;
    s.end[3 * 3 + 2] = -1;
    expect_candidates(1, 1);
    ck_assert_uint_eq(build(NULL).count, 2);
    expect_candidates(2, 2);
    drop_proposal();
}
END_TEST

/// Lowers the ends of the lower edges of three in four crosses.
static void lower(double end[], int vertices, double by)
{
    for (int i = 0; i < vertices; i++)
        if (i % 16 >= 4 && i % 4 < 2)
            end[3 * i + 2] -= by;
}

// More pairs than a task has, kept by several workers and checked by others.
START_TEST(workers_check_pairs_that_others_have_kept)
{
    enum {
        EDGES = 40000
    };
    static double start[6 * EDGES], end[6 * EDGES];
    static int edge[2 * EDGES];
    int workers = 3;
    tf_parallel parallel = scrambled_workers(&workers);
    for (int i = 0; i < 2 * EDGES; i++) {
        // Crosses far from each other; the edges of one pass through each
        // other.
        double at[] = {4 * (i / 4) + (i % 4 == 1) - (i % 4 == 0),
                       (i % 4 == 3) - (i % 4 == 2), i % 4 < 2 ? 0 : 1};
        memcpy(start + (ptrdiff_t)3 * i, at, sizeof at);
        memcpy(end + (ptrdiff_t)3 * i, at, sizeof at);
        end[3 * i + 2] = 0.5;
        edge[i] = i;
    }
    tf_mesh mesh = {
        .axes = 3, .vertices = 2 * EDGES, .edges = EDGES, .edge = edge};
    s.surface = surface_of(&mesh);
    motion = (tf_motion){3, 2 * EDGES, start, end};
    for (int parallel_first = 0; parallel_first < 2; parallel_first++) {
        tf_contacts found = build(parallel_first ? &parallel : NULL);
        ck_assert_uint_eq(found.count, EDGES / 2);
        ck_assert_uint_eq(update(parallel_first ? NULL : &parallel).count,
                          EDGES / 2);
        lower(end, 2 * EDGES, 0.3);
        found = update(&parallel);
        ck_assert_uint_eq(found.count, EDGES / 8);
        ck_assert_uint_eq(found.statistics.candidates, EDGES / 2);
        found = update(parallel_first ? &parallel : NULL);
        ck_assert_uint_eq(found.count, EDGES / 8);
        ck_assert_uint_eq(found.statistics.candidates, EDGES / 8);
        lower(end, 2 * EDGES, -0.3);
        ck_assert_uint_eq(update(&parallel).count, EDGES / 2);
    }
    tf_surface_free(s.surface);
}
END_TEST

// An element with ends on all sides, far out of the frame of the first search,
// and a search from the beginning with these.
START_TEST(ends_far_out_of_the_frame_are_found)
{
    generator random = generator_new(400);
    proposal_make(&random, SHEETS, 2, RESTING, &made);
    tf_surface *other = surface_of(&made.mesh);
    take_proposal();
    tf_contacts found = build(NULL);
    note_cached(other);
    for (int i = 0; i < 3; i++) {
        int v = made.mesh.triangle[i];
        for (int k = 0; k < made.mesh.axes; k++)
            s.end[made.mesh.axes * v + k] = i == k ? -0x1p1000 : 0x1p1000;
    }
    found = update(NULL);
    compare(other, &found, false);
    found = build(NULL);
    compare(other, &found, true);
    drop_proposal();
    tf_surface_free(other);
}
END_TEST

// Although no pair is decided.
START_TEST(an_update_of_pairs_that_rest_can_be_cancelled)
{
    watched_call call;
    tf_contacts found;
    generator random = generator_new(600);
    proposal_make(&random, BALLS, 2, RESTING, &made);
    take_proposal();
    ck_assert(!build(NULL).any);
    tf_contact_search kept = search(NULL);
    s.surface->workers.watch = watched_begin(&call, 0);
    ck_assert_int_eq(tf_pair_cache_update(&cache, &kept, &found), TF_OK);
    ck_assert_int_ge(call.calls, 2);
    ck_assert_uint_eq(found.statistics.candidates, 0);
    s.surface->workers.watch = watched_begin(&call, 1);
    ck_assert_int_eq(tf_pair_cache_update(&cache, &kept, &found), TF_CANCELLED);
    s.surface->workers.watch = watched_begin(&call, 1);
    ck_assert_int_eq(tf_pair_cache_build(&cache, &kept, &found, NULL),
                     TF_CANCELLED);
    s.surface->workers.watch = NULL;
    ck_assert(!build(NULL).any);
    free_cache();
    drop_proposal();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/pair_cache");
    TCase *tcase = tcase_create("contacts");
    tcase_add_loop_test(tcase, contacts_of_cached_pairs_are_found, 0,
                        PROPOSAL_SHAPES);
    tcase_add_test(tcase, pairs_that_cannot_be_in_contact_are_not_checked);
    tcase_add_test(tcase, without_clearances_all_pairs_that_move_are_checked);
    tcase_add_test(tcase, pairs_whose_movement_overflows_are_checked);
    tcase_add_test(tcase, contacts_of_other_pairs_are_not_found);
    tcase_add_test(tcase, workers_check_pairs_that_others_have_kept);
    tcase_add_test(tcase, ends_far_out_of_the_frame_are_found);
    tcase_add_test(tcase, an_update_of_pairs_that_rest_can_be_cancelled);
    suite_add_tcase(suite, tcase);
    return suite;
}

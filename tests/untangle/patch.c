// A round that looks at a patch alone does what it does with the whole surface.
#include "untangle/patch.h"

#include "support/generator.h"
#include "support/support.h"
#include "support/tangles.h"
#include "untangle/limit.h"

#include <string.h>

static made_tangle own;
static tf_scope scope;
static tf_vector move[TANGLE_VERTICES], whole_move[TANGLE_VERTICES];
static double to[3 * TANGLE_VERTICES], whole_to[3 * TANGLE_VERTICES];
static int patches;

static bool all_pairs(void *context, const tf_element_pair *pair)
{
    (void)context;
    (void)pair;
    return true;
}

/// Lets all pairs meet, but by a filter; then no patch is looked for.
static void use_filter(bool on)
{
    tf_pair_filter filter = {.size = sizeof filter,
                             .wanted = on ? all_pairs : NULL};
    ck_assert_int_eq(tf_surface_set_filter(own.surface, &filter, NULL), TF_OK);
}

static void release(void)
{
    tf_scope_free(&scope);
    tangle_free(&own);
    scope = (tf_scope){.zone = NULL};
}

/// Moves what is near a vertex, the rest stays.
static void move_near(generator *random, int vertex, double reach,
                      double length)
{
    const tf_neighbors *near = &own.tangle.near;
    tf_vector middle = tf_place(near, own.x, vertex);
    memset(move, 0, sizeof move);
    for (int v = 0; v < near->vertices; v++) {
        tf_vector way = tf_vector_difference(tf_place(near, own.x, v), middle);
        for (int k = 0; k < near->axes; k++)
            if (tf_vector_length(way) < reach)
                move[v].x[k] = uniform(random, -length, length);
    }
}

/// Limits the moves twice, and compares where they end.
static void compare_limits(void)
{
    memcpy(whole_move, move, sizeof move);
    use_filter(true);
    ck_assert_int_eq(
        tf_limit_moves(&own.tangle, &scope, own.x, whole_move, whole_to),
        TF_OK);
    ck_assert(!own.tangle.patch.is_used);
    use_filter(false);
    ck_assert_int_eq(tf_limit_moves(&own.tangle, &scope, own.x, move, to),
                     TF_OK);
    size_t count = (size_t)own.mesh.axes * (size_t)own.mesh.vertices;
    ck_assert_mem_eq(to, whole_to, count * sizeof *to);
}

/// Follows the moves, and compares what crosses with all that does.
static void compare_crossings(void)
{
    static tf_crossing kept[20000];
    ck_assert_int_eq(tf_tangle_follow(&own.tangle, own.x, to), TF_OK);
    size_t count = own.tangle.crossings.count;
    ck_assert_uint_lt(count, 20000);
    if (count > 0)
        memcpy(kept, own.tangle.crossings.crossing, count * sizeof *kept);
    ck_assert_int_eq(tf_tangle_check(&own.tangle, to), TF_OK);
    ck_assert_uint_eq(own.tangle.crossings.count, count);
    for (size_t i = 0; i < count; i++) {
        const tf_crossing *one = &own.tangle.crossings.crossing[i];
        ck_assert_int_eq(kept[i].kind, one->kind);
        ck_assert_mem_eq(kept[i].vertex, one->vertex, sizeof one->vertex);
    }
}

/// Takes rounds from one state to the next.
static void take_rounds(uint64_t stream, double reach, double length)
{
    generator random = generator_new(stream);
    for (int round = 0; round < 8; round++) {
        int vertex = (int)uniform(&random, 0, own.mesh.vertices - 1e-9);
        move_near(&random, vertex, reach, length);
        ck_assert(tf_scope_find(&scope, &own.tangle, NULL, 0));
        compare_limits();
        patches += own.tangle.patch.is_used;
        compare_crossings();
        memcpy(own.x, to, sizeof to);
    }
}

START_TEST(a_patch_changes_nothing)
{
    patches = 0;
    for (int trial = 0; trial < 12; trial++) {
        tangle_make_bump(&own, trial % 3);
        tangle_finish(&own);
        take_rounds((uint64_t)trial, 1.2, 0.2 + 0.1 * (trial % 5));
        release();
    }
    ck_assert_int_gt(patches, 60);
}
END_TEST

/// A chain of vertices in the plane, back and forth.
static void make_chain(void)
{
    tangle_begin(&own, 2);
    for (int i = 0; i < 300; i++) {
        int row = i / 30, column = row % 2 ? 29 - i % 30 : i % 30;
        tangle_add(&own, 1, (double[]){column, row * 0.75 + 0.01 * i});
        if (i > 0)
            tangle_add_edge(&own, i - 1, i);
    }
    tangle_finish(&own);
}

START_TEST(nor_does_it_in_the_plane)
{
    patches = 0;
    for (int trial = 0; trial < 10; trial++) {
        make_chain();
        take_rounds((uint64_t)trial + 100, 2, 0.5);
        release();
    }
    ck_assert_int_gt(patches, 60);
}
END_TEST

/// Two triangles and a particle that is about to go through the first one, at
/// the end of a long sheet.
START_TEST(particles_and_loose_edges_belong_to_it)
{
    tangle_begin(&own, 3);
    tangle_add_sheet(&own, 20, (double[]){1, 0, 0}, (double[]){0, 1, 0},
                     (double[]){0, 0, 0});
    int particle = tangle_add(&own, 1, (double[]){0.6, 0.3, 0.5});
    int end = tangle_add(&own, 2, (double[]){1.2, 1.3, 1, 1.4, 1.1, 0.5});
    tangle_add_edge(&own, end, end + 1);
    tangle_finish(&own);
    memset(move, 0, sizeof move);
    for (int v = particle; v <= end + 1; v++)
        move[v].x[2] = -1.4;
    ck_assert(tf_scope_find(&scope, &own.tangle, NULL, 0));
    compare_limits();
    ck_assert(own.tangle.patch.is_used);
    ck_assert_int_lt(own.tangle.patch.vertices, 100);
    ck_assert_double_gt(to[3 * particle + 2], 0);
    compare_crossings();
    release();
}
END_TEST

START_TEST(a_patch_knows_what_leaves_it)
{
    tangle_begin(&own, 3);
    tangle_add_sheet(&own, 20, (double[]){1, 0, 0}, (double[]){0, 1, 0},
                     (double[]){0, 0, 0});
    tangle_finish(&own);
    const tf_neighbors *near = &own.tangle.near;
    tf_near_patch patch = {.is_used = false};
    tf_near_patch_source source = {own.surface, near, own.tangle.edge};
    memset(move, 0, sizeof move);
    move[0].x[2] = 0.5;
    ck_assert_int_eq(tf_near_patch_find(&patch, &source, own.x, move), TF_OK);
    ck_assert(patch.is_used);
    memcpy(to, own.x, sizeof to);
    to[2] = 0.5;
    ck_assert(tf_near_patch_covers(&patch, near, own.x, to));
    to[3 * 399] += 0.001;
    ck_assert(!tf_near_patch_covers(&patch, near, own.x, to));
    tf_near_patch_free(&patch);
    tangle_free(&own);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/patch");
    TCase *tcase = tcase_create("patch");
    tcase_add_test(tcase, a_patch_changes_nothing);
    tcase_add_test(tcase, nor_does_it_in_the_plane);
    tcase_add_test(tcase, particles_and_loose_edges_belong_to_it);
    tcase_add_test(tcase, a_patch_knows_what_leaves_it);
    suite_add_tcase(suite, tcase);
    return suite;
}

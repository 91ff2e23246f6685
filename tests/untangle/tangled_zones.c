// The zones of tangled surfaces, against zones that are found by trying all
// pairs of facets.
#include "untangle/tangled_zones.h"

#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"
#include "support/tangles.h"
#include "support/zoned_facets.h"

#include <string.h>

enum {
    MOST_FACETS = 4 * SURFACE_ELEMENTS
};

static surface_case given;
static tf_surface *surface;
static zoned_facets facets;
static int zone[MOST_FACETS], expected[MOST_FACETS];

static int find(int rings, const tf_parallel *parallel)
{
    int zones = -1;
    tf_check_options options = {.parallel = parallel};
    tf_error error;
    ck_assert_int_eq(tf_surface_zones(surface, given.mesh.vertices, given.start,
                                      rings, &options, zone, &zones, NULL,
                                      &error),
                     TF_OK);
    ck_assert_int_eq(error.status, TF_OK);
    return zones;
}

// By trying all ---------------------------------------------------------------

/// Which facets are in zones, and which are connected, as numbers that are
/// equal: at first each facet's own, later the least of what it is connected
/// with.
static bool in[MOST_FACETS];
static int least[MOST_FACETS];

static bool have_common_vertex(int f, int g)
{
    for (int i = 0; i < facets.axes; i++)
        if (facet_has(&facets, g, 1, facets.facet + facets.axes * f + i))
            return true;
    return false;
}

/// Gives all facets with one of two numbers the lesser one.
static void connect(int f, int g)
{
    int low = least[f] < least[g] ? least[f] : least[g];
    int high = least[f] < least[g] ? least[g] : least[f];
    for (int i = 0; i < facets.facets; i++)
        if (least[i] == high)
            least[i] = low;
}

static void take_tangle(const tangle *found)
{
    int first = found->kind == POINT_IN_TRIANGLE ? 1 : 2;
    int second = found->kind == EDGES_MEET ? 2 : 3;
    for (int f = 0; f < facets.facets; f++)
        for (int g = 0; g < facets.facets; g++)
            if (facet_has(&facets, f, first, found->vertex) &&
                facet_has(&facets, g, second, found->vertex + first)) {
                in[f] = in[g] = true;
                connect(f, g);
            }
}

static void take_ring(void)
{
    bool before[MOST_FACETS];
    memcpy(before, in, sizeof before);
    for (int f = 0; f < facets.facets; f++)
        for (int g = 0; before[f] && g < facets.facets; g++)
            in[g] = in[g] || have_common_vertex(f, g);
}

/// Fills `expected`; returns how many zones there are.
static int try_all(int rings)
{
    tangle_judge *judge = tangle_judge_new(&given.mesh);
    int count = tangle_count_all(judge, given.start), zones = 0;
    for (int f = 0; f < facets.facets; f++) {
        in[f] = false;
        least[f] = f;
    }
    for (int i = 0; i < count; i++)
        if (tangles(judge)[i].kind != POINT_IN_EDGE)
            take_tangle(&tangles(judge)[i]);
    tangle_judge_free(judge);
    for (int i = 0; i < rings; i++)
        take_ring();
    for (int f = 0; f < facets.facets; f++)
        for (int g = 0; in[f] && g < f; g++)
            if (in[g] && have_common_vertex(f, g))
                connect(f, g);
    for (int f = 0; f < facets.facets; f++)
        expected[f] = !in[f]          ? -1
                      : least[f] == f ? zones++
                                      : expected[least[f]];
    return zones;
}

START_TEST(zones_are_those_of_all_pairs)
{
    static const int few[] = {1, 2, 3, 64};
    generator random = generator_new((uint64_t)_i);
    int most = 0;
    for (int i = 0; i < (int)cases_at_least(60, 60); i++) {
        random_surface(&random, 2 + i % 2, 4 + below(&random, 60),
                       (placement)_i, &given);
        surface = surface_of(&given.mesh);
        facets = zoned_facets_of(surface, zone);
        tf_parallel parallel = scrambled_workers(&few[i % 4]);
        int rings = below(&random, 2) ? 0 : below(&random, 5);
        int zones = find(rings, i % 3 ? &parallel : NULL);
        ck_assert_int_eq(zones, try_all(rings));
        ck_assert_mem_eq(zone, expected, sizeof *zone * (size_t)facets.facets);
        most = zones > most ? zones : most;
        tf_surface_free(surface);
    }
    ck_assert(most > 1 || _i != ANYWHERE);
}
END_TEST

// By hand ---------------------------------------------------------------------

static made_tangle own;

static int zones_of_own(int rings, tf_crossings *found)
{
    int zones;
    ck_assert_int_eq(tf_surface_zones(own.surface, own.mesh.vertices, own.x,
                                      rings, NULL, zone, &zones, found, NULL),
                     TF_OK);
    return zones;
}

/// Two triangles that cross, and two rods: one through a triangle, one away.
static void make_tangles(bool apart)
{
    tangle_begin(&own, 3);
    for (int i = 0; i < 2; i++) {
        double x = 50.0 * i, z = apart && i == 1 ? 2 : -1;
        int first = tangle_add(
            &own, 8, (double[]){x,     0, 0,     x + 4,  0, 0,     x, 4, 0, //
                                x + 1, 1, z,     x + 1,  1, z + 4,          //
                                x + 9, 9, z + 4, x + 20, 0, 0,     x, 9, 9});
        tangle_add_triangle(&own, first, first + 1, first + 2);
        tangle_add_triangle(&own, first + 3, first + 4, first + 5);
    }
    tangle_add_edge(&own, 6, 14);
    tangle_finish(&own);
}

START_TEST(zones_are_numbered_by_their_first_triangles)
{
    make_tangles(false);
    tf_crossings found;
    ck_assert_int_eq(zones_of_own(0, &found), 2);
    ck_assert_mem_eq(zone, ((int[]){0, 0, 1, 1}), sizeof(int[4]));
    ck_assert_uint_eq(found.count, own.tangle.crossings.count);
    ck_assert_mem_eq(found.crossing, own.tangle.crossings.crossing,
                     found.count * sizeof *found.crossing);
    tangle_free(&own);
    make_tangles(true);
    ck_assert_int_eq(zones_of_own(9, NULL), 1);
    ck_assert_mem_eq(zone, ((int[]){0, 0, -1, -1}), sizeof(int[4]));
    tangle_free(&own);
}
END_TEST

START_TEST(rods_that_cross_make_no_zone)
{
    tangle_begin(&own, 3);
    tangle_add(&own, 5,
               (double[]){0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, -1, 1, 1, 1});
    tangle_add_triangle(&own, 0, 1, 2);
    tangle_add_edge(&own, 3, 4);
    tangle_finish(&own);
    tf_crossings found;
    ck_assert_int_eq(zones_of_own(3, &found), 0);
    ck_assert_uint_eq(found.count, 1);
    ck_assert_int_eq(zone[0], -1);
    tangle_free(&own);
}
END_TEST

START_TEST(no_tangle_is_no_zone)
{
    tangle_make_bump(&own, 0);
    tangle_finish(&own);
    ck_assert_int_eq(zones_of_own(1000000000, NULL), 0);
    for (int i = 0; i < own.mesh.triangles; i++)
        ck_assert_int_eq(zone[i], -1);
    tangle_free(&own);
}
END_TEST

// What fails ------------------------------------------------------------------

START_TEST(what_fails_sets_nothing)
{
    tangle_make_bump(&own, 3);
    tangle_finish(&own);
    int zones = 7;
    tf_crossings found = {.count = 7};
    tf_error error;
    zone[0] = 7;
    ck_assert_int_eq(tf_surface_zones(own.surface, own.mesh.vertices, own.x, -1,
                                      NULL, zone, &zones, &found, &error),
                     TF_BAD_OPTION);
    ck_assert_str_eq(error.option, "rings");
    ck_assert_int_eq(tf_surface_zones(own.surface, 3, own.x, 0, NULL, zone,
                                      &zones, &found, &error),
                     TF_BAD_COUNT);
    ck_assert(zone[0] == 7 && zones == 7 && found.count == 7);
    tangle_free(&own);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/tangled_zones");
    TCase *tcase = tcase_create("zones");
    tcase_add_loop_test(tcase, zones_are_those_of_all_pairs, 0, PLACEMENTS);
    tcase_add_test(tcase, zones_are_numbered_by_their_first_triangles);
    tcase_add_test(tcase, rods_that_cross_make_no_zone);
    tcase_add_test(tcase, no_tangle_is_no_zone);
    tcase_add_test(tcase, what_fails_sets_nothing);
    suite_add_tcase(suite, tcase);
    return suite;
}

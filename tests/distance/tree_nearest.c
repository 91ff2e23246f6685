// Nearest facets by a tree, against looking at all of them.
#include "distance/tree_nearest.h"

#include "distance/nearest.h"
#include "support/support.h"

#include <stdlib.h>
#include <string.h>

enum {
    VERTICES = 60,
    FACETS = 100
};

typedef struct cloud {
    double x[3 * VERTICES];
    int corner[3 * FACETS], chosen[FACETS];
    tf_chosen_facets facets;
} cloud;

/// Facets among random vertices, some of which are on a coarse lattice, so that
/// distances are equal, and some with all corners on one line or in one point.
static void make_cloud(generator *random, cloud *own)
{
    int axes = 2 + below(random, 2);
    double size = pow(2, -below(random, 40));
    double far = below(random, 2) ? uniform(random, -1, 1) : 0;
    bool lattice = below(random, 2);
    for (int i = 0; i < axes * VERTICES; i++)
        own->x[i] =
            far + size * (lattice ? below(random, 4) : uniform(random, -1, 1));
    for (int i = 0; i < axes * FACETS; i++)
        own->corner[i] = below(random, VERTICES);
    for (int i = 0; i < FACETS; i++)
        own->chosen[i] = below(random, FACETS);
    own->facets = (tf_chosen_facets){
        .axes = axes,
        .count = below(random, 4) ? FACETS : below(random, 8),
        .chosen = below(random, 2) ? own->chosen : NULL,
        .corner = own->corner,
        .x = own->x,
    };
}

static bool has(const cloud *own, int place, int vertex)
{
    int facet = own->facets.chosen ? own->chosen[place] : place;
    for (int c = 0; c < own->facets.axes; c++)
        if (own->corner[own->facets.axes * facet + c] == vertex)
            return true;
    return false;
}

static tf_landing first_nearest(const cloud *own, tf_vector point, int without)
{
    tf_landing best = {.place = -1, .facet = -1, .distance = INFINITY};
    for (int i = 0; i < own->facets.count; i++) {
        tf_landing next = tf_land(&own->facets, point, i);
        if (!has(own, i, without) && next.distance < best.distance)
            best = next;
    }
    return best;
}

START_TEST(a_tree_finds_what_looking_at_all_facets_does)
{
    generator random = generator_new(1);
    tf_nearest_tree tree = {.leaves = 0};
    for (long i = cases(2000); i > 0; i--) {
        cloud own;
        make_cloud(&random, &own);
        ck_assert(tf_nearest_tree_build(&tree, &own.facets));
        for (int j = 0; j < 10; j++) {
            int vertex = below(&random, VERTICES);
            int without = below(&random, 2) ? vertex : -1;
            tf_vector point = {{0, 0, 0}};
            for (int k = 0; k < own.facets.axes; k++)
                point.x[k] = own.x[own.facets.axes * vertex + k] +
                             (below(&random, 2) ? uniform(&random, -1, 1) : 0);
            tf_landing found = tf_nearest_landing(&tree, point, without);
            tf_landing wanted = first_nearest(&own, point, without);
            ck_assert_msg(found.place == wanted.place &&
                              found.facet == wanted.facet &&
                              (found.distance == wanted.distance),
                          "seed %llu: place %d at %a, not %d at %a",
                          (unsigned long long)seed(), found.place,
                          found.distance, wanted.place, wanted.distance);
        }
    }
    tf_nearest_tree_free(&tree);
}
END_TEST

START_TEST(a_landing_is_as_near_as_the_exact_bounds_say)
{
    generator random = generator_new(2);
    for (long i = cases(20000); i > 0; i--) {
        cloud own;
        make_cloud(&random, &own);
        if (own.facets.count == 0)
            continue;
        int axes = own.facets.axes, place = below(&random, own.facets.count);
        double p[3] = {0, 0, 0};
        for (int k = 0; k < axes; k++)
            p[k] = uniform(&random, -2, 2);
        tf_landing found =
            tf_land(&own.facets, (tf_vector){{p[0], p[1], p[2]}}, place);
        const double *x[4] = {p};
        for (int c = 0; c < axes; c++)
            x[1 + c] = own.x + axes * own.corner[axes * found.facet + c];
        tf_nearest exact =
            tf_nearest_of(axes == 2 ? TF_POINT_EDGE : TF_POINT_TRIANGLE, x);
        ck_assert_msg(fabs(found.distance - exact.upper) < 1e-7,
                      "seed %llu: %a, not %a", (unsigned long long)seed(),
                      found.distance, exact.upper);
    }
}
END_TEST

START_TEST(a_tree_of_nothing_has_nothing_near)
{
    tf_nearest_tree tree = {.leaves = 0};
    tf_chosen_facets none = {.axes = 3};
    ck_assert(tf_nearest_tree_build(&tree, &none));
    tf_landing found = tf_nearest_landing(&tree, (tf_vector){{1, 2, 3}}, -1);
    ck_assert_int_eq(found.place, -1);
    tf_nearest_tree_free(&tree);
}
END_TEST

Suite *suite(void)
{
    Suite *all = suite_create("nearest facets by a tree");
    TCase *one = tcase_create("tree");
    tcase_set_timeout(one, 0);
    tcase_add_test(one, a_tree_finds_what_looking_at_all_facets_does);
    tcase_add_test(one, a_landing_is_as_near_as_the_exact_bounds_say);
    tcase_add_test(one, a_tree_of_nothing_has_nothing_near);
    suite_add_tcase(all, one);
    return all;
}

// The regions into which curves cut a surface.
#include "untangle/regions.h"

#include "support/support.h"
#include "support/tangles.h"

#include <stdlib.h>
#include <string.h>

static made_tangle own;
static tf_curves curves;
static tf_regions regions;

static void find(const int preferred[])
{
    ck_assert(tf_curves_find(&curves, &own.tangle, own.x));
    ck_assert(tf_regions_find(&regions, &own.tangle, &curves, preferred));
}

static void release(void)
{
    tf_curves_free(&curves);
    tf_regions_free(&regions);
    tangle_free(&own);
    curves = (tf_curves){.count = 0};
    regions = (tf_regions){.count = 0};
}

START_TEST(a_bump_is_a_region_that_is_wrong)
{
    tangle_make_bump(&own, 3);
    tangle_finish(&own);
    find((int[]){-1, -1});
    const tf_neighbors *near = &own.tangle.near;
    for (int v = 169; v < 338; v++)
        ck_assert_int_eq(tf_is_wrong(&regions, near, regions.region[v]),
                         own.x[3 * v + 2] < 0);
    // Nothing of the flat sheet is above the other but next to the bump, where
    // the curve cuts it, too.
    ck_assert_int_eq(regions.right[0], regions.region[0]);
    ck_assert_int_eq(regions.right[1], regions.region[169]);
    release();
}
END_TEST

START_TEST(members_are_listed_once)
{
    tangle_make_bump(&own, 3);
    tangle_finish(&own);
    find((int[]){-1, -1});
    const int *start = regions.members.start;
    ck_assert_int_eq(start[0], 0);
    ck_assert_int_eq(start[regions.count], own.mesh.vertices);
    for (int r = 0; r < regions.count; r++) {
        ck_assert_int_eq(start[r + 1] - start[r], regions.size[r]);
        for (int i = start[r]; i < start[r + 1]; i++) {
            ck_assert_int_eq(regions.region[regions.members.item[i]], r);
            ck_assert(i == start[r] ||
                      regions.members.item[i - 1] < regions.members.item[i]);
        }
    }
    release();
}
END_TEST

// An edge through two facets is cut twice, so its ends are on one side.
START_TEST(an_edge_that_is_cut_twice_is_not_cut)
{
    tangle_begin(&own, 3);
    tangle_add(&own, 3, (double[]){0, 0, 0, 4, 0, 0, 0, 4, 0});
    tangle_add(&own, 3, (double[]){0, 0, 1, 4, 0, 1, 0, 4, 1});
    tangle_add(&own, 3, (double[]){1, 1, -1, 1, 1, 2, 9, 9, 3});
    for (int t = 0; t < 3; t++)
        tangle_add_triangle(&own, 3 * t, 3 * t + 1, 3 * t + 2);
    tangle_finish(&own);
    find((int[]){-1, -1, -1});
    ck_assert_int_eq(regions.region[6], regions.region[7]);
    release();
}
END_TEST

START_TEST(the_preferred_half_is_right)
{
    tangle_begin(&own, 3);
    // A strip that a triangle cuts in two halves, three vertices and three.
    tangle_add(&own, 6,
               (double[]){-2, 0, 0, -2, 1, 0, -1, 0.5, 0, //
                          1, 0.5, 0, 2, 0, 0, 2, 1, 0});
    tangle_add_triangle(&own, 0, 1, 2);
    tangle_add_triangle(&own, 3, 4, 5);
    tangle_add_triangle(&own, 0, 2, 3);
    tangle_add_triangle(&own, 1, 2, 3);
    tangle_add_triangle(&own, 0, 3, 4);
    int wall =
        tangle_add(&own, 3, (double[]){0.1, -9, -9, 0.1, 9, -9, 0.1, 0, 20});
    tangle_add_triangle(&own, wall, wall + 1, wall + 2);
    tangle_finish(&own);
    find((int[]){-1, -1});
    ck_assert_int_eq(regions.right[0], regions.region[0]);
    find((int[]){5, -1});
    ck_assert_int_eq(regions.right[0], regions.region[5]);
    ck_assert(tf_is_wrong(&regions, &own.tangle.near, regions.region[0]));
    release();
}
END_TEST

// Flooding finds what a table of who reaches whom says.
START_TEST(regions_are_what_reaches_each_other)
{
    for (int trial = 0; trial < 20; trial++) {
        tangle_make_bump(&own, 1 + trial / 4.0);
        tangle_finish(&own);
        find((int[]){-1, -1});
        const tf_neighbors *near = &own.tangle.near;
        static int label[TANGLE_VERTICES], cuts[3 * TANGLE_ELEMENTS];
        memset(cuts, 0, sizeof cuts);
        for (size_t i = 0; i < curves.count; i++)
            cuts[curves.point[i].edge]++;
        for (int v = 0; v < near->vertices; v++)
            label[v] = v;
        for (bool changed = true; changed;) {
            changed = false;
            for (int e = 0; e < near->edges; e++) {
                int *a = &label[near->edge[2 * e]];
                int *b = &label[near->edge[2 * e + 1]];
                if (cuts[e] % 2 == 1 || *a == *b)
                    continue;
                *a = *b = *a < *b ? *a : *b;
                changed = true;
            }
        }
        for (int v = 0; v < near->vertices; v++)
            ck_assert_int_eq(regions.region[v], regions.region[label[v]]);
        for (int v = 1; v < near->vertices; v++)
            ck_assert_int_eq(label[v] == label[v - 1],
                             regions.region[v] == regions.region[v - 1]);
        release();
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/regions");
    TCase *tcase = tcase_create("regions");
    tcase_add_test(tcase, a_bump_is_a_region_that_is_wrong);
    tcase_add_test(tcase, members_are_listed_once);
    tcase_add_test(tcase, an_edge_that_is_cut_twice_is_not_cut);
    tcase_add_test(tcase, the_preferred_half_is_right);
    tcase_add_test(tcase, regions_are_what_reaches_each_other);
    suite_add_tcase(suite, tcase);
    return suite;
}

// Where wrong regions have passed through facets.
#include "untangle/breaches.h"

#include "support/support.h"
#include "support/tangles.h"

static made_tangle own;
static tf_curves curves;
static tf_regions regions;
static tf_breaches breaches;

static void find(const int preferred[])
{
    ck_assert(tf_curves_find(&curves, &own.tangle, own.x));
    ck_assert(tf_regions_find(&regions, &own.tangle, &curves, preferred));
    ck_assert(
        tf_breaches_find(&breaches, &own.tangle, &curves, &regions, own.x));
}

static void release(void)
{
    tf_breaches_free(&breaches);
    tf_curves_free(&curves);
    tf_regions_free(&regions);
    tangle_free(&own);
    breaches = (tf_breaches){.count = 0};
    curves = (tf_curves){.count = 0};
    regions = (tf_regions){.count = 0};
}

/// A large triangle in the plane z = 0, and a tetrahedron above it, the tip of
/// which is below it.
static void make_tip(void)
{
    tangle_begin(&own, 3);
    tangle_add(&own, 3, (double[]){-9, -9, 0, 9, -9, 0, 0, 9, 0});
    tangle_add(&own, 4, (double[]){-1, -1, 3, 1, -1, 3, 0, 1, 3, 0, 0, -1});
    tangle_add_triangle(&own, 0, 1, 2);
    tangle_add_triangle(&own, 3, 4, 5);
    tangle_add_triangle(&own, 3, 4, 6);
    tangle_add_triangle(&own, 4, 5, 6);
    tangle_add_triangle(&own, 3, 5, 6);
    tangle_finish(&own);
}

START_TEST(a_tip_has_three_breaches)
{
    make_tip();
    find((int[]){-1, -1});
    const tf_neighbors *near = &own.tangle.near;
    int large = tf_triangle_of(near, 0, 1, 2);
    double up = tf_facet_normal(near, own.x, large).x[2];
    ck_assert_uint_eq(breaches.count, 3);
    for (size_t i = 0; i < 3; i++) {
        const tf_breach *breach = &breaches.breach[i];
        ck_assert_int_eq(breach->region, regions.region[6]);
        ck_assert_int_eq(breach->facet, large);
        ck_assert_int_eq(breach->sheet, near->sheet[large]);
        // What is right of the tetrahedron is above.
        ck_assert_int_eq(breach->side, up > 0 ? 1 : -1);
        ck_assert(breach->inward.x[2] < 0);
        ck_assert_double_eq_tol(breach->place.x[2], 0, 1e-15);
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq(breaches.place[3 * i + (size_t)k],
                                breach->place.x[k]);
    }
    release();
}
END_TEST

START_TEST(votes_are_added_up)
{
    make_tip();
    find((int[]){-1, -1});
    ck_assert_uint_eq(breaches.sides, 1);
    ck_assert_int_eq(breaches.side[0].all, 3);
    ck_assert_int_eq(breaches.side[0].sum, 3 * breaches.breach[0].side);
    ck_assert_uint_eq(breaches.side[0].first, 0);
    // Three corners of the large triangle for each of three breaches.
    ck_assert_uint_eq(breaches.pairs, 1);
    ck_assert_int_eq(breaches.pair[0].region, regions.region[6]);
    ck_assert_int_eq(breaches.pair[0].other, regions.region[0]);
    ck_assert_int_eq(breaches.pair[0].all, 9);
    release();
}
END_TEST

// Which corners a breach sees on the tip's side of the curve, counted anew.
START_TEST(a_corner_is_near_if_it_is_on_the_regions_side)
{
    make_tip();
    find((int[]){-1, -1});
    int near = 0;
    for (size_t i = 0; i < 3; i++)
        for (int v = 0; v < 3; v++) {
            tf_vector out = tf_vector_difference(
                tf_place(&own.tangle.near, own.x, v), breaches.breach[i].place);
            near += tf_vector_dot(out, breaches.breach[i].inward) > 0 ? 1 : -1;
        }
    ck_assert_int_eq(breaches.pair[0].near, near);
    release();
}
END_TEST

START_TEST(of_two_wrong_ends_the_smaller_region_is_wrong)
{
    make_tip();
    find((int[]){-1, -1});
    for (size_t i = 0; i < curves.count; i++) {
        const int *end =
            own.tangle.near.edge + 2 * (ptrdiff_t)curves.point[i].edge;
        int wrong = tf_wrong_end(&regions, &own.tangle.near, &curves.point[i]);
        ck_assert_int_eq(end[wrong], 6);
    }
    // Now no region of the part is right, and the tip is the smaller one.
    regions.right[own.tangle.near.part[6]] = -1;
    for (size_t i = 0; i < curves.count; i++)
        ck_assert_int_eq(
            tf_wrong_end(&regions, &own.tangle.near, &curves.point[i]), 1);
    release();
}
END_TEST

START_TEST(a_bump_is_sorted)
{
    tangle_make_bump(&own, 3);
    tangle_finish(&own);
    find((int[]){-1, -1});
    ck_assert_uint_gt(breaches.count, 10);
    size_t sum = 0;
    for (size_t i = 1; i < breaches.count; i++)
        ck_assert_int_ge(breaches.breach[i].region,
                         breaches.breach[i - 1].region);
    for (size_t i = 0; i < breaches.sides; i++)
        sum += (size_t)breaches.side[i].all;
    ck_assert_uint_eq(sum, breaches.count);
    sum = 0;
    for (size_t i = 0; i < breaches.pairs; i++)
        sum += (size_t)breaches.pair[i].all;
    ck_assert_uint_eq(sum, 3 * breaches.count);
    release();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/breaches");
    TCase *tcase = tcase_create("breaches");
    tcase_add_test(tcase, a_tip_has_three_breaches);
    tcase_add_test(tcase, votes_are_added_up);
    tcase_add_test(tcase, a_corner_is_near_if_it_is_on_the_regions_side);
    tcase_add_test(tcase, of_two_wrong_ends_the_smaller_region_is_wrong);
    tcase_add_test(tcase, a_bump_is_sorted);
    suite_add_tcase(suite, tcase);
    return suite;
}

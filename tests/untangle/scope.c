// The zones of a round.
#include "untangle/scope.h"

#include "support/support.h"
#include "support/tangles.h"

static made_tangle own;
static tf_scope scope;

static void find(int rings)
{
    tangle_make_bump(&own, 3);
    tangle_finish(&own);
    ck_assert(tf_scope_find(&scope, &own.tangle, NULL, rings));
}

static void release(void)
{
    tf_scope_free(&scope);
    tangle_free(&own);
    scope = (tf_scope){.zone = NULL};
}

static tf_surface_contact contact_of(tf_kind kind, int a, int b, int c, int d)
{
    return (tf_surface_contact){.kind = kind, .vertex = {a, b, c, d}};
}

/// The contact of a crossing's first end and its triangle.
static tf_surface_contact contact_at(const tf_crossing *crossing)
{
    const int *v = crossing->vertex;
    return contact_of(TF_POINT_TRIANGLE, v[0], v[2], v[3], v[4]);
}

START_TEST(what_crosses_is_in_one_zone)
{
    for (int rings = 0; rings < 3; rings++) {
        find(rings);
        for (size_t i = 0; i < own.tangle.crossings.count; i++) {
            const tf_crossing *crossing = &own.tangle.crossings.crossing[i];
            for (int c = 1; c < 5; c++)
                ck_assert_int_eq(scope.zone[crossing->vertex[c]],
                                 scope.zone[crossing->vertex[0]]);
            tf_surface_contact contact = contact_at(crossing);
            ck_assert(tf_scope_has(&scope, &own.tangle.near, &contact));
        }
        release();
    }
}
END_TEST

START_TEST(far_away_is_no_zone)
{
    find(2);
    const tf_neighbors *near = &own.tangle.near;
    ck_assert(!scope.within[0]);
    // The corner of one sheet against a triangle in the middle of the other.
    const int *v = own.tangle.crossings.crossing[0].vertex;
    tf_surface_contact contact =
        contact_of(TF_POINT_TRIANGLE, 0, v[2], v[3], v[4]);
    ck_assert(!tf_scope_has(&scope, near, &contact));
    contact = contact_of(TF_EDGE_EDGE, 0, 1, 169, 170);
    ck_assert(!tf_scope_has(&scope, near, &contact));
    release();
}
END_TEST

// An edge at the zone's border has a facet that is in no zone: it may be hit
// through that one.
START_TEST(within_means_with_all_facets)
{
    find(0);
    const tf_neighbors *near = &own.tangle.near;
    int borders = 0;
    const int *mark = tf_mark_rings(&scope.marks, &own.tangle, NULL, 0);
    for (int e = 0; e < near->edges; e++) {
        bool all = true;
        for (int i = near->sides.start[e]; i < near->sides.start[e + 1]; i++) {
            const int *corner = near->triangle + 3 * near->sides.item[i];
            all =
                all && (mark[corner[0]] || mark[corner[1]] || mark[corner[2]]);
        }
        ck_assert_int_eq(scope.within[near->vertices + e], all);
        bool some = mark[near->edge[2 * e]] || mark[near->edge[2 * e + 1]];
        borders += some && !all;
    }
    for (int v = 0; v < near->vertices; v++) {
        bool all = true;
        for (int i = near->triangles_at.start[v];
             i < near->triangles_at.start[v + 1]; i++) {
            const int *corner = near->triangle + 3 * near->triangles_at.item[i];
            all =
                all && (mark[corner[0]] || mark[corner[1]] || mark[corner[2]]);
        }
        ck_assert_int_eq(scope.within[v], all);
    }
    ck_assert_int_eq(borders, 0);
    release();
}
END_TEST

/// Expects that a triangle is kept apart from every vertex that it doesn't
/// have; returns from how many.
static int kept_against(int a, int b, int c)
{
    int kept = 0;
    for (int v = 0; v < own.mesh.vertices; v++) {
        if (v == a || v == b || v == c)
            continue;
        tf_surface_contact contact = contact_of(TF_POINT_TRIANGLE, v, a, b, c);
        ck_assert(!tf_scope_has(&scope, &own.tangle.near, &contact));
        kept++;
    }
    return kept;
}

// Its first corner is in the zone, as a neighbor of a vertex that is marked.
START_TEST(a_triangle_of_no_zone_beside_one_is_kept)
{
    find(1);
    const tf_neighbors *near = &own.tangle.near;
    const int *mark = tf_mark_rings(&scope.marks, &own.tangle, NULL, 1);
    int tried = 0;
    for (int t = 0; t < near->triangles; t++) {
        const int *v = near->triangle + 3 * t;
        if (mark[v[0]] || mark[v[1]] || mark[v[2]])
            continue;
        for (int i = 0; i < 3; i++)
            if (scope.zone[v[i]] != v[i])
                tried += kept_against(v[i], v[(i + 1) % 3], v[(i + 2) % 3]);
    }
    ck_assert_int_gt(tried, 1000);
    release();
}
END_TEST

START_TEST(rings_grow)
{
    int last = 0;
    for (int rings = 0; rings < 6; rings++) {
        find(rings);
        const int *mark = tf_mark_rings(&scope.marks, &own.tangle, NULL, rings);
        int count = 0;
        for (int v = 0; v < own.mesh.vertices; v++) {
            ck_assert_int_le(mark[v], rings + 1);
            count += mark[v] > 0;
        }
        ck_assert_int_gt(count, last);
        last = count;
        release();
    }
}
END_TEST

START_TEST(two_tangles_are_two_zones)
{
    tangle_begin(&own, 3);
    for (int i = 0; i < 2; i++) {
        int first =
            tangle_add(&own, 6,
                       (double[]){50.0 * i, 0, 0, 50.0 * i + 4, 0, 0, //
                                  50.0 * i, 4, 0, 50.0 * i + 1, 1, -1,
                                  50.0 * i + 1, 1, 3, 50.0 * i + 9, 9, 3});
        tangle_add_triangle(&own, first, first + 1, first + 2);
        tangle_add_triangle(&own, first + 3, first + 4, first + 5);
    }
    tangle_finish(&own);
    ck_assert(tf_scope_find(&scope, &own.tangle, NULL, 0));
    ck_assert_int_eq(scope.zone[0], scope.zone[3]);
    ck_assert_int_ne(scope.zone[0], scope.zone[6]);
    tf_surface_contact inside = contact_of(TF_POINT_TRIANGLE, 3, 0, 1, 2);
    tf_surface_contact across = contact_of(TF_POINT_TRIANGLE, 9, 0, 1, 2);
    ck_assert(tf_scope_has(&scope, &own.tangle.near, &inside));
    ck_assert(!tf_scope_has(&scope, &own.tangle.near, &across));
    release();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/scope");
    TCase *tcase = tcase_create("scope");
    tcase_add_test(tcase, what_crosses_is_in_one_zone);
    tcase_add_test(tcase, far_away_is_no_zone);
    tcase_add_test(tcase, within_means_with_all_facets);
    tcase_add_test(tcase, a_triangle_of_no_zone_beside_one_is_kept);
    tcase_add_test(tcase, rings_grow);
    tcase_add_test(tcase, two_tangles_are_two_zones);
    suite_add_tcase(suite, tcase);
    return suite;
}

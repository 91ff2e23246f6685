// Edges that face each other, and the pieces that they make.
#include "topology/facing.h"

#include "remesh/measure.h"
#include "support/adaptive_surfaces.h"
#include "support/blobs.h"
#include "support/support.h"
#include "topology/reconnector.h"

static blobs made;
static tf_reconnector reconnector;

/// Two balls with a gap at the height 0, the first of them below, or above.
static void begin(double gap, int divisions, bool above)
{
    made.vertices = made.triangles = 0;
    for (int i = 0; i < 2; i++) {
        const double middle[] = {0, 0, (i == above ? -1 : 1) * (1 + gap / 2)};
        add_ball(&made, middle, 1, divisions);
    }
    reconnector = (tf_reconnector){.surface = blobs_surface(&made)};
}

static void end(void)
{
    tf_adaptive_free(reconnector.surface);
    tf_reconnector_free(&reconnector);
}

static const tf_facing_edges *pair_at(int i)
{
    return (const tf_facing_edges *)reconnector.candidate.data + i;
}

/// The distance of two edges, by points on them.
static double about(const int first[2], const int second[2])
{
    double least = INFINITY;
    for (int i = 0; i <= 2500; i++) {
        double s = i % 51 / 50.0, t = i / 51 / 48.0;
        tf_vector p = tf_vector_sum(
            tf_vector_scaled(1 - s,
                             tf_position_of(reconnector.surface, first[0])),
            s, tf_position_of(reconnector.surface, first[1]));
        tf_vector q = tf_vector_sum(
            tf_vector_scaled(1 - t,
                             tf_position_of(reconnector.surface, second[0])),
            t, tf_position_of(reconnector.surface, second[1]));
        least = fmin(least, tf_vector_length(tf_vector_difference(p, q)));
    }
    return least;
}

START_TEST(edges_across_a_gap_are_listed_the_nearest_first)
{
    begin(0.05, 4, false);
    ck_assert_int_eq(tf_list_facing(&reconnector, 0.2), TF_OK);
    ck_assert_int_gt(reconnector.candidates, 10);
    for (int i = 0; i < reconnector.candidates; i++) {
        const tf_facing_edges *pair = pair_at(i);
        ck_assert(i == 0 || pair[-1].distance <= pair->distance);
        ck_assert_double_lt(pair->distance, 0.2);
        ck_assert_double_eq_tol(about(pair->first, pair->second),
                                pair->distance, 0.02);
        bool lower =
            tf_position_of(reconnector.surface, pair->first[0]).x[2] < 0;
        ck_assert(
            lower !=
            (tf_position_of(reconnector.surface, pair->second[0]).x[2] < 0));
        for (int j = 0; j < i; j++)
            ck_assert(pair_at(j)->first[0] != pair->first[0] ||
                      pair_at(j)->first[1] != pair->first[1] ||
                      pair_at(j)->second[0] != pair->second[0] ||
                      pair_at(j)->second[1] != pair->second[1]);
    }
    end();
}
END_TEST

// All pairs, without the tree: those whose ends are within reach are
// there.
START_TEST(all_facing_edges_are_listed)
{
    begin(0.05, 3, _i);
    ck_assert_int_eq(tf_list_facing(&reconnector, 0.3), TF_OK);
    int near = 0, corners = 3 * reconnector.surface->triangles;
    for (int c = 0; c < corners; c++)
        for (int d = 0; d < c; d++) {
            int a[] = {tf_vertex_at(reconnector.surface, c),
                       tf_vertex_at(reconnector.surface, tf_corner_after(c))};
            int b[] = {tf_vertex_at(reconnector.surface, d),
                       tf_vertex_at(reconnector.surface, tf_corner_after(d))};
            bool across =
                (a[0] < made.vertices / 2) != (b[0] < made.vertices / 2);
            if (a[0] < a[1] && b[0] < b[1] && across)
                near += about(a, b) < 0.25;
        }
    ck_assert_int_gt(near, 4);
    ck_assert_int_ge(reconnector.candidates, near);
    end();
}
END_TEST

// The inner sides of a wall face away from each other.
START_TEST(edges_that_face_inward_are_not_listed)
{
    made.vertices = made.triangles = 0;
    const double middle[] = {0, 0, 0};
    add_ball(&made, middle, 1, 4);
    add_ball(&made, middle, 1.1, 4);
    for (int t = made.triangles / 2; t < made.triangles; t++) {
        int *v = made.triangle + 3 * t, swap = v[1];
        v[1] = v[2];
        v[2] = swap;
    }
    for (int inward = 0; inward < 2; inward++) {
        reconnector = (tf_reconnector){.surface = blobs_surface(&made)};
        ck_assert_int_eq(tf_list_facing(&reconnector, 0.2), TF_OK);
        ck_assert_int_eq(reconnector.candidates > 0, inward == 0);
        end();
        for (int i = 0; i < made.triangles; i++) {
            int *v = made.triangle + 3 * i, swap = v[1];
            v[1] = v[2];
            v[2] = swap;
        }
    }
}
END_TEST

// Two squares at a right angle, each before the other.
START_TEST(edges_whose_normals_do_not_oppose_are_not_listed)
{
    static double position[][3] = {
        {0, 0, 0},      {1, 0, 0},      {1, 1, 0},      {0, 1, 0},
        {-0.1, 0, 0.1}, {-0.1, 1, 0.1}, {-0.1, 1, 1.1}, {-0.1, 0, 1.1}};
    static const int triangle[] = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    reconnector =
        (tf_reconnector){.surface = adaptive_of(8, position, 4, triangle)};
    ck_assert_int_eq(tf_list_facing(&reconnector, 2), TF_OK);
    ck_assert_int_eq(reconnector.candidates, 0);
    end();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("topology/facing");
    TCase *tcase = tcase_create("edges");
    tcase_add_test(tcase, edges_across_a_gap_are_listed_the_nearest_first);
    tcase_add_loop_test(tcase, all_facing_edges_are_listed, 0, 2);
    tcase_add_test(tcase, edges_whose_normals_do_not_oppose_are_not_listed);
    tcase_add_test(tcase, edges_that_face_inward_are_not_listed);
    suite_add_tcase(suite, tcase);
    return suite;
}

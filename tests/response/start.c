// What a start has to be.
#include "response/start.h"

#include "fast/detect.h"
#include "support/proposals.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/watches.h"

#include <math.h>
#include <string.h>

static proposal made;
static tf_watch *watch; // over checks of contacts
static tf_error error;

static tf_status check(void)
{
    tf_surface *surface = surface_of(&made.mesh);
    tf_motion motion = {made.mesh.axes, made.mesh.vertices, made.start,
                        made.end};
    memset(&error, 0, sizeof error);
    tf_status status = tf_start_check(surface, &motion, NULL, &error);
    tf_surface_free(surface);
    return status;
}

static tf_status check_contacts(void)
{
    tf_surface *surface = surface_of(&made.mesh);
    tf_motion motion = {made.mesh.axes, made.mesh.vertices, made.start,
                        made.end};
    tf_contacts found;
    memset(&error, 0, sizeof error);
    ck_assert_int_eq(tf_surface_detect(surface, &motion, NULL, &found, NULL),
                     TF_OK);
    tf_status status = tf_start_check_contacts(&motion, &found, watch, &error);
    tf_surface_free(surface);
    return status;
}

/// A rod from height `low` to height 1, upright in a triangle.
static void make_rod(double low)
{
    proposal_begin(&made, 3);
    for (int i = 0; i < 3; i++)
        proposal_add_vertex(&made, i == 1 ? 4 : 0, i == 2 ? 4 : 0, 0);
    proposal_add_triangle(&made, 0, 1, 2);
    proposal_add_vertex(&made, 1, 1, low);
    proposal_add_vertex(&made, 1, 1, 1);
    proposal_add_edge(&made, 3, 4);
}

START_TEST(edges_through_triangles_are_found)
{
    make_rod(-1);
    ck_assert_int_eq(check(), TF_START_NOT_CLEAR);
    static const int expected[] = {3, 4, 0, 1, 2};
    ck_assert_int_eq(error.subject, TF_EDGE_TRIANGLE_PAIR);
    ck_assert_mem_eq(error.vertex, expected, sizeof expected);
    // No contact shows them.
    ck_assert_int_eq(check_contacts(), TF_OK);
    make_rod(0x1p-1074);
    ck_assert_int_eq(check(), TF_OK);
}
END_TEST

START_TEST(contacts_at_the_start_are_told_from_later_ones)
{
    make_rod(0);
    made.end[3 * 3 + 2] = 1;
    ck_assert_int_eq(check_contacts(), TF_START_NOT_CLEAR);
    ck_assert_int_eq(error.subject, TF_POINT_TRIANGLE_PAIR);
    ck_assert_int_eq(error.vertex[0], 3);
    ck_assert_int_eq(error.vertex[1], 0);
    // So near that toi_lo is 0, and yet no touch.
    make_rod(0x1p-1074);
    made.end[3 * 3 + 2] = -1;
    ck_assert_int_eq(check_contacts(), TF_OK);
}
END_TEST

/// Two edges that cross at the start, after which the second one rises.
static void make_cross(void)
{
    proposal_begin(&made, 3);
    for (int v = 0; v < 4; v++) {
        int along = v % 2 ? 1 : -1;
        proposal_add_vertex(&made, v < 2 ? along : 0, v < 2 ? 0 : along, 0);
        made.end[3 * v + 2] = v < 2 ? 0 : 1;
    }
    proposal_add_edge(&made, 0, 1);
    proposal_add_edge(&made, 2, 3);
}

START_TEST(edges_that_cross_are_found)
{
    static const int expected[] = {0, 1, 2, 3};
    make_cross();
    ck_assert_int_eq(check_contacts(), TF_START_NOT_CLEAR);
    ck_assert_int_eq(error.subject, TF_EDGE_EDGE_PAIR);
    ck_assert_mem_eq(error.vertex, expected, sizeof expected);
    ck_assert_int_eq(error.vertex[4], -1);
    ck_assert_int_eq(error.time, 0);
    ck_assert_int_eq(check(), TF_START_NOT_CLEAR);
    ck_assert_int_eq(error.time, 0);
}
END_TEST

START_TEST(curves_touch_points_and_edges)
{
    proposal_begin(&made, 2);
    for (int i = 0; i < 4; i++)
        proposal_add_vertex(&made, i < 2 ? 2 * i - 1 : 0, i < 2 ? 0 : 3 - i, 0);
    proposal_add_edge(&made, 0, 1);
    proposal_add_edge(&made, 2, 3);
    ck_assert_int_eq(check(), TF_START_NOT_CLEAR);
    ck_assert_int_eq(error.subject, TF_EDGE_EDGE_PAIR);
    ck_assert_int_eq(check_contacts(), TF_START_NOT_CLEAR);
    ck_assert_int_eq(error.subject, TF_POINT_EDGE_PAIR);
    ck_assert_int_eq(error.vertex[0], 3);
}
END_TEST

START_TEST(statuses_are_passed_on)
{
    make_rod(0.5);
    made.start[4] = NAN;
    ck_assert_int_eq(check(), TF_NOT_FINITE);
    ck_assert_uint_eq(error.index, 1);
}
END_TEST

START_TEST(a_caller_may_cancel)
{
    watched_call call;
    make_rod(0.5);
    made.end[3 * 3 + 2] = made.end[3 * 4 + 2] = -1;
    watch = watched_begin(&call, 0);
    ck_assert_int_eq(check_contacts(), TF_OK);
    ck_assert_uint_ge(watched_work(&call), 2);
    watch = watched_begin(&call, -1);
    ck_assert_int_eq(check_contacts(), TF_CANCELLED);
    ck_assert_int_eq(error.status, TF_CANCELLED);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/start");
    TCase *tcase = tcase_create("starts");
    tcase_add_test(tcase, edges_through_triangles_are_found);
    tcase_add_test(tcase, contacts_at_the_start_are_told_from_later_ones);
    tcase_add_test(tcase, edges_that_cross_are_found);
    tcase_add_test(tcase, curves_touch_points_and_edges);
    tcase_add_test(tcase, statuses_are_passed_on);
    tcase_add_test(tcase, a_caller_may_cancel);
    suite_add_tcase(suite, tcase);
    return suite;
}

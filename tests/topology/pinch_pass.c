// The pass that pinches: necks of short edges, and no tips.
#include "topology/pinch_pass.h"

#include "support/adaptive_surfaces.h"
#include "support/blobs.h"
#include "support/support.h"
#include "topology/reconnector.h"

static blobs made;
static tf_reconnector reconnector;

static void begin(int rings, const double radius[], const double height[])
{
    made.vertices = made.triangles = 0;
    add_turned(&made, 3, rings, radius, height);
    reconnector = (tf_reconnector){.surface = blobs_surface(&made),
                                   .lengths = {.apart = 0.3, .pinch = 0.7}};
}

static size_t pinches(void)
{
    ck_assert_int_eq(tf_pinch_pass(&reconnector), TF_OK);
    return reconnector.report.tried[TF_PINCH][TF_COMMITTED];
}

static void end(void)
{
    tf_adaptive_free(reconnector.surface);
    tf_reconnector_free(&reconnector);
}

// The edges of a ring are the square root of 3 times its radius long.
START_TEST(a_neck_of_short_edges_is_pinched)
{
    static const double radius[] = {1, 1, 0.3, 1, 1},
                        height[] = {0, 1, 2, 3, 4};
    begin(5, radius, height);
    double before = volume_of(reconnector.surface);
    ck_assert_uint_eq(pinches(), 1);
    ck_assert_int_eq(parts_of(reconnector.surface), 2);
    ck_assert(is_sound(reconnector.surface));
    ck_assert_double_eq_tol(volume_of(reconnector.surface) - before,
                            reconnector.report.gained[TF_PINCH], 1e-12);
    ck_assert_double_lt(reconnector.report.gained[TF_PINCH], 0);
    // The caps are so far apart that they do not merge again.
    double low = 9, high = 0;
    for (int v = 6; v < tf_adaptive_mesh(reconnector.surface)->vertices; v++)
        if (v < 9 || v >= made.vertices) {
            double z = coordinates_of(reconnector.surface, v)[2];
            low = fmin(low, z);
            high = fmax(high, z);
        }
    ck_assert_double_gt(high - low, 0.3);
    end();
}
END_TEST

START_TEST(a_wide_neck_is_not_pinched)
{
    static const double radius[] = {1, 1, 0.5, 1, 1},
                        height[] = {0, 1, 2, 3, 4};
    begin(5, radius, height);
    ck_assert_uint_eq(pinches(), 0);
    end();
}
END_TEST

// The first and the last ring have one vertex beyond.
START_TEST(a_tip_is_not_pinched)
{
    static const double radius[] = {0.3, 0.3}, height[] = {0, 1};
    begin(2, radius, height);
    ck_assert_uint_eq(pinches(), 0);
    ck_assert_int_eq(parts_of(reconnector.surface), 1);
    end();
}
END_TEST

// A thread of two loops is cut at one of them, or at both.
START_TEST(a_thread_of_two_loops_is_cut)
{
    static const double radius[] = {1, 1, 0.3, 0.25, 1, 1},
                        height[] = {0, 1, 2, 3, 4, 5};
    begin(6, radius, height);
    size_t count = pinches();
    ck_assert_uint_ge(count, 1);
    ck_assert_int_eq(parts_of(reconnector.surface), (int)count + 1);
    ck_assert(is_sound(reconnector.surface));
    end();
}
END_TEST

START_TEST(a_boundary_is_not_pinched)
{
    static const double radius[] = {0.3, 0.3, 0.3}, height[] = {0, 1, 2};
    begin(3, radius, height);
    end();
    made.triangles -= 6; // open at both ends
    reconnector = (tf_reconnector){.surface = blobs_surface(&made),
                                   .lengths = {.apart = 0.3, .pinch = 0.7}};
    ck_assert_uint_eq(pinches(), 1); // the ring between
    ck_assert_uint_eq(reconnector.report.tried[TF_PINCH][TF_IMPOSSIBLE], 0);
    end();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("topology/pinch_pass");
    TCase *tcase = tcase_create("pinching");
    tcase_add_test(tcase, a_neck_of_short_edges_is_pinched);
    tcase_add_test(tcase, a_wide_neck_is_not_pinched);
    tcase_add_test(tcase, a_tip_is_not_pinched);
    tcase_add_test(tcase, a_thread_of_two_loops_is_cut);
    tcase_add_test(tcase, a_boundary_is_not_pinched);
    suite_add_tcase(suite, tcase);
    return suite;
}

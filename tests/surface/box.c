// Boxes: rounding keeps the order of numbers, so it keeps overlaps.
#include "surface/box.h"

#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surfaces.h"

#include <float.h>
#include <math.h>
#include <string.h>

static surface_case given;

/// Whether the coordinates of two vertices on an axis are finite, and in the
/// order that they have in space: starts with starts and ends with ends, or if
/// they are swept each with each.
static bool keeps_order(const tf_path path[], int axes, int v, int w, int k,
                        bool swept)
{
    bool kept = true;
    for (int from = 0; from < 2; from++)
        for (int to = 0; to < 2; to++) {
            double x = (from ? given.end : given.start)[axes * v + k];
            double y = (to ? given.end : given.start)[axes * w + k];
            float a = path[v].at[TF_AXES * from + k];
            float b = path[w].at[TF_AXES * to + k];
            kept &= isfinite(a) != 0;
            kept &= (from != to && !swept) || x > y || a <= b;
        }
    return kept;
}

START_TEST(the_order_of_coordinates_is_kept)
{
    static tf_path path[SURFACE_VERTICES];
    generator random = generator_new((uint64_t)_i);
    for (int i = 0; i < (int)cases(50); i++) {
        int axes = 2 + i % 2, bad;
        bool swept = i % 3 == 0;
        random_surface(&random, axes, 60, (placement)_i, &given);
        tf_frame frame;
        ck_assert_int_eq(tf_frame_of(axes, &given.motion, NULL, &frame, &bad),
                         TF_OK);
        if (swept)
            tf_frame_sweep(&frame);
        tf_vertex_paths(&frame, &given.motion, NULL, path);
        bool kept = true;
        for (int v = 0; v < given.mesh.vertices; v++)
            for (int w = 0; w < given.mesh.vertices; w++)
                for (int k = 0; k < axes; k++)
                    kept &= keeps_order(path, axes, v, w, k, swept);
        ck_assert(kept);
    }
}
END_TEST

/// The frame of two vertices on a line.
static tf_frame frame_of(double a, double b)
{
    double x[] = {a, 0, 0, b, 0, 0};
    tf_motion motion = {3, 2, x, x};
    tf_frame frame;
    int bad;
    ck_assert_int_eq(tf_frame_of(3, &motion, NULL, &frame, &bad), TF_OK);
    return frame;
}

START_TEST(the_largest_coordinates_come_near_one)
{
    static const double size[] = {4.9e-324, 1e-300, 1, 1e300, DBL_MAX};
    for (int i = 0; i < 5; i++) {
        tf_frame frame = frame_of(-size[i], size[i]);
        double place = (size[i] - frame.center[0]) * frame.scale;
        ck_assert(isfinite(place) && place > 0 && place < 2);
        // Half of the least double is none.
        ck_assert(i == 0 || (float)place >= 0.5f);
    }
    // Far from the origin, too, a small scene keeps its shape.
    tf_frame far = frame_of(1e6, 1e6 + 1e-3);
    ck_assert((float)((1e6 + 1e-3 - far.center[0]) * far.scale) > 0.4f);
}
END_TEST

START_TEST(the_whole_is_the_union_of_all_paths)
{
    static tf_path path[SURFACE_VERTICES];
    generator random = generator_new((uint64_t)_i);
    for (int i = 0; i < (int)cases(50); i++) {
        int axes = 2 + i % 2, bad;
        bool swept = i % 3 == 0;
        random_surface(&random, axes, 60, (placement)_i, &given);
        tf_frame frame;
        ck_assert_int_eq(tf_frame_of(axes, &given.motion, NULL, &frame, &bad),
                         TF_OK);
        if (swept)
            tf_frame_sweep(&frame);
        tf_vertex_paths(&frame, &given.motion, NULL, path);
        for (int side = 0; side < TF_SIDES; side++) {
            float low = INFINITY, high = -INFINITY;
            for (int v = 0; v < given.mesh.vertices; v++)
                for (int end = 0; end < 2; end++) {
                    bool own = swept || end == side / TF_AXES;
                    float x = path[v].at[TF_AXES * end + side % TF_AXES];
                    low = own && x < low ? x : low;
                    high = own && x > high ? x : high;
                }
            ck_assert(frame.whole.low[side] == low);
            ck_assert(frame.whole.high[side] == high);
        }
    }
}
END_TEST

enum {
    MANY = 100000 // vertices, for several tasks
};

static double many_start[3 * MANY], many_end[3 * MANY];

static tf_status frame_of_many(tf_frame *frame, int *bad)
{
    static const int workers = 3;
    tf_parallel parallel = scrambled_workers(&workers);
    tf_motion motion = {3, MANY, many_start, many_end};
    return tf_frame_of(3, &motion, &parallel, frame, bad);
}

START_TEST(each_vertex_extends_the_frame)
{
    generator random = generator_new((uint64_t)_i);
    for (int i = 0; i < 3 * MANY; i++) {
        many_start[i] = uniform(&random, -1, 1);
        many_end[i] = uniform(&random, -1, 1);
    }
    for (int i = 0; i < (int)cases(200); i++) {
        int v = i == 0 ? 0 : i == 1 ? MANY - 1 : below(&random, MANY);
        double *x = (i % 2 ? many_end : many_start) + 3 * v + i % 3, old = *x;
        int bad;
        tf_frame frame;
        *x = i % 4 < 2 ? 8 : -8;
        ck_assert_int_eq(frame_of_many(&frame, &bad), TF_OK);
        *x = old;
        // The center of the side is half of that, give or take half of 1.
        int side = (i % 2 ? TF_AXES : 0) + i % 3;
        double center = frame.center[side] * (i % 4 < 2 ? 1 : -1);
        ck_assert(center >= 3.5 && center <= 4.5);
        ck_assert(frame.scale == 0.125);
    }
}
END_TEST

START_TEST(the_first_vertex_that_is_not_finite_is_named)
{
    generator random = generator_new((uint64_t)_i);
    memset(many_start, 0, sizeof many_start);
    memset(many_end, 0, sizeof many_end);
    for (int i = 0; i < (int)cases(200); i++) {
        int v = below(&random, MANY), w = below(&random, MANY), bad;
        tf_frame frame;
        many_start[3 * v + i % 3] = i % 4 < 2 ? NAN : INFINITY;
        many_end[3 * w + i % 3] = i % 4 < 2 ? -INFINITY : NAN;
        ck_assert_int_eq(frame_of_many(&frame, &bad), TF_NOT_FINITE);
        ck_assert_int_eq(bad, v < w ? v : w);
        many_start[3 * v + i % 3] = many_end[3 * w + i % 3] = 0;
    }
}
END_TEST

START_TEST(a_shift_of_all_ends_changes_no_path)
{
    generator random = generator_new(8);
    for (int i = 0; i < (int)cases(100); i++) {
        tf_frame frame;
        tf_path path[2][60];
        int bad, stray = below(&random, 60);
        double shift = ldexp(1 + below(&random, 1000), below(&random, 20));
        tf_motion motion = {3, 60, many_start, many_end};
        for (int k = 0; k < 3 * 60; k++) {
            many_start[k] = below(&random, 1 << 20);
            many_end[k] = below(&random, 1 << 20);
        }
        for (int n = 0; n < 2; n++) {
            ck_assert_int_eq(tf_frame_of(3, &motion, NULL, &frame, &bad),
                             TF_OK);
            tf_vertex_paths(&frame, &motion, NULL, path[n]);
            for (int k = 0; k < 3 * 60; k++)
                many_end[k] += shift;
        }
        ck_assert_mem_eq(path[0], path[1], sizeof *path);
        many_end[3 * stray] += 5e6; // beyond all others
        ck_assert_int_eq(tf_frame_of(3, &motion, NULL, &frame, &bad), TF_OK);
        tf_vertex_paths(&frame, &motion, NULL, path[1]);
        ck_assert_mem_ne(path[0], path[1], sizeof *path);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/box");
    TCase *tcase = tcase_create("boxes");
    tcase_add_loop_test(tcase, the_order_of_coordinates_is_kept, 0, PLACEMENTS);
    tcase_add_test(tcase, the_largest_coordinates_come_near_one);
    tcase_add_loop_test(tcase, the_whole_is_the_union_of_all_paths, 0,
                        PLACEMENTS);
    tcase_add_test(tcase, each_vertex_extends_the_frame);
    tcase_add_test(tcase, the_first_vertex_that_is_not_finite_is_named);
    tcase_add_test(tcase, a_shift_of_all_ends_changes_no_path);
    suite_add_tcase(suite, tcase);
    return suite;
}

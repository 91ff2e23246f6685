#include "renderer/camera.h"

#include "support/support.h"

#include <math.h>

static const fig_box box = {10, 20, 200, 100};

#define CLOSE(a, b) ck_assert_double_eq_tol(a, b, 1e-9)

/// Expect a point of the world at a place of the page and behind the center.
static void expect_seen(const fig_view *view, tf_vector world, double x,
                        double y, double depth)
{
    fig_point at = fig_view_project(view, world);
    CLOSE(at.x, x);
    CLOSE(at.y, y);
    CLOSE(fig_view_depth(view, world), depth);
}

START_TEST(front_view_keeps_x_and_z)
{
    fig_camera camera = {.height = 10};
    fig_view view = fig_view_of(&camera, box);
    expect_seen(&view, (tf_vector){{0, 0, 0}}, 110, 70, 0);
    expect_seen(&view, (tf_vector){{1, 5, 2}}, 120, 50, 5);
}
END_TEST

START_TEST(azimuth_walks_to_the_right)
{
    fig_camera camera = {.height = 10, .azimuth = 90};
    fig_view view = fig_view_of(&camera, box);
    // From the right, +y is to the right and +x comes nearer.
    expect_seen(&view, (tf_vector){{3, 1, 0}}, 120, 70, -3);
}
END_TEST

START_TEST(elevation_looks_from_above)
{
    fig_camera camera = {.height = 10, .elevation = 90};
    fig_view view = fig_view_of(&camera, box);
    expect_seen(&view, (tf_vector){{0, 2, 4}}, 110, 50, -4);
}
END_TEST

START_TEST(perspective_shrinks_with_distance)
{
    fig_camera camera = {.height = 10, .distance = 5};
    fig_view view = fig_view_of(&camera, box);
    expect_seen(&view, (tf_vector){{1, 0, 0}}, 120, 70, 0);
    expect_seen(&view, (tf_vector){{1, 5, 0}}, 115, 70, 5);
    fig_point at_eye = fig_view_project(&view, (tf_vector){{1, -5, 0}});
    ck_assert(isfinite(at_eye.x) && at_eye.x > 1000);
}
END_TEST

START_TEST(fit_fills_the_box_to_its_margin)
{
    fig_camera camera = {.azimuth = 35, .elevation = 20};
    camera.distance = _i == 0 ? 0 : 12;
    generator random = generator_new(1);
    tf_vector points[20];
    for (int i = 0; i < 20; i++)
        for (int k = 0; k < 3; k++)
            points[i].x[k] = uniform(&random, -1, 3);
    fig_camera fitted =
        fig_camera_fit(&camera, 20, points, box.width, box.height, 8);
    fig_view view = fig_view_of(&fitted, box);
    double least = 1e9;
    for (int i = 0; i < 20; i++) {
        fig_point at = fig_view_project(&view, points[i]);
        double left = at.x - box.x, top = at.y - box.y;
        double right = box.width - left, bottom = box.height - top;
        least = fmin(least, fmin(fmin(left, right), fmin(top, bottom)));
    }
    ck_assert_double_eq_tol(least, 8, 0.05);
}
END_TEST

START_TEST(fit_takes_a_single_point)
{
    const fig_camera camera = {.elevation = 20};
    const tf_vector center = {{7, 8, 9}};
    fig_camera fitted =
        fig_camera_fit(&camera, 1, &center, box.width, box.height, 8);
    fig_view view = fig_view_of(&fitted, box);
    expect_seen(&view, center, 110, 70, 0);
}
END_TEST

Suite *suite(void)
{
    Suite *made = suite_create("renderer/camera");
    TCase *tests = tcase_create("camera");
    suite_add_tcase(made, tests);
    tcase_add_test(tests, front_view_keeps_x_and_z);
    tcase_add_test(tests, azimuth_walks_to_the_right);
    tcase_add_test(tests, elevation_looks_from_above);
    tcase_add_test(tests, perspective_shrinks_with_distance);
    tcase_add_loop_test(tests, fit_fills_the_box_to_its_margin, 0, 2);
    tcase_add_test(tests, fit_takes_a_single_point);
    return made;
}

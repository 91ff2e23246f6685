#include "stage/camera.h"

#include "support/support.h"

#include <math.h>

static const tf_box box = {10, 20, 200, 100};

#define CLOSE(a, b) ck_assert_double_eq_tol(a, b, 1e-9)

START_TEST(front_view_keeps_x_and_z)
{
    tf_camera camera = {.height = 10};
    tf_view view = tf_view_of(&camera, box);
    double at[2];
    CLOSE(tf_view_project(&view, (double[]){0, 0, 0}, at), 0);
    CLOSE(at[0], 110);
    CLOSE(at[1], 70);
    CLOSE(tf_view_project(&view, (double[]){1, 5, 2}, at), 5);
    CLOSE(at[0], 120);
    CLOSE(at[1], 50);
}
END_TEST

START_TEST(azimuth_walks_to_the_right)
{
    tf_camera camera = {.height = 10, .azimuth = 90};
    tf_view view = tf_view_of(&camera, box);
    double at[2];
    // From the right, +y is to the right and +x comes nearer.
    CLOSE(tf_view_project(&view, (double[]){3, 1, 0}, at), -3);
    CLOSE(at[0], 120);
    CLOSE(at[1], 70);
}
END_TEST

START_TEST(elevation_looks_from_above)
{
    tf_camera camera = {.height = 10, .elevation = 90};
    tf_view view = tf_view_of(&camera, box);
    double at[2];
    CLOSE(tf_view_project(&view, (double[]){0, 2, 4}, at), -4);
    CLOSE(at[0], 110);
    CLOSE(at[1], 50);
}
END_TEST

START_TEST(perspective_shrinks_with_distance)
{
    tf_camera camera = {.height = 10, .distance = 5};
    tf_view view = tf_view_of(&camera, box);
    double at[2];
    tf_view_project(&view, (double[]){1, 0, 0}, at);
    CLOSE(at[0], 120);
    tf_view_project(&view, (double[]){1, 5, 0}, at);
    CLOSE(at[0], 115);
    tf_view_project(&view, (double[]){1, -5, 0}, at); // at the eye
    ck_assert(isfinite(at[0]) && at[0] > 1000);
}
END_TEST

START_TEST(fit_fills_the_box_to_its_margin)
{
    tf_camera camera = {.azimuth = 35, .elevation = 20};
    camera.distance = _i == 0 ? 0 : 12;
    generator random = generator_new(1);
    double points[20][3];
    for (int i = 0; i < 20; i++)
        for (int k = 0; k < 3; k++)
            points[i][k] = uniform(&random, -1, 3);
    tf_camera fitted = tf_camera_fit(&camera, 20, (const double(*)[3])points,
                                     box.width, box.height, 8);
    tf_view view = tf_view_of(&fitted, box);
    double least = 1e9;
    for (int i = 0; i < 20; i++) {
        double at[2];
        tf_view_project(&view, points[i], at);
        double left = at[0] - box.x, top = at[1] - box.y;
        double right = box.width - left, bottom = box.height - top;
        least = fmin(least, fmin(fmin(left, right), fmin(top, bottom)));
    }
    ck_assert_double_eq_tol(least, 8, 0.05);
}
END_TEST

START_TEST(fit_takes_a_single_point)
{
    tf_camera camera = {.elevation = 20};
    tf_camera fitted = tf_camera_fit(&camera, 1, (const double[][3]){{7, 8, 9}},
                                     box.width, box.height, 8);
    tf_view view = tf_view_of(&fitted, box);
    double at[2];
    tf_view_project(&view, (double[]){7, 8, 9}, at);
    CLOSE(at[0], 110);
    CLOSE(at[1], 70);
}
END_TEST

Suite *suite(void)
{
    Suite *made = suite_create("stage/camera");
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

#include "simulate/cloth.h"

#include "support/support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const tf_material linen = {.density = 0.5, .stretch = 200, .bend = 0.01};

/// A rectangle of 2 by 1 in the first two axes.
static tf_body sheet_of(int across, const tf_material *material)
{
    tf_body body = {.axes = 3};
    int along = across / 2;
    tf_sheet sheet = {.across = across,
                      .along = along,
                      .corner = {-1, -0.5, 0},
                      .across_step = {2.0 / across, 0, 0},
                      .along_step = {0, 1.0 / along, 0}};
    tf_sheet_add(&body, &sheet, material);
    ck_assert(!body.failed);
    return body;
}

START_TEST(a_sheet_has_two_triangles_a_cell)
{
    tf_body body = sheet_of(6, NULL);
    ck_assert_int_eq(body.vertices, 7 * 4);
    ck_assert_int_eq(body.triangles, 2 * 6 * 3);
    ck_assert_int_eq(body.elastics, 0);
    double area = 0;
    for (int t = 0; t < body.triangles; t++) {
        const int *corner = body.triangle + 3 * t;
        const double *a = body.position + 3 * corner[0];
        const double *b = body.position + 3 * corner[1];
        const double *c = body.position + 3 * corner[2];
        double twice =
            (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
        ck_assert_double_gt(twice, 0);
        area += twice / 2;
    }
    ck_assert_double_eq_tol(area, 2, 1e-12);
    tf_body_free(&body);
}
END_TEST

START_TEST(the_mass_of_a_sheet_is_that_of_its_area)
{
    tf_body body = sheet_of(6, &linen);
    double mass = 0;
    for (int v = 0; v < body.vertices; v++) {
        ck_assert_double_gt(body.mass[v], 0);
        mass += body.mass[v];
    }
    ck_assert_double_eq_tol(mass, 1, 1e-12);
    tf_body_free(&body);
}
END_TEST

START_TEST(moving_a_sheet_rigidly_takes_no_energy)
{
    tf_body body = sheet_of(10, &linen);
    double *moved = malloc(sizeof(double) * 3 * (size_t)body.vertices);
    for (int v = 0; v < body.vertices; v++) {
        const double *x = body.position + 3 * v;
        moved[3 * v] = 0.6 * x[0] - 0.8 * x[1] + 5;
        moved[3 * v + 1] = x[2] - 7;
        moved[3 * v + 2] = 0.8 * x[0] + 0.6 * x[1];
    }
    ck_assert_double_lt(tf_body_elastic_energy(&body, body.position), 1e-25);
    ck_assert_double_lt(tf_body_elastic_energy(&body, moved), 1e-25);
    free(moved);
    tf_body_free(&body);
}
END_TEST

/// The energy of a sheet that is stretched along an axis by a part.
static double stretched(int across, int axis)
{
    tf_body body = sheet_of(across, &linen);
    for (int v = 0; v < body.vertices; v++)
        body.position[3 * v + axis] *= 1.01;
    double energy = tf_body_elastic_energy(&body, body.position);
    tf_body_free(&body);
    return energy;
}

// To first order an edge of length l at an angle a gets longer by
// 0.01 l cos^2 a, and the springs of each unit of area share stretch / 2 for
// each direction of a triangle's sides: its legs and the diagonal.
START_TEST(a_sheet_is_as_stiff_in_any_resolution_and_direction)
{
    double expected = 200 * 1e-4 * 2 / 2 * (1 + 0.25);
    for (int across = 4; across <= 64; across *= 2)
        for (int axis = 0; axis < 2; axis++)
            ck_assert_double_eq_tol(stretched(across, axis), expected,
                                    0.01 * expected);
}
END_TEST

/// The energy of a sheet that is rolled up in a direction, in parts of that of a
/// plate: bend / 2 times the square of the curvature and the area.
static double rolled(int across, double angle, double radius)
{
    const tf_material soft = {.density = 1, .stretch = 1e-9, .bend = 0.01};
    tf_body body = sheet_of(across, &soft);
    double c = cos(angle), s = sin(angle);
    for (int v = 0; v < body.vertices; v++) {
        double *x = body.position + 3 * v;
        double along = c * x[0] + s * x[1], beside = c * x[1] - s * x[0];
        x[0] = radius * sin(along / radius);
        x[1] = beside;
        x[2] = radius * (1 - cos(along / radius));
    }
    double energy = tf_body_elastic_energy(&body, body.position);
    tf_body_free(&body);
    return energy / (0.01 / 2 / (radius * radius) * 2);
}

START_TEST(rolling_takes_the_energy_of_a_plate)
{
    const double pi = 3.141592653589793;
    for (double radius = 1; radius < 3; radius++) {
        for (int i = 0; i < 2; i++) {
            double coarse = rolled(16, i * pi / 2, radius);
            double fine = rolled(128, i * pi / 2, radius);
            ck_assert_msg(fabs(fine - 1) < 0.03 && coarse < fine, "%g, then %g",
                          coarse, fine);
        }
        ck_assert_double_eq_tol(rolled(128, pi / 4, radius), 1.5, 0.03);
    }
}
END_TEST

START_TEST(without_a_resistance_to_folds_there_are_only_springs)
{
    const tf_material net = {.density = 1, .stretch = 1};
    tf_body body = sheet_of(6, &net);
    ck_assert_int_eq(body.elastics, 6 * 4 + 3 * 7 + 6 * 3);
    for (int i = 0; i < body.elastics; i++)
        ck_assert_int_eq(body.elastic[i].count, 2);
    tf_body_free(&body);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/cloth");
    TCase *tcase = tcase_create("sheets");
    tcase_add_test(tcase, a_sheet_has_two_triangles_a_cell);
    tcase_add_test(tcase, the_mass_of_a_sheet_is_that_of_its_area);
    tcase_add_test(tcase, moving_a_sheet_rigidly_takes_no_energy);
    tcase_add_test(tcase, a_sheet_is_as_stiff_in_any_resolution_and_direction);
    tcase_add_test(tcase, rolling_takes_the_energy_of_a_plate);
    tcase_add_test(tcase, without_a_resistance_to_folds_there_are_only_springs);
    suite_add_tcase(suite, tcase);
    return suite;
}

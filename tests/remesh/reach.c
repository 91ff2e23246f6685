// How far triangles reach: the bounds hold, and are near each other.
#include "remesh/reach.h"

#include "support/adaptive_surfaces.h"
#include "support/cancelling.h"
#include "support/flows.h"
#include "support/support.h"
#include "surgery/adaptive.h"

static tf_original original;

static void begin(const tf_adaptive_surface *surface)
{
    original = (tf_original){0};
    ck_assert_int_eq(tf_original_begin(&original, surface, NULL), TF_OK);
}

static tf_vector point_in(const tf_shape *triangle, generator *random)
{
    double s = uniform(random, 0, 1), t = uniform(random, 0, 1);
    if (s + t > 1) {
        s = 1 - s;
        t = 1 - t;
    }
    tf_vector point = tf_vector_scaled(1 - s - t, triangle->corner[0]);
    point = tf_vector_sum(point, s, triangle->corner[1]);
    return tf_vector_sum(point, t, triangle->corner[2]);
}

static tf_vector random_point(generator *random, double size)
{
    tf_vector point;
    for (int k = 0; k < 3; k++)
        point.x[k] = uniform(random, -size, size);
    return point;
}

/// Expects that the bounds hold for many points; returns whether they are near.
static bool expect_reach(const tf_shape *triangle, double fine,
                         generator *random)
{
    tf_reach found = tf_triangle_reach(&original, triangle, fine, NULL);
    ck_assert_double_le(found.least, found.most);
    double farthest = 0;
    for (int i = 0; i < 100; i++) {
        tf_vector point = point_in(triangle, random);
        double far = tf_original_project(&original, point).distance;
        farthest = fmax(farthest, far);
    }
    ck_assert_double_le(farthest, found.most + 1e-15);
    return found.most <= fmax(found.least * 1.01, found.least + fine);
}

// Triangles anywhere around a bumpy sphere, of all sizes.
START_TEST(no_point_is_farther_than_the_bound)
{
    generator random = generator_new(1);
    tf_adaptive_surface *sphere = adaptive_bumpy_sphere(6, 0.05, 1);
    begin(sphere);
    long near = 0, all = cases(1000);
    for (long i = 0; i < all; i++) {
        tf_shape triangle;
        tf_vector middle = random_point(&random, 1.5);
        double size = ldexp(1, (int)uniform(&random, -6, 2));
        for (int k = 0; k < 3; k++)
            triangle.corner[k] =
                tf_vector_sum(middle, 1, random_point(&random, size));
        near += expect_reach(&triangle, 1e-3, &random);
    }
    ck_assert_int_ge(near, all * 9 / 10);
    tf_original_free(&original);
    tf_adaptive_free(sphere);
}
END_TEST

// A triangle on a sheet of many triangles, whatever it overlaps, is cut up until
// each piece is above one of them.
START_TEST(a_triangle_on_a_plane_is_at_no_distance)
{
    generator random = generator_new(2);
    tf_adaptive_surface *sheet = adaptive_sheet(9, 9);
    begin(sheet);
    for (long i = 0; i < cases(300); i++) {
        tf_shape triangle;
        double height = i % 2 ? 0 : uniform(&random, 0, 3);
        for (int k = 0; k < 3; k++)
            triangle.corner[k] = (tf_vector){
                {uniform(&random, 0, 9), uniform(&random, 0, 9), height}};
        tf_reach found = tf_triangle_reach(&original, &triangle, 1e-9, NULL);
        ck_assert_double_eq_tol(found.least, height, 1e-12);
        ck_assert_double_eq_tol(found.most, height, 1e-9 + 0.01 * height);
    }
    tf_original_free(&original);
    tf_adaptive_free(sheet);
}
END_TEST

START_TEST(degenerate_triangles_have_a_reach)
{
    tf_adaptive_surface *sheet = adaptive_sheet(3, 3);
    begin(sheet);
    const tf_vector a = {{1.5, 1.5, 2}}, b = {{0.5, 2.5, 1}};
    const tf_shape triangles[] = {
        {{a, a, a}}, {{a, b, a}}, {{a, b, tf_vector_sum(a, 0.5, b)}}};
    for (int i = 0; i < 3; i++) {
        tf_reach found =
            tf_triangle_reach(&original, &triangles[i], 1e-6, NULL);
        ck_assert_double_ge(found.least, 2);
        ck_assert_double_le(found.most, 1.01 * found.least + 1e-6);
    }
    tf_original_free(&original);
    tf_adaptive_free(sheet);
}
END_TEST

START_TEST(surfaces_reach_as_far_as_their_triangles)
{
    static double position[][3] = {{0, 0, 0.5}, {3, 0, 0}, {0, 3, 0}};
    static const int triangle[] = {0, 1, 2};
    tf_adaptive_surface *sheet = adaptive_sheet(3, 3);
    tf_adaptive_surface *other = adaptive_of(3, position, 1, triangle);
    begin(sheet);
    double most[1];
    tf_reach_each each = {most, 0};
    tf_reach found = tf_surface_reach(&original, other, 1e-3, &each, NULL);
    ck_assert_double_eq(found.least, 0.5);
    ck_assert_double_eq_tol(found.most, 0.5, 0.01);
    ck_assert_double_eq(most[0], found.most);
    // Where less is enough, the bound is still one.
    each.enough = 0.75;
    found = tf_surface_reach(&original, other, 1e-3, &each, NULL);
    ck_assert_double_ge(most[0], 0.5);
    ck_assert_double_le(most[0], 0.75);
    ck_assert_double_eq(most[0], found.most);
    tf_original_free(&original);
    begin(other);
    found = tf_surface_reach(&original, sheet, 1e-3, NULL, NULL);
    ck_assert_double_eq_tol(found.least, sqrt(4.5), 1e-12);
    tf_original_free(&original);
    tf_adaptive_free(sheet);
    tf_adaptive_free(other);
}
END_TEST

static bool never(void *context, const tf_stage *stage)
{
    (void)context, (void)stage;
    return false;
}

START_TEST(reaching_can_be_cancelled)
{
    tf_adaptive_surface *sheet = adaptive_sheet(9, 9);
    tf_watch own, *watch = tf_watch_begin(&own, never, NULL);
    begin(sheet);
    tf_surface_reach(&original, sheet, 1e-3, NULL, watch);
    ck_assert(tf_watch_cancelled(&own));
    tf_original_free(&original);
    tf_adaptive_free(sheet);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/reach");
    TCase *tcase = tcase_create("reach");
    tcase_add_test(tcase, no_point_is_farther_than_the_bound);
    tcase_add_test(tcase, a_triangle_on_a_plane_is_at_no_distance);
    tcase_add_test(tcase, degenerate_triangles_have_a_reach);
    tcase_add_test(tcase, surfaces_reach_as_far_as_their_triangles);
    tcase_add_test(tcase, reaching_can_be_cancelled);
    suite_add_tcase(suite, tcase);
    return suite;
}

#include "simulate/body.h"

#include "support/support.h"

#include <math.h>

/// Two masses on the first axis, 2 apart, with a spring.
static tf_body pair(void)
{
    tf_body body = {.axes = 3};
    tf_body_add_vertex(&body, (const double[]){0, 0, 0});
    tf_body_add_vertex(&body, (const double[]){2, 0, 0});
    tf_body_add_spring(&body, 0, 1, 100);
    body.mass[1] = 3;
    return body;
}

START_TEST(a_body_holds_what_is_added)
{
    enum {
        COUNT = 1000
    };
    tf_body body = {.axes = 2};
    for (int v = 0; v < COUNT; v++)
        tf_body_add_vertex(&body, (const double[]){v, -v});
    for (int v = 0; v + 2 < COUNT; v++) {
        tf_body_add_triangle(&body, v, v + 1, v + 2);
        tf_body_add_edge(&body, v + 2, v);
    }
    tf_mesh mesh = tf_body_mesh(&body);
    ck_assert_int_eq(mesh.axes, 2);
    ck_assert_int_eq(mesh.vertices, COUNT);
    ck_assert_int_eq(mesh.triangles, COUNT - 2);
    ck_assert_int_eq(mesh.edges, COUNT - 2);
    for (int v = 0; v + 2 < COUNT; v++) {
        ck_assert_double_eq(body.position[2 * v + 1], -v);
        ck_assert_double_eq(body.mass[v], 0);
        ck_assert_int_eq(mesh.triangle[3 * v + 1], v + 1);
        ck_assert_int_eq(mesh.edge[2 * v], v + 2);
    }
    tf_body_free(&body);
    ck_assert_ptr_null(body.position);
}
END_TEST

START_TEST(without_memory_nothing_is_added)
{
    tf_body body = pair();
    body.failed = true;
    tf_body_add_vertex(&body, (const double[]){1, 1, 1});
    tf_body_add_triangle(&body, 0, 1, 2);
    tf_body_add_edge(&body, 0, 1);
    tf_body_add_spring(&body, 0, 1, 1);
    ck_assert_int_eq(body.vertices, 2);
    ck_assert_int_eq(body.triangles + body.edges, 0);
    ck_assert_int_eq(body.elastics, 1);
    tf_body_free(&body);
}
END_TEST

START_TEST(a_spring_is_as_long_as_it_was)
{
    tf_body body = pair();
    ck_assert_double_eq(body.elastic[0].rest, 2);
    ck_assert_double_eq(tf_body_elastic_energy(&body, body.position), 0);
    ck_assert_double_eq(tf_body_stretch(&body, body.position), 1);
    const double longer[] = {0, 0, 0, 0, 0, 3}, shorter[] = {0, 0, 0, 0, 1, 0};
    ck_assert_double_eq(tf_body_elastic_energy(&body, longer), 50);
    ck_assert_double_eq(tf_body_elastic_energy(&body, shorter), 50);
    ck_assert_double_eq(tf_body_stretch(&body, longer), 1.5);
    ck_assert_double_eq(tf_body_stretch(&body, shorter), 1);
    tf_body_free(&body);
}
END_TEST

START_TEST(scripted_vertices_have_no_kinetic_energy)
{
    tf_body body = pair();
    const double velocity[] = {9, 9, 9, 1, -2, 2};
    ck_assert_double_eq(tf_body_kinetic_energy(&body, velocity), 13.5);
    tf_body_free(&body);
}
END_TEST

START_TEST(weight_has_energy_too)
{
    tf_body body = pair();
    const double at[] = {2, 3, 7, 5, 4, 10};
    double elastic = tf_body_elastic_energy(&body, at);
    for (int up = 0; up < 3; up++) {
        double weight = 0;
        body.up = up;
        ck_assert_int_eq(tf_body_up(&body), up == 0 ? 2 : up - 1);
        for (int v = 0; v < 2; v++)
            weight += body.mass[v] * 9.5 * at[3 * v + (up + 2) % 3];
        ck_assert_double_gt(weight, 0);
        ck_assert_double_eq(tf_body_potential_energy(&body, 9.5, at),
                            elastic + weight);
        ck_assert_double_eq(tf_body_potential_energy(&body, 0, at), elastic);
    }
    tf_body_free(&body);
    ck_assert_int_eq(tf_body_up(&(tf_body){.axes = 2}), 1);
}
END_TEST

START_TEST(a_curvature_is_a_weighted_sum)
{
    tf_body body = {.axes = 2};
    for (int v = 0; v < 3; v++)
        tf_body_add_vertex(&body, (const double[]){v, v == 1});
    tf_elastic bend = {3, {0, 1, 2}, {1, -2, 1}, 0, 10};
    tf_body_add_elastic(&body, &bend);
    double sum[3];
    tf_elastic_sum(&bend, 2, body.position, sum);
    ck_assert_double_eq(sum[0], 0);
    ck_assert_double_eq(sum[1], -2);
    ck_assert_double_eq(tf_body_elastic_energy(&body, body.position), 20);
    tf_body_free(&body);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/body");
    TCase *tcase = tcase_create("bodies");
    tcase_add_test(tcase, a_body_holds_what_is_added);
    tcase_add_test(tcase, without_memory_nothing_is_added);
    tcase_add_test(tcase, a_spring_is_as_long_as_it_was);
    tcase_add_test(tcase, scripted_vertices_have_no_kinetic_energy);
    tcase_add_test(tcase, weight_has_energy_too);
    tcase_add_test(tcase, a_curvature_is_a_weighted_sum);
    suite_add_tcase(suite, tcase);
    return suite;
}

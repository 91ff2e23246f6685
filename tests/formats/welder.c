// Corners that become vertices.
#include "formats/welder.h"

#include "support/meshes.h"
#include "support/support.h"

#include <math.h>
#include <stdlib.h>

/// The vertex of a corner.
static int weld(tf_welder *welder, tf_mesh_file *file, const double x[3])
{
    int vertex;
    tf_welder_expect(welder, x);
    ck_assert(tf_welder_find(welder, file, x, 7, &vertex));
    return vertex;
}

START_TEST(equal_bits_are_one_vertex)
{
    tf_welder welder = {0};
    tf_mesh_file file = empty_mesh("corners");
    const double x[][3] = {{1, 2, 3}, {1, 2, nextafter(3, 4)},
                           {3, 2, 1}, {5e-324, 0, 0},
                           {0, 0, 0}, {-5e-324, 0, 0}};
    for (int round = 0; round < 2; round++)
        for (int i = 0; i < 6; i++)
            ck_assert_int_eq(weld(&welder, &file, x[i]), i);
    expect_vertices(&file, 6, *x);
    ck_assert_int_eq(file.vertex_place.item[5], 7);
    tf_welder_free(&welder);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(zeros_of_both_signs_are_one_place)
{
    tf_welder welder = {0};
    tf_mesh_file file = empty_mesh("corners");
    ck_assert_int_eq(weld(&welder, &file, (double[]){-0., 0, 1}), 0);
    ck_assert_int_eq(weld(&welder, &file, (double[]){0, -0., 1}), 0);
    ck_assert_int_eq(weld(&welder, &file, (double[]){0, 0, 1}), 0);
    ck_assert_int_eq(weld(&welder, &file, (double[]){0, 0, -1}), 1);
    // The first one stays.
    expect_vertices(&file, 2, (double[]){-0., 0, 1, 0, 0, -1});
    tf_welder_free(&welder);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(many_corners_are_found_again)
{
    enum {
        SIDE = 30
    };
    generator random = generator_new(1);
    static int vertex[SIDE * SIDE * SIDE];
    tf_welder welder = {0};
    tf_mesh_file file = empty_mesh("corners");
    int vertices = 0;
    for (long i = 0; i < cases(100000); i++) {
        int place = below(&random, SIDE * SIDE * SIDE);
        double x[] = {place % SIDE, place / SIDE % SIDE * 0.1,
                      place / SIDE / SIDE * 1e-300};
        int found = weld(&welder, &file, x);
        if (vertex[place] == 0)
            vertex[place] = ++vertices;
        ck_assert_int_eq(found, vertex[place] - 1);
        ck_assert(file.position.item[3 * found + 1] == x[1]);
    }
    ck_assert_int_eq(tf_mesh_file_vertices(&file), vertices);
    tf_welder_free(&welder);
    tf_mesh_file_free(&file);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("formats/welder");
    TCase *welding = tcase_create("welding");
    tcase_add_test(welding, equal_bits_are_one_vertex);
    tcase_add_test(welding, zeros_of_both_signs_are_one_place);
    tcase_add_test(welding, many_corners_are_found_again);
    suite_add_tcase(suite, welding);
    return suite;
}

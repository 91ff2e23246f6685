// Polygons that are divided into triangles.
#include "formats/polygon.h"

#include "support/support.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum {
    MOST = 64 // corners
};

/// A polygon of the plane with integer coordinates.
typedef struct outline {
    int count;
    int x[MOST][2];
} outline;

// The oracle ------------------------------------------------------------------

static int64_t area_of(const int a[2], const int b[2], const int c[2])
{
    return (int64_t)(b[0] - a[0]) * (c[1] - a[1]) -
           (int64_t)(b[1] - a[1]) * (c[0] - a[0]);
}

static int64_t outline_area(const outline *shape)
{
    int64_t sum = 0;
    for (int i = 1; i < shape->count - 1; i++)
        sum += area_of(shape->x[0], shape->x[i], shape->x[i + 1]);
    return sum;
}

static bool in_box(const int a[2], const int b[2], const int p[2])
{
    bool inside = true;
    for (int k = 0; k < 2; k++)
        inside &=
            (p[k] >= a[k] || p[k] >= b[k]) && (p[k] <= a[k] || p[k] <= b[k]);
    return inside;
}

static int sign(int64_t number)
{
    return (number > 0) - (number < 0);
}

/// Whether two segments have a common point.
static bool meet(const int a[2], const int b[2], const int c[2], const int d[2])
{
    int e = sign(area_of(a, b, c)), f = sign(area_of(a, b, d));
    int g = sign(area_of(c, d, a)), h = sign(area_of(c, d, b));
    return (e * f < 0 && g * h < 0) || (e == 0 && in_box(a, b, c)) ||
           (f == 0 && in_box(a, b, d)) || (g == 0 && in_box(c, d, a)) ||
           (h == 0 && in_box(c, d, b));
}

/// Whether a corner folds back onto the side before it.
static bool folds(const int a[2], const int b[2], const int c[2])
{
    return area_of(a, b, c) == 0 &&
           (a[0] - b[0]) * (c[0] - b[0]) + (a[1] - b[1]) * (c[1] - b[1]) >= 0;
}

static bool is_simple(const outline *shape)
{
    int n = shape->count;
    for (int i = 0; i < n; i++) {
        const int *a = shape->x[i], *b = shape->x[(i + 1) % n];
        if (folds(a, b, shape->x[(i + 2) % n]))
            return false;
        for (int j = i + 2; j < n; j++)
            if ((j + 1) % n != i &&
                meet(a, b, shape->x[j], shape->x[(j + 1) % n]))
                return false;
    }
    return true;
}

/// Each side belongs to one triangle, in its direction, each other edge to two,
/// in both: then the triangles cover what the sides go around, once if none is
/// turned over.
static void expect_division(const outline *shape, const int triangle[])
{
    static signed char passed[MOST][MOST];
    int n = shape->count, turn = sign(outline_area(shape));
    memset(passed, 0, sizeof passed);
    for (int t = 0; t < n - 2; t++) {
        const int *v = triangle + 3 * t;
        ck_assert_int_eq(
            sign(area_of(shape->x[v[0]], shape->x[v[1]], shape->x[v[2]])),
            turn);
        for (int i = 0; i < 3; i++) {
            passed[v[i]][v[(i + 1) % 3]]++;
            passed[v[(i + 1) % 3]][v[i]]--;
        }
    }
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            ck_assert_int_eq(passed[i][j],
                             (j == (i + 1) % n) - (i == (j + 1) % n));
}

// Dividing --------------------------------------------------------------------

/// Corner i is vertex label[i] (vertex i without labels), in a plane that is
/// tilted by an axis, scaled; the list begins at a corner.  The triangles are of
/// vertices.
typedef struct setting {
    const int *label;
    int axis;
    double scale;
    int begin;
} setting;

static void divide(const outline *shape, const setting *set, int triangle[])
{
    static tf_polygon polygon; // its room is used again
    double position[3 * MOST];
    int n = shape->count, vertex[MOST];
    for (int i = 0; i < n; i++) {
        int label = set->label ? set->label[i] : i;
        double u = shape->x[i][0], v = shape->x[i][1];
        double *x = position + (ptrdiff_t)3 * label;
        x[set->axis] = set->scale * (7 + (u - v) / 4);
        x[(set->axis + 1) % 3] = set->scale * u;
        x[(set->axis + 2) % 3] = set->scale * v;
        vertex[(i + n - set->begin) % n] = label;
    }
    ck_assert(tf_polygon_divide(&polygon, position, n, vertex, triangle));
}

static const setting plain = {.scale = 1};

static void expect_same(const outline *shape, const setting *set)
{
    int wanted[3 * MOST], found[3 * MOST];
    setting first = {.label = set->label, .scale = 1};
    divide(shape, &first, wanted);
    divide(shape, set, found);
    ck_assert_mem_eq(found, wanted,
                     sizeof *found * 3 * (size_t)(shape->count - 2));
}

static void expect_triangles_of(const outline *shape, const int wanted[])
{
    int found[3 * MOST];
    divide(shape, &plain, found);
    for (int i = 0; i < 3 * (shape->count - 2); i++)
        ck_assert_msg(found[i] == wanted[i], "%d: %d", i, found[i]);
}

// Small polygons --------------------------------------------------------------

/// All lists of different points of a grid of 3 x 3, by their digits.
static bool take_points(long number, outline *shape)
{
    bool used[9] = {false};
    for (int i = 0; i < shape->count; i++, number /= 9) {
        int point = (int)(number % 9);
        if (used[point])
            return false;
        used[point] = true;
        shape->x[i][0] = point % 3;
        shape->x[i][1] = point / 3;
    }
    return true;
}

START_TEST(all_simple_polygons_of_a_grid_are_divided)
{
    outline shape = {.count = _i};
    int triangle[3 * MOST], simple = 0;
    long lists = 1;
    for (int i = 0; i < shape.count; i++)
        lists *= 9;
    for (long number = 0; number < lists; number++) {
        if (!take_points(number, &shape) || !is_simple(&shape))
            continue;
        simple++;
        divide(&shape, &plain, triangle);
        expect_division(&shape, triangle);
    }
    // Of triangles, 76 choices have an area; each begins anywhere, both ways.
    ck_assert_int_gt(simple, 0);
    if (_i == 3)
        ck_assert_int_eq(simple, 76 * 6);
}
END_TEST

START_TEST(all_polygons_of_a_grid_do_not_depend_on_where_they_begin)
{
    outline shape = {.count = _i};
    long lists = 1;
    for (int i = 0; i < shape.count; i++)
        lists *= 9;
    for (long number = 0; number < lists; number += 1 + (_i > 4 ? 7 : 0))
        if (take_points(number, &shape))
            for (int begin = 1; begin < shape.count; begin++)
                expect_same(&shape, &(setting){.scale = 1, .begin = begin});
}
END_TEST

// Large polygons --------------------------------------------------------------

/// Around the origin, at random distances.
static outline make_star(generator *random, int count)
{
    outline shape = {.count = count};
    for (int i = 0; i < count; i++) {
        double angle =
            6.283185307179586 * (i + 0.4 * uniform(random, 0, 1)) / count;
        double radius = 1000 + 100000 * uniform(random, 0, 1);
        shape.x[i][0] = (int)(radius * cos(angle));
        shape.x[i][1] = (int)(radius * sin(angle));
    }
    return shape;
}

static void shuffle(generator *random, int count, int label[])
{
    for (int i = 0; i < count; i++) {
        int j = below(random, i + 1);
        label[i] = label[j];
        label[j] = i;
    }
}

START_TEST(stars_are_divided)
{
    generator random = generator_new(1);
    for (long i = 0; i < cases(3000); i++) {
        int label[MOST] = {0}, place[MOST], triangle[3 * MOST];
        outline shape = make_star(&random, 4 + below(&random, MOST - 3));
        if (!is_simple(&shape))
            continue;
        shuffle(&random, shape.count, label);
        for (int j = 0; j < shape.count; j++)
            place[label[j]] = j;
        divide(&shape, &(setting){label, below(&random, 3), 1, 0}, triangle);
        for (int j = 0; j < 3 * (shape.count - 2); j++)
            triangle[j] = place[triangle[j]];
        expect_division(&shape, triangle);
    }
}
END_TEST

START_TEST(neither_unit_nor_axis_nor_beginning_matter)
{
    generator random = generator_new(2);
    for (long i = 0; i < cases(3000); i++) {
        int label[MOST] = {0};
        outline shape = make_star(&random, 4 + below(&random, 12));
        shuffle(&random, shape.count, label);
        int exponent = below(&random, 2000) - 1000;
        expect_same(&shape,
                    &(setting){label, below(&random, 3), ldexp(1, exponent),
                               below(&random, shape.count)});
    }
}
END_TEST

START_TEST(spirals_are_divided)
{
    // Two walls of a corridor that winds inward by right angles.
    outline shape = {.count = 60};
    int triangle[3 * MOST];
    for (int i = 0; i < 30; i++) {
        static const int way[4][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
        int radius = 100 - 3 * i;
        for (int k = 0; k < 2; k++) {
            shape.x[i][k] = way[i % 4][k] * radius;
            shape.x[59 - i][k] = way[i % 4][k] * (radius - 2);
        }
    }
    ck_assert(is_simple(&shape));
    divide(&shape, &plain, triangle);
    expect_division(&shape, triangle);
}
END_TEST

// The rule --------------------------------------------------------------------

START_TEST(a_convex_polygon_is_a_fan_around_its_least_index)
{
    static const int label[] = {5, 3, 0, 4, 1, 2};
    outline shape = {6, {{1, 0}, {3, 0}, {4, 2}, {3, 4}, {1, 4}, {0, 2}}};
    int triangle[3 * MOST];
    divide(&shape, &(setting){label, 0, 1, 0}, triangle);
    static const int fan[] = {0, 4, 1, 0, 1, 2, 0, 2, 5, 0, 5, 3};
    ck_assert_mem_eq(triangle, fan, sizeof fan);
    static const int backward[] = {1, 0, 4, 3, 5, 2};
    divide(&shape, &(setting){backward, 0, 1, 0}, triangle);
    static const int other[] = {0, 4, 3, 0, 3, 5, 0, 5, 2, 0, 2, 1};
    ck_assert_mem_eq(triangle, other, sizeof other);
}
END_TEST

START_TEST(a_dart_is_cut_at_its_notch)
{
    // The fan around the tip is good, and that around a wing is not.
    expect_triangles_of(&(outline){4, {{0, 0}, {2, 3}, {0, 1}, {-2, 3}}},
                        (int[]){0, 1, 2, 0, 2, 3});
    expect_triangles_of(&(outline){4, {{2, 3}, {0, 1}, {-2, 3}, {0, 0}}},
                        (int[]){3, 0, 1, 1, 2, 3});
}
END_TEST

START_TEST(corners_on_a_side_are_kept)
{
    expect_triangles_of(&(outline){5, {{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}},
                        (int[]){4, 0, 1, 4, 1, 2, 2, 3, 4});
}
END_TEST

START_TEST(where_there_is_no_ear_it_is_a_fan)
{
    // On a line, and all at one place.
    expect_triangles_of(&(outline){4, {{0, 0}, {1, 0}, {2, 0}, {3, 0}}},
                        (int[]){0, 1, 2, 0, 2, 3});
    expect_triangles_of(&(outline){5, {{0, 0}}},
                        (int[]){0, 1, 2, 0, 2, 3, 0, 3, 4});
    // Two loops.
    expect_triangles_of(&(outline){4, {{0, 0}, {3, 3}, {3, 0}, {0, 2}}},
                        (int[]){0, 1, 2, 0, 2, 3});
}
END_TEST

START_TEST(corners_that_touch_a_side_are_no_part_of_ears)
{
    expect_triangles_of(&(outline){5, {{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}},
                        (int[]){1, 2, 3, 3, 4, 0, 0, 1, 3});
}
END_TEST

START_TEST(the_nearest_axis_is_projected_along)
{
    // Seen along z, or along x, this quadrilateral is convex, but along y, to
    // which its normal is nearest, it is not.
    static const double position[2][12] = {
        {1, 0, 4, 0.1, .1, 1, 0, 0.01, 4, 0, 0, 0},
        {4, 0, 1, 1, .1, 0.1, 4, 0.01, 0, 0, 0, 0}};
    static const int lists[2][4] = {{3, 0, 1, 2}, {2, 1, 0, 3}};
    static const int wanted[2][6] = {{3, 0, 1, 1, 2, 3}, {1, 0, 3, 3, 2, 1}};
    for (int i = 0; i < 4; i++) {
        tf_polygon polygon = {0};
        int triangle[6];
        ck_assert(tf_polygon_divide(&polygon, position[i / 2], 4, lists[i % 2],
                                    triangle));
        ck_assert_mem_eq(triangle, wanted[i % 2], sizeof wanted[i % 2]);
        tf_polygon_free(&polygon);
    }
}
END_TEST

START_TEST(the_largest_and_smallest_doubles_are_divided)
{
    static const double sizes[] = {0x1.fffffffffffffp1023, 0x1p-1074};
    for (int i = 0; i < 2; i++) {
        double s = sizes[i];
        double position[] = {s, s, s, 0, 0, 0, -s, s, -s, 0, -s, 0};
        tf_polygon polygon = {0};
        int triangle[6];
        ck_assert(tf_polygon_divide(&polygon, position, 4, (int[]){0, 1, 2, 3},
                                    triangle));
        static const int wanted[] = {3, 0, 1, 1, 2, 3};
        ck_assert_mem_eq(triangle, wanted, sizeof wanted);
        tf_polygon_free(&polygon);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("formats/polygon");
    TCase *division = tcase_create("division");
    tcase_set_timeout(division, 60);
    tcase_add_loop_test(division, all_simple_polygons_of_a_grid_are_divided, 3,
                        7);
    tcase_add_loop_test(
        division, all_polygons_of_a_grid_do_not_depend_on_where_they_begin, 4,
        6);
    tcase_add_test(division, stars_are_divided);
    tcase_add_test(division, neither_unit_nor_axis_nor_beginning_matter);
    tcase_add_test(division, spirals_are_divided);
    suite_add_tcase(suite, division);

    TCase *rule = tcase_create("the rule");
    tcase_add_test(rule, a_convex_polygon_is_a_fan_around_its_least_index);
    tcase_add_test(rule, a_dart_is_cut_at_its_notch);
    tcase_add_test(rule, corners_on_a_side_are_kept);
    tcase_add_test(rule, where_there_is_no_ear_it_is_a_fan);
    tcase_add_test(rule, corners_that_touch_a_side_are_no_part_of_ears);
    tcase_add_test(rule, the_nearest_axis_is_projected_along);
    tcase_add_test(rule, the_largest_and_smallest_doubles_are_divided);
    suite_add_tcase(suite, rule);
    return suite;
}

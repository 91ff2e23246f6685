#include "simulate/rope.h"

#include "support/simulations.h"
#include "support/support.h"

#include <math.h>

static double distance(const double a[3], const double b[3])
{
    return sqrt((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]) +
                (b[2] - a[2]) * (b[2] - a[2]));
}

START_TEST(points_of_a_knot_are_at_equal_distances)
{
    tf_line line = tf_knot_line(0.5, 6, 0.05);
    ck_assert_int_gt(line.points, 300);
    for (int i = 0; i + 1 < line.points; i++)
        ck_assert_double_eq_tol(distance(line.x + 3 * i, line.x + 3 * (i + 1)),
                                0.05, 0.01);
    tf_line_free(&line);
}
END_TEST

START_TEST(ends_of_a_knot_point_away_from_each_other)
{
    tf_line line = tf_knot_line(1, 6, 0.1);
    const double *x = line.x, *last = line.x + 3 * (line.points - 1);
    ck_assert_double_eq_tol(x[1] - x[4], 0.1, 0.01);
    ck_assert_double_eq_tol(last[1] - last[-2], -0.1, 0.01);
    for (int i = 1; i < line.points; i++)
        ck_assert_double_lt(line.x[3 * i + 1], x[1] + 1e-9);
    tf_line_free(&line);
}
END_TEST

// A point is as near as the line is long between, or not near at all.
START_TEST(no_part_of_a_knot_is_near_another)
{
    tf_line line = tf_knot_line(1, 6, 0.1);
    for (int i = 0; i < line.points; i++)
        for (int j = i + 32; j < line.points; j++)
            ck_assert_double_gt(distance(line.x + 3 * i, line.x + 3 * j), 1.2);
    tf_line_free(&line);
}
END_TEST

// The knot ----------------------------------------------------------------------

typedef struct crossing {
    double over, under; ///< where along the line it passes itself
} crossing;

enum {
    MOST = 16
};

/// Where two steps of a line cross as seen from above, in parts of the steps.
static bool cross(const double *a, const double *b, double *s, double *t)
{
    double ax = a[3] - a[0], ay = a[4] - a[1];
    double bx = b[3] - b[0], by = b[4] - b[1];
    double cx = b[0] - a[0], cy = b[1] - a[1], area = ax * by - ay * bx;
    *s = (cx * by - cy * bx) / area;
    *t = (cx * ay - cy * ax) / area;
    return *s >= 0 && *s < 1 && *t >= 0 && *t < 1;
}

static int find_crossings(const tf_line *line, crossing found[MOST])
{
    int count = 0;
    for (int i = 0; i + 1 < line->points; i++)
        for (int j = i + 2; j + 1 < line->points; j++) {
            const double *a = line->x + 3 * i, *b = line->x + 3 * j;
            double s, t;
            if (!cross(a, b, &s, &t))
                continue;
            double up = a[2] + s * (a[5] - a[2]) - b[2] - t * (b[5] - b[2]);
            ck_assert_int_lt(count, MOST);
            found[count++] =
                up > 0 ? (crossing){i + s, j + t} : (crossing){j + t, i + s};
        }
    return count;
}

/// The number of the arc, from one passage below to the next, at a place.
static int arc_at(const crossing found[], int count, double place)
{
    int arc = 0;
    for (int i = 0; i < count; i++)
        arc += found[i].under < place;
    return arc;
}

/// The determinant of the knot: its ways to be colored, 3 for the trefoil, 1 for
/// what is no knot.  Of a line with n crossings the first arc and the last are
/// one; one crossing and one arc are left out.
static double determinant(const crossing found[], int count)
{
    double m[MOST][MOST] = {{0}}, product = 1;
    for (int i = 0; i < count; i++) {
        int over = arc_at(found, count, found[i].over);
        int before = arc_at(found, count, found[i].under);
        m[i][over % count] += 2;
        m[i][before % count] -= 1;
        m[i][(before + 1) % count] -= 1;
    }
    for (int k = 0; k < count - 1; k++) {
        int best = k;
        for (int i = k; i < count - 1; i++)
            best = fabs(m[i][k]) > fabs(m[best][k]) ? i : best;
        for (int j = 0; j < count; j++) {
            double swapped = m[k][j];
            m[k][j] = m[best][j];
            m[best][j] = swapped;
        }
        product *= m[k][k];
        for (int i = k + 1; i < count - 1 && m[k][k] != 0; i++)
            for (int j = count - 1; j >= k; j--)
                m[i][j] -= m[i][k] / m[k][k] * m[k][j];
    }
    return fabs(product);
}

START_TEST(the_line_is_a_trefoil_knot)
{
    crossing found[MOST];
    tf_line line = tf_knot_line(1, 6, 0.1);
    int count = find_crossings(&line, found);
    ck_assert_int_ge(count, 3);
    ck_assert_double_eq_tol(determinant(found, count), 3, 1e-9);
    tf_line_free(&line);
}
END_TEST

// Ropes -------------------------------------------------------------------------

START_TEST(a_rope_is_a_clear_tube_at_rest)
{
    const tf_material sisal = {.density = 2, .stretch = 5};
    tf_line line = tf_knot_line(1, 6, 0.2);
    tf_body body = {.axes = 3};
    tf_rope_add(&body, &line, 0.5, 8, &sisal);
    ck_assert_int_eq(body.vertices, 8 * line.points);
    ck_assert_int_eq(body.triangles, 16 * (line.points - 1));
    ck_assert_double_eq(tf_body_elastic_energy(&body, body.position), 0);
    for (int v = 0; v < body.vertices; v++)
        ck_assert_double_eq_tol(
            distance(body.position + 3 * v, line.x + 3 * (v / 8)), 0.5, 1e-12);
    expect_clear(&body);
    tf_body_free(&body);
    tf_line_free(&line);
}
END_TEST

START_TEST(struts_keep_a_rope_round)
{
    const tf_material sisal = {.density = 2, .stretch = 5};
    tf_line line = tf_knot_line(1, 6, 0.2);
    tf_body body = {.axes = 3};
    tf_rope_add(&body, &line, 0.5, 8, &sisal);
    int across = 0;
    for (int i = 0; i < body.elastics; i++)
        across += fabs(body.elastic[i].rest - 1) < 1e-9;
    ck_assert_int_eq(across, 4 * line.points);
    tf_body_free(&body);
    tf_line_free(&line);
}
END_TEST

START_TEST(without_memory_there_is_no_rope)
{
    const tf_material sisal = {.density = 2, .stretch = 5};
    tf_line line = {0};
    tf_body body = {.axes = 3};
    tf_rope_add(&body, &line, 0.5, 8, &sisal);
    ck_assert(body.failed);
    tf_body_free(&body);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/rope");
    TCase *lines = tcase_create("lines");
    tcase_add_test(lines, points_of_a_knot_are_at_equal_distances);
    tcase_add_test(lines, ends_of_a_knot_point_away_from_each_other);
    tcase_add_test(lines, no_part_of_a_knot_is_near_another);
    tcase_add_test(lines, the_line_is_a_trefoil_knot);
    suite_add_tcase(suite, lines);
    TCase *ropes = tcase_create("ropes");
    tcase_add_test(ropes, a_rope_is_a_clear_tube_at_rest);
    tcase_add_test(ropes, struts_keep_a_rope_round);
    tcase_add_test(ropes, without_memory_there_is_no_rope);
    suite_add_tcase(suite, ropes);
    return suite;
}

#include "query/point_triangle.h"

#include "query/query.h"
#include "support/rational.h"
#include "support/statuses.h"
#include "support/support.h"

#include <math.h>

// A point falls from (x, y, 1) to (x, y, -1) on the triangle (0, 0), (1, 0),
// (0, 1), whose height is the number of its vertex times `slope`.

typedef struct fall {
    double x, y;
    bool hit;
    double barycentric[3];
} fall;

static const fall falls[] = {
    {0.25, 0.25, true, {0.5, 0.25, 0.25}},
    {0.5, 0.25, true, {0.25, 0.5, 0.25}},
    {0, 0, true, {1, 0, 0}},
    {1, 0, true, {0, 1, 0}},
    {0, 1, true, {0, 0, 1}},
    {0.5, 0.5, true, {0, 0.5, 0.5}},
    {0.5, 0, true, {0.5, 0.5, 0}},
    {0x1.8p-1, 0x1.0000000000001p-2, false, {0}},
    {0x1.8p-1, 0x1.fffffffffffffp-3, true, {0, 0.75, 0.25}},
    {-0x1p-1074, 0.5, false, {0}},
    {0x1p-1074, 0.5, true, {0.5, 0, 0.5}},
    {1, 1, false, {0}},
};

enum {
    FALLS = sizeof falls / sizeof *falls
};

static tf_contact answer(const fall *f, double slope)
{
    static const double corner[3][2] = {{0, 0}, {1, 0}, {0, 1}};
    tf_worldline triangle[3], point;
    for (int v = 0; v < 3; v++) {
        double x[3] = {corner[v][0], corner[v][1], v * slope};
        triangle[v] = tf_worldline_between(3, x, x);
    }
    point = tf_worldline_between(3, (double[]){f->x, f->y, 1},
                                 (double[]){f->x, f->y, -1});
    tf_contact contact;
    ck_assert_int_eq(
        tf_query(&oracle_arithmetic, 3, 1, &point, 3, triangle, &contact),
        TF_OK);
    return contact;
}

static void expect_contact(const fall *f, double slope)
{
    tf_contact c = answer(f, slope);
    ck_assert_msg(c.verdict == (f->hit ? TF_HIT : TF_APART),
                  "(%a, %a), slope %a: verdict %d", f->x, f->y, slope,
                  c.verdict);
    if (!f->hit)
        return;
    double height = slope * (f->barycentric[1] + 2 * f->barycentric[2]);
    ck_assert_msg(fabs(c.toi_lo - (1 - height) / 2) < 1e-12,
                  "(%a, %a), slope %a: time %a", f->x, f->y, slope, c.toi_lo);
    for (int v = 0; v < 3; v++)
        ck_assert_msg(fabs(c.barycentric[1][v] - f->barycentric[v]) < 1e-12,
                      "(%a, %a), slope %a: coordinate %d is %a", f->x, f->y,
                      slope, v, c.barycentric[1][v]);
}

START_TEST(a_falling_point_meets_a_triangle)
{
    expect_contact(&falls[_i], 0);
    expect_contact(&falls[_i], 0.25);
    expect_contact(&falls[_i], -0.25);
}
END_TEST

// Statuses

static tf_status ask_public(const tf_arithmetic *arithmetic,
                            const tf_motion *motion, const int vertex[],
                            tf_contact *contact)
{
    return tf_point_triangle(arithmetic, motion, vertex[0], vertex + 1,
                             contact);
}

static void use_public(void)
{
    statuses_use(POINT_TRIANGLE, ask_public);
}

START_TEST(null_indices_break_the_contract)
{
    static const double x[4 * TF_AXES] = {0};
    tf_motion motion = {.axes = 3, .vertices = 4, .start = x, .end = x};
    tf_contact contact;
    exit_on_broken_contract();
    tf_point_triangle(&oracle_arithmetic, &motion, 0, NULL, &contact);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("query/point_triangle");
    TCase *tcase = tcase_create("point_triangle");
    tcase_add_loop_test(tcase, a_falling_point_meets_a_triangle, 0, FALLS);
    tcase_add_exit_test(tcase, null_indices_break_the_contract,
                        BROKEN_CONTRACT);
    suite_add_tcase(suite, tcase);
    suite_add_tcase(suite, statuses_case("statuses", use_public));
    return suite;
}

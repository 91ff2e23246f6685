#include "arithmetic/functions.h"
#include "check.h"

#include "query/query.h"
#include "support/oracle.h"
#include "support/rational.h"

typedef struct encounter {
    double point[2][3];
    double triangle[3][2][3];
} encounter;

encounter no_normal(void);

/// Whether the triangle has an area at a time: its projection to some plane of
/// two axes has.
static bool has_area(const tf_worldline v[3], int t)
{
    bool some = false;
    for (int k = 0; k < 3; k++) {
        tf_differences shadow = {.n = 2,
                                 .to = {&v[1].at[t], &v[2].at[t]},
                                 .from = {&v[0].at[t], &v[0].at[t]},
                                 .axis = {k, (k + 1) % 3}};
        some |= oracle_arithmetic.sign(&shadow) != TF_ZERO;
    }
    return some;
}

static void expect_no_normal(const tf_worldline *point,
                             const tf_worldline triangle[3])
{
    mpq_t toi;
    mpq_init(toi);
    check_that(oracle_meet(3, 1, point, 3, triangle, toi), "a contact", "none");
    check_that(mpq_sgn(toi) > 0 && mpq_cmp_ui(toi, 1, 1) < 0,
               "0 < t < 1 when they meet first", "t = %s",
               text_real(mpq_get_d(toi)));
    mpq_clear(toi);
    tf_contact contact;
    tf_query(&oracle_arithmetic, 3, 1, point, 3, triangle, &contact);
    check_point(3, ((const double[]){0, 0, 0}), contact.normal, 0);
}

TEST(meets_without_a_normal)
{
    check_input("none: the function gives an encounter");
    encounter e;
    check_value(e, no_normal());
    tf_worldline point = tf_worldline_between(3, e.point[0], e.point[1]);
    tf_worldline triangle[3];
    for (int v = 0; v < 3; v++)
        triangle[v] =
            tf_worldline_between(3, e.triangle[v][0], e.triangle[v][1]);
    check_input("point: %s\n%s", text_line(3, &point),
                text_lines(3, "vertex", 3, triangle));
    check_picture(3, 1, &point, 3, triangle);
    check_finite(3, 1, &point);
    check_finite(3, 3, triangle);
    for (int t = 0; t < 2; t++)
        check_that(has_area(triangle, t), "a triangle that has an area",
                   "none at t = %d", t);
    expect_no_normal(&point, triangle);
}

void run_tests(void)
{
    check_run(1, meets_without_a_normal);
}

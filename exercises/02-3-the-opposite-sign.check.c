#include "arithmetic/functions.h"
#include "check.h"

#include "support/rational.h"

#include <math.h>

typedef struct three_points {
    double a[2], b[2], c[2];
} three_points;

three_points opposite_sign(void);

static tf_event at(const double x[2])
{
    return (tf_event){.x = {x[0], x[1]}};
}

TEST(rounded_sign_is_opposite)
{
    check_input("none: the function gives three points");
    three_points p;
    check_value(p, opposite_sign());
    check_input("a = %s, b = %s, c = %s", text_point(2, p.a),
                text_point(2, p.b), text_point(2, p.c));
    const double all[] = {p.a[0], p.a[1], p.b[0], p.b[1], p.c[0], p.c[1]};
    for (int i = 0; i < 6; i++)
        check_that(fabs(all[i]) <= 1, "coordinates from -1 to 1", "%s",
                   text_real(all[i]));

    tf_event a = at(p.a), b = at(p.b), c = at(p.c);
    tf_differences rows = {
        .n = 2, .to = {&b, &c}, .from = {&a, &a}, .axis = {0, 1}};
    double e[TF_AXES][TF_AXES];
    tf_differences_round(&rows, e);
    double rounded = e[0][0] * e[1][1] - e[0][1] * e[1][0];
    int rounded_sign = (rounded > 0) - (rounded < 0);
    tf_sign true_sign = oracle_arithmetic.sign(&rows);
    check_that(rounded_sign * true_sign == -1, "two opposite signs",
               "rounded: %s, true: %s", text_sign(rounded_sign),
               text_sign(true_sign));
}

void run_tests(void)
{
    check_run(1, rounded_sign_is_opposite);
}

#include "arithmetic/functions.h"
#include "check.h"

#include "query/query.h"
#include "support/oracle.h"
#include "support/rational.h"

typedef struct encounter {
    double first[2][2][3];
    double second[2][2][3];
} encounter;

encounter parallel_at_different_times(void);

/// Whether two edges are parallel at a time, or one has no length then: their
/// projections to all planes of two axes are.
static bool parallel(const tf_worldline a[2], const tf_worldline b[2], int t)
{
    bool all = true;
    for (int k = 0; k < 3; k++) {
        tf_differences shadow = {.n = 2,
                                 .to = {&a[1].at[t], &b[1].at[t]},
                                 .from = {&a[0].at[t], &b[0].at[t]},
                                 .axis = {k, (k + 1) % 3}};
        all &= oracle_arithmetic.sign(&shadow) == TF_ZERO;
    }
    return all;
}

static void expect_no_normal(const tf_worldline first[2],
                             const tf_worldline second[2])
{
    mpq_t toi;
    mpq_init(toi);
    check_that(oracle_meet(3, 2, first, 2, second, toi), "a contact", "none");
    check_that(mpq_sgn(toi) > 0 && mpq_cmp_ui(toi, 1, 1) < 0,
               "0 < t < 1 when they meet first", "t = %s",
               text_real(mpq_get_d(toi)));
    mpq_clear(toi);
    tf_contact contact;
    tf_query(&oracle_arithmetic, 3, 2, first, 2, second, &contact);
    check_point(3, ((const double[]){0, 0, 0}), contact.normal, 0);
}

TEST(meets_without_a_normal)
{
    check_input("none: the function gives an encounter");
    encounter e;
    check_value(e, parallel_at_different_times());
    tf_worldline first[2], second[2];
    for (int v = 0; v < 2; v++) {
        first[v] = tf_worldline_between(3, e.first[v][0], e.first[v][1]);
        second[v] = tf_worldline_between(3, e.second[v][0], e.second[v][1]);
    }
    check_input("%s\n%s", text_lines(3, "first, vertex", 2, first),
                text_lines(3, "second, vertex", 2, second));
    check_picture(3, 2, first, 2, second);
    check_finite(3, 2, first);
    check_finite(3, 2, second);
    for (int t = 0; t < 2; t++)
        check_that(!parallel(first, second, t),
                   "edges that have a length and are not parallel",
                   "parallel edges, or one without a length, at t = %d", t);
    expect_no_normal(first, second);
}

void run_tests(void)
{
    check_run(1, meets_without_a_normal);
}

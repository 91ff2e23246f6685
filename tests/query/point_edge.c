#include "query/point_edge.h"

#include "arithmetic/clamped.h"
#include "query/query.h"
#include "support/statuses.h"
#include "support/support.h"

// A point falls at x through the edge from (2^-10, 0) to (1, 0), at its ends
// and an ulp beyond.

static tf_verdict fall(double x)
{
    tf_worldline point =
        tf_worldline_between(2, (double[]){x, 1}, (double[]){x, -1});
    tf_worldline edge[2] = {
        tf_worldline_between(2, (double[]){0x1p-10, 0}, (double[]){0x1p-10, 0}),
        tf_worldline_between(2, (double[]){1, 0}, (double[]){1, 0}),
    };
    tf_contact contact;
    ck_assert_int_eq(tf_query(&tf_clamped, 2, 1, &point, 2, edge, &contact),
                     TF_OK);
    return contact.verdict;
}

START_TEST(a_point_meets_an_edge_between_its_ends)
{
    ck_assert_int_eq(fall(0.5), TF_HIT);
    ck_assert_int_eq(fall(0x1p-10), TF_HIT);
    ck_assert_int_eq(fall(1), TF_HIT);
    ck_assert_int_eq(fall(0x1.fffffffffffffp-11), TF_APART);
    ck_assert_int_eq(fall(0x1.0000000000001p0), TF_APART);
}
END_TEST

// Statuses

static tf_status ask_public(const tf_arithmetic *arithmetic,
                            const tf_motion *motion, const int vertex[],
                            tf_contact *contact)
{
    return tf_point_edge(arithmetic, motion, vertex[0], vertex + 1, contact);
}

static void use_public(void)
{
    statuses_use(POINT_EDGE, ask_public);
}

START_TEST(null_indices_break_the_contract)
{
    static const double x[4 * TF_AXES] = {0};
    tf_motion motion = {.axes = 2, .vertices = 4, .start = x, .end = x};
    tf_contact contact;
    exit_on_broken_contract();
    tf_point_edge(&tf_clamped, &motion, 0, NULL, &contact);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("query/point_edge");
    TCase *tcase = tcase_create("point_edge");
    tcase_add_test(tcase, a_point_meets_an_edge_between_its_ends);
    tcase_add_exit_test(tcase, null_indices_break_the_contract,
                        BROKEN_CONTRACT);
    suite_add_tcase(suite, tcase);
    suite_add_tcase(suite, statuses_case("statuses", use_public));
    return suite;
}

#include "base/fail.h"

#include "support/support.h"

START_TEST(each_kind_sets_all_members)
{
    const int vertex[] = {4, 1, 2, 3};
    tf_error error, filled = {.index = 77, .option = "x", .time = 9};
    error = filled;
    ck_assert_int_eq(tf_fail(&error, TF_OK), TF_OK);
    ck_assert(error.status == TF_OK && error.subject == TF_NO_SUBJECT &&
              error.index == 0 && error.vertex[0] == -1 && error.time == -1 &&
              !error.option);
    error = filled;
    tf_fail_vertex(&error, TF_NOT_FINITE, 5, 1);
    ck_assert(error.status == TF_NOT_FINITE && error.subject == TF_VERTEX &&
              error.index == 5 && error.vertex[0] == 5 && error.time == 1 &&
              error.vertex[1] == -1 && !error.option);
    error = filled;
    tf_fail_query(&error, TF_OUT_OF_RANGE, 8, 5, 0);
    ck_assert(error.status == TF_OUT_OF_RANGE &&
              error.subject == TF_BATCH_QUERY && error.index == 8 &&
              error.vertex[0] == 5 && error.time == 0 &&
              error.vertex[1] == -1 && !error.option);
    error = filled;
    tf_fail_pair(&error, TF_START_NOT_CLEAR, TF_POINT_TRIANGLE_PAIR, 4, vertex,
                 0);
    ck_assert(error.vertex[0] == 4 && error.vertex[3] == 3 &&
              error.vertex[4] == -1 && error.time == 0);
    error = filled;
    tf_fail_option(&error, "friction", "0 or more", -1);
    ck_assert(error.status == TF_BAD_OPTION && error.value == -1 &&
              error.time == -1);
    error = filled;
    tf_fail_vertex_option(&error, "friction", "0 or more", 7, -2);
    ck_assert(error.status == TF_BAD_OPTION && error.value == -2 &&
              error.subject == TF_VERTEX && error.index == 7 &&
              error.vertex[0] == 7 && error.vertex[1] == -1 && error.option &&
              error.range && error.time == -1);
}
END_TEST

START_TEST(pair_ends_at_minus_one)
{
    const int vertex[] = {4, 1, 2, -1, 7};
    tf_error error;
    tf_fail_pair(&error, TF_START_NOT_CLEAR, TF_POINT_EDGE_PAIR, 5, vertex, 0);
    ck_assert(error.vertex[2] == 2 && error.vertex[3] == -1 &&
              error.vertex[4] == -1);
}
END_TEST

START_TEST(error_may_be_null)
{
    const int vertex[] = {4, 1, 2, 3};
    ck_assert_int_eq(tf_fail(NULL, TF_BAD_MASS), TF_BAD_MASS);
    ck_assert_int_eq(tf_fail_vertex(NULL, TF_BAD_MASS, 3, -1), TF_BAD_MASS);
    ck_assert_int_eq(tf_fail_query(NULL, TF_NOT_FINITE, 3, 1, 0),
                     TF_NOT_FINITE);
    ck_assert_int_eq(tf_fail_option(NULL, "a", "b", 0), TF_BAD_OPTION);
    ck_assert_int_eq(tf_fail_vertex_option(NULL, "a", "b", 3, 0),
                     TF_BAD_OPTION);
    ck_assert_int_eq(tf_fail_element(NULL, TF_BAD_INDEX, TF_EDGE, 0, 0),
                     TF_BAD_INDEX);
    ck_assert_int_eq(
        tf_fail_pair(NULL, TF_NOT_EMBEDDED, TF_EDGE_EDGE_PAIR, 4, vertex, -1),
        TF_NOT_EMBEDDED);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("base/fail");
    TCase *tcase = tcase_create("fail");
    tcase_add_test(tcase, each_kind_sets_all_members);
    tcase_add_test(tcase, pair_ends_at_minus_one);
    tcase_add_test(tcase, error_may_be_null);
    suite_add_tcase(suite, tcase);
    return suite;
}

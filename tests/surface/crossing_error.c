// An error about elements that intersect names both.
#include "surface/crossing_error.h"

#include "support/support.h"

static const struct {
    tf_crossing crossing;
    tf_subject subject;
} rows[] = {
    {{TF_EDGE_THROUGH_TRIANGLE, {1, 2, 3, 4, 5}}, TF_EDGE_TRIANGLE_PAIR},
    {{TF_POINT_ON_TRIANGLE, {9, 2, 3, 4, -1}}, TF_POINT_TRIANGLE_PAIR},
    {{TF_EDGE_ON_EDGE, {0, 7, 3, 4, -1}}, TF_EDGE_EDGE_PAIR},
};

START_TEST(both_elements_are_named)
{
    const tf_crossing *crossing = &rows[_i].crossing;
    tf_error error;
    ck_assert_int_eq(
        tf_fail_crossing(&error, TF_NOT_EMBEDDED, crossing, _i - 1),
        TF_NOT_EMBEDDED);
    ck_assert_int_eq(error.status, TF_NOT_EMBEDDED);
    ck_assert_int_eq(error.subject, rows[_i].subject);
    ck_assert_int_eq(error.time, _i - 1);
    for (int i = 0; i < 5; i++)
        ck_assert_int_eq(error.vertex[i], crossing->vertex[i]);
    ck_assert_int_eq(tf_fail_crossing(NULL, TF_START_NOT_CLEAR, crossing, 0),
                     TF_START_NOT_CLEAR);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/crossing_error");
    TCase *tcase = tcase_create("errors");
    tcase_add_loop_test(tcase, both_elements_are_named, 0,
                        sizeof rows / sizeof *rows);
    suite_add_tcase(suite, tcase);
    return suite;
}

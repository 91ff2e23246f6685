#include "simulate/pulled.h"

#include "support/support.h"

#include <math.h>

/// The mean of where a handle's vertices start.
static void find_middle(const tf_stage *stage, int handle, double middle[3])
{
    const tf_handle *h = &stage->handle[handle];
    for (int k = 0; k < 3; k++) {
        middle[k] = 0;
        for (int v = h->first; v < h->first + h->count; v++)
            middle[k] += stage->body.position[3 * v + k] / h->count;
    }
}

static int count_scripted(const tf_body *body)
{
    int count = 0;
    for (int v = 0; v < body->vertices; v++)
        count += body->mass[v] == 0;
    return count;
}

START_TEST(a_strip_is_turned_at_both_ends)
{
    tf_stage stage = {.body.axes = 3};
    double left[3], right[3];
    tf_build_twist(&stage, 4);
    ck_assert_int_eq(stage.handles, 2);
    ck_assert_int_eq(count_scripted(&stage.body), 2 * 5);
    find_middle(&stage, 0, left);
    find_middle(&stage, 1, right);
    ck_assert_double_eq_tol(left[0], -0.6, 1e-12);
    ck_assert_double_eq_tol(right[0], 0.6, 1e-12);
    ck_assert_double_eq(stage.handle[0].turn, -stage.handle[1].turn);
    ck_assert_double_gt(stage.handle[0].shift[0], 0);
    ck_assert_double_lt(stage.handle[1].shift[0], 0);
    tf_body_free(&stage.body);
}
END_TEST

START_TEST(a_rope_is_pulled_at_both_ends)
{
    tf_stage stage = {.body.axes = 3};
    double first[3], last[3];
    tf_build_knot(&stage, 3);
    ck_assert_int_eq(stage.handles, 2);
    ck_assert_int_eq(count_scripted(&stage.body), 4 * 6);
    ck_assert_int_eq(stage.handle[1].first + stage.handle[1].count,
                     stage.body.vertices);
    find_middle(&stage, 0, first);
    find_middle(&stage, 1, last);
    ck_assert_double_gt(first[1], last[1]);
    ck_assert_double_gt(stage.handle[0].shift[1], 0);
    ck_assert_double_lt(stage.handle[1].shift[1], 0);
    tf_body_free(&stage.body);
}
END_TEST

START_TEST(a_curtain_is_pulled_at_its_middle)
{
    for (int size = 10; size < 14; size++) {
        tf_stage stage = {.body.axes = 3};
        double middle[2][3];
        tf_build_curtain(&stage, size);
        for (int h = 0; h < 2; h++) {
            find_middle(&stage, h, middle[h]);
            ck_assert_int_eq(stage.handle[h].count, 2);
            ck_assert_double_lt(stage.handle[h].shift[2], -0.5);
        }
        for (int k = 0; k < 2; k++)
            ck_assert_double_le(fabs(middle[0][k] + middle[1][k]), 1e-12);
        tf_body_free(&stage.body);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/pulled");
    TCase *tcase = tcase_create("stages");
    tcase_add_test(tcase, a_strip_is_turned_at_both_ends);
    tcase_add_test(tcase, a_rope_is_pulled_at_both_ends);
    tcase_add_test(tcase, a_curtain_is_pulled_at_its_middle);
    suite_add_tcase(suite, tcase);
    return suite;
}

#include "query/shape.h"

#include "support/support.h"

#include <stddef.h>

START_TEST(elements_have_a_vertex_more_than_there_are_axes)
{
    static const tf_kind kinds[] = {TF_POINT_EDGE, TF_POINT_TRIANGLE,
                                    TF_EDGE_EDGE};
    static const tf_query_shape expected[] = {{2, 1, 2}, {3, 1, 3}, {3, 2, 2}};
    for (int i = 0; i < 3; i++) {
        const tf_query_shape *shape = tf_query_shape_of(kinds[i]);
        ck_assert_int_eq(shape->axes, expected[i].axes);
        ck_assert_int_eq(shape->vertices, expected[i].vertices);
        ck_assert_int_eq(shape->others, expected[i].others);
        ck_assert_int_eq(shape->vertices + shape->others, shape->axes + 1);
    }
}
END_TEST

START_TEST(other_kinds_have_no_shape)
{
    ck_assert_ptr_null(tf_query_shape_of(TF_NO_KIND));
    ck_assert_ptr_null(tf_query_shape_of((tf_kind)(TF_EDGE_EDGE + 1)));
    ck_assert_ptr_null(tf_query_shape_of((tf_kind)-1));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("query/shape");
    TCase *tcase = tcase_create("shape");
    tcase_add_test(tcase, elements_have_a_vertex_more_than_there_are_axes);
    tcase_add_test(tcase, other_kinds_have_no_shape);
    suite_add_tcase(suite, tcase);
    return suite;
}

#define _POSIX_C_SOURCE 200809L // strdup

#include "formats/source.h"

#include "support/support.h"

#include <stdlib.h>
#include <string.h>

START_TEST(points_are_kept_in_their_order)
{
    tf_source source = {.text = strdup("abc"), .size = 3};
    for (int i = 0; i < 1000; i++) {
        size_t at = (size_t)i;
        ck_assert(tf_source_add(
            &source, &(tf_source_point){{at, at + 1, at + 2}, 7 * i}));
    }
    ck_assert_uint_eq(source.points, 1000);
    for (int i = 0; i < 1000; i++) {
        ck_assert_uint_eq(source.point[i].at[2], (size_t)i + 2);
        ck_assert_int_eq(source.point[i].vertex, 7 * i);
    }
    tf_source_free(&source);
    ck_assert_ptr_null(source.text);
    ck_assert_ptr_null(source.point);
    ck_assert_uint_eq(source.points, 0);
}
END_TEST

START_TEST(parts_are_kept_in_their_order)
{
    tf_source source = {.keeps_parts = true};
    for (int i = 0; i < 1000; i++)
        ck_assert(tf_source_add_part(
            &source, &(tf_source_part){(size_t)i, 2, TF_CORNER_PART, 7 * i}));
    ck_assert_uint_eq(source.parts, 1000);
    for (int i = 0; i < 1000; i++)
        ck_assert(source.part[i].at == (size_t)i &&
                  source.part[i].vertex == 7 * i);
    tf_source_free(&source);
    ck_assert_ptr_null(source.part);
    ck_assert_uint_eq(source.parts, 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("formats/source");
    TCase *tcase = tcase_create("points");
    tcase_add_test(tcase, points_are_kept_in_their_order);
    tcase_add_test(tcase, parts_are_kept_in_their_order);
    suite_add_tcase(suite, tcase);
    return suite;
}

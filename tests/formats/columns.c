// Columns of values: rows come as they were added, and mix as they should.
#include "formats/columns.h"

#include "support/support.h"

#include <math.h>
#include <string.h>

static tf_columns columns_of(int count, const tf_number_type types[])
{
    tf_columns made = {.count = count};
    for (int i = 0; i < count; i++) {
        made.column[i] = (tf_column){.type = types[i]};
        made.column[i].name[0] = (char)('a' + i);
    }
    return made;
}

START_TEST(rows_are_added)
{
    static const tf_number_type types[] = {TF_DOUBLE, TF_INT};
    tf_columns columns = columns_of(2, types);
    for (int i = 0; i < 1000; i++)
        ck_assert(tf_columns_add(&columns, (const double[]){i, -i}));
    ck_assert_uint_eq(columns.rows, 1000);
    for (int i = 0; i < 1000; i++) {
        ck_assert_double_eq(tf_columns_row(&columns, i)[0], i);
        ck_assert_double_eq(tf_columns_row(&columns, i)[1], -i);
    }
    tf_columns_free(&columns);
    ck_assert_int_eq(columns.count, 0);
    ck_assert_uint_eq(columns.rows, 0);
}
END_TEST

START_TEST(columns_are_found_by_name)
{
    static const tf_number_type types[] = {TF_DOUBLE, TF_INT, TF_CHAR};
    tf_columns columns = columns_of(3, types);
    ck_assert_int_eq(tf_columns_find(&columns, "a"), 0);
    ck_assert_int_eq(tf_columns_find(&columns, "c"), 2);
    ck_assert_int_eq(tf_columns_find(&columns, "d"), -1);
    ck_assert_int_eq(tf_columns_find(&columns, ""), -1);
}
END_TEST

START_TEST(numbers_are_interpolated_and_integers_rounded)
{
    static const tf_number_type types[] = {TF_DOUBLE, TF_FLOAT, TF_UCHAR,
                                           TF_INT};
    static const double rows[3][4] = {
        {1, -0.5, 255, -3}, {2, 0.5, 0, -4}, {4, 8, 255, -5}};
    static const int vertex[] = {2, 0, 1};
    tf_columns columns = columns_of(4, types), mixed = columns_of(4, types);
    for (int i = 0; i < 3; i++)
        ck_assert(tf_columns_add(&columns, rows[i]));
    ck_assert(tf_columns_mix(&mixed, &columns, vertex,
                             (const double[]){0.5, 0.25, 0.25}));
    ck_assert(
        tf_columns_mix(&mixed, &columns, vertex, (const double[]){0, 1, 0}));
    const double *row = tf_columns_row(&mixed, 0);
    ck_assert_double_eq(row[0], 2.75);
    ck_assert_double_eq(row[1], 4);
    ck_assert_double_eq(row[2], 191); // 191.25
    ck_assert_double_eq(row[3], -4);  // -4.25
    ck_assert_mem_eq(tf_columns_row(&mixed, 1), rows[0], sizeof rows[0]);
    tf_columns_free(&columns);
    tf_columns_free(&mixed);
}
END_TEST

// Each integer type keeps its range.
START_TEST(equal_integers_stay_whatever_the_weights_are)
{
    static const tf_number_type types[] = {TF_UCHAR, TF_UINT};
    static const double row[] = {255, 4294967295};
    generator random = generator_new(1);
    tf_columns columns = columns_of(2, types), mixed = columns_of(2, types);
    ck_assert(tf_columns_add(&columns, row));
    for (int i = 0; i < 1000; i++) {
        double a = uniform(&random, 0, 1), b = uniform(&random, 0, 1 - a);
        double weight[] = {a, b, 1 - a - b};
        ck_assert(
            tf_columns_mix(&mixed, &columns, (const int[]){0, 0, 0}, weight));
        ck_assert_mem_eq(tf_columns_row(&mixed, i), row, sizeof row);
    }
    tf_columns_free(&columns);
    tf_columns_free(&mixed);
}
END_TEST

START_TEST(what_has_no_weight_does_not_count)
{
    static const tf_number_type types[] = {TF_DOUBLE};
    tf_columns columns = columns_of(1, types), mixed = columns_of(1, types);
    ck_assert(tf_columns_add(&columns, (const double[]){NAN}));
    ck_assert(tf_columns_add(&columns, (const double[]){7}));
    for (int i = 0; i < 2; i++)
        ck_assert(tf_columns_mix(&mixed, &columns, (const int[]){0, 1, 1},
                                 (const double[]){0.5 * i, 1 - 0.5 * i, 0}));
    ck_assert_double_eq(tf_columns_row(&mixed, 0)[0], 7);
    ck_assert(isnan(tf_columns_row(&mixed, 1)[0]));
    tf_columns_free(&columns);
    tf_columns_free(&mixed);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("formats/columns");
    TCase *tcase = tcase_create("columns");
    tcase_add_test(tcase, rows_are_added);
    tcase_add_test(tcase, columns_are_found_by_name);
    tcase_add_test(tcase, numbers_are_interpolated_and_integers_rounded);
    tcase_add_test(tcase, equal_integers_stay_whatever_the_weights_are);
    tcase_add_test(tcase, what_has_no_weight_does_not_count);
    suite_add_tcase(suite, tcase);
    return suite;
}

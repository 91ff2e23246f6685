#define _GNU_SOURCE // fopencookie, memmem

#include "files/query_file.h"

#include "support/queries.h"
#include "support/support.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// Reading a text --------------------------------------------------------------

enum {
    KEPT = 4
};

/// What a reader made of a text: the first queries, how many, and the fault.
typedef struct outcome {
    tf_query_rows query[KEPT];
    long count;
    tf_reading last;
    tf_fault fault;
} outcome;

static outcome read_stream(const char *kind, FILE *stream)
{
    outcome found = {0};
    tf_query_file file;
    tf_query_file_start(&file, stream, "text",
                        tf_choice_named(tf_query_kinds, kind), 100,
                        &found.fault);
    tf_query_rows rows;
    while ((found.last = tf_query_file_next(&file, &rows)) == TF_READ_GOOD) {
        if (found.count < KEPT)
            found.query[found.count] = rows;
        found.count++;
    }
    tf_query_file_close(&file);
    return found;
}

static outcome read_bytes(const char *kind, const char *text, size_t length)
{
    // fmemopen takes no empty buffer.
    FILE *stream = length > 0 ? fmemopen((void *)text, length, "r")
                              : fopen("/dev/null", "r");
    ck_assert_ptr_nonnull(stream);
    return read_stream(kind, stream);
}

static outcome read_text(const char *kind, const char *text)
{
    return read_bytes(kind, text, strlen(text));
}

static void expect_same(const outcome *found, const char *kind, long line,
                        const char *words)
{
    ck_assert_msg(found->last == TF_READ_FAULT, "%s: no fault, but %s", kind,
                  words);
    ck_assert_msg(strstr(found->fault.text, words), "'%s' and not '%s'",
                  found->fault.text, words);
    ck_assert_msg(strstr(found->fault.text, "; "), "'%s': how to mend it?",
                  found->fault.text);
    ck_assert_msg(found->fault.place == line, "line %ld, not %ld: %s",
                  found->fault.place, line, found->fault.text);
}

/// Expect `good` queries, then a fault in a line, told in these words.
static void expect_fault(const char *kind, const char *text, long good,
                         long line, const char *words)
{
    outcome found = read_text(kind, text);
    expect_same(&found, kind, line, words);
    ck_assert_int_eq(found.count, good);
}

static outcome expect_good(const char *kind, const char *text, long good)
{
    outcome found = read_text(kind, text);
    ck_assert_msg(found.last == TF_READ_END, "%ld: %s", found.fault.place,
                  found.fault.text);
    ck_assert_int_eq(found.count, good);
    return found;
}

// The rows of a query of each kind of columns.
#define PLANE "1,2\n-3,4\n5,6\n7,8\n9,10\n11,12\n"
#define RATIONAL "1,2,3,4\n1,2,3,4\n1,2,3,4\n1,2,3,4\n1,2,3,4\n1,2,3,4\n"
#define TRUE_FIVE "1,2,3,4,1\n1,2,3,4,1\n1,2,3,4,1\n1,2,3,4,1\n1,2,3,4,1\n"
#define TRUE_SIX TRUE_FIVE "1,2,3,4,1\n"
#define SPACE_FOUR "1,2,3\n4,5,6\n7,8,9\n10,11,12\n"
#define SPACE SPACE_FOUR "13,14,15\n16,17,18\n19,20,21\n22,23,24\n"

// Good files ------------------------------------------------------------------

START_TEST(rows_are_vertices_at_0_then_at_1)
{
    outcome found = expect_good("edge-edge", SPACE SPACE, 2);
    for (int q = 0; q < 2; q++)
        for (int row = 0; row < 8; row++)
            for (int k = 0; k < 3; k++) {
                double x = found.query[q].x[row / 4][3 * (row % 4) + k];
                ck_assert(x == 3 * row + k + 1);
            }
    for (int row = 0; row < 8; row++) {
        ck_assert_int_eq(found.query[0].line[row], row + 1);
        ck_assert_int_eq(found.query[1].line[row], row + 9);
    }
    ck_assert_int_eq(found.query[1].ground_truth, -1);
    ck_assert_int_eq(found.query[1].rounded, 0);
}
END_TEST

START_TEST(a_query_of_the_plane_has_three_vertices)
{
    outcome found = expect_good("point-edge", PLANE, 1);
    const tf_query_rows *rows = &found.query[0];
    ck_assert(rows->x[0][2] == -3 && rows->x[0][3] == 4);
    ck_assert(rows->x[1][4] == 11 && rows->x[1][5] == 12);
}
END_TEST

START_TEST(rationals_may_have_the_truth)
{
    outcome found = expect_good("point-edge", RATIONAL, 1);
    ck_assert(found.query[0].x[0][0] == 0.5);
    ck_assert(found.query[0].x[0][1] == 0.75);
    ck_assert_int_eq(found.query[0].ground_truth, -1);
    found = expect_good("point-edge", TRUE_SIX TRUE_SIX, 2);
    ck_assert(found.query[1].x[1][5] == 0.75);
    ck_assert_int_eq(found.query[1].ground_truth, 1);
}
END_TEST

START_TEST(rationals_are_read_in_space)
{
    char text[400] = "";
    for (int row = 0; row < 8; row++)
        strcat(text, "1,-2,-3,-4,+7,1,0\n");
    outcome found = expect_good("point-triangle", text, 1);
    const double *x = found.query[0].x[1] + 9;
    ck_assert(x[0] == -0.5 && x[1] == 0.75 && x[2] == 7);
    ck_assert_int_eq(found.query[0].ground_truth, 0);
}
END_TEST

START_TEST(rounded_coordinates_are_counted)
{
    outcome found = expect_good("point-edge",
                                "1,3,1,2\n1,2,2,3\n1,2,1,2\n1,2,1,2\n"
                                "1,2,1,2\n1,10,9007199254740993,1\n",
                                1);
    ck_assert_int_eq(found.query[0].rounded, 4);
    ck_assert(found.query[0].x[1][4] == 0.1);
    ck_assert(found.query[0].x[1][5] == 0x1p53);
}
END_TEST

START_TEST(every_way_to_write_a_number_is_read)
{
    outcome found = expect_good("point-edge",
                                "0x1.8p-1,-0X1P3\n1e-3,-2.5E+2\n.5,5.\n"
                                "+1,-0\n4.9e-324,0x1p-1074\n"
                                "1.7976931348623157e308,1e-400\n",
                                1);
    const tf_query_rows *rows = &found.query[0];
    ck_assert(rows->x[0][0] == 0.75 && rows->x[0][1] == -8);
    ck_assert(rows->x[0][2] == 0.001 && rows->x[0][3] == -250);
    ck_assert(rows->x[0][4] == 0.5 && rows->x[0][5] == 5);
    ck_assert(rows->x[1][2] == 0x1p-1074 && rows->x[1][3] == 0x1p-1074);
    ck_assert(rows->x[1][4] == 0x1.fffffffffffffp1023 && rows->x[1][5] == 0);
}
END_TEST

START_TEST(blanks_around_fields_are_skipped)
{
    expect_good("point-edge",
                " 1 ,\t2\n3\t, 4 \n5,6\n7,8\n9,10\n \t11 \t, \t12\t\n", 1);
    expect_good("point-edge", TRUE_FIVE " 1 , 2 ,3\t,\t4 , 1 \n", 1);
}
END_TEST

START_TEST(carriage_returns_end_lines)
{
    outcome found = expect_good(
        "point-edge", "1,2\r\n-3,4\r\n5,6\r\n7,8\r\n9,10\r\n11,12\r\n\r\n", 1);
    ck_assert(found.query[0].x[1][5] == 12);
    expect_good("point-edge", TRUE_FIVE "1,2,3,4,1\r", 1);
}
END_TEST

START_TEST(a_byte_order_mark_is_skipped)
{
    outcome found = expect_good("point-edge", "\xEF\xBB\xBF" PLANE, 1);
    ck_assert(found.query[0].x[0][0] == 1);
    expect_fault("point-edge", PLANE "\xEF\xBB\xBF" PLANE, 1, 7, "'\?\?\?1'");
}
END_TEST

START_TEST(the_last_line_needs_no_end)
{
    outcome found = expect_good("point-edge",
                                PLANE "1,2\n3,4\n5,6\n7,8\n9,10\n"
                                      "11,125",
                                2);
    ck_assert(found.query[1].x[1][5] == 125);
}
END_TEST

START_TEST(blank_lines_and_comments_are_skipped)
{
    expect_good("point-edge", PLANE "\n\n \t\n\r\n", 1);
    expect_good("point-edge", PLANE "\n ", 1);
    expect_good("point-edge", PLANE "\n" PLANE, 2);
    expect_good("point-edge", "\n" PLANE " \t\r\n\n\n" PLANE, 2);
    expect_good("point-edge", "# x,y\n" PLANE "#\n" PLANE "  # end", 2);
    expect_good("point-edge", "\xEF\xBB\xBF#\xFF\r\n" PLANE "#0,0,0\n", 1);
}
END_TEST

START_TEST(each_row_has_its_line)
{
    outcome found = expect_good("point-edge",
                                "# A point,\n1,2\n# and an edge.\n\n3,4\n5,6\n"
                                "\n# At the end:\n7,8\n9,10\n11,12\n",
                                1);
    static const long line[] = {2, 5, 6, 9, 10, 11};
    for (int row = 0; row < 6; row++)
        ck_assert_int_eq(found.query[0].line[row], line[row]);
    ck_assert(found.query[0].x[0][2] == 3 && found.query[0].x[1][0] == 7);
}
END_TEST

START_TEST(very_long_lines_are_read)
{
    enum {
        LONG = 3000000
    };
    char *text = malloc(LONG + 200);
    memset(text, ' ', LONG);
    strcpy(text + LONG, PLANE);
    outcome found = expect_good("point-edge", text, 1);
    ck_assert(found.query[0].x[0][0] == 1);
    memset(text, '0', LONG);
    found = expect_good("point-edge", text, 1);
    ck_assert(found.query[0].x[0][0] == 1);
    memset(text, 'x', LONG);
    expect_fault("point-edge", text, 0, 1, "'xxxxxxxxxxxxxxxxxxxxxxxxxxxx...'");
    memset(text, ',', LONG);
    expect_fault("point-edge", text, 0, 1,
                 "3000002 columns; a row of point-edge has");
    free(text);
}
END_TEST

START_TEST(three_hundred_digits_are_read)
{
    char ones[301], threes[301], text[4000] = "";
    memset(ones, '1', 300);
    memset(threes, '3', 300);
    ones[300] = threes[300] = '\0';
    for (int row = 0; row < 6; row++)
        sprintf(text + strlen(text), "%s,%s,0,1\n", ones, threes);
    outcome found = expect_good("point-edge", text, 1);
    ck_assert(found.query[0].x[1][4] == 1. / 3);
    ck_assert_int_eq(found.query[0].rounded, 6);
}
END_TEST

START_TEST(random_queries_come_back_to_the_last_bit)
{
    static const char *const names[KINDS] = {"point-edge", "point-triangle",
                                             "edge-edge"};
    generator random = generator_new(1);
    for (long i = 0; i < cases(20000); i++) {
        int kind = below(&random, KINDS);
        query q = query_extreme(&random, (query_kind)kind);
        outcome found = expect_good(names[kind], query_text(&q), 1);
        int vertices = q.vertices + q.others;
        for (int row = 0; row < 2 * vertices; row++)
            for (int k = 0; k < q.axes; k++) {
                int place = q.axes * (row % vertices) + k;
                double read = found.query[0].x[row / vertices][place];
                double right = q.vertex[row % vertices].at[row / vertices].x[k];
                ck_assert_msg(read == right && signbit(read) == signbit(right),
                              "%a, not %a", read, right);
            }
    }
}
END_TEST

// Faults of a field -----------------------------------------------------------

START_TEST(nan_is_refused)
{
    expect_fault("point-edge", PLANE "1,nan\n", 1, 7,
                 "column 2 is 'nan', not a finite number");
    expect_fault("point-edge", PLANE "-NaN(1),1\n", 1, 7, "column 1 is");
}
END_TEST

START_TEST(infinity_is_refused)
{
    expect_fault("point-edge", PLANE "1,2\n-inf,1\n", 1, 8,
                 "column 1 is '-inf', not a finite number");
    expect_fault("point-triangle", SPACE "1,2,Infinity\n", 1, 9,
                 "column 3 is 'Infinity', not a finite number");
}
END_TEST

START_TEST(text_in_a_number_is_refused)
{
    expect_fault("point-edge", PLANE "1,2.5abc\n", 1, 7,
                 "column 2 is '2.5abc'");
    expect_fault("point-edge", PLANE "1 2,3\n", 1, 7, "column 1 is '1 2'");
    expect_fault("point-edge", "0x,1\n", 0, 1, "column 1 is '0x'");
    expect_fault("point-edge", "0x1.p,1\n", 0, 1, "column 1 is '0x1.p'");
    expect_fault("point-edge", "1;2,3\n", 0, 1, "column 1 is '1;2'");
}
END_TEST

START_TEST(text_instead_of_a_number_is_refused)
{
    expect_fault("point-triangle", "x,1,z\n" SPACE, 0, 1, "column 1 is 'x'");
    expect_fault("point-edge", "\x1b[31m,1\n", 0, 1, "column 1 is '?[31m'");
}
END_TEST

START_TEST(text_in_an_integer_is_refused)
{
    expect_fault("point-edge", RATIONAL "1,2,0.5,1\n", 1, 7,
                 "column 3 is '0.5', not an integer");
    expect_fault("point-edge", RATIONAL "1,0x2,3,4\n", 1, 7,
                 "column 2 is '0x2', not an integer");
    expect_fault("point-edge", RATIONAL "1,2,nan,4\n", 1, 7,
                 "column 3 is 'nan', not an integer");
}
END_TEST

START_TEST(an_empty_field_is_refused)
{
    expect_fault("point-edge", PLANE "1,\n", 1, 7, "column 2 is empty");
    expect_fault("point-edge", PLANE ",1\n", 1, 7, "column 1 is empty");
    expect_fault("point-edge", RATIONAL "1, ,3,4\n", 1, 7, "column 2 is empty");
    expect_fault("point-edge", TRUE_FIVE "1,2,3,4,\n", 0, 6,
                 "column 5 is empty");
}
END_TEST

START_TEST(overflow_is_refused)
{
    expect_fault("point-edge", PLANE "1,-1e309\n", 1, 7,
                 "column 2 is '-1e309', beyond the largest double");
    expect_fault("point-edge", "0x1p1024,1\n", 0, 1, "beyond the largest");
    char text[400] = "1,1,1";
    memset(text + 5, '0', 309);
    strcpy(text + 314, ",1\n");
    expect_fault("point-edge", text, 0, 1, "column 3 is '1000");
    expect_fault("point-edge", text, 0, 1, "beyond the largest");
}
END_TEST

START_TEST(a_zero_denominator_is_refused)
{
    expect_fault("point-edge", RATIONAL "1,2,3,0\n", 1, 7,
                 "column 4 is 0; a denominator");
    expect_fault("point-edge", RATIONAL "0,-000,3,1\n", 1, 7,
                 "column 2 is 0; a denominator");
}
END_TEST

START_TEST(bad_truth_is_refused)
{
    expect_fault("point-edge", TRUE_FIVE "1,2,3,4,2\n", 0, 6,
                 "column 5 is '2', not a ground truth");
    expect_fault("point-edge", TRUE_FIVE "1,2,3,4,01\n", 0, 6,
                 "not a ground truth");
    expect_fault("point-edge", TRUE_FIVE "1,2,3,4,true\n", 0, 6,
                 "column 5 is 'true'");
    expect_fault("point-edge", TRUE_FIVE "1,2,3,4,-1\n", 0, 6,
                 "not a ground truth");
}
END_TEST

START_TEST(truth_that_changes_is_refused)
{
    expect_fault("point-edge", TRUE_FIVE "1,2,3,4,0\n", 0, 6,
                 "the ground truth is 0, but 1 on line 1");
    expect_good("point-edge",
                TRUE_SIX "1,2,3,4,0\n1,2,3,4,0\n1,2,3,4,0\n1,2,3,4,0\n"
                         "1,2,3,4,0\n1,2,3,4,0\n",
                2);
}
END_TEST

// Faults of a row -------------------------------------------------------------

START_TEST(a_missing_column_is_refused)
{
    expect_fault("point-edge", PLANE "1\n", 1, 7, "too few columns: 1, but");
    expect_fault("point-triangle", SPACE "1,2\n", 1, 9,
                 "too few columns: 2, but the first row has 3");
    expect_fault("point-edge", TRUE_FIVE "1,2,3,4\n", 0, 6,
                 "too few columns: 4, but the first row has 5");
}
END_TEST

START_TEST(too_many_columns_are_refused)
{
    expect_fault("point-edge", PLANE "1,2,3\n", 1, 7, "too many columns: 3");
    expect_fault("point-edge", PLANE "1,2,\n", 1, 7, "too many columns: 3");
    expect_fault("point-edge", RATIONAL "1,2,3,4,1\n", 1, 7,
                 "too many columns: 5, but the first row has 4");
}
END_TEST

START_TEST(columns_of_another_kind_are_refused)
{
    expect_fault("point-edge", SPACE, 0, 1,
                 "3 columns; a row of point-edge has 2 (decimals), 4 "
                 "(rationals) or 5 (rationals and the ground truth)");
    expect_fault("edge-edge", PLANE, 0, 1,
                 "2 columns; a row of edge-edge has 3 (decimals), 6 "
                 "(rationals) or 7");
    expect_fault("edge-edge", RATIONAL, 0, 1,
                 "4 columns; a row of edge-edge has 3");
    expect_fault("edge-edge", TRUE_SIX, 0, 1,
                 "5 columns; a row of edge-edge has 3");
    expect_fault("edge-edge", "1,2,3,4,5,6,7,8\n", 0, 1,
                 "8 columns; a row of edge-edge has 3");
    expect_fault("edge-edge", "hello\n", 0, 1, "1 column; a row of");
}
END_TEST

START_TEST(a_header_line_is_refused)
{
    static const char *const headers[] = {"x,y,z",
                                          "X , Y , Z",
                                          "\"x\",\"y\",\"z\"",
                                          "\n# comment\n_1,_2,_3",
                                          "x_num,x_den,y_num,y_den,truth",
                                          "info,nano"};
    for (size_t i = 0; i < sizeof headers / sizeof *headers; i++) {
        char text[1000];
        snprintf(text, sizeof text, "%s\n%s", headers[i], SPACE);
        expect_fault("point-triangle", text, 0, i == 3 ? 3 : 1,
                     "this is a header line; delete it, or begin it with #");
    }
    // Only the first row, if nothing in it is a number.
    expect_fault("point-edge", PLANE "x,y\n", 1, 7, "column 1 is 'x'");
    expect_fault("point-edge", "x,0\n", 0, 1, "column 1 is 'x'");
    expect_fault("point-edge", "x,inf\n", 0, 1, "column 1 is 'x'");
    expect_fault("point-edge", "nan,NaN\n", 0, 1, "column 1 is 'nan'");
    expect_fault("point-edge", "x,\n", 0, 1, "column 1 is 'x'");
}
END_TEST

START_TEST(skipped_lines_are_counted)
{
    expect_fault("point-edge", "\n#\n" PLANE "\n#\n1,x\n", 1, 11,
                 "column 2 is 'x'");
    expect_fault("point-edge", PLANE "1,2\n#\n3,4\n\n#\n", 1, 9,
                 "query 101 has only 2 of its 6 rows");
    expect_fault("point-edge", "#\n" TRUE_FIVE "\n1,2,3,4,0\n", 0, 8,
                 "the ground truth is 0, but 1 on line 2;");
}
END_TEST

START_TEST(a_nul_byte_is_refused)
{
    char text[] = PLANE "1,2@\n";
    *strchr(text, '@') = '\0';
    outcome found = read_bytes("point-edge", text, sizeof text - 1);
    expect_same(&found, "point-edge", 7, "a NUL byte");
    ck_assert_int_eq(found.count, 1);
    found = read_bytes("point-edge", "\0", 1);
    expect_same(&found, "point-edge", 1, "a NUL byte");
    found = read_bytes("point-edge", "\n\0\n", 3);
    expect_same(&found, "point-edge", 2, "a NUL byte");
}
END_TEST

START_TEST(utf_16_is_refused)
{
    outcome found = read_bytes("point-edge",
                               "\xFF\xFE"
                               "1\0,\0002\0\n\0",
                               10);
    expect_same(&found, "point-edge", 1, "a NUL byte");
}
END_TEST

// Faults of a file ------------------------------------------------------------

START_TEST(missing_rows_are_refused)
{
    expect_fault("edge-edge", SPACE SPACE SPACE_FOUR "1,2,3\n", 2, 21,
                 "query 102 has only 5 of its 8 rows");
    expect_fault("edge-edge", SPACE "1,2,3\n\n\n", 1, 9,
                 "query 101 has only 1 of its 8 rows");
    expect_fault("edge-edge", SPACE_FOUR "1,2,3\n4,5,6\n7,8,9", 0, 7,
                 "query 100 has only 7 of its 8 rows");
    expect_fault("point-edge", PLANE "1,2\n", 1, 7,
                 "query 101 has only 1 of its 6 rows");
}
END_TEST

START_TEST(an_empty_file_is_refused)
{
    expect_fault("point-edge", "", 0, 1, "no rows; a query has 6");
    expect_fault("edge-edge", "\n\n", 0, 1, "no rows; a query has 8");
    expect_fault("edge-edge", "\xEF\xBB\xBF", 0, 1, "no rows");
    expect_fault("edge-edge", "# nothing\n\n", 0, 1, "no rows");
}
END_TEST

/// Give five rows, then fail as a broken disk does.
static ssize_t fail_to_read(void *given, char *text, size_t room)
{
    static const char rows[] = SPACE_FOUR "1,2,3\n";
    bool *before = given;
    if (*before || room < sizeof rows) {
        errno = EIO;
        return -1;
    }
    *before = true;
    memcpy(text, rows, sizeof rows - 1);
    return sizeof rows - 1;
}

START_TEST(a_read_error_is_reported)
{
    bool given = false;
    cookie_io_functions_t functions = {.read = fail_to_read};
    FILE *stream = fopencookie(&given, "r", functions);
    outcome found = read_stream("edge-edge", stream);
    expect_same(&found, "edge-edge", 6, "cannot read: Input/output error");
}
END_TEST

static void expect_no_file(const char *path, bool opens, const char *words)
{
    tf_query_file file;
    tf_query_rows rows;
    tf_fault fault;
    const tf_query_kind *kind = tf_choice_named(tf_query_kinds, "edge-edge");
    ck_assert_int_eq(tf_query_file_open(&file, path, kind, 0, &fault), opens);
    if (opens)
        ck_assert_int_eq(tf_query_file_next(&file, &rows), TF_READ_FAULT);
    ck_assert_msg(strstr(fault.text, words), "'%s'", fault.text);
    ck_assert_str_eq(file.lines.text.name, path);
    tf_query_file_close(&file);
}

START_TEST(an_absent_file_is_refused)
{
    expect_no_file("/no/such/file", false,
                   "cannot open: No such file or directory; ");
}
END_TEST

START_TEST(a_directory_is_refused)
{
    expect_no_file("/", true, "cannot read: Is a directory; ");
}
END_TEST

// Kinds -----------------------------------------------------------------------

START_TEST(kinds_are_found_by_their_names)
{
    const tf_query_kind *kind = tf_choice_named(tf_query_kinds, "point-edge");
    ck_assert(kind->axes == 2 && kind->vertices[0] == 1 &&
              kind->vertices[1] == 2);
    kind = tf_choice_named(tf_query_kinds, "edge-edge");
    ck_assert(kind->axes == 3 && kind->vertices[0] == 2 &&
              kind->vertices[1] == 2);
    static const char *const names[] = {"point-triangle", "vertex-face"};
    for (int i = 0; i < 2; i++) {
        kind = tf_choice_named(tf_query_kinds, names[i]);
        ck_assert(kind->axes == 3 && kind->vertices[0] == 1 &&
                  kind->vertices[1] == 3);
    }
    ck_assert_ptr_null(tf_choice_named(tf_query_kinds, ""));
    ck_assert_ptr_null(tf_choice_named(tf_query_kinds, "face-vertex"));
}
END_TEST

START_TEST(standard_input_has_a_name)
{
    tf_query_file file;
    tf_fault fault;
    ck_assert(tf_query_file_open(
        &file, "-", tf_choice_named(tf_query_kinds, "edge-edge"), 0, &fault));
    ck_assert_ptr_eq(file.lines.stream, stdin);
    ck_assert_str_eq(file.lines.text.name, "standard input");
    tf_query_file_close(&file);
    ck_assert_msg(lseek(STDIN_FILENO, 0, SEEK_CUR) >= 0 || errno != EBADF,
                  "closed");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("files/query_file");
    TCase *good = tcase_create("good files");
    tcase_add_test(good, rows_are_vertices_at_0_then_at_1);
    tcase_add_test(good, a_query_of_the_plane_has_three_vertices);
    tcase_add_test(good, rationals_may_have_the_truth);
    tcase_add_test(good, rationals_are_read_in_space);
    tcase_add_test(good, rounded_coordinates_are_counted);
    tcase_add_test(good, every_way_to_write_a_number_is_read);
    tcase_add_test(good, blanks_around_fields_are_skipped);
    tcase_add_test(good, carriage_returns_end_lines);
    tcase_add_test(good, a_byte_order_mark_is_skipped);
    tcase_add_test(good, the_last_line_needs_no_end);
    tcase_add_test(good, blank_lines_and_comments_are_skipped);
    tcase_add_test(good, each_row_has_its_line);
    tcase_add_test(good, very_long_lines_are_read);
    tcase_add_test(good, three_hundred_digits_are_read);
    tcase_add_test(good, random_queries_come_back_to_the_last_bit);
    suite_add_tcase(suite, good);

    TCase *fields = tcase_create("faults of a field");
    tcase_add_test(fields, nan_is_refused);
    tcase_add_test(fields, infinity_is_refused);
    tcase_add_test(fields, text_in_a_number_is_refused);
    tcase_add_test(fields, text_instead_of_a_number_is_refused);
    tcase_add_test(fields, text_in_an_integer_is_refused);
    tcase_add_test(fields, an_empty_field_is_refused);
    tcase_add_test(fields, overflow_is_refused);
    tcase_add_test(fields, a_zero_denominator_is_refused);
    tcase_add_test(fields, bad_truth_is_refused);
    tcase_add_test(fields, truth_that_changes_is_refused);
    suite_add_tcase(suite, fields);

    TCase *rows = tcase_create("faults of a row");
    tcase_add_test(rows, a_missing_column_is_refused);
    tcase_add_test(rows, too_many_columns_are_refused);
    tcase_add_test(rows, columns_of_another_kind_are_refused);
    tcase_add_test(rows, a_header_line_is_refused);
    tcase_add_test(rows, skipped_lines_are_counted);
    tcase_add_test(rows, a_nul_byte_is_refused);
    tcase_add_test(rows, utf_16_is_refused);
    suite_add_tcase(suite, rows);

    TCase *files = tcase_create("faults of a file");
    tcase_add_test(files, missing_rows_are_refused);
    tcase_add_test(files, an_empty_file_is_refused);
    tcase_add_test(files, a_read_error_is_reported);
    tcase_add_test(files, an_absent_file_is_refused);
    tcase_add_test(files, a_directory_is_refused);
    suite_add_tcase(suite, files);

    TCase *kinds = tcase_create("kinds");
    tcase_add_test(kinds, kinds_are_found_by_their_names);
    tcase_add_test(kinds, standard_input_has_a_name);
    suite_add_tcase(suite, kinds);
    return suite;
}

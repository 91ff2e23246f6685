//: Include what query files need
#include "files/query_file.h"

#include "files/number.h"
#include "files/rational.h"
#include "files/visible.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

//: Name the kinds of query
static const tf_query_kind kinds[] = {
    {"point-edge", 2, {1, 2}},
    {"point-triangle", 3, {1, 3}},
    {"edge-edge", 3, {2, 2}},
    {"vertex-face", 3, {1, 3}},
};

const tf_choice tf_query_kinds[] = {
    {"point-edge", &kinds[0]},
    {"point-triangle", &kinds[1]},
    {"edge-edge", &kinds[2]},
    {"vertex-face", &kinds[3]},
    {NULL, NULL},
};

//: Open and close a query file
void tf_query_file_start(tf_query_file *file, FILE *stream, const char *name,
                         const tf_query_kind *kind, size_t queries,
                         tf_fault *fault)
{
    *file = (tf_query_file){.kind = kind, .queries = queries};
    tf_text_lines_start(&file->lines, stream, name, fault);
}

bool tf_query_file_open(tf_query_file *file, const char *path,
                        const tf_query_kind *kind, size_t queries,
                        tf_fault *fault)
{
    *file = (tf_query_file){.kind = kind, .queries = queries};
    return tf_text_lines_open(&file->lines, path, fault);
}

void tf_query_file_close(tf_query_file *file)
{
    tf_text_lines_close(&file->lines);
}

//: Distinguish the columns
/// Plain numbers, an axis a column; or rationals, two; or these and the truth.
static bool are_rational(const tf_query_file *file)
{
    return file->columns >= 2 * file->kind->axes;
}

static bool have_truth(const tf_query_file *file)
{
    return file->columns > 2 * file->kind->axes;
}

static long count_columns(const char *row)
{
    long columns = 1;
    for (; *row; row++)
        columns += *row == ',';
    return columns;
}

//: Recognize a header line
/// Whether a field begins as a word does, and is none of those that stand for a
/// number: nan and inf.
static bool is_word(const char *field)
{
    char *end;
    field += strspn(field, " \t");
    strtod(field, &end);
    bool number = end != field && strchr(" \t,", *end);
    return !number && *field &&
           (isalpha((unsigned char)*field) || strchr("_\"", *field));
}

static bool is_header(const tf_query_file *file)
{
    const char *field = file->lines.text.at;
    while (is_word(field) && field[strcspn(field, ",")] == ',')
        field += strcspn(field, ",") + 1;
    return field > file->lines.text.at && is_word(field);
}

//: Let the first row choose the columns
static bool choose_columns(tf_query_file *file)
{
    long axes = file->kind->axes, columns = count_columns(file->lines.row);
    if (is_header(file))
        return tf_text_fault(&file->lines.text,
                             "this is a header line; delete it, or "
                             "begin it with #");
    if (columns != axes && columns != 2 * axes && columns != 2 * axes + 1)
        return tf_text_fault(&file->lines.text,
                             "%ld column%s; a row of %s has %ld "
                             "(decimals), %ld (rationals) or %ld "
                             "(rationals and the ground truth)",
                             columns, columns == 1 ? "" : "s", file->kind->name,
                             axes, 2 * axes, 2 * axes + 1);
    file->columns = (int)columns;
    return true;
}

//: Describe what is wrong with a field
/// Quotes a field, without the blanks around it.
static bool fault_in_field(tf_query_file *file, int column, const char *field,
                           const char *verdict)
{
    size_t length = strcspn(field, ",");
    while (length > 0 && strchr(" \t", field[length - 1]))
        length--;
    if (length == 0)
        return tf_text_fault(&file->lines.text,
                             "column %d is empty; write a number there",
                             column);
    return tf_text_fault(&file->lines.text, "column %d is '%s', %s", column,
                         tf_quote(field, length).text, verdict);
}

//: Describe what is wrong with the number of columns
static bool fault_in_columns(const tf_query_file *file)
{
    long columns = count_columns(file->lines.row);
    return tf_text_fault(&file->lines.text,
                         "too %s columns: %ld, but the first row has %d; all "
                         "rows must have as many",
                         columns < file->columns ? "few" : "many", columns,
                         file->columns);
}

//: Step over the end of a field
static bool end_field(tf_query_file *file, int column, const char *field,
                      const char *verdict)
{
    tf_text_skip_blanks(&file->lines.text);
    bool ends_row = *file->lines.text.at == '\0';
    if (!ends_row && *file->lines.text.at != ',')
        return fault_in_field(file, column, field, verdict);
    if (ends_row != (column == file->columns))
        return fault_in_columns(file);
    file->lines.text.at += !ends_row;
    return true;
}

//: Read a decimal or a hexadecimal float
static bool read_decimal(tf_query_file *file, int column, double *x)
{
    tf_text_skip_blanks(&file->lines.text);
    const char *field = file->lines.text.at;
    if (!tf_number_read(&file->lines.text.at, x))
        return fault_in_field(file, column, field, TF_NO_NUMBER_VERDICT);
    if (!end_field(file, column, field, TF_NO_NUMBER_VERDICT))
        return false;
    return isfinite(*x) ||
           fault_in_field(file, column, field, TF_TOO_LARGE_VERDICT);
}

//: Read an integer
static bool read_integer(tf_query_file *file, int column, tf_numeral *integer)
{
    static const char no_integer[] =
        "not an integer; write rationals as numerator,denominator";
    tf_text_skip_blanks(&file->lines.text);
    const char *field = file->lines.text.at;
    return tf_numeral_read(&file->lines.text.at, integer)
               ? end_field(file, column, field, no_integer)
               : fault_in_field(file, column, field, no_integer);
}

//: Read a rational
static bool read_rational(tf_query_file *file, int column, double *x,
                          int *rounded)
{
    tf_numeral dividend, divisor;
    if (!read_integer(file, column, &dividend) ||
        !read_integer(file, column + 1, &divisor))
        return false;
    if (divisor.count == 0)
        return tf_text_fault(&file->lines.text,
                             "column %d is 0; a denominator must "
                             "not be 0",
                             column + 1);
    tf_rounding rounding = tf_rational_round(&dividend, &divisor, x);
    if (rounding == TF_ROUNDING_OVERFLOW)
        return fault_in_field(file, column, dividend.digit,
                              "and divided by its denominator beyond the "
                              "largest double; scale the scene down");
    if (rounding == TF_ROUNDING_FAILED)
        return tf_text_fault(&file->lines.text,
                             "not enough memory; use shorter integers");
    *rounded += rounding == TF_ROUNDING_NEAREST;
    return true;
}

//: Read the ground truth
static bool read_truth(tf_query_file *file, tf_query_rows *query)
{
    static const char no_truth[] =
        "not a ground truth; write 0 (apart) or 1 (hit)";
    tf_text_skip_blanks(&file->lines.text);
    const char *field = file->lines.text.at;
    int truth = *field - '0';
    if (truth != 0 && truth != 1)
        return fault_in_field(file, file->columns, field, no_truth);
    file->lines.text.at++;
    if (!end_field(file, file->columns, field, no_truth))
        return false;
    if (query->ground_truth >= 0 && query->ground_truth != truth)
        return tf_text_fault(&file->lines.text,
                             "the ground truth is %d, but %d on line "
                             "%ld; it must be the same on all rows of a "
                             "query",
                             truth, query->ground_truth, query->line[0]);
    query->ground_truth = truth;
    return true;
}

//: Read the coordinates of a row
static bool read_coordinates(tf_query_file *file, double x[],
                             tf_query_rows *query)
{
    if (file->columns == 0 && !choose_columns(file))
        return false;
    for (int k = 0; k < file->kind->axes; k++)
        if (are_rational(file)
                ? !read_rational(file, 2 * k + 1, &x[k], &query->rounded)
                : !read_decimal(file, k + 1, &x[k]))
            return false;
    return !have_truth(file) || read_truth(file, query);
}

//: Report missing rows
static tf_reading end_early(const tf_query_file *file,
                            const tf_query_rows *query, int have, int want)
{
    const tf_text *text = &file->lines.text;
    if (file->columns == 0)
        tf_fault_set(text->fault, text->name, 1, "no rows; a query has %d",
                     want);
    else
        tf_fault_set(text->fault, text->name, query->line[have - 1],
                     "query %zu has only %d of its %d rows; add the rest",
                     file->queries, have, want);
    return TF_READ_FAULT;
}

//: Read the next query
tf_reading tf_query_file_next(tf_query_file *file, tf_query_rows *query)
{
    int vertices = file->kind->vertices[0] + file->kind->vertices[1];
    *query = (tf_query_rows){.ground_truth = -1};
    for (int row = 0; row < 2 * vertices; row++) {
        tf_reading reading = tf_text_lines_next(&file->lines);
        if (reading == TF_READ_END && row == 0 && file->columns > 0)
            return TF_READ_END;
        if (reading == TF_READ_END)
            return end_early(file, query, row, 2 * vertices);
        if (reading == TF_READ_FAULT)
            return TF_READ_FAULT;

        query->line[row] = file->lines.text.line;
        int place = row % vertices * file->kind->axes;
        if (!read_coordinates(file, &query->x[row / vertices][place], query))
            return TF_READ_FAULT;
    }
    file->queries++;
    return TF_READ_GOOD;
}

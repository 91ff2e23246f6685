// Any bytes as a query file: the first tells the kind, the others are the text.
// Whatever they are, the reader ends with finite numbers or a fault in a line.
#define _GNU_SOURCE // fmemopen

#include "files/query_file.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static void require(bool condition)
{
    if (!condition)
        abort();
}

static long lines(const char *text, size_t length)
{
    long count = 1;
    for (size_t i = 0; i < length; i++)
        count += text[i] == '\n';
    return count;
}

static int rows(const tf_query_kind *kind)
{
    return 2 * (kind->vertices[0] + kind->vertices[1]);
}

/// Every row is on a line of its own, after *last, which becomes the last.
static void check_lines(const tf_query_rows *query, const tf_query_kind *kind,
                        long *last, long most)
{
    for (int row = 0; row < rows(kind); row++) {
        require(query->line[row] > *last && query->line[row] <= most);
        *last = query->line[row];
    }
}

static void check_query(const tf_query_rows *query, const tf_query_kind *kind)
{
    require(query->ground_truth >= -1 && query->ground_truth <= 1);
    require(query->rounded >= 0 && query->rounded <= rows(kind) * kind->axes);
    int coordinates = rows(kind) / 2 * kind->axes;
    for (int t = 0; t < 2; t++)
        for (int i = 0; i < coordinates; i++)
            require(isfinite(query->x[t][i]));
}

static void check_fault(const tf_fault *fault, long most)
{
    require(fault->place >= 1 && fault->place <= most);
    require(strstr(fault->text, "; ") != NULL);
    for (const char *c = fault->text; *c; c++)
        require(*c >= ' ' && *c <= '~');
}

static void read_all(FILE *stream, const tf_query_kind *kind, long most)
{
    tf_query_file file;
    tf_fault fault = {0};
    tf_query_file_start(&file, stream, "fuzz", kind, 0, &fault);
    tf_query_rows query;
    tf_reading reading;
    long count = 0, last = 0;
    while ((reading = tf_query_file_next(&file, &query)) == TF_READ_GOOD) {
        check_lines(&query, kind, &last, most);
        check_query(&query, kind);
        count++;
    }
    require(file.queries == (size_t)count);
    require(reading == TF_READ_END ? count > 0 : reading == TF_READ_FAULT);
    if (reading == TF_READ_FAULT)
        check_fault(&fault, most);
    else
        require(fault.text[0] == '\0');
    tf_query_file_close(&file);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static const char *const names[] = {"point-edge", "point-triangle",
                                        "edge-edge"};
    if (size < 2)
        return 0;
    const tf_query_kind *kind =
        tf_choice_named(tf_query_kinds, names[bytes[0] % 3]);
    FILE *stream = fmemopen((void *)(bytes + 1), size - 1, "r");
    require(stream != NULL);
    read_all(stream, kind, lines((const char *)bytes + 1, size - 1));
    return 0;
}

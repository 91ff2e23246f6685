#include "kit/measured.h"

#include "base/require.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const fig_workload fig_workloads[FIG_WORKLOADS] = {
    {"soup", "point-triangle", "pt"},    {"soup", "edge-edge", "ee"},
    {"near", "point-triangle", "pt"},    {"near", "edge-edge", "ee"},
    {"rest", "point-triangle", "pt"},    {"rest", "edge-edge", "ee"},
    {"lattice", "point-triangle", "pt"}, {"lattice", "edge-edge", "ee"},
};

static const struct row {
    const char *name;
    double value;
} rows[] = {
// The build makes this of the lines of figures/measured.
#include "measured_rows.h"
};

double fig_measured(const char *format, ...)
{
    char name[80];
    va_list words;
    va_start(words, format);
    vsnprintf(name, sizeof name, format, words);
    va_end(words);
    const struct row *row = rows, *end = rows + sizeof rows / sizeof *rows;
    while (row < end && strcmp(row->name, name) != 0)
        row++;
    TF_REQUIRE(row < end);
    return row->value;
}

void fig_name_workload(fig_page *page, double x, double y,
                       const fig_workload *workload)
{
    char name[64];
    snprintf(name, sizeof name, "%s, %s", workload->work, workload->letters);
    fig_page_text(page, x, y, FIG_ALIGN_RIGHT, name, FIG_LETTERS_SMALL,
                  FIG_ROLE_INK);
}

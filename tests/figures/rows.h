// The rows of figures/measured.csv, for the tests of figures that show them.
#ifndef FIGURES_ROWS_H
#define FIGURES_ROWS_H

#include "figures/numbers.h"

/// The value of a row, "name,value,unit".
static inline double row_value(const char *name)
{
    FILE *file = fopen("figures/measured.csv", "r");
    ck_assert_msg(file != NULL, "no figures/measured.csv");
    char line[256];
    size_t length = strlen(name);
    bool found = false;
    while (!found && fgets(line, sizeof line, file))
        found = strncmp(line, name, length) == 0 && line[length] == ',';
    fclose(file);
    ck_assert_msg(found, "figures/measured.csv has no row '%s'", name);
    return strtod(line + length + 1, NULL);
}

#endif

// The rows of figures/measured, for the tests of figures that show them.
#ifndef FIGURES_ROWS_H
#define FIGURES_ROWS_H

#include "figures/numbers.h"

/// The value of a row, "name,value,unit", of a file of measurements.
static inline double value_in(const char *path, const char *name)
{
    FILE *file = fopen(path, "r");
    ck_assert_msg(file != NULL, "no %s", path);
    char line[512];
    size_t length = strlen(name);
    bool found = false;
    while (!found && fgets(line, sizeof line, file))
        found = strncmp(line, name, length) == 0 && line[length] == ',';
    fclose(file);
    ck_assert_msg(found, "%s has no row '%s'", path, name);
    return strtod(line + length + 1, NULL);
}

static inline double row_value(const char *name)
{
    return value_in("figures/measured/library.csv", name);
}

static inline double methods_value(const char *name)
{
    return value_in("figures/measured/methods.csv", name);
}

#endif

#include "renderer/figure.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum {
    DIGITS_MOST = 17
}; ///< that tell any double from all others

void fig_number(FILE *numbers, const char *key, double value)
{
    char text[64];
    bool whole = value == rint(value) && fabs(value) < 1 / DBL_EPSILON;
    int digits = whole ? DIGITS_MOST : 1;
    do
        snprintf(text, sizeof text, "%.*g", digits, value);
    while (strtod(text, NULL) != value && digits++ < DIGITS_MOST);
    fprintf(numbers, "%s %s\n", key, text);
}

// The numbers that a figure prints, for the tests of figures.  To be included
// first.
#ifndef FIGURES_NUMBERS_H
#define FIGURES_NUMBERS_H

#define _POSIX_C_SOURCE 200809L // open_memstream

#include "kit/figures.h"
#include "support/oracle.h"
#include "support/support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/// What a figure prints when it is drawn in a theme.  The caller frees it.
static inline char *printed_in(const fig_figure *figure, const fig_theme *theme)
{
    fig_page_options options = {.width = figure->width,
                                .height = figure->height,
                                .pixels_x = FIG_PAGE_PIXELS_X,
                                .pixels_y = FIG_PAGE_PIXELS_Y,
                                .theme = theme};
    char *text = NULL;
    size_t size;
    FILE *numbers = open_memstream(&text, &size);
    fig_page *page;
    ck_assert_int_eq(fig_page_new(&options, &page), FIG_OK);
    figure->draw(page, numbers);
    fig_page_free(page);
    fclose(numbers);
    return text;
}

/// The same for both themes, in which it must not differ.
static inline char *printed(const fig_figure *figure)
{
    char *light = printed_in(figure, &fig_theme_light);
    char *dark = printed_in(figure, &fig_theme_dark);
    ck_assert_str_eq(light, dark);
    free(dark);
    return light;
}

/// The number of a key in what was printed.
static inline double number_of(const char *text, const char *key)
{
    size_t length = strlen(key);
    for (const char *line = text; line; line = strchr(line, '\n')) {
        line += *line == '\n';
        if (strncmp(line, key, length) == 0 && line[length] == ' ')
            return strtod(line + length, NULL);
    }
    ck_abort_msg("no number %s in:\n%s", key, text);
}

/// Expect a number up to rounding.
static inline void expect_number(const char *text, const char *key,
                                 double expected)
{
    double found = number_of(text, key);
    ck_assert_msg(fabs(found - expected) <= 1e-12 * fmax(1, fabs(expected)),
                  "%s is %.17g, not %.17g", key, found, expected);
}

/// When two moving elements first meet, as the oracle has it, rounded; -1 if
/// they do not.
static inline double oracle_time(int axes, int vertices,
                                 const tf_worldline first[], int others,
                                 const tf_worldline second[])
{
    mpq_t toi;
    mpq_init(toi);
    bool meet = oracle_meet(axes, vertices, first, others, second, toi);
    double time = meet ? mpq_get_d(toi) : -1;
    mpq_clear(toi);
    return time;
}

/// The suite of a figure's one test.
static inline Suite *suite_of(const char *name, const TTest *test)
{
    Suite *s = suite_create(name);
    TCase *numbers = tcase_create("numbers");
    tcase_add_test(numbers, test);
    suite_add_tcase(s, numbers);
    return s;
}

#endif

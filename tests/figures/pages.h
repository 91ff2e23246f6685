// Pages of figures.
#ifndef FIGURES_PAGES_H
#define FIGURES_PAGES_H

#include "kit/figures.h"

#include <check.h>

/// A page on which a figure is drawn, of its size, whatever the options say of
/// it.  The figure prints to `numbers`, or nowhere if that is NULL.
static inline fig_page *draw_figure(const fig_figure *figure,
                                    fig_page_options options, FILE *numbers)
{
    FILE *nowhere = numbers ? NULL : fopen("/dev/null", "w");
    fig_page *page;
    options.width = figure->width;
    options.height = figure->height;
    ck_assert_int_eq(fig_page_new(&options, &page), FIG_OK);
    figure->draw(page, numbers ? numbers : nowhere);
    if (nowhere)
        fclose(nowhere);
    return page;
}

/// How many figures there are.
static inline int count_figures(void)
{
    int count = 0;
    while (fig_figures[count])
        count++;
    return count;
}

#endif

// How many queries the cubic gets wrong, either way, by its tolerance.
#include "kit/figures.h"

#include "kit/measured.h"
#include "renderer/plot.h"

#include <math.h>
#include <stdio.h>

enum {
    SETS = 3,
    TOLERANCES = 17, ///< 0 and 1e-16 to 1e-1
    ERRORS = 2
};

static const char *const sets[SETS] = {"adversarial", "public", "random"};

static const struct errors {
    const char *name, *title;
    fig_role role;
} errors[ERRORS] = {
    {"missed", "contacts that are missed", FIG_ROLE_CONTACT},
    {"extra", "contacts that are none", FIG_ROLE_EDGE},
};

static const double zero_x = 1e-17, zero_y = 0.4; ///< where zeros are drawn

/// The errors of the cubic on a set with its i-th tolerance.
static double count_of(int set, int error, int i)
{
    if (i == 0)
        return fig_measured("methods cubic 0 %s %s", sets[set],
                            errors[error].name);
    return fig_measured("methods cubic 1e-%02d %s %s", TOLERANCES - i,
                        sets[set], errors[error].name);
}

static double tolerance_of(int i)
{
    return i == 0 ? zero_x : pow(10, i - TOLERANCES);
}

static void draw_errors(fig_page *page, const fig_plot *plot, int set,
                        int error, FILE *numbers)
{
    fig_point at[TOLERANCES];
    double least = INFINITY;
    for (int i = 0; i < TOLERANCES; i++) {
        double count = count_of(set, error, i);
        at[i] = (fig_point){tolerance_of(i), fmax(count, zero_y)};
        least = fmin(least, count);
    }
    // The line begins at the least tolerance that is not zero.
    fig_plot_curve(page, plot, TOLERANCES - 1, at + 1,
                   (fig_stroke){.paint.role = errors[error].role});
    for (int i = 0; i < TOLERANCES; i++)
        fig_plot_dot(page, plot, at[i].x, at[i].y, 3.6, errors[error].role);
    char key[64];
    snprintf(key, sizeof key, "%s_%s_least", sets[set], errors[error].name);
    fig_number(numbers, key, least);
}

/// The least number of errors of both kinds together.
static double least_sum(int set)
{
    double least = INFINITY;
    for (int i = 0; i < TOLERANCES; i++)
        least = fmin(least, count_of(set, 0, i) + count_of(set, 1, i));
    return least;
}

/// The scale of tolerances, and names for the zeros, which have no place on
/// logarithmic scales.
static void draw_scales(fig_page *page, const fig_plot *plot)
{
    static const double tick[] = {1e-11, 1e-6, 1e-1};
    static const char *const name[] = {"$10^{-11}$", "$10^{-6}$", "$10^{-1}$"};
    double foot = plot->box.y + plot->box.height;
    for (int i = 0; i < 3; i++)
        fig_plot_tick(page,
                      (fig_point){fig_plot_place(plot, tick[i], 1).x, foot},
                      name[i]);
    fig_point at = fig_plot_place(plot, zero_x, zero_y);
    fig_plot_tick(page, (fig_point){at.x, foot}, "0");
    fig_page_text(page, plot->box.x + plot->box.width / 2, foot + 30,
                  FIG_ALIGN_CENTER, "tolerance", FIG_LETTERS, FIG_ROLE_INK);
    fig_page_text(page, plot->box.x - 6, at.y + 3, FIG_ALIGN_RIGHT, "0",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    double pitch = (fig_page_width(page) - 20) / SETS;
    for (int s = 0; s < SETS; s++) {
        fig_plot plot = {.box = {pitch * s + 46, 40, pitch - 40, 120},
                         .x = {3e-18, 1},
                         .y = {0.28, 1e5},
                         .log_x = true,
                         .log_y = true,
                         .ticks_x = -1,
                         .name_y = s == 0 ? "queries" : NULL};
        fig_plot_frame(page, &plot);
        draw_scales(page, &plot);
        for (int e = 0; e < ERRORS; e++)
            draw_errors(page, &plot, s, e, numbers);
        char text[40];
        snprintf(text, sizeof text, "*%s*", sets[s]);
        fig_page_title(page, plot.box, text);
        snprintf(text, sizeof text, "%s_least", sets[s]);
        fig_number(numbers, text, least_sum(s));
    }
    for (int e = 0; e < ERRORS; e++)
        fig_plot_key(page, 60 + 150 * e, 14, errors[e].title, errors[e].role);
}

const fig_figure fig_tolerance_errors = {
    .name = "tolerance-errors",
    .title = "Errors of the cubic by its tolerance",
    .width = FIG_PAGE_WIDTH,
    .height = 196,
    .draw = draw,
};

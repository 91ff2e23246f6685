// The kinetic energy of a stack of sheets over time, by three ways to answer
// contacts, in two sizes: what `make measure-resting` has measured.
#include "kit/figures.h"

#include "kit/measured.h"
#include "renderer/plot.h"

#include <math.h>
#include <stdio.h>

enum {
    SIZES = 2,
    WAYS = 3,
    MOST_WINDOWS = 64
};

static const struct {
    const char *name, *key;
    fig_role role;
} way[WAYS] = {
    {"pushed", "velocities with pushes", FIG_ROLE_CONTACT},
    {"unpushed", "without them", FIG_ROLE_OTHER_EDGE},
    {"relaxed", "and with the relaxation", FIG_ROLE_EDGE},
};

static int size_of(int i)
{
    return 10 * (i + 1);
}

static void draw_curve(fig_page *page, const fig_plot *plot, int size, int i)
{
    int window = (int)fig_measured("resting window");
    int count = (int)fig_measured("resting steps") / window;
    fig_point at[MOST_WINDOWS];
    for (int n = 0; n < count && n < MOST_WINDOWS; n++) {
        int end = window * (n + 1);
        at[n] = (fig_point){
            end - window / 2.0,
            fig_measured("resting %d %s kinetic %d", size, way[i].name, end)};
    }
    fig_plot_curve(page, plot, count, at,
                   (fig_stroke){.paint = {.role = way[i].role}, .width = 1.6});
}

static void draw_size(fig_page *page, FILE *numbers, int i)
{
    int size = size_of(i);
    char title[32], key[32];
    snprintf(title, sizeof title, "%d cells a side", size);
    fig_plot plot = {.box = {46 + 184.0 * i, 20, 140, 132},
                     .x = {0, fig_measured("resting steps")},
                     .y = {1e-6, 1},
                     .log_y = true,
                     .ticks_x = 4,
                     .name_x = "step",
                     .name_y = i == 0 ? "kinetic energy, J" : NULL};
    fig_plot_frame(page, &plot);
    fig_page_title(page, plot.box, title);
    for (int k = 0; k < WAYS; k++)
        draw_curve(page, &plot, size, k);
    snprintf(key, sizeof key, "calmer_%d", size);
    fig_number(numbers, key,
               fig_measured("resting %d pushed late", size) /
                   fig_measured("resting %d relaxed late", size));
}

static void draw(fig_page *page, FILE *numbers)
{
    static const double x[WAYS] = {46, 166, 252};
    for (int i = 0; i < SIZES; i++)
        draw_size(page, numbers, i);
    for (int k = 0; k < WAYS; k++)
        fig_plot_key(page, x[k], 194, way[k].key, way[k].role);
    fig_number(numbers, "steps", fig_measured("resting steps"));
}

const fig_figure fig_coming_to_rest = {
    .name = "coming-to-rest",
    .title = "The kinetic energy of a stack in the course of time",
    .width = FIG_PAGE_WIDTH,
    .height = 204,
    .draw = draw,
};

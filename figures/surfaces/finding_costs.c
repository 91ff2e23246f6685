// How long it takes to find the candidates of cloth, and how much memory, by
// the number of its triangles.
#include "kit/figures.h"

#include "kit/measured.h"
#include "renderer/plot.h"

#include <stdio.h>

enum {
    CLOTHS = 2,
    SIZES = 6
};

static const int triangles[SIZES] = {180, 980, 9680, 98000, 994580, 3996180};

static const struct cloth {
    const char *name;
    fig_role role;
} cloths[CLOTHS] = {{"dense", FIG_ROLE_CONTACT}, {"sparse", FIG_ROLE_EDGE}};

/// What is drawn of each cloth.
static const struct measure {
    const char *row, *key, *title;
    double most;
} measures[] = {
    {"finding candidates", "time", "nanoseconds per triangle", 700},
    {"memory", "memory", "bytes per triangle", 700},
};

static void draw_cloth(fig_page *page, const fig_plot *plot, int measure,
                       const struct cloth *cloth, FILE *numbers)
{
    fig_point at[SIZES];
    for (int i = 0; i < SIZES; i++) {
        double value = fig_measured("%s %d %s", cloth->name, triangles[i],
                                    measures[measure].row);
        at[i] = (fig_point){triangles[i], value};
        char key[80];
        snprintf(key, sizeof key, "%s_%s_%d", cloth->name,
                 measures[measure].key, triangles[i]);
        fig_number(numbers, key, value);
    }
    fig_plot_curve(
        page, plot, SIZES, at,
        (fig_stroke){.paint.role = cloth->role, .width = FIG_WIDTH_LINE});
    for (int i = 0; i < SIZES; i++)
        if (at[i].y <= plot->y[1])
            fig_plot_dot(page, plot, at[i].x, at[i].y, 4.6, cloth->role);
}

static void draw(fig_page *page, FILE *numbers)
{
    double side = fig_page_width(page) / 2;
    for (int i = 0; i < 2; i++) {
        fig_plot plot = {.box = {i * side + 38, 22, side - 46, 130},
                         .x = {100, 1e7},
                         .y = {0, measures[i].most},
                         .log_x = true,
                         .name_x = "triangles",
                         .name_y = measures[i].title};
        fig_plot_frame(page, &plot);
        for (int j = 0; j < CLOTHS; j++)
            draw_cloth(page, &plot, i, &cloths[j], numbers);
    }
    for (int j = 0; j < CLOTHS; j++)
        fig_plot_key(page, 44 + 56 * j, 14, cloths[j].name, cloths[j].role);
}

const fig_figure fig_finding_costs = {
    .name = "finding-costs",
    .title = "What finding candidates costs, by the number of triangles",
    .width = FIG_PAGE_WIDTH,
    .height = 188,
    .draw = draw,
};

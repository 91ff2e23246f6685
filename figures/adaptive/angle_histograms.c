// The least angles of triangles of three meshes, before and after.
#include "kit/figures.h"
#include "kit/measured.h"

#include "renderer/plot.h"

enum {
    MESHES = 3,
    ROWS = 2,
    BINS = 12
};

static const char *const meshes[MESHES] = {"clamp", "piston", "fitting"};

static const struct {
    const char *when;
    fig_role role;
} rows[ROWS] = {
    {"before", FIG_ROLE_CONTACT},
    {"after", FIG_ROLE_EDGE},
};

static void draw_bars(fig_page *page, const fig_plot *plot, int mesh, int row)
{
    for (int bin = 0; bin < BINS; bin++)
        fig_plot_bar(page, plot, 5 * bin, 5 * bin + 5,
                     fig_measured("remeshing %s %s %d", meshes[mesh],
                                  rows[row].when, bin),
                     (fig_paint){.role = rows[row].role});
}

static void draw_histogram(fig_page *page, int mesh, int row)
{
    bool last = row == ROWS - 1;
    fig_plot plot = {.box = {46 + 114.0 * mesh, 20 + 92.0 * row, 98, 72},
                     .x = {0, 60},
                     .y = {0, 60},
                     .ticks_x = last ? 3 : -1,
                     .ticks_y = mesh == 0 ? 3 : -1,
                     .name_x = last ? "least angle, degrees" : NULL,
                     .name_y = mesh == 0 ? rows[row].when : NULL};
    draw_bars(page, &plot, mesh, row);
    fig_plot_frame(page, &plot);
    if (row == 0)
        fig_page_title(page, plot.box, meshes[mesh]);
}

static void draw(fig_page *page, FILE *numbers)
{
    for (int mesh = 0; mesh < MESHES; mesh++)
        for (int row = 0; row < ROWS; row++)
            draw_histogram(page, mesh, row);
    fig_number(numbers, "bins", BINS);
}

const fig_figure fig_angle_histograms = {
    .name = "angle-histograms",
    .title = "The least angles of three meshes",
    .width = FIG_PAGE_WIDTH,
    .height = 220,
    .draw = draw,
};

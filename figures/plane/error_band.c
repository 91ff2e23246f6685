// The determinant along one row of the sign maps: the true one, the computed
// one and the bound on the error.
#include "arithmetic/functions.h"
#include "kit/figures.h"

#include "arithmetic/filter.h"
#include "renderer/plot.h"

#include <math.h>

enum {
    ROW = 192,
    CELLS = 256
};

/// The step from a double in [0.5, 1) to the next.
static const double step = 0x1p-53;

/// The line goes through these two points on the diagonal.
static const double near_end = 12, far_end = 24;

/// Computed in doubles, in steps.
static tf_estimate estimate_cell(int i)
{
    tf_event p = {.x = {0.5 + i * step, 0.5 + ROW * step}};
    tf_event q = {.x = {near_end, near_end}}, r = {.x = {far_end, far_end}};
    tf_differences d = {
        .n = 2, .to = {&q, &r}, .from = {&p, &p}, .axis = {0, 1}};
    tf_estimate e = tf_differences_estimate(&d);
    return (tf_estimate){e.number / step, e.bound / step};
}

/// In steps, without error.
static double true_cell(int i)
{
    return (far_end - near_end) * (ROW - i);
}

/// A level line through the plot, and its name at the right.
static void draw_level(fig_page *page, const fig_plot *plot, double y,
                       const char *name, fig_stroke stroke)
{
    fig_plot_curve(page, plot, 2, (fig_point[]){{0, y}, {CELLS, y}}, stroke);
    fig_point right = fig_plot_place(plot, CELLS, y);
    fig_page_text(page, right.x + 4, right.y + 3, FIG_ALIGN_LEFT, name,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw_band(fig_page *page, const fig_plot *plot, double bound)
{
    fig_point corner[4];
    for (int i = 0; i < 4; i++)
        corner[i] = fig_plot_place(plot, i == 0 || i == 3 ? 0 : CELLS,
                                   i < 2 ? bound : -bound);
    fig_page_fill(page, 4, corner,
                  (fig_paint){.role = FIG_ROLE_UNCERTAIN, .opacity = 0.22});
    fig_stroke border = {.paint = {.role = FIG_ROLE_UNCERTAIN},
                         .width = FIG_WIDTH_THIN,
                         .under_labels = true};
    draw_level(page, plot, bound, "$B$", border);
    draw_level(page, plot, -bound, "$-B$", border);
    draw_level(page, plot, 0, "$0$",
               (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                            .width = FIG_WIDTH_HAIR,
                            .under_labels = true});
}

static void draw_truth(fig_page *page, const fig_plot *plot)
{
    fig_point at[2] = {{0, true_cell(0)}, {CELLS - 1, true_cell(CELLS - 1)}};
    fig_plot_curve(page, plot, 2, at, (fig_stroke){.width = FIG_WIDTH_LINE});
    fig_point place = fig_plot_place(plot, 118, true_cell(118));
    fig_page_label(page, place.x, place.y,
                   (fig_label){.text = "true", .side = FIG_SIDE_SW, .gap = 8});
}

/// What the colors of the computed numbers stand for.
static void draw_keys(fig_page *page, const fig_plot *plot)
{
    fig_point at = fig_plot_place(plot, 112, 2550);
    fig_plot_key(page, at.x, at.y, "computed, its sign is certain",
                 FIG_ROLE_POSITIVE);
    fig_plot_key(page, at.x, at.y + 15, "computed, its sign is unknown",
                 FIG_ROLE_UNCERTAIN);
}

/// A dot for each computed number, in the color of what its sign is to be
/// taken for.
static void draw_cell(fig_page *page, const fig_plot *plot, int i)
{
    tf_estimate e = estimate_cell(i);
    fig_role role = e.number > e.bound    ? FIG_ROLE_POSITIVE
                    : -e.number > e.bound ? FIG_ROLE_NEGATIVE
                                          : FIG_ROLE_UNCERTAIN;
    fig_plot_dot(page, plot, i, e.number, 2.6, role);
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_plot plot = {.box = {52, 8, fig_page_width(page) - 84, 168},
                     .x = {0, CELLS},
                     .y = {-2000, 2800},
                     .name_x = "column $i$",
                     .name_y = "determinant, in units of $u$"};
    double bound = estimate_cell(ROW).bound, error = 0;
    draw_band(page, &plot, bound);
    fig_plot_frame(page, &plot);
    draw_truth(page, &plot);
    draw_keys(page, &plot);
    for (int i = 0; i < CELLS; i++) {
        draw_cell(page, &plot, i);
        error = fmax(error, fabs(estimate_cell(i).number - true_cell(i)));
    }
    fig_number(numbers, "bound", bound);
    fig_number(numbers, "error", error);
    // Products between 256 and 512 are so far apart.
    fig_number(numbers, "step", 0x1p-44 / step);
}

const fig_figure fig_error_band = {
    .name = "error-band",
    .title = "A determinant near zero: true, computed and its bound",
    .width = FIG_PAGE_WIDTH,
    .height = 212,
    .draw = draw,
};

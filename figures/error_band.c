// The determinant along one row of the sign maps: the true one, the computed
// one and the bound on the error.
#include "figures.h"

#include "arithmetic/clamped.h"
#include "stage/plot.h"

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
static void draw_level(tf_page *page, const tf_plot *plot, double y,
                       const char *name, tf_stroke stroke)
{
    double at[2][2] = {{0, y}, {CELLS, y}}, right[2];
    tf_plot_curve(page, plot, 2, (const double(*)[2])at, stroke);
    tf_plot_place(plot, CELLS, y, right);
    tf_page_text(page, right[0] + 4, right[1] + 3, TF_ALIGN_LEFT, name,
                 TF_LETTERS_SMALL, TF_ROLE_INK);
}

static void draw_band(tf_page *page, const tf_plot *plot, double bound)
{
    double corner[4][2];
    for (int i = 0; i < 4; i++)
        tf_plot_place(plot, i == 0 || i == 3 ? 0 : CELLS,
                      i < 2 ? bound : -bound, corner[i]);
    tf_page_fill(page, 4, (const double(*)[2])corner,
                 (tf_paint){.role = TF_ROLE_UNCERTAIN, .opacity = 0.22});
    tf_stroke border = {.paint = {.role = TF_ROLE_UNCERTAIN},
                        .width = TF_WIDTH_THIN,
                        .under_labels = true};
    draw_level(page, plot, bound, "$B$", border);
    draw_level(page, plot, -bound, "$-B$", border);
    draw_level(page, plot, 0, "$0$",
               (tf_stroke){.paint = {.role = TF_ROLE_NEUTRAL},
                           .width = TF_WIDTH_HAIR,
                           .under_labels = true});
}

static void draw_truth(tf_page *page, const tf_plot *plot)
{
    double at[2][2] = {{0, true_cell(0)}, {CELLS - 1, true_cell(CELLS - 1)}};
    tf_plot_curve(page, plot, 2, (const double(*)[2])at,
                  (tf_stroke){.width = TF_WIDTH_LINE});
    double place[2];
    tf_plot_place(plot, 20, true_cell(20), place);
    tf_page_label(page, place[0], place[1],
                  (tf_label){.text = "true", .side = TF_SIDE_SW, .gap = 8});
}

/// A dot for each computed number, in the colour of what its sign is to be
/// taken for.
static void draw_cell(tf_page *page, const tf_plot *plot, int i)
{
    tf_estimate e = estimate_cell(i);
    tf_role role = e.number > e.bound    ? TF_ROLE_POSITIVE
                   : -e.number > e.bound ? TF_ROLE_NEGATIVE
                                         : TF_ROLE_UNCERTAIN;
    double place[2];
    tf_plot_place(plot, i, e.number, place);
    tf_page_dot(page, place[0], place[1], 2.6, (tf_paint){.role = role});
}

static void draw(tf_page *page, FILE *numbers)
{
    tf_plot plot = {.box = {52, 8, tf_page_width(page) - 84, 168},
                    .x = {0, CELLS},
                    .y = {-2000, 2800},
                    .name_x = "$i$",
                    .name_y = "determinant, in units of $u$"};
    double bound = estimate_cell(ROW).bound, error = 0;
    draw_band(page, &plot, bound);
    tf_plot_frame(page, &plot);
    draw_truth(page, &plot);
    for (int i = 0; i < CELLS; i++) {
        draw_cell(page, &plot, i);
        error = fmax(error, fabs(estimate_cell(i).number - true_cell(i)));
    }
    tf_figure_number(numbers, "bound", bound);
    tf_figure_number(numbers, "error", error);
    // Products between 256 and 512 are so far apart.
    tf_figure_number(numbers, "step", 0x1p-44 / step);
}

const tf_figure tf_figure_error_band = {
    .name = "error-band",
    .title = "A determinant near zero: true, computed and its bound",
    .width = TF_FIGURE_WIDTH,
    .height = 212,
    .draw = draw,
};

// Axis frames for plots in the plane.
#ifndef FIG_RENDERER_PLOT_H
#define FIG_RENDERER_PLOT_H

#include "renderer/page.h"

enum {
    FIG_GROUPED = 32
}; ///< letters of a number in groups

/// A rectangle of the page with a scale on either side.
typedef struct fig_plot {
    fig_box box;          ///< of the curves, on the page
    double x[2], y[2];    ///< the numbers at its left and right, bottom and top
    bool log_x, log_y;    ///< logarithmic; then the numbers are > 0
    const char *name_x;   ///< below; NULL for none
    const char *name_y;   ///< beside, reading upwards
    int ticks_x, ticks_y; ///< about how many; 0: 5, negative: none
} fig_plot;

/// Draw the frame, ticks at round numbers, and the names.  All that takes
/// FIG_PLOT_ROOM points below the box, and as many to the left of it as long as
/// the numbers have up to two digits; longer ones take more.
void fig_plot_frame(fig_page *page, const fig_plot *plot);
#define FIG_PLOT_ROOM 32.0

/// A point of the plot, in points of the page.
fig_point fig_plot_place(const fig_plot *plot, double x, double y);

/// A dot at a point of the plot, whose place on the page is returned.
fig_point fig_plot_dot(fig_page *page, const fig_plot *plot, double x, double y,
                       double diameter, fig_role role);

/// A thin gray line across the plot at a number of y.
void fig_plot_level(fig_page *page, const fig_plot *plot, double y);

/// A bar between two numbers of x, from 0 up to `height`.
void fig_plot_bar(fig_page *page, const fig_plot *plot, double from, double to,
                  double height, fig_paint paint);

/// A curve through `count` points of the plot; parts out of the box are cut.
void fig_plot_curve(fig_page *page, const fig_plot *plot, int count,
                    const fig_point at[], fig_stroke stroke);

/// A square of a color and, to the right of it, what is drawn in that color.
void fig_plot_key(fig_page *page, double x, double y, const char *text,
                  fig_role role);

/// Write a whole number as the book does: its digits in groups, "-11,972".
void fig_plot_grouped(long number, char text[FIG_GROUPED]);

/// A tick of a scale, down from a point of the page, and its name below.
void fig_plot_tick(fig_page *page, fig_point at, const char *name);

#endif

// Axis frames for plots in the plane.
#ifndef TF_STAGE_PLOT_H
#define TF_STAGE_PLOT_H

#include "stage/page.h"

/// A rectangle of the page with a scale on either side.
typedef struct tf_plot {
    tf_box box;           ///< of the curves, on the page
    double x[2], y[2];    ///< the numbers at its left and right, bottom and top
    bool log_x, log_y;    ///< logarithmic; then the numbers are > 0
    const char *name_x;   ///< below; NULL for none
    const char *name_y;   ///< beside, reading upwards
    int ticks_x, ticks_y; ///< about how many; 0: 5, negative: none
} tf_plot;

/// Draw the frame, ticks at round numbers, and the names.  All that takes
/// TF_PLOT_ROOM points below the box, and as many to the left of it as long as
/// the numbers have up to two digits; longer ones take more.
void tf_plot_frame(tf_page *page, const tf_plot *plot);
#define TF_PLOT_ROOM 32.0

/// A point of the plot, in points of the page.
void tf_plot_place(const tf_plot *plot, double x, double y, double page[2]);

/// A curve through `count` points of the plot; parts out of the box are cut.
void tf_plot_curve(tf_page *page, const tf_plot *plot, int count,
                   const double at[][2], tf_stroke stroke);

#endif

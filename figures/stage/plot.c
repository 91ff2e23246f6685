#include "stage/plot.h"

#include "contract.h"
#include "stage/page_parts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double tick_length = 3;

enum {
    TICKS = 5
}; ///< about how many, unless told

/// Where a number is between the ends of a scale, 0..1.
static double along(const double ends[2], bool logarithmic, double x)
{
    if (logarithmic)
        return log(x / ends[0]) / log(ends[1] / ends[0]);
    return (x - ends[0]) / (ends[1] - ends[0]);
}

void tf_plot_place(const tf_plot *plot, double x, double y, double page[2])
{
    page[0] = plot->box.x + plot->box.width * along(plot->x, plot->log_x, x);
    page[1] =
        plot->box.y + plot->box.height * (1 - along(plot->y, plot->log_y, y));
}

// Ticks ------------------------------------------------------------------

/// A step of 1, 2 or 5 times a power of ten, for about `count` in a range.
static double round_step(double range, int count)
{
    double raw = range / count, power = pow(10, floor(log10(raw)));
    double lead = raw / power;
    return power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
}

static void name_number(double x, bool logarithmic, char *text, size_t size)
{
    if (logarithmic)
        snprintf(text, size, "$10^{%d}$", (int)lround(log10(x)));
    else
        snprintf(text, size, "$%.6g$", x);
}

/// Draw a tick.  Returns the width of its number.
static double draw_tick(tf_page *page, const tf_plot *plot, int axis, double x)
{
    const double *ends = axis == 0 ? plot->x : plot->y;
    bool logarithmic = axis == 0 ? plot->log_x : plot->log_y;
    double at[2][2];
    char text[32];
    name_number(x, logarithmic, text, sizeof text);
    tf_plot_place(plot, axis == 0 ? x : plot->x[0], axis == 0 ? plot->y[0] : x,
                  at[0]);
    at[1][0] = at[0][0] - (axis == 1 ? tick_length : 0);
    at[1][1] = at[0][1] + (axis == 0 ? tick_length : 0);
    if (along(ends, logarithmic, x) < -1e-9 ||
        along(ends, logarithmic, x) > 1 + 1e-9)
        return 0;
    tf_page_line(
        page, 2, (const double(*)[2])at,
        (tf_stroke){.paint.role = TF_ROLE_NEUTRAL, .width = TF_WIDTH_THIN});
    if (axis == 0)
        tf_page_text(page, at[1][0], at[1][1] + TF_LETTERS_SMALL,
                     TF_ALIGN_CENTER, text, TF_LETTERS_SMALL, TF_ROLE_INK);
    else
        tf_page_text(page, at[1][0] - 2, at[1][1] + 0.33 * TF_LETTERS_SMALL,
                     TF_ALIGN_RIGHT, text, TF_LETTERS_SMALL, TF_ROLE_INK);
    double width, height;
    tf_page_measure(page, text, TF_LETTERS_SMALL, &width, &height);
    return width;
}

/// Draw the ticks of an axis.  Returns the width of the widest number.
static double draw_ticks(tf_page *page, const tf_plot *plot, int axis,
                         int count)
{
    const double *ends = axis == 0 ? plot->x : plot->y;
    bool logarithmic = axis == 0 ? plot->log_x : plot->log_y;
    double widest = 0;
    double lo = fmin(ends[0], ends[1]), hi = fmax(ends[0], ends[1]);
    if (logarithmic) {
        int first = (int)ceil(log10(lo) - 1e-9);
        int last = (int)floor(log10(hi) + 1e-9);
        int step = (last - first) / count + 1;
        for (int power = first; power <= last; power += step)
            widest = fmax(widest, draw_tick(page, plot, axis, pow(10, power)));
        return widest;
    }
    double step = round_step(hi - lo, count);
    long first = lround(ceil(lo / step - 1e-9));
    long last = lround(floor(hi / step + 1e-9));
    for (long i = first; i <= last; i++)
        widest = fmax(widest, draw_tick(page, plot, axis, (double)i * step));
    return widest;
}

void tf_plot_frame(tf_page *page, const tf_plot *plot)
{
    const tf_box *box = &plot->box;
    const double corner[3][2] = {{box->x, box->y},
                                 {box->x, box->y + box->height},
                                 {box->x + box->width, box->y + box->height}};
    tf_page_line(
        page, 3, corner,
        (tf_stroke){.paint.role = TF_ROLE_NEUTRAL, .width = TF_WIDTH_THIN});
    if (plot->ticks_x >= 0)
        draw_ticks(page, plot, 0, plot->ticks_x > 0 ? plot->ticks_x : TICKS);
    double beside = 0;
    if (plot->ticks_y >= 0)
        beside = draw_ticks(page, plot, 1,
                            plot->ticks_y > 0 ? plot->ticks_y : TICKS);
    if (plot->name_x != NULL)
        tf_page_text(page, box->x + box->width / 2,
                     box->y + box->height + TF_PLOT_ROOM - 7, TF_ALIGN_CENTER,
                     plot->name_x, TF_LETTERS, TF_ROLE_INK);
    if (plot->name_y != NULL)
        tf_page_text_upwards(page, box->x - tick_length - beside - 8,
                             box->y + box->height / 2, TF_ALIGN_CENTER,
                             plot->name_y, TF_LETTERS, TF_ROLE_INK);
}

// Curves -----------------------------------------------------------------

/// Cut a segment to a box.  False if nothing is left.
static bool cut(const tf_box *box, double from[2], double to[2])
{
    const double lo[2] = {box->x, box->y};
    const double hi[2] = {box->x + box->width, box->y + box->height};
    double begin = 0, end = 1, start[2] = {from[0], from[1]};
    double step[2] = {to[0] - from[0], to[1] - from[1]};
    for (int k = 0; k < 2; k++) {
        if (step[k] == 0 && (from[k] < lo[k] || from[k] > hi[k]))
            return false;
        if (step[k] == 0)
            continue;
        double a = (lo[k] - from[k]) / step[k], b = (hi[k] - from[k]) / step[k];
        begin = fmax(begin, fmin(a, b));
        end = fmin(end, fmax(a, b));
    }
    for (int k = 0; k < 2; k++) {
        to[k] = end < 1 ? start[k] + end * step[k] : to[k];
        from[k] = begin > 0 ? start[k] + begin * step[k] : from[k];
    }
    return begin <= end;
}

void tf_plot_curve(tf_page *page, const tf_plot *plot, int count,
                   const double at[][2], tf_stroke stroke)
{
    TF_REQUIRE(count >= 2);
    double(*run)[2] = malloc((size_t)count * sizeof *run);
    if (run == NULL) {
        tf_page_note(page, TF_STAGE_NO_MEMORY);
        return;
    }
    // A run of points goes on as long as each piece begins where the last one
    // ended; so dashes and joints are those of one line.
    int length = 0;
    for (int i = 0; i + 1 < count; i++) {
        double from[2], to[2];
        tf_plot_place(plot, at[i][0], at[i][1], from);
        tf_plot_place(plot, at[i + 1][0], at[i + 1][1], to);
        bool seen = cut(&plot->box, from, to);
        bool goes_on = seen && length > 0 && from[0] == run[length - 1][0] &&
                       from[1] == run[length - 1][1];
        if (length > 0 && !goes_on) {
            tf_page_line(page, length, (const double(*)[2])run, stroke);
            length = 0;
        }
        if (seen && length == 0)
            memcpy(run[length++], from, sizeof from);
        if (seen)
            memcpy(run[length++], to, sizeof to);
    }
    if (length > 0)
        tf_page_line(page, length, (const double(*)[2])run, stroke);
    free(run);
}

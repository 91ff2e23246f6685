#include "renderer/plot.h"

#include "base/require.h"
#include "renderer/page_parts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

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

fig_point fig_plot_place(const fig_plot *plot, double x, double y)
{
    double right = along(plot->x, plot->log_x, x);
    double up = along(plot->y, plot->log_y, y);
    return (fig_point){plot->box.x + plot->box.width * right,
                       plot->box.y + plot->box.height * (1 - up)};
}

// Ticks ------------------------------------------------------------------

/// A step of 1, 2 or 5 times a power of ten, for about `count` in a range.
static double round_step(double range, int count)
{
    double raw = range / count, power = pow(10, floor(log10(raw)));
    double lead = raw / power;
    return power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
}

void fig_plot_grouped(long number, char text[FIG_GROUPED])
{
    char digits[FIG_GROUPED];
    int count = snprintf(digits, sizeof digits, "%ld", labs(number));
    if (number < 0)
        *text++ = '-';
    for (int i = 0; i < count; i++) {
        if (i > 0 && (count - i) % 3 == 0)
            *text++ = ',';
        *text++ = digits[i];
    }
    *text = '\0';
}

static void name_number(double x, bool logarithmic, char *text, size_t size)
{
    char whole[FIG_GROUPED];
    if (logarithmic) {
        snprintf(text, size, "$10^{%d}$", (int)lround(log10(x)));
    } else if (fabs(x) >= 1000) {
        fig_plot_grouped(lround(x), whole);
        snprintf(text, size, "$%s$", whole);
    } else {
        snprintf(text, size, "$%.6g$", x);
    }
}

/// Draw a tick.  Returns the width of its number.
static double draw_tick(fig_page *page, const fig_plot *plot, int axis,
                        double x)
{
    const double *ends = axis == 0 ? plot->x : plot->y;
    bool logarithmic = axis == 0 ? plot->log_x : plot->log_y;
    if (along(ends, logarithmic, x) < -1e-9 ||
        along(ends, logarithmic, x) > 1 + 1e-9)
        return 0;
    fig_point on = fig_plot_place(plot, axis == 0 ? x : plot->x[0],
                                  axis == 0 ? plot->y[0] : x);
    fig_point off = {on.x - (axis == 1 ? tick_length : 0),
                     on.y + (axis == 0 ? tick_length : 0)};
    fig_page_line(
        page, 2, (fig_point[]){on, off},
        (fig_stroke){.paint.role = FIG_ROLE_NEUTRAL, .width = FIG_WIDTH_THIN});
    char text[FIG_GROUPED + 2];
    name_number(x, logarithmic, text, sizeof text);
    if (axis == 0)
        fig_page_text(page, off.x, off.y + FIG_LETTERS_SMALL, FIG_ALIGN_CENTER,
                      text, FIG_LETTERS_SMALL, FIG_ROLE_INK);
    else
        fig_page_text(page, off.x - 2, off.y + 0.33 * FIG_LETTERS_SMALL,
                      FIG_ALIGN_RIGHT, text, FIG_LETTERS_SMALL, FIG_ROLE_INK);
    double width, height;
    fig_page_measure(page, text, FIG_LETTERS_SMALL, &width, &height);
    return width;
}

/// Draw the ticks of an axis.  Returns the width of the widest number.
static double draw_ticks(fig_page *page, const fig_plot *plot, int axis,
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

void fig_plot_frame(fig_page *page, const fig_plot *plot)
{
    const fig_box *box = &plot->box;
    fig_page_add_plot(page, *box);
    const fig_point corner[] = {{box->x, box->y},
                                {box->x, box->y + box->height},
                                {box->x + box->width, box->y + box->height}};
    fig_page_line(
        page, 3, corner,
        (fig_stroke){.paint.role = FIG_ROLE_NEUTRAL, .width = FIG_WIDTH_THIN});
    if (plot->ticks_x >= 0)
        draw_ticks(page, plot, 0, plot->ticks_x > 0 ? plot->ticks_x : TICKS);
    double beside = 0;
    if (plot->ticks_y >= 0)
        beside = draw_ticks(page, plot, 1,
                            plot->ticks_y > 0 ? plot->ticks_y : TICKS);
    if (plot->name_x != NULL)
        fig_page_text(page, box->x + box->width / 2,
                      box->y + box->height + FIG_PLOT_ROOM - 7,
                      FIG_ALIGN_CENTER, plot->name_x, FIG_LETTERS,
                      FIG_ROLE_INK);
    if (plot->name_y != NULL)
        fig_page_text_upwards(page, box->x - tick_length - beside - 8,
                              box->y + box->height / 2, FIG_ALIGN_CENTER,
                              plot->name_y, FIG_LETTERS, FIG_ROLE_INK);
}

void fig_plot_tick(fig_page *page, fig_point at, const char *name)
{
    const fig_point tick[2] = {at, {at.x, at.y + 4}};
    fig_page_line(
        page, 2, tick,
        (fig_stroke){.paint.role = FIG_ROLE_NEUTRAL, .width = FIG_WIDTH_THIN});
    fig_page_text(page, at.x, at.y + 16, FIG_ALIGN_CENTER, name,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

void fig_plot_key(fig_page *page, double x, double y, const char *text,
                  fig_role role)
{
    fig_page_fill_box(page, (fig_box){x, y - 7, 8, 8},
                      (fig_paint){.role = role});
    fig_page_text(page, x + 13, y, FIG_ALIGN_LEFT, text, FIG_LETTERS_SMALL,
                  FIG_ROLE_INK);
}

// Dots, bars and curves -------------------------------------------------

fig_point fig_plot_dot(fig_page *page, const fig_plot *plot, double x, double y,
                       double diameter, fig_role role)
{
    fig_point at = fig_plot_place(plot, x, y);
    fig_page_dot(page, at.x, at.y, diameter, (fig_paint){.role = role});
    return at;
}

void fig_plot_level(fig_page *page, const fig_plot *plot, double y)
{
    const fig_point at[2] = {{plot->x[0], y}, {plot->x[1], y}};
    fig_plot_curve(
        page, plot, 2, at,
        (fig_stroke){.paint.role = FIG_ROLE_NEUTRAL, .width = FIG_WIDTH_HAIR});
}

void fig_plot_bar(fig_page *page, const fig_plot *plot, double from, double to,
                  double height, fig_paint paint)
{
    fig_point foot = fig_plot_place(plot, from, 0);
    fig_point top = fig_plot_place(plot, to, height);
    fig_box bar = {foot.x, top.y, top.x - foot.x, foot.y - top.y};
    fig_page_fill_box(page, bar, paint);
}

/// Clip a segment to a box.  False if nothing is left.
static bool clip(const fig_box *box, fig_point ends[2])
{
    fig_point from = ends[0], to = ends[1];
    double dx = to.x - from.x, dy = to.y - from.y, part[2];
    if (!fig_box_clip(box, from, to, part))
        return false;
    // An end that is inside stays to the last bit.
    if (part[0] > 0)
        ends[0] = (fig_point){from.x + part[0] * dx, from.y + part[0] * dy};
    if (part[1] < 1)
        ends[1] = (fig_point){from.x + part[1] * dx, from.y + part[1] * dy};
    return true;
}

void fig_plot_curve(fig_page *page, const fig_plot *plot, int count,
                    const fig_point at[], fig_stroke stroke)
{
    TF_REQUIRE(count >= 2);
    fig_point *run = malloc((size_t)count * sizeof *run);
    if (run == NULL) {
        fig_page_note(page, FIG_NO_MEMORY);
        return;
    }
    // A run of points goes on as long as each piece begins where the last one
    // ended; so dashes and joints are those of one line.
    int length = 0;
    for (int i = 0; i + 1 < count; i++) {
        fig_point ends[2] = {fig_plot_place(plot, at[i].x, at[i].y),
                             fig_plot_place(plot, at[i + 1].x, at[i + 1].y)};
        bool seen = clip(&plot->box, ends);
        bool goes_on = seen && length > 0 && ends[0].x == run[length - 1].x &&
                       ends[0].y == run[length - 1].y;
        if (length > 0 && !goes_on) {
            fig_page_line(page, length, run, stroke);
            length = 0;
        }
        if (seen && length == 0)
            run[length++] = ends[0];
        if (seen)
            run[length++] = ends[1];
    }
    if (length > 0)
        fig_page_line(page, length, run, stroke);
    free(run);
}

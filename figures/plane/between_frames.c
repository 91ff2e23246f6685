// A drop falls past a line between two frames, and what space-time makes of
// it.
#include "base/require.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "kit/worlds.h"
#include "query/query.h"
#include "renderer/plot.h"

enum {
    FRAMES = 5
};

/// Where the drop is at first and at last, and the ends of the line.
static const double top = 2, bottom = -3.2, left = -0.55, right = 0.55;

/// What the frames and the plot show of heights.
static const double lowest = -3.7, highest = 2.5;

static const fig_box plot_box = {44, 112, 322, 120};
static const double frame_side = 62, frame_top = 18;

/// The time at which the drop meets the line, counted in frames.
static double find_contact(void)
{
    tf_worldline drop =
        tf_worldline_between(2, (double[]){0, top}, (double[]){0, bottom});
    tf_worldline line[2];
    for (int i = 0; i < 2; i++) {
        double end[2] = {i == 0 ? left : right, 0};
        line[i] = tf_worldline_between(2, end, end);
    }
    tf_contact contact;
    tf_status status = tf_query(&tf_exact, 2, 1, &drop, 2, line, &contact);
    TF_REQUIRE(status == TF_OK && contact.verdict == TF_HIT);
    return fig_toi(&contact) * (FRAMES - 1);
}

static double height_at(double frame)
{
    return top + frame / (FRAMES - 1) * (bottom - top);
}

/// One frame: the line, and the drop above or below it.
static void draw_frame(fig_page *page, double center, int i)
{
    fig_box box = {center - frame_side / 2, frame_top, frame_side, frame_side};
    fig_plot plot = {.box = box, .x = {-1, 1}, .y = {lowest, highest}};
    fig_page_fill_box(page, box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    fig_point end[2] = {fig_plot_place(&plot, left, 0),
                        fig_plot_place(&plot, right, 0)};
    fig_page_line(page, 2, end,
                  (fig_stroke){.paint = {.role = FIG_ROLE_EDGE},
                               .width = FIG_WIDTH_TUBE});
    fig_plot_dot(page, &plot, 0, height_at(i), FIG_WIDTH_BALL, FIG_ROLE_POINT);
    char title[16];
    snprintf(title, sizeof title, "$t = %d$", i);
    fig_page_title(page, box, title);
}

/// A straight line of the plot from the first frame to the last, and its
/// name in the middle between two frames, clear of their lines.
static void draw_path(fig_page *page, const fig_plot *plot, double first,
                      double last, fig_role role, const char *name,
                      fig_point name_at)
{
    fig_point at[2] = {{0, first}, {FRAMES - 1, last}};
    fig_plot_curve(
        page, plot, 2, at,
        (fig_stroke){.paint = {.role = role}, .width = FIG_WIDTH_TUBE});
    fig_point place = fig_plot_place(plot, name_at.x, name_at.y);
    fig_page_text(page, place.x, place.y, FIG_ALIGN_CENTER, name, FIG_LETTERS,
                  role);
}

/// Where the path of the drop passes the times of the frames.
static void draw_moments(fig_page *page, const fig_plot *plot)
{
    for (int i = 0; i < FRAMES; i++) {
        fig_point at[2] = {fig_plot_place(plot, i, highest),
                           fig_plot_place(plot, i, lowest)};
        fig_page_line(page, 2, at,
                      (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                                   .width = FIG_WIDTH_HAIR,
                                   .under_labels = true});
        fig_plot_dot(page, plot, i, height_at(i), FIG_WIDTH_BALL,
                     FIG_ROLE_POINT);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    double toi = find_contact();
    fig_plot plot = {.box = plot_box,
                     .x = {-0.42, FRAMES - 0.58},
                     .y = {lowest, highest},
                     .name_x = "time, in frames",
                     .name_y = "height",
                     .ticks_y = -1};
    fig_plot_frame(page, &plot);
    for (int i = 0; i < FRAMES; i++)
        draw_frame(page, fig_plot_place(&plot, i, 0).x, i);
    draw_path(page, &plot, 0, 0, FIG_ROLE_EDGE, "the line",
              (fig_point){3.5, 0.3});
    draw_path(page, &plot, top, bottom, FIG_ROLE_POINT, "the drop",
              (fig_point){3.5, -1.9});
    draw_moments(page, &plot);
    fig_point at =
        fig_plot_dot(page, &plot, toi, 0, FIG_WIDTH_MARK, FIG_ROLE_CONTACT);
    fig_page_label(page, at.x, at.y,
                   (fig_label){.text = "contact",
                               .role = FIG_ROLE_CONTACT,
                               .side = FIG_SIDE_NE,
                               .gap = 6});
    fig_number(numbers, "toi", toi);
}

const fig_figure fig_between_frames = {
    .name = "between-frames",
    .title = "A drop falls past a line between two frames",
    .width = FIG_PAGE_WIDTH,
    .height = 268,
    .draw = draw,
};

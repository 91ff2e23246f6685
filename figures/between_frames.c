// A drop falls past a line between two pictures, and what space-time makes of
// it.
#include "figures.h"

#include "arithmetic/exact.h"
#include "query/point_edge.h"
#include "stage/plot.h"

enum {
    PICTURES = 5
};

/// Where the drop is at first and at last, and the ends of the line.
static const double top = 2, bottom = -3.2, left = -0.55, right = 0.55;

/// What the pictures and the plot show of heights.
static const double lowest = -3.7, highest = 2.5;

static const tf_box plot_box = {44, 112, 322, 120};
static const double frame_side = 62, frame_top = 18;

/// The time at which the drop meets the line, counted in pictures.
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
    tf_status status = tf_point_edge(&tf_exact, &drop, line, &contact);
    TF_REQUIRE(status == TF_OK && contact.verdict == TF_HIT);
    return (contact.toi_lo + contact.toi_hi) / 2 * (PICTURES - 1);
}

static double height_at(double picture)
{
    return top + picture / (PICTURES - 1) * (bottom - top);
}

/// One picture: the line, and the drop above or below it.
static void draw_picture(tf_page *page, double center, int i)
{
    tf_box box = {center - frame_side / 2, frame_top, frame_side, frame_side};
    tf_plot plot = {.box = box, .x = {-1, 1}, .y = {lowest, highest}};
    double end[2][2], drop[2];
    tf_page_fill_box(page, box,
                     (tf_paint){.role = TF_ROLE_NEUTRAL, .opacity = 0.09});
    tf_plot_place(&plot, left, 0, end[0]);
    tf_plot_place(&plot, right, 0, end[1]);
    tf_page_line(
        page, 2, (const double(*)[2])end,
        (tf_stroke){.paint = {.role = TF_ROLE_EDGE}, .width = TF_WIDTH_TUBE});
    tf_plot_place(&plot, 0, height_at(i), drop);
    tf_page_dot(page, drop[0], drop[1], TF_WIDTH_BALL,
                (tf_paint){.role = TF_ROLE_POINT});
    char title[16];
    snprintf(title, sizeof title, "$t = %d$", i);
    tf_page_title(page, box, title);
}

/// A straight line of the plot from the first picture to the last.
static void draw_path(tf_page *page, const tf_plot *plot, const double y[2],
                      tf_role role, const char *name, tf_side side)
{
    double at[2][2] = {{0, y[0]}, {PICTURES - 1, y[1]}}, end[2];
    tf_plot_curve(page, plot, 2, (const double(*)[2])at,
                  (tf_stroke){.paint = {.role = role}, .width = TF_WIDTH_TUBE});
    tf_plot_place(plot, 3.3, y[0] + 3.3 / (PICTURES - 1) * (y[1] - y[0]), end);
    tf_page_label(
        page, end[0], end[1],
        (tf_label){.text = name, .role = role, .side = side, .gap = 5});
}

/// Where the path of the drop passes the times of the pictures.
static void draw_moments(tf_page *page, const tf_plot *plot)
{
    for (int i = 0; i < PICTURES; i++) {
        double at[2][2], drop[2];
        tf_plot_place(plot, i, highest, at[0]);
        tf_plot_place(plot, i, lowest, at[1]);
        tf_page_line(page, 2, (const double(*)[2])at,
                     (tf_stroke){.paint = {.role = TF_ROLE_NEUTRAL},
                                 .width = TF_WIDTH_HAIR,
                                 .under_labels = true});
        tf_plot_place(plot, i, height_at(i), drop);
        tf_page_dot(page, drop[0], drop[1], TF_WIDTH_BALL,
                    (tf_paint){.role = TF_ROLE_POINT});
    }
}

static void draw(tf_page *page, FILE *numbers)
{
    double toi = find_contact(), at[2];
    tf_plot plot = {.box = plot_box,
                    .x = {-0.42, PICTURES - 0.58},
                    .y = {lowest, highest},
                    .name_x = "time, in pictures",
                    .name_y = "height",
                    .ticks_y = -1};
    tf_plot_frame(page, &plot);
    for (int i = 0; i < PICTURES; i++) {
        tf_plot_place(&plot, i, 0, at);
        draw_picture(page, at[0], i);
    }
    draw_path(page, &plot, (double[]){0, 0}, TF_ROLE_EDGE, "the line",
              TF_SIDE_N);
    draw_path(page, &plot, (double[]){top, bottom}, TF_ROLE_POINT, "the drop",
              TF_SIDE_SW);
    draw_moments(page, &plot);
    tf_plot_place(&plot, toi, 0, at);
    tf_page_dot(page, at[0], at[1], TF_WIDTH_MARK,
                (tf_paint){.role = TF_ROLE_CONTACT});
    tf_page_label(page, at[0], at[1],
                  (tf_label){.text = "contact",
                             .role = TF_ROLE_CONTACT,
                             .side = TF_SIDE_NE,
                             .gap = 6});
    tf_figure_number(numbers, "toi", toi);
}

const tf_figure tf_figure_between_frames = {
    .name = "between-frames",
    .title = "A drop falls past a line between two pictures",
    .width = TF_FIGURE_WIDTH,
    .height = 268,
    .draw = draw,
};

// How much of its displacement each vertex of a triangle has given to a painted
// point by a time: one after another, each as much as the point's coordinate.
#include "kit/figures.h"

#include "renderer/plot.h"

#include <math.h>

enum {
    VERTICES = 3
};

static const double coordinate[VERTICES] = {0.3, 0.45, 0.25};
static const double toi = 0.4;

static const fig_role role[VERTICES] = {FIG_ROLE_EDGE, FIG_ROLE_OTHER_EDGE,
                                        FIG_ROLE_TRIANGLE};

/// When the turn of a vertex begins: after those of all vertices above it.
static double begin_of(int vertex)
{
    double sum = 0;
    for (int i = vertex + 1; i < VERTICES; i++)
        sum += coordinate[i];
    return sum;
}

static double given_by(int vertex, double t)
{
    return fmin(fmax(t - begin_of(vertex), 0), coordinate[vertex]);
}

// Drawing ----------------------------------------------------------------

static void draw_ramp(fig_page *page, const fig_plot *plot, int vertex)
{
    double begin = begin_of(vertex), end = begin + coordinate[vertex];
    const fig_point ramp[] = {
        {0, 0}, {begin, 0}, {end, coordinate[vertex]}, {1, coordinate[vertex]}};
    fig_plot_curve(page, plot, 4, ramp,
                   (fig_stroke){.paint = {.role = role[vertex]}, .width = 1.8});
    static const char *const name[VERTICES] = {"$b_0$", "$b_1$", "$b_2$"};
    double middle = begin + coordinate[vertex] / 2;
    fig_point at = fig_plot_place(plot, middle, coordinate[vertex] / 2);
    fig_page_label(page, at.x, at.y,
                   (fig_label){.text = name[vertex],
                               .role = role[vertex],
                               .side = FIG_SIDE_NW,
                               .gap = 4});
}

/// The dots of the coordinates at t = 1, named to the right of the frame, and
/// those of what has been given at the contact.
static void mark_shares(fig_page *page, const fig_plot *plot, int vertex)
{
    static const char *const name[VERTICES] = {"$w_0$", "$w_1$", "$w_2$"};
    fig_plot_dot(page, plot, toi, given_by(vertex, toi), 5.5, role[vertex]);
    fig_point at =
        fig_plot_dot(page, plot, 1, coordinate[vertex], 5.5, role[vertex]);
    fig_page_text(page, at.x + 9, at.y + 3.5, FIG_ALIGN_LEFT, name[vertex],
                  FIG_LETTERS, role[vertex]);
}

static void mark_contact(fig_page *page, const fig_plot *plot)
{
    fig_point line[2] = {fig_plot_place(plot, toi, 0),
                         fig_plot_place(plot, toi, plot->y[1])};
    fig_page_line(page, 2, line,
                  (fig_stroke){.paint = {.role = FIG_ROLE_CONTACT},
                               .width = FIG_WIDTH_LINE,
                               .dash = 3,
                               .under_labels = true});
    fig_page_text(page, line[1].x + 5, line[1].y + 11, FIG_ALIGN_LEFT,
                  "contact", FIG_LETTERS_SMALL, FIG_ROLE_CONTACT);
}

static void print_numbers(FILE *numbers)
{
    fig_number(numbers, "toi", toi);
    for (int i = 0; i < VERTICES; i++) {
        char key[16];
        snprintf(key, sizeof key, "w_%d", i);
        fig_number(numbers, key, coordinate[i]);
        snprintf(key, sizeof key, "b_%d", i);
        fig_number(numbers, key, given_by(i, toi));
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = fig_page_width(page), height = fig_page_height(page);
    fig_plot plot = {.box = {48, 8, width - 86, height - 46},
                     .x = {0, 1},
                     .y = {0, 0.55},
                     .name_x = "time $t$",
                     .name_y = "share $b_i(t)$"};
    fig_plot_frame(page, &plot);
    mark_contact(page, &plot);
    for (int i = 0; i < VERTICES; i++)
        draw_ramp(page, &plot, i);
    for (int i = 0; i < VERTICES; i++)
        mark_shares(page, &plot, i);
    print_numbers(numbers);
}

const fig_figure fig_shares_over_time = {
    .name = "shares-over-time",
    .title = "How the shares of a triangle's vertices come in over time",
    .width = FIG_PAGE_WIDTH,
    .height = 176,
    .draw = draw,
};

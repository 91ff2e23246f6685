// The middle of an edge, which hardly ever is a double: a few doubles of the
// plane, enlarged, and how many middles are exact, by the edges' lengths.
#include "kit/figures.h"
#include "kit/random.h"

#include "renderer/plot.h"

#include <math.h>
#include <stdint.h>

enum {
    COLUMNS = 8,
    ROWS = 7,
    EDGES = 40000, ///< for each dot
    DOTS = 9
};

/// The ends of the edge that is shown, in cells.
static const int shown[2][2] = {{0, 1}, {7, 4}};

static const double printed_length = 0.02;

// Measuring -------------------------------------------------------------------

static double between(uint64_t *state, double low, double high)
{
    return low + (high - low) * fig_random_number(state);
}

/// Whether the half of a + b is a double: the error of the rounded sum is zero.
static bool has_middle(double a, double b)
{
    double sum = a + b, part = sum - a;
    return (a - (sum - part)) + (b - part) == 0;
}

/// An end in the unit cube, and another one at that distance.
static bool random_middle_is_exact(uint64_t *state, double length)
{
    double way[3], square = 0;
    do {
        square = 0;
        for (int k = 0; k < 3; k++) {
            way[k] = between(state, -1, 1);
            square += way[k] * way[k];
        }
    } while (square > 1 || square == 0);
    bool exact = true;
    for (int k = 0; k < 3; k++) {
        double a = between(state, 0, 1);
        exact &= has_middle(a, a + length * way[k] / sqrt(square));
    }
    return exact;
}

/// How many percent of the middles are exact.
static double percentage(double length)
{
    uint64_t state = 21;
    int exact = 0;
    for (int i = 0; i < EDGES; i++)
        exact += random_middle_is_exact(&state, length);
    return 100.0 * exact / EDGES;
}

// Drawing ---------------------------------------------------------------------

static void draw_lattice(fig_page *page, const fig_plot *plot)
{
    for (int i = 0; i < COLUMNS; i++)
        for (int j = 0; j < ROWS - 1; j++)
            fig_plot_dot(page, plot, i, j, 2.6, FIG_ROLE_NEUTRAL);
    fig_point end[2], middle = {0, 0};
    for (int i = 0; i < 2; i++) {
        end[i] = fig_plot_place(plot, shown[i][0], shown[i][1]);
        middle.x += shown[i][0] / 2.0;
        middle.y += shown[i][1] / 2.0;
    }
    fig_page_line(page, 2, end,
                  (fig_stroke){.paint = {.role = FIG_ROLE_EDGE},
                               .width = FIG_WIDTH_LINE});
    for (int i = 0; i < 2; i++)
        fig_plot_dot(page, plot, shown[i][0], shown[i][1], 5, FIG_ROLE_EDGE);
    fig_plot_dot(page, plot, middle.x, middle.y, 5, FIG_ROLE_POINT);
    // Halves are rounded to even.
    fig_point place = {2 * rint(middle.x / 2), 2 * rint(middle.y / 2)};
    fig_point way[2] = {fig_plot_place(plot, middle.x, middle.y),
                        fig_plot_place(plot, place.x, place.y)};
    fig_page_line(page, 2, way,
                  (fig_stroke){.paint = {.role = FIG_ROLE_POINT},
                               .width = FIG_WIDTH_THIN,
                               .arrow = true});
    fig_page_label(page, way[0].x, way[0].y,
                   (fig_label){.text = "middle",
                               .size = FIG_LETTERS_SMALL,
                               .role = FIG_ROLE_POINT,
                               .side = FIG_SIDE_SE});
    fig_page_label(page, end[0].x, end[0].y,
                   (fig_label){.text = "$a$", .side = FIG_SIDE_N, .gap = 4});
    fig_page_label(page, end[1].x, end[1].y,
                   (fig_label){.text = "$b$", .side = FIG_SIDE_N, .gap = 4});
}

static void draw_shares(fig_page *page, const fig_plot *plot, FILE *numbers)
{
    double least = 100, most = 0;
    for (int i = 0; i < DOTS; i++) {
        double length = pow(10, -0.5 * i), share = percentage(length);
        least = fmin(least, share);
        most = fmax(most, share);
        fig_plot_dot(page, plot, length, share, FIG_WIDTH_BALL - 1,
                     FIG_ROLE_EDGE);
    }
    fig_number(numbers, "length", printed_length);
    fig_number(numbers, "exact", percentage(printed_length));
    fig_number(numbers, "least", least);
    fig_number(numbers, "most", most);
    fig_number(numbers, "edges", EDGES);
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_plot picture = {
        .box = {4, 8, 160, 130}, .x = {-0.6, 7.6}, .y = {-0.8, 5.9}};
    fig_plot plot = {.box = {222, 8, 154, 126},
                     .x = {5e-5, 2},
                     .y = {0, 30},
                     .log_x = true,
                     .name_x = "length of the edge",
                     .name_y = "% of exact middles"};
    draw_lattice(page, &picture);
    fig_plot_frame(page, &plot);
    draw_shares(page, &plot, numbers);
}

const fig_figure fig_rounded_midpoints = {
    .name = "rounded-midpoints",
    .title = "Midpoints of edges that are no doubles",
    .width = FIG_PAGE_WIDTH,
    .height = 168,
    .draw = draw,
};

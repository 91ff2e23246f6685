// Time per query of every arithmetic on every workload: of doubles, and of the
// same queries rounded to the grid of the integers.
#include "kit/figures.h"

#include "kit/measured.h"
#include "renderer/plot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    PANELS = 2,
    ARITHMETICS = 5,
    MIDDLE_LANE = ARITHMETICS / 2
};

static const double dot = 4.6, lane = 0.16, names_width = 56, gap = 12;

/// What a panel shows: integers take part only where coordinates are integers.
static const struct input {
    const char *title, *prefix;
    int arithmetics;
} inputs[PANELS] = {
    {"doubles", "", ARITHMETICS - 2},
    {"the same, on the grid", "rounded ", ARITHMETICS},
};

static const struct contender {
    const char *name;
    fig_role role;
} contenders[ARITHMETICS] = {
    {"clamped", FIG_ROLE_NEUTRAL}, {"exact", FIG_ROLE_CONTACT},
    {"perturbed", FIG_ROLE_POINT}, {"integer64", FIG_ROLE_TRIANGLE},
    {"integer128", FIG_ROLE_EDGE},
};

/// The middle of a row, 0 the topmost; rows of one work are side by side.
static double height_of(int row)
{
    return FIG_WORKLOADS - row - 0.5 + (row % 2 == 0 ? -0.05 : 0.05);
}

/// The lattice is on the grid as it is.
static bool is_lattice(int row)
{
    return strcmp(fig_workloads[row].work, "lattice") == 0;
}

static const char *prefix_of(int row, int panel)
{
    return is_lattice(row) ? "" : inputs[panel].prefix;
}

/// Whether a panel has dots in a row.
static bool is_shown(int row, int panel)
{
    return panel > 0 || !is_lattice(row);
}

/// Nanoseconds a query.
static double time_of(int row, int panel, int arithmetic)
{
    return fig_measured("%s %s%s %s", contenders[arithmetic].name,
                        prefix_of(row, panel), fig_workloads[row].work,
                        fig_workloads[row].kind);
}

/// A band for each workload.
static void draw_row(fig_page *page, const fig_plot *plot, int row)
{
    static const double half = 0.44;
    fig_point top = fig_plot_place(plot, plot->x[0], height_of(row) + half);
    fig_point foot = fig_plot_place(plot, plot->x[1], height_of(row) - half);
    fig_page_fill_box(page,
                      (fig_box){top.x, top.y, foot.x - top.x, foot.y - top.y},
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.13});
}

/// Each arithmetic has a lane of its own in the row.
static void draw_dots(fig_page *page, const fig_plot *plot, int row, int panel)
{
    for (int i = 0; i < inputs[panel].arithmetics; i++) {
        double height = height_of(row) + lane * (MIDDLE_LANE - i);
        fig_plot_dot(page, plot, time_of(row, panel, i), height, dot,
                     contenders[i].role);
    }
}

/// Vertical lines at 1, 2 and 5 times the powers of ten, named.
static void draw_scale(fig_page *page, const fig_plot *plot)
{
    static const double leads[] = {1, 2, 5};
    for (int power = 0; pow(10, power) <= plot->x[1]; power++)
        for (int i = 0; i < 3; i++) {
            double x = leads[i] * pow(10, power);
            if (x < plot->x[0] || x > plot->x[1])
                continue;
            fig_point at[2] = {fig_plot_place(plot, x, plot->y[1]),
                               fig_plot_place(plot, x, plot->y[0])};
            fig_page_line(page, 2, at,
                          (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL,
                                                 .opacity = 0.5},
                                       .width = FIG_WIDTH_HAIR});
            char name[FIG_GROUPED];
            fig_plot_grouped(lround(x), name);
            fig_page_text(page, at[1].x, at[1].y + 12, FIG_ALIGN_CENTER, name,
                          FIG_LETTERS_SMALL, FIG_ROLE_INK);
        }
}

static void draw_key(fig_page *page, double x, double y)
{
    for (int i = 0; i < ARITHMETICS; i++) {
        double width, height;
        fig_page_dot(page, x, y - 3, dot,
                     (fig_paint){.role = contenders[i].role});
        fig_page_text(page, x + 6, y, FIG_ALIGN_LEFT, contenders[i].name,
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
        fig_page_measure(page, contenders[i].name, FIG_LETTERS_SMALL, &width,
                         &height);
        x += width + 20;
    }
}

/// The time, and how many of the queries were not found apart.
static void print_numbers(FILE *numbers, int row, int panel, int arithmetic)
{
    const fig_workload *w = &fig_workloads[row];
    const char *name = contenders[arithmetic].name;
    const char *prefix = prefix_of(row, panel);
    const struct {
        const char *ending;
        double value;
    } number[] = {
        {"", time_of(row, panel, arithmetic)},
        {"_hits",
         fig_measured("%s %s%s %s hits", name, prefix, w->work, w->kind)},
        {"_queries", fig_measured("%s%s %s queries", prefix, w->work, w->kind)},
    };
    for (int i = 0; i < 3; i++) {
        char key[80];
        snprintf(key, sizeof key, "%s%s_%s_%s%s", *prefix ? "rounded_" : "",
                 w->work, w->letters, name, number[i].ending);
        fig_number(numbers, key, number[i].value);
    }
}

/// Print all numbers, and find the range of the times.
static void find_range(FILE *numbers, double range[2])
{
    range[0] = INFINITY, range[1] = 0;
    for (int panel = 0; panel < PANELS; panel++)
        for (int row = 0; row < FIG_WORKLOADS; row++)
            for (int i = 0; i < inputs[panel].arithmetics; i++) {
                if (!is_shown(row, panel))
                    continue;
                double time = time_of(row, panel, i);
                range[0] = fmin(range[0], time);
                range[1] = fmax(range[1], time);
                print_numbers(numbers, row, panel, i);
            }
}

static void draw_panel(fig_page *page, int panel, const double range[2])
{
    double width = (fig_page_width(page) - names_width - gap - 8) / PANELS;
    fig_plot plot = {
        .box = {names_width + panel * (width + gap), 42, width, 224},
        .x = {range[0] / 1.2, range[1] * 1.2},
        .y = {0, FIG_WORKLOADS},
        .log_x = true,
        .name_x = "nanoseconds a query",
        .ticks_x = -1,
        .ticks_y = -1};
    for (int row = 0; row < FIG_WORKLOADS; row++)
        if (is_shown(row, panel))
            draw_row(page, &plot, row);
    draw_scale(page, &plot);
    for (int row = 0; row < FIG_WORKLOADS; row++)
        if (is_shown(row, panel))
            draw_dots(page, &plot, row, panel);
    fig_plot_frame(page, &plot);
    fig_page_text(page, plot.box.x + width / 2, plot.box.y - 6,
                  FIG_ALIGN_CENTER, inputs[panel].title, FIG_LETTERS,
                  FIG_ROLE_INK);
    for (int row = 0; row < FIG_WORKLOADS && panel == 0; row++)
        fig_name_workload(page, plot.box.x - 6,
                          fig_plot_place(&plot, range[0], height_of(row)).y + 3,
                          &fig_workloads[row]);
}

static void draw(fig_page *page, FILE *numbers)
{
    double range[2];
    find_range(numbers, range);
    for (int panel = 0; panel < PANELS; panel++)
        draw_panel(page, panel, range);
    draw_key(page, names_width + 8, 14);
}

const fig_figure fig_sign_costs = {
    .name = "sign-costs",
    .title = "What every arithmetic costs, by workload",
    .width = FIG_PAGE_WIDTH,
    .height = 302,
    .draw = draw,
};

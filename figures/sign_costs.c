// Time per query of every arithmetic on every workload.
#include "figures.h"

#include "measured.h"
#include "stage/plot.h"

#include <math.h>
#include <string.h>

enum {
    ARITHMETICS = 5,
    MIDDLE_LANE = ARITHMETICS / 2,
    ROWS = 8
};

static const double dot = 4.6, lane = 0.16;

static const struct contender {
    const char *name;
    tf_role role;
} contenders[ARITHMETICS] = {
    {"clamped", TF_ROLE_NEUTRAL}, {"exact", TF_ROLE_CONTACT},
    {"perturbed", TF_ROLE_POINT}, {"integer64", TF_ROLE_TRIANGLE},
    {"integer128", TF_ROLE_EDGE},
};

/// The middle of a row, 0 the topmost; pairs of rows stand together.
static double height_of(int row)
{
    return ROWS - row - 0.5 + (row % 2 == 0 ? -0.05 : 0.05);
}

static int row_of(const tf_query_time *timed, const tf_query_time *first)
{
    int row = 0;
    for (const tf_query_time *t = first + 1; t <= timed; t++)
        row += strcmp(t->work, t[-1].work) != 0 ||
               strcmp(t->kind, t[-1].kind) != 0;
    return row;
}

/// A band with the workload's name beside it.
static void draw_row(tf_page *page, const tf_plot *plot,
                     const tf_query_time *timed, int row)
{
    static const double half = 0.44;
    double top[2], foot[2];
    tf_plot_place(plot, plot->x[0], height_of(row) + half, top);
    tf_plot_place(plot, plot->x[1], height_of(row) - half, foot);
    tf_page_fill_box(
        page, (tf_box){top[0], top[1], foot[0] - top[0], foot[1] - top[1]},
        (tf_paint){.role = TF_ROLE_NEUTRAL, .opacity = 0.13});
    tf_name_workload(page, top[0] - 6, (top[1] + foot[1]) / 2 + 3, timed->work,
                     timed->kind);
}

/// Each arithmetic has a lane of its own in the row.
static void draw_dot(tf_page *page, const tf_plot *plot,
                     const tf_query_time *timed, int row)
{
    double at[2];
    for (int i = 0; i < ARITHMETICS; i++)
        if (strcmp(timed->arithmetic, contenders[i].name) == 0) {
            double height = height_of(row) + lane * (MIDDLE_LANE - i);
            tf_plot_place(plot, timed->time, height, at);
            tf_page_dot(page, at[0], at[1], dot,
                        (tf_paint){.role = contenders[i].role});
        }
}

/// Vertical lines at 1, 2 and 5 times the powers of ten, named.
static void draw_scale(tf_page *page, const tf_plot *plot)
{
    static const double leads[] = {1, 2, 5};
    for (int power = 0; pow(10, power) <= plot->x[1]; power++)
        for (int i = 0; i < 3; i++) {
            double x = leads[i] * pow(10, power), at[2][2];
            if (x < plot->x[0] || x > plot->x[1])
                continue;
            tf_plot_place(plot, x, plot->y[1], at[0]);
            tf_plot_place(plot, x, plot->y[0], at[1]);
            tf_page_line(
                page, 2, (const double(*)[2])at,
                (tf_stroke){.paint = {.role = TF_ROLE_NEUTRAL, .opacity = 0.5},
                            .width = TF_WIDTH_HAIR});
            char name[32];
            snprintf(name, sizeof name, "%g", x);
            tf_page_text(page, at[1][0], at[1][1] + 12, TF_ALIGN_CENTER, name,
                         TF_LETTERS_SMALL, TF_ROLE_INK);
        }
}

static void draw_key(tf_page *page, double x, double y)
{
    for (int i = 0; i < ARITHMETICS; i++) {
        double width, height;
        tf_page_dot(page, x, y - 3, dot,
                    (tf_paint){.role = contenders[i].role});
        tf_page_text(page, x + 6, y, TF_ALIGN_LEFT, contenders[i].name,
                     TF_LETTERS_SMALL, TF_ROLE_INK);
        tf_page_measure(page, contenders[i].name, TF_LETTERS_SMALL, &width,
                        &height);
        x += width + 20;
    }
}

/// The time, and how many of the queries were not found apart.
static void print_numbers(FILE *numbers, const tf_query_time *timed)
{
    char key[80];
    int length = snprintf(key, sizeof key, "%s_%s_%s", timed->work,
                          tf_kind_letters(timed->kind), timed->arithmetic);
    tf_figure_number(numbers, key, timed->time);
    char *end = key + length;
    snprintf(end, sizeof key - (size_t)length, "_hits");
    tf_figure_number(numbers, key, (double)timed->hits);
    snprintf(end, sizeof key - (size_t)length, "_queries");
    tf_figure_number(numbers, key, (double)timed->queries);
}

static void draw(tf_page *page, FILE *numbers)
{
    int count;
    const tf_query_time *timed = tf_measured_queries(&count);
    double least = INFINITY, most = 0;
    for (int i = 0; i < count; i++) {
        least = fmin(least, timed[i].time);
        most = fmax(most, timed[i].time);
        print_numbers(numbers, &timed[i]);
    }
    tf_plot plot = {.box = {64, 24, tf_page_width(page) - 80, 224},
                    .x = {least / 1.3, most * 1.3},
                    .y = {0, ROWS},
                    .log_x = true,
                    .name_x = "nanoseconds a query",
                    .ticks_x = -1,
                    .ticks_y = -1};
    for (int i = 0; i < count; i++)
        if (i == 0 || row_of(&timed[i], timed) != row_of(&timed[i - 1], timed))
            draw_row(page, &plot, &timed[i], row_of(&timed[i], timed));
    draw_scale(page, &plot);
    for (int i = 0; i < count; i++)
        draw_dot(page, &plot, &timed[i], row_of(&timed[i], timed));
    tf_plot_frame(page, &plot);
    draw_key(page, plot.box.x + 4, 14);
}

const tf_figure tf_figure_sign_costs = {
    .name = "sign-costs",
    .title = "What every arithmetic costs, by workload",
    .width = TF_FIGURE_WIDTH,
    .height = 284,
    .draw = draw,
};

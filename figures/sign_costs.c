// Time per query of every arithmetic on every workload.
#include "figures.h"

#include "measured.h"
#include "stage/plot.h"

#include <math.h>
#include <string.h>

enum {
    ARITHMETICS = 5,
    ROWS = 8
};

#define DOT 6.0

static const struct contender {
    const char *name;
    tf_role role;
    double diameter;
} contenders[ARITHMETICS] = {
    {"clamped", TF_ROLE_NEUTRAL, DOT}, {"exact", TF_ROLE_CONTACT, DOT},
    {"perturbed", TF_ROLE_POINT, 3.6}, {"integer64", TF_ROLE_TRIANGLE, DOT},
    {"integer128", TF_ROLE_EDGE, 3.6},
};

/// The middle of a row, 0 the topmost; pairs of rows stand together.
static double height_of(int row)
{
    return ROWS - row - 0.5 + (row % 2 == 0 ? -0.12 : 0.12);
}

static int row_of(const tf_query_time *timed, const tf_query_time *first)
{
    int row = 0;
    for (const tf_query_time *t = first + 1; t <= timed; t++)
        row += strcmp(t->work, t[-1].work) != 0 ||
               strcmp(t->kind, t[-1].kind) != 0;
    return row;
}

static void draw_row(tf_page *page, const tf_plot *plot,
                     const tf_query_time *timed, int row)
{
    double line[2][2] = {{plot->x[0], height_of(row)},
                         {plot->x[1], height_of(row)}};
    double at[2];
    tf_plot_curve(
        page, plot, 2, (const double(*)[2])line,
        (tf_stroke){.paint.role = TF_ROLE_NEUTRAL, .width = TF_WIDTH_HAIR});
    tf_plot_place(plot, plot->x[0], height_of(row), at);
    tf_name_workload(page, at[0] - 6, at[1] + 3, timed->work, timed->kind);
}

static void draw_dot(tf_page *page, const tf_plot *plot,
                     const tf_query_time *timed, int row)
{
    double at[2];
    for (int i = 0; i < ARITHMETICS; i++)
        if (strcmp(timed->arithmetic, contenders[i].name) == 0) {
            tf_plot_place(plot, timed->time, height_of(row), at);
            tf_page_dot(page, at[0], at[1], contenders[i].diameter,
                        (tf_paint){.role = contenders[i].role});
        }
}

static void draw_key(tf_page *page, double x, double y)
{
    for (int i = 0; i < ARITHMETICS; i++) {
        double width, height;
        tf_page_dot(page, x, y - 3, contenders[i].diameter,
                    (tf_paint){.role = contenders[i].role});
        tf_page_text(page, x + 6, y, TF_ALIGN_LEFT, contenders[i].name,
                     TF_LETTERS_SMALL, TF_ROLE_INK);
        tf_page_measure(page, contenders[i].name, TF_LETTERS_SMALL, &width,
                        &height);
        x += width + 20;
    }
}

static void print_number(FILE *numbers, const tf_query_time *timed)
{
    char key[80];
    bool points = strcmp(timed->kind, "point-triangle") == 0;
    snprintf(key, sizeof key, "%s_%s_%s", timed->work, points ? "pt" : "ee",
             timed->arithmetic);
    tf_figure_number(numbers, key, timed->time);
}

static void draw(tf_page *page, FILE *numbers)
{
    int count;
    const tf_query_time *timed = tf_measured_queries(&count);
    double least = INFINITY, most = 0;
    for (int i = 0; i < count; i++) {
        least = fmin(least, timed[i].time);
        most = fmax(most, timed[i].time);
        print_number(numbers, &timed[i]);
    }
    tf_plot plot = {.box = {64, 24, tf_page_width(page) - 80, 176},
                    .x = {least / 1.3, most * 1.3},
                    .y = {0, ROWS},
                    .log_x = true,
                    .name_x = "nanoseconds a query",
                    .ticks_y = -1};
    for (int i = 0; i < count; i++)
        if (i == 0 || row_of(&timed[i], timed) != row_of(&timed[i - 1], timed))
            draw_row(page, &plot, &timed[i], row_of(&timed[i], timed));
    for (int i = 0; i < count; i++)
        draw_dot(page, &plot, &timed[i], row_of(&timed[i], timed));
    tf_plot_frame(page, &plot);
    draw_key(page, plot.box.x + 4, 14);
}

const tf_figure tf_figure_sign_costs = {
    .name = "sign-costs",
    .title = "What every arithmetic costs, by workload",
    .width = TF_FIGURE_WIDTH,
    .height = 236,
    .draw = draw,
};

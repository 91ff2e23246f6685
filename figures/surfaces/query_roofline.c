// Time against bytes: what a query takes if it must be read, and what it takes
// if it is there already.
#include "kit/figures.h"

#include "kit/measured.h"
#include "renderer/plot.h"

#include <math.h>
#include <stdio.h>

enum {
    KINDS = 2
};

/// What a query has in a block.
static const double query_bytes = 192;

static const struct kind {
    const char *key, *name;
    fig_role role;
} kinds[KINDS] = {{"pt", "point-triangle", FIG_ROLE_POINT},
                  {"ee", "edge-edge", FIG_ROLE_EDGE}};

/// What is a dot at the bytes of a query; kinds are side by side.
static const struct way {
    const char *key, *row, *name;
    fig_side side;
} ways[] = {{"vector", "vector", "gathered by indices", FIG_SIDE_E},
            {"streaming", "filter streaming", "streaming", FIG_SIDE_E}};

enum {
    WAYS = sizeof ways / sizeof *ways
};

static double time_of(const char *row, int kind)
{
    return fig_measured("%s near %s", row, kinds[kind].name);
}

/// Nanoseconds that reading a byte takes.
static double byte_time(void)
{
    return time_of("read", 0) / query_bytes;
}

/// At so many bytes reading takes as long as the filter in the cache.
static double balance_of(int kind)
{
    return time_of("filter in cache", kind) / byte_time();
}

/// What memory allows, and what the arithmetic of a kind does.
static void draw_memory(fig_page *page, const fig_plot *plot)
{
    double most = fmin(plot->x[1], plot->y[1] / byte_time());
    fig_point at[2] = {{0, 0}, {most, byte_time() * most}};
    fig_plot_curve(
        page, plot, 2, at,
        (fig_stroke){.paint.role = FIG_ROLE_NEUTRAL, .width = FIG_WIDTH_THIN});
    fig_point place = fig_plot_place(plot, 70, byte_time() * 70);
    fig_page_label(page, place.x, place.y,
                   (fig_label){.text = "reading",
                               .side = FIG_SIDE_SE,
                               .size = FIG_LETTERS_SMALL,
                               .gap = 4});
}

static void draw_roof(fig_page *page, const fig_plot *plot, int kind)
{
    double level = time_of("filter in cache", kind);
    double most = plot->x[1], turn = fmin(balance_of(kind), most);
    fig_point at[3] = {
        {0, level}, {turn, level}, {most, fmax(level, byte_time() * most)}};
    fig_plot_curve(page, plot, 3, at,
                   (fig_stroke){.paint.role = kinds[kind].role,
                                .width = FIG_WIDTH_LINE,
                                .under_labels = true});
}

/// Names the levels of both kinds, above the higher one.
static void name_levels(fig_page *page, const fig_plot *plot)
{
    double highest =
        fmax(time_of("filter in cache", 0), time_of("filter in cache", 1));
    fig_point place = fig_plot_place(plot, 6, highest);
    fig_page_text(page, place.x, place.y - 4, FIG_ALIGN_LEFT, "in the cache",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw_way(fig_page *page, const fig_plot *plot,
                     const struct way *way, FILE *numbers)
{
    for (int kind = 0; kind < KINDS; kind++) {
        double time = time_of(way->row, kind);
        fig_point at =
            fig_plot_dot(page, plot, query_bytes, time, 6.5, kinds[kind].role);
        if (kind == KINDS - 1)
            fig_page_label(page, at.x, at.y,
                           (fig_label){.text = way->name,
                                       .side = way->side,
                                       .size = FIG_LETTERS_SMALL,
                                       .gap = 7,
                                       .leader = true});
        char key[48];
        snprintf(key, sizeof key, "%s_%s", kinds[kind].key, way->key);
        fig_number(numbers, key, time);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    double highest = fmax(time_of("vector", 0), time_of("vector", 1));
    fig_plot plot = {.box = {40, 26, fig_page_width(page) - 54, 160},
                     .x = {0, 320},
                     .y = {0, 1.2 * highest},
                     .name_x = "bytes of a query",
                     .name_y = "nanoseconds a query"};
    fig_plot_frame(page, &plot);
    draw_memory(page, &plot);
    for (int kind = 0; kind < KINDS; kind++) {
        draw_roof(page, &plot, kind);
        fig_plot_key(page, 52 + 110 * kind, 14, kinds[kind].name,
                     kinds[kind].role);
        char key[32];
        snprintf(key, sizeof key, "%s_balance", kinds[kind].key);
        fig_number(numbers, key, balance_of(kind));
        snprintf(key, sizeof key, "%s_cache", kinds[kind].key);
        fig_number(numbers, key, time_of("filter in cache", kind));
    }
    name_levels(page, &plot);
    for (int i = 0; i < WAYS; i++)
        draw_way(page, &plot, &ways[i], numbers);
    fig_number(numbers, "read", time_of("read", 0));
    fig_number(numbers, "bytes", query_bytes);
}

const fig_figure fig_query_roofline = {
    .name = "query-roofline",
    .title = "What a query takes, against its bytes",
    .width = FIG_PAGE_WIDTH,
    .height = 222,
    .draw = draw,
};

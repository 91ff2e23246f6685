// Where the time of a detection goes.
#include "kit/figures.h"

#include "kit/measured.h"
#include "renderer/plot.h"

#include <math.h>
#include <stdio.h>

enum {
    CLOTHS = 3,
    PARTS = 4
};

static const double bar = 20, step = 34, names_width = 62, totals_width = 74;

static const struct cloth {
    const char *name;
    int triangles;
} cloths[CLOTHS] = {{"sparse", 994580}, {"dense", 994580}, {"crowded", 98000}};

static const struct part {
    const char *key, *name;
    fig_paint paint;
} parts[PARTS] = {
    {"trees", "boxes and trees", {.role = FIG_ROLE_NEUTRAL}},
    {"joins", "joins", {.role = FIG_ROLE_EDGE}},
    {"deciding", "deciding", {.role = FIG_ROLE_TRIANGLE}},
    {"describing", "describing", {.role = FIG_ROLE_CONTACT}},
};

/// Nanoseconds a triangle; returns the sum.
static double times_of(const struct cloth *cloth, double time[PARTS])
{
    const char *name = cloth->name;
    int triangles = cloth->triangles;
    double trees = fig_measured("%s %d boxes and trees", name, triangles);
    double found = fig_measured("%s %d finding candidates", name, triangles);
    double all = fig_measured("%s %d finding contacts", name, triangles);
    time[0] = trees;
    time[1] = found - trees;
    time[3] = fig_measured("%s %d describing contacts", name, triangles);
    time[2] = all - found - time[3];
    return all;
}

static void print_numbers(FILE *numbers, const struct cloth *cloth)
{
    double time[PARTS], all = times_of(cloth, time);
    char key[80];
    snprintf(key, sizeof key, "%s_all", cloth->name);
    fig_number(numbers, key, all);
    for (int i = 0; i < PARTS; i++) {
        snprintf(key, sizeof key, "%s_%s", cloth->name, parts[i].key);
        fig_number(numbers, key, time[i]);
        snprintf(key, sizeof key, "%s_%s_percent", cloth->name, parts[i].key);
        fig_number(numbers, key, 100 * time[i] / all);
    }
}

static void draw_bar(fig_page *page, fig_box box, const struct cloth *cloth)
{
    double time[PARTS], all = times_of(cloth, time), x = box.x;
    for (int i = 0; i < PARTS; i++) {
        double width = box.width * fmax(0, time[i]) / all;
        fig_page_fill_box(page, (fig_box){x, box.y, width, box.height},
                          parts[i].paint);
        x += width;
    }
    double base = box.y + box.height / 2 + 3;
    char digits[FIG_GROUPED], text[64];
    fig_plot_grouped(lround(all), digits);
    snprintf(text, sizeof text, "%s ns", digits);
    fig_page_text(page, box.x - 6, base, FIG_ALIGN_RIGHT, cloth->name,
                  FIG_LETTERS, FIG_ROLE_INK);
    fig_page_text(page, box.x + box.width + 6, base, FIG_ALIGN_LEFT, text,
                  FIG_LETTERS, FIG_ROLE_INK);
}

static void draw_scale(fig_page *page, fig_box box)
{
    for (int percent = 0; percent <= 100; percent += 25) {
        char text[16];
        snprintf(text, sizeof text, "%d%%", percent);
        fig_plot_tick(
            page, (fig_point){box.x + box.width * percent / 100, box.y}, text);
    }
}

static void draw_key(fig_page *page, double x, double y)
{
    for (int i = 0; i < PARTS; i++) {
        double width, height;
        fig_page_fill_box(page, (fig_box){x, y - 7, 8, 8}, parts[i].paint);
        fig_page_text(page, x + 12, y, FIG_ALIGN_LEFT, parts[i].name,
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
        fig_page_measure(page, parts[i].name, FIG_LETTERS_SMALL, &width,
                         &height);
        x += width + 26;
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_box box = {names_width, 28,
                   fig_page_width(page) - names_width - totals_width, bar};
    draw_key(page, names_width, 14);
    for (int i = 0; i < CLOTHS; i++) {
        draw_bar(page, box, &cloths[i]);
        print_numbers(numbers, &cloths[i]);
        box.y += step;
    }
    box.y += bar - step + 3;
    draw_scale(page, box);
}

const fig_figure fig_detection_costs = {
    .name = "detection-costs",
    .title = "Where the time of a detection goes",
    .width = FIG_PAGE_WIDTH,
    .height = 140,
    .draw = draw,
};

// Where the reference's time goes, and what the vectors make of it.
#include "kit/figures.h"

#include "kit/measured.h"
#include "renderer/plot.h"

#include <math.h>
#include <stdio.h>

enum {
    WORKS = 4 ///< soup and near, of either kind
};

static const double left = 62, top = 28, row = 45, bar = 10, bar_step = 12.5;

/// Nanoseconds of a workload, in the order of the bars.
typedef struct times {
    double reference, signs, vector, filter;
} times;

static times times_of(const fig_workload *w)
{
    times t = {.reference = fig_measured("reference %s %s", w->work, w->kind),
               .vector = fig_measured("vector %s %s", w->work, w->kind),
               .filter =
                   fig_measured("filter streaming %s %s", w->work, w->kind)};
    t.signs = fig_measured("exact %s %s pairs", w->work, w->kind) *
              fig_measured("six estimates");
    return t;
}

static const struct part {
    const char *name;
    fig_paint paint;
} parts[] = {
    {"signs", {.role = FIG_ROLE_CONTACT}},
    {"all around them", {.role = FIG_ROLE_NEUTRAL, .opacity = 0.5}},
    {"vectors, gathered", {.role = FIG_ROLE_OTHER_EDGE}},
    {"filter alone", {.role = FIG_ROLE_EDGE}},
};

static void draw_part(fig_page *page, double from, double to, double y,
                      double scale, fig_paint paint)
{
    fig_page_fill_box(
        page, (fig_box){left + scale * from, y, scale * (to - from), bar},
        paint);
}

static void write_time(fig_page *page, double time, double y, double scale)
{
    char text[16];
    snprintf(text, sizeof text, "%.0f", time);
    fig_page_text(page, left + scale * time + 4, y + 8.5, FIG_ALIGN_LEFT, text,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw_work(fig_page *page, int i, double scale, FILE *numbers)
{
    const fig_workload *w = &fig_workloads[i];
    times t = times_of(w);
    double y = top + row * i;
    draw_part(page, 0, t.signs, y, scale, parts[0].paint);
    draw_part(page, t.signs, t.reference, y, scale, parts[1].paint);
    draw_part(page, 0, t.vector, y + bar_step, scale, parts[2].paint);
    draw_part(page, 0, t.filter, y + 2 * bar_step, scale, parts[3].paint);
    write_time(page, t.reference, y, scale);
    write_time(page, t.vector, y + bar_step, scale);
    write_time(page, t.filter, y + 2 * bar_step, scale);
    fig_name_workload(page, left - 6, y + bar_step + 8, w);
    const struct {
        const char *name;
        double value;
    } number[] = {{"reference", t.reference},
                  {"signs", t.signs},
                  {"share", 100 * t.signs / t.reference},
                  {"vector", t.vector},
                  {"filter", t.filter}};
    for (int j = 0; j < 5; j++) {
        char key[48];
        snprintf(key, sizeof key, "%s_%s_%s", w->work, w->letters,
                 number[j].name);
        fig_number(numbers, key, number[j].value);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    static const double place[] = {0, 58, 154, 250};
    double most = 0;
    for (int i = 0; i < WORKS; i++)
        most = fmax(most, times_of(&fig_workloads[i]).reference);
    double scale = (fig_page_width(page) - left - 30) / most;
    for (int i = 0; i < 4; i++) {
        double x = left + place[i];
        fig_page_fill_box(page, (fig_box){x, 6, 11, 8}, parts[i].paint);
        fig_page_text(page, x + 15, 13, FIG_ALIGN_LEFT, parts[i].name,
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
    }
    for (int i = 0; i < WORKS; i++)
        draw_work(page, i, scale, numbers);
}

const fig_figure fig_reference_profile = {
    .name = "reference-profile",
    .title = "Where the time of a query goes",
    .width = FIG_PAGE_WIDTH,
    .height = 206,
    .draw = draw,
};

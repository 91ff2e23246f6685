// How far exact signs have to go, query by query.
#include "kit/figures.h"

#include "kit/measured.h"
#include "renderer/plot.h"

#include <stdio.h>

#define BAR 13.0
#define STEP 18.0

enum {
    SHARES = 4
};

static const struct share {
    const char *key, *name;
    fig_paint paint; ///< the darker, the dearer
} shares[SHARES] = {
    {"none", "no sign needed", {.role = FIG_ROLE_NEUTRAL, .opacity = 0.3}},
    {"estimate", "estimate", {.role = FIG_ROLE_NEUTRAL}},
    {"grid", "integers on a grid", {.role = FIG_ROLE_TRIANGLE}},
    {"accumulator", "superaccumulator", {.role = FIG_ROLE_INK}},
};

static double percent_of(const fig_workload *w, const char *share)
{
    return fig_measured("%s %s %s", w->work, w->kind, share);
}

static void draw_bar(fig_page *page, fig_box box, const fig_workload *w)
{
    double x = box.x;
    for (int i = 0; i < SHARES; i++) {
        double percent = percent_of(w, shares[i].key);
        double width = box.width * percent / 100;
        if (percent > 0)
            fig_page_fill_box(page, (fig_box){x, box.y, width, box.height},
                              shares[i].paint);
        x += width;
    }
}

/// Percents below the bars.
static void draw_scale(fig_page *page, fig_box box)
{
    for (int percent = 0; percent <= 100; percent += 25) {
        double x = box.x + box.width * percent / 100;
        const fig_point tick[2] = {{x, box.y}, {x, box.y + 3}};
        char text[16];
        snprintf(text, sizeof text, "%d%%", percent);
        fig_page_line(page, 2, tick,
                      (fig_stroke){.paint.role = FIG_ROLE_NEUTRAL,
                                   .width = FIG_WIDTH_THIN});
        fig_page_text(page, x, box.y + 13, FIG_ALIGN_CENTER, text,
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
    }
}

static void draw_key(fig_page *page, double x, double y)
{
    for (int i = 0; i < SHARES; i++) {
        double width, height;
        fig_page_fill_box(page, (fig_box){x, y - 7, 8, 8}, shares[i].paint);
        fig_page_text(page, x + 12, y, FIG_ALIGN_LEFT, shares[i].name,
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
        fig_page_measure(page, shares[i].name, FIG_LETTERS_SMALL, &width,
                         &height);
        x += width + 26;
    }
}

static void print_shares(FILE *numbers, const fig_workload *w)
{
    static const char *const names[] = {"none",        "estimate", "grid",
                                        "accumulator", "tails",    "heads"};
    for (int i = 0; i < 6; i++) {
        char key[80];
        snprintf(key, sizeof key, "%s_%s_%s", w->work, w->letters, names[i]);
        fig_number(numbers, key, percent_of(w, names[i]));
    }
}

static void print_times(FILE *numbers)
{
    static const struct {
        const char *key, *name;
    } ways[] = {
        {"ns_estimate", "estimate"},
        {"ns_grid", "grid"},
        {"ns_whole", "accumulator"},
        {"ns_accumulator", "accumulator with tails"},
        {"ns_any_size", "accumulator of any size"},
        {"ns_expansion", "expansion"},
        {"ns_grid_integers", "grid of integers"},
        {"ns_integers", "accumulator of integers"},
        {"ns_expansion_integers", "expansion of integers"},
        {"ns_grid_plane", "grid in the plane"},
        {"ns_plane", "accumulator in the plane"},
        {"ns_expansion_plane", "expansion in the plane"},
    };
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++)
        fig_number(numbers, ways[i].key, fig_measured("%s", ways[i].name));
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_box bar = {64, 28, fig_page_width(page) - 84, BAR};
    draw_key(page, bar.x, 14);
    for (int i = 0; i < FIG_WORKLOADS; i++) {
        const fig_workload *w = &fig_workloads[i];
        fig_name_workload(page, bar.x - 6, bar.y + BAR - 3, w);
        draw_bar(page, bar, w);
        print_shares(numbers, w);
        bar.y += STEP + (i % 2 == 1 ? 6 : 0);
    }
    bar.y -= 8;
    draw_scale(page, bar);
    print_times(numbers);
}

const fig_figure fig_sign_stages = {
    .name = "sign-stages",
    .title = "How far exact signs have to go, by workload",
    .width = FIG_PAGE_WIDTH,
    .height = 208,
    .draw = draw,
};

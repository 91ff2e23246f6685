// From all pairs of elements of a step to its contacts: how many are left after
// each stage of a detection.
#include "kit/figures.h"

#include "kit/measured.h"
#include "renderer/plot.h"

#include <math.h>
#include <stdio.h>

enum {
    CLOTHS = 2,
    STAGES = 3
};

static const double bar = 15, step = 28, text_drop = 11;

static const struct cloth {
    const char *name, *title;
    int triangles;
} cloths[CLOTHS] = {
    {"dense", "ten layers close together", 994580},
    {"crowded", "ten layers that pass through each other", 98000},
};

static const struct stage {
    const char *key, *name;
    const char *by; ///< what has left so many of the stage before
    fig_paint paint;
} stages[STAGES] = {
    {"pairs", "pairs", NULL, {.role = FIG_ROLE_NEUTRAL, .opacity = 0.45}},
    {"candidates", "candidates", "boxes leave", {.role = FIG_ROLE_EDGE}},
    {"contacts", "contacts", "signs leave", {.role = FIG_ROLE_CONTACT}},
};

/// How many pairs are left after each stage.
static void count(const struct cloth *cloth, double left[STAGES])
{
    static const char *const decided[] = {"by an axis", "by the filter",
                                          "by signs"};
    const char *name = cloth->name;
    int triangles = cloth->triangles;
    left[0] = fig_measured("%s %d pairs", name, triangles);
    left[1] = 0;
    for (int i = 0; i < 3; i++)
        left[1] +=
            fig_measured("%s %d decided %s", name, triangles, decided[i]);
    left[2] = fig_measured("%s %d contacts", name, triangles);
}

static void write_ratio(fig_page *page, double x, double y, double before,
                        double after, const char *by)
{
    char digits[FIG_GROUPED], text[80];
    double ratio = before / after;
    if (ratio < 99.5) {
        snprintf(digits, sizeof digits, "%.1f", ratio);
    } else {
        double unit = pow(10, floor(log10(ratio)) - 1);
        fig_plot_grouped(lround(ratio / unit) * lround(unit), digits);
    }
    snprintf(text, sizeof text, "%s 1 in %s", by, digits);
    fig_page_text(page, x, y, FIG_ALIGN_LEFT, text, FIG_LETTERS_SMALL,
                  FIG_ROLE_INK);
}

static void draw_cloth(fig_page *page, fig_box box, const struct cloth *cloth,
                       double most)
{
    double left[STAGES];
    count(cloth, left);
    for (int i = 0; i < STAGES; i++) {
        double y = box.y + step * i;
        double width = box.width * log10(left[i]) / log10(most);
        fig_page_fill_box(page, (fig_box){box.x, y, width, bar},
                          stages[i].paint);
        char digits[FIG_GROUPED];
        fig_plot_grouped(lround(left[i]), digits);
        fig_page_text(page, box.x + width + 5, y + text_drop, FIG_ALIGN_LEFT,
                      digits, FIG_LETTERS_SMALL, FIG_ROLE_INK);
        fig_page_text(page, box.x - 6, y + text_drop, FIG_ALIGN_RIGHT,
                      stages[i].name, FIG_LETTERS_SMALL, FIG_ROLE_INK);
        if (i > 0)
            write_ratio(page, box.x + 4, y - 4, left[i - 1], left[i],
                        stages[i].by);
    }
    fig_page_text(page, box.x, box.y - 8, FIG_ALIGN_LEFT, cloth->title,
                  FIG_LETTERS, FIG_ROLE_INK);
}

/// Powers of ten below the bars.
static void draw_scale(fig_page *page, fig_box box, double most)
{
    for (int power = 0; pow(10, power) < most; power += 3) {
        double x = box.x + box.width * power / log10(most);
        char name[32];
        snprintf(name, sizeof name, "$10^{%d}$", power);
        fig_plot_tick(page, (fig_point){x, box.y}, power == 0 ? "1" : name);
    }
}

static void print_numbers(FILE *numbers, const struct cloth *cloth)
{
    double left[STAGES];
    count(cloth, left);
    char key[80];
    snprintf(key, sizeof key, "%s_triangles", cloth->name);
    fig_number(numbers, key, cloth->triangles);
    for (int i = 0; i < STAGES; i++) {
        snprintf(key, sizeof key, "%s_%s", cloth->name, stages[i].key);
        fig_number(numbers, key, left[i]);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    double left[STAGES];
    count(&cloths[0], left);
    fig_box box = {100, 22, fig_page_width(page) - 100 - 88, STAGES * step};
    for (int i = 0; i < CLOTHS; i++) {
        draw_cloth(page, box, &cloths[i], left[0]);
        print_numbers(numbers, &cloths[i]);
        box.y += STAGES * step + 22;
    }
    box.y -= 30;
    draw_scale(page, box, left[0]);
}

const fig_figure fig_pairs_to_contacts = {
    .name = "pairs-to-contacts",
    .title = "From all pairs of elements to the contacts",
    .width = FIG_PAGE_WIDTH,
    .height = 226,
    .draw = draw,
};

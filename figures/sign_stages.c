// How far exact signs have to go, query by query.
#include "figures.h"

#include "contract.h"
#include "measured.h"
#include "stage/plot.h"

#include <string.h>

#define BAR 13.0
#define STEP 18.0

static const struct share {
    const char *key, *name;
    tf_role role;
} shares[TF_STAGE_SHARES] = {
    {"none", "no sign asked", TF_ROLE_NEUTRAL},
    {"estimate", "estimate", TF_ROLE_START},
    {"accumulator", "accumulator", TF_ROLE_CONTACT},
};

static void draw_bar(tf_page *page, tf_box box, const double percent[])
{
    double x = box.x;
    for (int i = 0; i < TF_STAGE_SHARES; i++) {
        double width = box.width * percent[i] / 100;
        if (percent[i] > 0)
            tf_page_fill_box(page, (tf_box){x, box.y, width, box.height},
                             (tf_paint){.role = shares[i].role});
        x += width;
    }
}

/// Percents below the bars.
static void draw_scale(tf_page *page, tf_box box)
{
    for (int percent = 0; percent <= 100; percent += 25) {
        double x = box.x + box.width * percent / 100;
        const double tick[2][2] = {{x, box.y}, {x, box.y + 3}};
        char text[16];
        snprintf(text, sizeof text, "%d %%", percent);
        tf_page_line(
            page, 2, tick,
            (tf_stroke){.paint.role = TF_ROLE_NEUTRAL, .width = TF_WIDTH_THIN});
        tf_page_text(page, x, box.y + 13, TF_ALIGN_CENTER, text,
                     TF_LETTERS_SMALL, TF_ROLE_INK);
    }
}

static void draw_key(tf_page *page, double x, double y)
{
    for (int i = 0; i < TF_STAGE_SHARES; i++) {
        double width, height;
        tf_page_fill_box(page, (tf_box){x, y - 7, 8, 8},
                         (tf_paint){.role = shares[i].role});
        tf_page_text(page, x + 12, y, TF_ALIGN_LEFT, shares[i].name,
                     TF_LETTERS_SMALL, TF_ROLE_INK);
        tf_page_measure(page, shares[i].name, TF_LETTERS_SMALL, &width,
                        &height);
        x += width + 26;
    }
}

static void print_number(FILE *numbers, const tf_stage_share *row,
                         const char *name, double percent)
{
    char key[80];
    snprintf(key, sizeof key, "%s_%s_%s", row->work, tf_kind_letters(row->kind),
             name);
    tf_figure_number(numbers, key, percent);
}

static void print_numbers(FILE *numbers, const tf_stage_share *row)
{
    for (int i = 0; i < TF_STAGE_SHARES; i++)
        print_number(numbers, row, shares[i].key, row->percent[i]);
    print_number(numbers, row, "tails", row->tails);
    print_number(numbers, row, "heads", row->heads);
}

static void print_times(FILE *numbers)
{
    static const char *const keys[] = {
        "ns_estimate",           "ns_whole",     "ns_accumulator",
        "ns_any_size",           "ns_expansion", "ns_integers",
        "ns_expansion_integers", "ns_plane",     "ns_expansion_plane"};
    int count;
    const tf_stage_time *timed = tf_measured_stages(&count);
    TF_REQUIRE(count == (int)(sizeof keys / sizeof *keys));
    for (int i = 0; i < count; i++)
        tf_figure_number(numbers, keys[i], timed[i].time);
}

static void draw(tf_page *page, FILE *numbers)
{
    int count;
    const tf_stage_share *rows = tf_measured_shares(&count);
    tf_box bar = {64, 28, tf_page_width(page) - 84, BAR};
    draw_key(page, bar.x, 14);
    for (int i = 0; i < count; i++) {
        tf_name_workload(page, bar.x - 6, bar.y + BAR - 3, rows[i].work,
                         rows[i].kind);
        draw_bar(page, bar, rows[i].percent);
        print_numbers(numbers, &rows[i]);
        bar.y += STEP + (i % 2 == 1 ? 6 : 0);
    }
    bar.y -= 8;
    draw_scale(page, bar);
    print_times(numbers);
}

const tf_figure tf_figure_sign_stages = {
    .name = "sign-stages",
    .title = "How far exact signs have to go, by workload",
    .width = TF_FIGURE_WIDTH,
    .height = 208,
    .draw = draw,
};

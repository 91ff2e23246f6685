// The layers of src/, their public modules, and how many includes go down from
// one to another.
#include "base/require.h"
#include "kit/figures.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/// First the layers, the lowest first, with no `to`; then who includes whom.
static const struct row {
    const char *from, *to;
} table[] = {
#include "includes.h"
};

enum {
    ROWS = sizeof table / sizeof *table,
    MODULES_MOST = 2 * ROWS
};

typedef struct module {
    const char *path; ///< below src/, without ending
    int layer;
    bool is_public; ///< makes a part of a public header
    fig_box box;    ///< on the page
} module;

typedef struct layout {
    int count;
    module modules[MODULES_MOST];
    fig_box band[ROWS]; ///< of each layer
    fig_box rest[ROWS]; ///< where the number of its other modules is
} layout;

static const double key_height = 20, band_left = 60, band_pad = 3;
static const double chip_height = 12, chip_pad = 2, chip_gap = 2;
static const double lane_pitch = 16, lane_right = 17, dot_area = 2.5;

// The table ------------------------------------------------------------------

static int layer_count(void)
{
    int count = 0;
    while (count < ROWS && !*table[count].to)
        count++;
    return count;
}

static int layer_of(const char *path)
{
    size_t length = strcspn(path, "/");
    int layer = 0;
    while (strncmp(table[layer].from, path, length) != 0 ||
           table[layer].from[length])
        layer++;
    TF_REQUIRE(layer < layer_count());
    return layer;
}

/// How many includes go from one layer to another.
static int includes_between(int from, int to)
{
    int count = 0;
    for (int i = layer_count(); i < ROWS; i++)
        count += layer_of(table[i].from) == from && layer_of(table[i].to) == to;
    return count;
}

/// A module is public if it includes base/api.h, or is it.
static bool includes_api(const char *path)
{
    static const char api[] = "base/api";
    for (int i = layer_count(); i < ROWS; i++)
        if (strcmp(table[i].from, path) == 0 && strcmp(table[i].to, api) == 0)
            return true;
    return strcmp(path, api) == 0;
}

/// Append the module unless it is there already.
static void add_module(layout *plan, const char *path)
{
    for (int i = 0; i < plan->count; i++)
        if (strcmp(plan->modules[i].path, path) == 0)
            return;
    plan->modules[plan->count++] = (module){
        .path = path, .layer = layer_of(path), .is_public = includes_api(path)};
}

static int compare_modules(const void *a, const void *b)
{
    const module *first = a, *second = b;
    return strcmp(first->path, second->path);
}

/// All modules, by name.
static void find_modules(layout *plan)
{
    for (int i = layer_count(); i < ROWS; i++) {
        add_module(plan, table[i].from);
        add_module(plan, table[i].to);
    }
    qsort(plan->modules, (size_t)plan->count, sizeof *plan->modules,
          compare_modules);
}

/// How many modules of a layer are public, or are not.
static int count_modules(const layout *plan, int layer, bool is_public)
{
    int count = 0;
    for (int i = 0; i < plan->count; i++)
        count += plan->modules[i].layer == layer &&
                 plan->modules[i].is_public == is_public;
    return count;
}

// Chips ----------------------------------------------------------------------

static const char *name_of(const module *m)
{
    return strchr(m->path, '/') + 1;
}

static fig_box chip_at(fig_page *page, double x, double y, const char *name)
{
    double width, height;
    fig_page_measure(page, name, FIG_LETTERS_SMALL, &width, &height);
    return (fig_box){x, y, width + 2 * chip_pad, chip_height};
}

static void write_in(fig_page *page, fig_box box, const char *text,
                     fig_role role)
{
    fig_page_text(page, box.x + box.width / 2, box.y + 9, FIG_ALIGN_CENTER,
                  text, FIG_LETTERS_SMALL, role);
}

static void draw_chip(fig_page *page, fig_box box, const char *name)
{
    fig_page_fill_box(page, box,
                      (fig_paint){.role = FIG_ROLE_INK, .shade = -0.15});
    write_in(page, box, name, FIG_ROLE_PAPER);
}

/// Of the modules that are not public, their number alone.
static const char *rest_of(const layout *plan, int layer, char text[24])
{
    int count = count_modules(plan, layer, false);
    snprintf(text, 24, "%d internal", count);
    return text;
}

/// Where the lane goes down to a layer: the lower the layer, the farther right.
static double lane_of(const fig_page *page, int to)
{
    return fig_page_width(page) - lane_right - lane_pitch * to;
}

/// Place a chip to the right of another one, or below it at the left.
static fig_box chip_after(fig_page *page, fig_box last, const char *name,
                          double right)
{
    fig_box box = chip_at(page, last.x + last.width + chip_gap, last.y, name);
    if (box.x + box.width <= right)
        return box;
    return chip_at(page, band_left, last.y + chip_height + chip_gap, name);
}

/// Place the chips of a layer in rows from the height y on; the height below.
static double place_chips(fig_page *page, layout *plan, int layer, double right,
                          double y)
{
    char text[24];
    fig_box last = {.x = band_left - chip_gap, .y = y};
    for (int i = 0; i < plan->count; i++) {
        module *m = &plan->modules[i];
        if (m->layer == layer && m->is_public)
            last = m->box = chip_after(page, last, name_of(m), right);
    }
    if (count_modules(plan, layer, false) > 0)
        last = plan->rest[layer] =
            chip_after(page, last, rest_of(plan, layer, text), right);
    return last.y + chip_height;
}

/// Place them left of the lanes that cross their band, in rows about equally
/// long: as narrow as they can be without taking one row more.
static double balance_chips(fig_page *page, layout *plan, int layer, double y)
{
    double right = lane_of(page, layer - 1) - lane_pitch / 2;
    double foot = place_chips(page, plan, layer, right, y);
    while (right > band_left &&
           place_chips(page, plan, layer, right - 1, y) == foot)
        right--;
    return place_chips(page, plan, layer, right, y);
}

// Bands and lanes ------------------------------------------------------------

/// Place the bands and their chips, the highest layer on top; the height below.
static double stack_bands(fig_page *page, layout *plan, double gap)
{
    double y = key_height - gap;
    for (int i = layer_count() - 1; i >= 0; i--) {
        double top = y + gap;
        y = balance_chips(page, plan, i, top + band_pad) + band_pad;
        plan->band[i] = (fig_box){0, top, fig_page_width(page), y - top};
    }
    return y;
}

/// Let the gaps between the bands fill the page.
static void place_bands(fig_page *page, layout *plan)
{
    double rest = fig_page_height(page) - stack_bands(page, plan, 0);
    TF_REQUIRE(rest >= 0);
    stack_bands(page, plan, rest / (layer_count() - 1));
}

static double middle(const fig_box *band)
{
    return band->y + band->height / 2;
}

static void draw_band(fig_page *page, const fig_box *band, const char *name)
{
    fig_page_fill_box(page, *band,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.13});
    fig_page_text(page, band->x + 7, middle(band) + 3.5, FIG_ALIGN_LEFT, name,
                  FIG_LETTERS, FIG_ROLE_INK);
}

/// A dot with an area that shows how many includes there are, and the number.
static void draw_count(fig_page *page, double x, double y, int count)
{
    char text[16];
    double diameter = sqrt(dot_area * count);
    snprintf(text, sizeof text, "%d", count);
    fig_page_dot(page, x, y, diameter, (fig_paint){.role = FIG_ROLE_INK});
    fig_page_text(page, x + diameter / 2 + 2, y + 3, FIG_ALIGN_LEFT, text,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

/// From the highest layer that includes this one down to it, past a dot for
/// each that does.
static void draw_lane(fig_page *page, const fig_box band[], int to)
{
    int top = layer_count() - 1;
    while (top > to && includes_between(top, to) == 0)
        top--;
    double x = lane_of(page, to);
    fig_point line[2] = {{x, middle(&band[top])}, {x, band[to].y + band_pad}};
    fig_page_line(page, 2, line,
                  (fig_stroke){.paint.role = FIG_ROLE_NEUTRAL, .arrow = true});
    for (int from = top; from > to; from--)
        if (includes_between(from, to) > 0)
            draw_count(page, x, middle(&band[from]),
                       includes_between(from, to));
}

static void draw_key(fig_page *page)
{
    fig_box box = chip_at(page, band_left, 1, "in a public header");
    draw_chip(page, box, "in a public header");
    double width, height;
    fig_page_measure(page, "includes", FIG_LETTERS_SMALL, &width, &height);
    double right = fig_page_width(page) - 2;
    fig_page_dot(page, right - width - 6, middle(&box), sqrt(dot_area * 5),
                 (fig_paint){.role = FIG_ROLE_INK});
    fig_page_text(page, right, box.y + 9, FIG_ALIGN_RIGHT, "includes",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void print_numbers(FILE *numbers, const layout *plan)
{
    int down = 0, within = 0, up = 0, offered = 0;
    for (int i = 0; i < layer_count(); i++)
        offered += count_modules(plan, i, true);
    for (int i = layer_count(); i < ROWS; i++) {
        int from = layer_of(table[i].from), to = layer_of(table[i].to);
        down += from > to;
        within += from == to;
        up += from < to;
    }
    fig_number(numbers, "layers", layer_count());
    fig_number(numbers, "modules", plan->count);
    fig_number(numbers, "public", offered);
    fig_number(numbers, "includes", ROWS - layer_count());
    fig_number(numbers, "down", down);
    fig_number(numbers, "within", within);
    fig_number(numbers, "up", up);
}

/// How many modules each layer has, and how many includes each arrow stands
/// for.
static void print_layers(FILE *numbers, const layout *plan)
{
    char key[80];
    for (int from = 0; from < layer_count(); from++) {
        snprintf(key, sizeof key, "%s_modules", table[from].from);
        fig_number(numbers, key,
                   count_modules(plan, from, true) +
                       count_modules(plan, from, false));
        for (int to = 0; to < from; to++) {
            snprintf(key, sizeof key, "%s_%s", table[from].from,
                     table[to].from);
            fig_number(numbers, key, includes_between(from, to));
        }
    }
}

static void draw_layer(fig_page *page, const layout *plan, int layer)
{
    char text[24];
    draw_band(page, &plan->band[layer], table[layer].from);
    for (int i = 0; i < plan->count; i++) {
        const module *m = &plan->modules[i];
        if (m->layer == layer && m->is_public)
            draw_chip(page, m->box, name_of(m));
    }
    if (count_modules(plan, layer, false) > 0)
        write_in(page, plan->rest[layer], rest_of(plan, layer, text),
                 FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    layout plan = {0};
    find_modules(&plan);
    place_bands(page, &plan);
    draw_key(page);
    for (int i = 0; i < layer_count(); i++)
        draw_layer(page, &plan, i);
    for (int to = 0; to < layer_count() - 1; to++)
        draw_lane(page, plan.band, to);
    print_numbers(numbers, &plan);
    print_layers(numbers, &plan);
}

const fig_figure fig_layers = {
    .name = "layers",
    .title = "The layers of the library and what includes what",
    .width = FIG_PAGE_WIDTH,
    .height = 530,
    .draw = draw,
};

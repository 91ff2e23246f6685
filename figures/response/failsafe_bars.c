// Bars that the failsafe unites one by one, a round each.
#include "base/require.h"
#include "kit/failsafe_rounds.h"
#include "kit/figures.h"
#include "kit/film.h"

#include "renderer/plot.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

enum {
    BARS = 8,
    VERTICES = 2 * BARS,
    NUMBERS = 2 * VERTICES,
    ROUNDS = BARS
};

/// How far the first bar should move, and the first gap.
static const double move = 1, first_gap = 0.9;

/// Bars reach from -low to high, or the other way around.
static const double low = 1, high = 0.4;

/// What is so after a number of rounds.
typedef struct state {
    double end[NUMBERS];
    int root[BARS]; ///< of the group of each bar
    bool hit[BARS]; ///< whether the bar is in contact
    size_t contacts;
} state;

typedef struct history {
    double start[NUMBERS];
    state after[ROUNDS + 1]; ///< 0 and more rounds
    int rounds;              ///< how many it takes
} history;

// The rounds ------------------------------------------------------------------

static void place_bars(double x[])
{
    double at = 0;
    for (int i = 0; i < BARS; i++) {
        double *bar = x + 4 * (ptrdiff_t)i;
        bar[0] = bar[2] = at;
        bar[1] = i % 2 == 0 ? -low : -high;
        bar[3] = i % 2 == 0 ? high : low;
        at += first_gap / (i + 1);
    }
}

/// Keeps what is so before a round in a history.
static void keep(void *context, const fig_round *round)
{
    history *h = context;
    const tf_contacts *found = round->found;
    TF_REQUIRE(round->round <= ROUNDS);
    state *now = &h->after[round->round];
    memcpy(now->end, round->end, sizeof now->end);
    for (int i = 0; i < BARS; i++)
        now->root[i] = tf_groups_find(round->groups, 2 * i) / 2;
    now->contacts = found->count;
    for (size_t i = 0; i < found->count; i++)
        for (int k = 0; k < 3; k++)
            now->hit[found->contact[i].vertex[k] / 2] = true;
}

static void answer(history *h)
{
    int edge[VERTICES];
    double proposed[NUMBERS];
    for (int v = 0; v < VERTICES; v++)
        edge[v] = v;
    const tf_mesh mesh = {
        .axes = 2, .vertices = VERTICES, .edges = BARS, .edge = edge};
    memset(h, 0, sizeof *h);
    place_bars(h->start);
    memcpy(proposed, h->start, sizeof proposed);
    proposed[0] += move;
    proposed[2] += move;
    h->rounds = fig_failsafe_rounds(&mesh, h->start, proposed, keep, h);
}

// Drawing ---------------------------------------------------------------------

static fig_paint paint_of(const state *now, int bar)
{
    if (now->root[bar] == 0)
        return (fig_paint){.role = FIG_ROLE_EDGE};
    if (now->hit[bar])
        return (fig_paint){.role = FIG_ROLE_CONTACT};
    return (fig_paint){.role = FIG_ROLE_NEUTRAL};
}

/// The bars at a fraction of their displacements.
static void draw_bars(fig_page *page, const fig_plot *plot, const history *h,
                      const state *now, double t)
{
    for (int i = 0; i < BARS; i++) {
        const double *start = h->start + 4 * (ptrdiff_t)i;
        double d = now->end[(ptrdiff_t)4 * i] - start[0], x = start[0] + t * d;
        fig_plot_curve(page, plot, 2,
                       (fig_point[]){{x, start[1]}, {x, start[3]}},
                       (fig_stroke){.paint = paint_of(now, i), .width = 2});
    }
}

/// The displacement of the first group, from its foremost bar on.
static void draw_arrow(fig_page *page, const fig_plot *plot, const history *h,
                       const state *now, double y)
{
    int last = 0;
    for (int i = 0; i < BARS; i++)
        last = now->root[i] == 0 ? i : last;
    double from = h->start[(ptrdiff_t)4 * last];
    double to = from + now->end[0] - h->start[0];
    fig_plot_curve(
        page, plot, 2, (fig_point[]){{from, y}, {to, y}},
        (fig_stroke){.paint = {.role = FIG_ROLE_EDGE}, .arrow = true});
}

static const char *name_of(int round, char text[16])
{
    snprintf(text, 16, round == 0 ? "proposed" : "round %d", round);
    return text;
}

/// One row for the state after each round.
static void draw_still(fig_page *page, const history *h)
{
    double width = fig_page_width(page);
    double height = fig_page_height(page) / (h->rounds + 1);
    for (int round = 0; round <= h->rounds; round++) {
        char text[16];
        fig_box box = {54, height * round + 3, width - 60, height - 6};
        fig_plot plot = {.box = box, .x = {-0.12, 2.6}, .y = {-1.05, 1.05}};
        fig_page_fill_box(
            page, box, (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
        draw_bars(page, &plot, h, &h->after[round], 0);
        draw_arrow(page, &plot, h, &h->after[round], 0);
        fig_page_text(page, 4, box.y + box.height / 2 + 3, FIG_ALIGN_LEFT,
                      name_of(round, text), FIG_LETTERS_SMALL, FIG_ROLE_INK);
    }
}

/// Each round in its turn: the bars go where they would go.
static void draw_frame(fig_page *page, const history *h, double t)
{
    double at = t * (h->rounds + 1);
    int round = at >= h->rounds + 1 ? h->rounds : (int)at;
    double part = fmin(1, 1.25 * (at - round));
    char name[16], text[64];
    fig_box box = {8, 24, fig_page_width(page) - 16,
                   fig_page_height(page) - 60};
    fig_plot plot = {.box = box, .x = {-0.12, 2.6}, .y = {-1.15, 1.15}};
    const state *now = &h->after[round];
    for (int i = 0; i < BARS; i++) {
        const double *start = h->start + 4 * (ptrdiff_t)i;
        fig_plot_curve(
            page, &plot, 2,
            (fig_point[]){{start[0], start[1]}, {start[2], start[3]}},
            (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL, .shade = -0.6},
                         .width = FIG_WIDTH_THIN});
    }
    draw_bars(page, &plot, h, now, part);
    fig_page_text(page, fig_page_width(page) / 2, 16, FIG_ALIGN_CENTER,
                  name_of(round, name), FIG_LETTERS, FIG_ROLE_INK);
    snprintf(text, sizeof text, "displacement %.3f, %zu contacts",
             now->end[0] - h->start[0], now->contacts);
    fig_page_text(page, fig_page_width(page) / 2, fig_page_height(page) - 14,
                  FIG_ALIGN_CENTER, text, FIG_LETTERS_SMALL,
                  now->contacts > 0 ? FIG_ROLE_CONTACT : FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    history h;
    answer(&h);
    double t = fig_film_time(page, numbers, 0.2, -1);
    if (fig_page_moves(page))
        draw_frame(page, &h, t);
    else
        draw_still(page, &h);
    fig_number(numbers, "bars", BARS);
    fig_number(numbers, "vertices", VERTICES);
    fig_number(numbers, "rounds", h.rounds);
    for (int round = 0; round <= h.rounds; round++) {
        char key[32];
        snprintf(key, sizeof key, "displacement_%d", round);
        fig_number(numbers, key, h.after[round].end[0] - h.start[0]);
    }
}

const fig_figure fig_failsafe_bars = {
    .name = "failsafe-bars",
    .title = "Bars that the failsafe unites one by one",
    .width = FIG_PAGE_WIDTH,
    .height = 232,
    .moves = true,
    .draw = draw,
};

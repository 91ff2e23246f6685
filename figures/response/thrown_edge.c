// An edge that each round of the failsafe throws to its other side, where it
// meets one point more: a step that needs as many rounds as there can be.
#include "base/require.h"
#include "kit/failsafe_rounds.h"
#include "kit/figures.h"

#include "renderer/plot.h"

#include <stdio.h>
#include <string.h>

enum {
    POINTS = 6,
    VERTICES = 2 + POINTS, ///< those of the edge come first
    NUMBERS = 2 * VERTICES,
    ROUNDS = VERTICES
};

/// What is so after a number of rounds.
typedef struct state {
    double displacement; ///< of the edge
    bool joined[POINTS]; ///< whether a point is in the edge's group
    bool hit[POINTS];    ///< whether it meets the edge
} state;

typedef struct history {
    double start[NUMBERS], proposed[NUMBERS];
    state after[ROUNDS + 1]; ///< 0 and more rounds
    int rounds;              ///< how many it takes
} history;

// The step --------------------------------------------------------------------

/// Where the edge is after some rounds: to the left, to the right, and so on,
/// each time a bit farther.
static double place_after(int rounds)
{
    double far = 0.4 + 0.2 * rounds;
    return rounds == 0 ? 0 : rounds % 2 == 0 ? far : -far;
}

/// Where a point is proposed to end: where the edge has come by the rounds
/// before, but was not when it was last on this side.
static double end_of(int point)
{
    double last = point < 2 ? 0 : place_after(point - 2);
    return point == 0 ? -0.2 : (place_after(point) + last) / 2;
}

/// The points move such that the mean with that of the next one is the edge's
/// next place.  If `rounded`, the first one starts so near to the edge that the
/// last throw, a long one, rounds the distance away.
static void propose(history *h, bool rounded)
{
    double sum = 0;
    memset(h, 0, sizeof *h);
    h->start[3] = h->proposed[3] = POINTS + 1;
    for (int i = 0; i < POINTS; i++) {
        double *start = h->start + 4 + 2 * (ptrdiff_t)i;
        double *end = h->proposed + 4 + 2 * (ptrdiff_t)i;
        double next = rounded && i == POINTS - 1 ? 1024 : place_after(i + 1);
        double move = (i + 3) * next - sum;
        start[0] = rounded && i == 0 ? 0x1p-50 : end_of(i) - move;
        end[0] = start[0] + move;
        start[1] = end[1] = POINTS - i;
        sum += end[0] - start[0];
    }
}

// The rounds ------------------------------------------------------------------

/// Keeps what is so before a round in a history.
static void keep(void *context, const fig_round *round)
{
    history *h = context;
    TF_REQUIRE(round->round <= ROUNDS);
    state *now = &h->after[round->round];
    now->displacement = round->end[0] - h->start[0];
    for (int i = 0; i < POINTS; i++)
        now->joined[i] = tf_groups_find(round->groups, 2 + i) ==
                         tf_groups_find(round->groups, 0);
    for (size_t i = 0; i < round->found->count; i++)
        now->hit[round->found->contact[i].vertex[0] - 2] = true;
}

static void answer(history *h, bool rounded)
{
    const int edge[] = {0, 1};
    const tf_mesh mesh = {
        .axes = 2, .vertices = VERTICES, .edges = 1, .edge = edge};
    propose(h, rounded);
    h->rounds = fig_failsafe_rounds(&mesh, h->start, h->proposed, keep, h);
}

// Drawing ---------------------------------------------------------------------

static void draw_upright(fig_page *page, const fig_plot *plot, double x,
                         fig_stroke stroke)
{
    fig_plot_curve(page, plot, 2, (fig_point[]){{x, 0}, {x, POINTS + 1}},
                   stroke);
}

/// The path of a point that goes its own way, from the side from which it
/// comes.
static void draw_path(fig_page *page, const fig_plot *plot, const history *h,
                      int point, bool hit)
{
    const double *end = h->proposed + 4 + 2 * (ptrdiff_t)point;
    double from = plot->x[point % 2 == 0];
    fig_role role = hit ? FIG_ROLE_CONTACT : FIG_ROLE_POINT;
    fig_plot_curve(
        page, plot, 2, (fig_point[]){{from, end[1]}, {end[0], end[1]}},
        (fig_stroke){.paint = {.role = role}, .width = FIG_WIDTH_THIN});
    fig_plot_dot(page, plot, end[0], end[1], 4, role);
}

static void draw_row(fig_page *page, const history *h, int round, fig_box box)
{
    const state *now = &h->after[round];
    fig_plot plot = {.box = box, .x = {-2, 2}, .y = {-0.4, POINTS + 1.4}};
    fig_page_fill_box(page, box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    draw_upright(page, &plot, 0,
                 (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                              .width = FIG_WIDTH_THIN});
    draw_upright(page, &plot, now->displacement,
                 (fig_stroke){.paint = {.role = FIG_ROLE_EDGE}, .width = 2});
    for (int i = 0; i < POINTS; i++)
        if (!now->joined[i])
            draw_path(page, &plot, h, i, now->hit[i]);
}

static void draw(fig_page *page, FILE *numbers)
{
    history h, rounded;
    answer(&h, false);
    answer(&rounded, true);
    double width = fig_page_width(page);
    double height = fig_page_height(page) / (h.rounds + 1);
    for (int round = 0; round <= h.rounds; round++) {
        char text[16], key[32];
        fig_box box = {54, height * round + 2, width - 60, height - 4};
        draw_row(page, &h, round, box);
        snprintf(text, sizeof text, round == 0 ? "proposed" : "round %d",
                 round);
        fig_page_text(page, 4, box.y + box.height / 2 + 3, FIG_ALIGN_LEFT, text,
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
        snprintf(key, sizeof key, "displacement_%d", round);
        fig_number(numbers, key, h.after[round].displacement);
    }
    fig_number(numbers, "vertices", VERTICES);
    fig_number(numbers, "rounds", h.rounds);
    fig_number(numbers, "rounds_rounded", rounded.rounds);
}

const fig_figure fig_thrown_edge = {
    .name = "thrown-edge",
    .title = "An edge that each round of the failsafe throws across",
    .width = FIG_PAGE_WIDTH,
    .height = 246,
    .draw = draw,
};

// A curve that moves as a whole: the boxes around what its edges sweep, and boxes
// around each edge at the start and at the end.  In the film the step grows.
#include "kit/figures.h"

#include "kit/film.h"

#include "renderer/plot.h"
#include "surface/box.h"

#include <math.h>
#include <stddef.h>

enum {
    EDGES = 48
};

static const double pi = 3.141592653589793;
static const double panel_side = 180, gap = 16, panel_top = 4, text_room = 16;

static const fig_paint start_paint = {.role = FIG_ROLE_EDGE, .opacity = 0.3},
                       end_paint = {.role = FIG_ROLE_OTHER_EDGE,
                                    .opacity = 0.3},
                       swept_paint = {.role = FIG_ROLE_EDGE, .opacity = 0.05},
                       start_line = {.role = FIG_ROLE_EDGE, .opacity = 0.8},
                       end_line = {.role = FIG_ROLE_OTHER_EDGE, .opacity = 0.8},
                       swept_line = {.role = FIG_ROLE_EDGE, .opacity = 0.45};

/// A step: both ends of the motion of all vertices.
typedef struct step {
    double x[2][EDGES][2];
} step;

/// A step that goes so far, 0 to 1; the curve bends a little on its way.
static void make_step(double far, step *made)
{
    for (int end = 0; end < 2; end++)
        for (int v = 0; v < EDGES; v++) {
            double turn = 2 * pi * v / EDGES, along = end * far;
            double radius = 0.3 + 0.09 * cos(5 * turn + 0.5 * along);
            made->x[end][v][0] = 0.4 + radius * cos(turn) + 0.62 * along;
            made->x[end][v][1] = 0.4 + radius * sin(turn) + 0.55 * along;
        }
}

/// The box of an edge, around its vertices from one end to another.
static tf_box box_of(const step *s, int edge, int from, int to)
{
    tf_box box = tf_box_empty;
    for (int end = from; end <= to; end++)
        for (int i = 0; i < 2; i++) {
            const double *x = s->x[end][(edge + i) % EDGES];
            for (int k = 0; k < 2; k++) {
                box.low[k] = fminf(box.low[k], (float)x[k]);
                box.high[k] = fmaxf(box.high[k], (float)x[k]);
            }
        }
    return box;
}

// Pairs ------------------------------------------------------------------

/// On which side of another a box is, along an axis: -1, 1, or 0 if they overlap.
static int side_of(const tf_box *a, const tf_box *b, int k)
{
    return a->high[k] < b->low[k] ? -1 : a->low[k] > b->high[k];
}

static bool are_neighbors(int a, int b)
{
    return b - a == 1 || b - a == EDGES - 1;
}

static bool is_swept_pair(const step *s, int a, int b)
{
    tf_box first = box_of(s, a, 0, 1), second = box_of(s, b, 0, 1);
    return side_of(&first, &second, 0) == 0 && side_of(&first, &second, 1) == 0;
}

static bool is_pair(const step *s, int a, int b)
{
    bool apart = false;
    for (int k = 0; k < 2; k++) {
        tf_box start[] = {box_of(s, a, 0, 0), box_of(s, b, 0, 0)};
        tf_box end[] = {box_of(s, a, 1, 1), box_of(s, b, 1, 1)};
        int side = side_of(&start[0], &start[1], k);
        apart |= side != 0 && side == side_of(&end[0], &end[1], k);
    }
    return !apart;
}

static int count_pairs(const step *s, bool is(const step *, int, int))
{
    int count = 0;
    for (int a = 0; a < EDGES; a++)
        for (int b = a + 1; b < EDGES; b++)
            count += !are_neighbors(a, b) && is(s, a, b);
    return count;
}

static bool is_any_pair(const step *s, int a, int b)
{
    (void)s;
    return a != b;
}

// Drawing ----------------------------------------------------------------

static fig_plot plot_of(int panel)
{
    double margin = (FIG_PAGE_WIDTH - 2 * panel_side - gap) / 2;
    return (fig_plot){.box = {margin + panel * (panel_side + gap), panel_top,
                              panel_side, panel_side},
                      .x = {-0.02, 1.44},
                      .y = {-0.02, 1.44}};
}

static void draw_box(fig_page *page, const fig_plot *plot, tf_box box,
                     fig_paint fill, fig_paint line)
{
    fig_point low = fig_plot_place(plot, box.low[0], box.low[1]);
    fig_point high = fig_plot_place(plot, box.high[0], box.high[1]);
    const fig_point corner[4] = {low, {high.x, low.y}, high, {low.x, high.y}};
    fig_page_fill(page, 4, corner, fill);
    fig_page_line(
        page, 4, corner,
        (fig_stroke){.paint = line, .width = FIG_WIDTH_HAIR, .closed = true});
}

static void draw_curve(fig_page *page, const fig_plot *plot, const step *s,
                       int end)
{
    fig_point at[EDGES];
    for (int i = 0; i < EDGES; i++)
        at[i] = fig_plot_place(plot, s->x[end][i][0], s->x[end][i][1]);
    fig_page_line(page, EDGES, at,
                  (fig_stroke){.width = FIG_WIDTH_THIN, .closed = true});
}

static void draw_boxes(fig_page *page, const fig_plot plot[2], const step *s)
{
    for (int i = 0; i < EDGES; i++) {
        draw_box(page, &plot[0], box_of(s, i, 0, 1), swept_paint, swept_line);
        draw_box(page, &plot[1], box_of(s, i, 0, 0), start_paint, start_line);
        draw_box(page, &plot[1], box_of(s, i, 1, 1), end_paint, end_line);
    }
}

static void draw_count(fig_page *page, const fig_plot *plot, const char *boxes,
                       int pairs)
{
    char text[64];
    snprintf(text, sizeof text, "%s: %d pairs", boxes, pairs);
    fig_page_text(page, plot->box.x + panel_side / 2,
                  panel_top + panel_side + text_room - 4, FIG_ALIGN_CENTER,
                  text, FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    const fig_plot plot[] = {plot_of(0), plot_of(1)};
    step s;
    make_step(fig_film_time(page, numbers, 1, -1), &s);
    int swept = count_pairs(&s, is_swept_pair), both = count_pairs(&s, is_pair);
    draw_boxes(page, plot, &s);
    for (int end = 0; end < 2; end++) {
        draw_curve(page, &plot[0], &s, end);
        draw_curve(page, &plot[1], &s, end);
    }
    draw_count(page, &plot[0], "a box around each sweep", swept);
    draw_count(page, &plot[1], "a box at each end", both);
    fig_number(numbers, "edges", EDGES);
    fig_number(numbers, "pairs", count_pairs(&s, is_any_pair));
    fig_number(numbers, "swept", swept);
    fig_number(numbers, "both", both);
}

const fig_figure fig_bulk_motion = {
    .name = "bulk-motion",
    .title = "A curve that moves as a whole, in boxes",
    .width = FIG_PAGE_WIDTH,
    .height = 204,
    .moves = true,
    .draw = draw,
};

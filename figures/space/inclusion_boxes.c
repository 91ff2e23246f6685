// Inclusion: the square of the place on an edge and the time, divided until
// the boxes of what is left miss a point or are small.  How many boxes that
// takes where the edge passes the point, turns back at it, and slides over it.
#include "kit/figures.h"

#include "renderer/plot.h"

#include <math.h>

enum {
    SCENES = 3,
    CORNERS = 4,
    SHOWN_DEPTH = 7, ///< of the cells in the pictures
    MOST_DEPTH = 14, ///< of the counts: cells of a side of 2^-14
    MOST_CELLS = 1 << (MOST_DEPTH + 2)
};

/// The difference of the edge's ends and a point, at the four corners of the
/// square: (s, t) = (0, 0), (1, 0), (0, 1), (1, 1).
typedef struct scene {
    const char *key, *title;
    double corner[CORNERS][2];
} scene;

static const scene scenes[SCENES] = {
    {"pass", "passes", {{-1.5, -1.75}, {0, -0.75}, {0, 1.25}, {1.5, -1.75}}},
    {"turn", "turns back", {{-1.5, -0.75}, {0, 0.25}, {0, 2.25}, {1.5, -0.75}}},
    {"slide", "slides", {{-1.5, -0.75}, {1, 0.5}, {-1, -0.5}, {1.5, 0.75}}},
};

/// A cell of the square at some depth: its column (s) and row (t).
typedef struct cell {
    int column, row;
} cell;

/// What is left of a division, and how many boxes it has looked at.
typedef struct division {
    int count, looked_at;
    cell left[MOST_CELLS];
} division;

/// The difference at a place of the square, exact: all numbers have few bits.
static void difference(const scene *s, double u, double t, double x[2])
{
    for (int k = 0; k < 2; k++)
        x[k] = (1 - t) * ((1 - u) * s->corner[0][k] + u * s->corner[1][k]) +
               t * ((1 - u) * s->corner[2][k] + u * s->corner[3][k]);
}

/// Whether the box of a cell's corners holds the origin.  The image of a cell
/// is in the convex hull of its corners, and so in their box.
static bool may_hold_zero(const scene *s, cell c, double side)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < CORNERS; i++) {
        int column = c.column + i % 2, row = c.row + i / 2;
        double x[2];
        difference(s, column * side, row * side, x);
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], x[k]);
            high[k] = fmax(high[k], x[k]);
        }
    }
    return low[0] <= 0 && high[0] >= 0 && low[1] <= 0 && high[1] >= 0;
}

/// Cut what is left into quarters, and keep those that may hold the origin.
static void divide(const scene *s, double side, division *d)
{
    static cell next[MOST_CELLS];
    int count = 0;
    for (int i = 0; i < d->count; i++)
        for (int q = 0; q < CORNERS; q++) {
            cell c = {2 * d->left[i].column + q % 2,
                      2 * d->left[i].row + q / 2};
            d->looked_at++;
            if (may_hold_zero(s, c, side))
                next[count++] = c;
        }
    d->count = count;
    for (int i = 0; i < count; i++)
        d->left[i] = next[i];
}

static void draw_cells(fig_page *page, fig_box box, const division *d,
                       int depth)
{
    double side = box.width / (1 << depth);
    for (int i = 0; i < d->count; i++) {
        const cell *c = &d->left[i];
        fig_box place = {box.x + side * c->column,
                         box.y + box.height - side * (c->row + 1), side, side};
        const fig_point corner[CORNERS] = {{place.x, place.y},
                                           {place.x + side, place.y},
                                           {place.x + side, place.y + side},
                                           {place.x, place.y + side}};
        double shade = (double)depth / SHOWN_DEPTH;
        fig_page_fill_box(page, place,
                          (fig_paint){.role = FIG_ROLE_CONTACT,
                                      .opacity = 0.1 + 0.25 * shade * shade});
        fig_page_line(page, CORNERS, corner,
                      (fig_stroke){.paint.role = FIG_ROLE_NEUTRAL,
                                   .width = FIG_WIDTH_HAIR,
                                   .closed = true});
    }
}

static void name_axes(fig_page *page, fig_box box)
{
    fig_page_text(page, box.x + box.width / 2, box.y + box.height + 11,
                  FIG_ALIGN_CENTER, "$s$", FIG_LETTERS_SMALL, FIG_ROLE_INK);
    fig_page_text(page, box.x - 6, box.y + box.height / 2 + 3, FIG_ALIGN_RIGHT,
                  "$t$", FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

/// Divide the square of a scene and print how many boxes that took, for each
/// depth: the side of a cell is then 2^-depth.
static void draw_scene(fig_page *page, fig_box box, const scene *s,
                       FILE *numbers)
{
    static division d;
    d.count = 1;
    d.looked_at = 1;
    d.left[0] = (cell){0, 0};
    fig_page_fill_box(page, box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    for (int depth = 1; depth <= MOST_DEPTH; depth++) {
        divide(s, ldexp(1, -depth), &d);
        if (depth <= SHOWN_DEPTH)
            draw_cells(page, box, &d, depth);
        char key[32];
        snprintf(key, sizeof key, "%s_%d", s->key, depth);
        fig_number(numbers, key, d.looked_at);
    }
    char text[64], grouped[FIG_GROUPED];
    fig_plot_grouped(d.looked_at, grouped);
    snprintf(text, sizeof text, "%s: %s boxes", s->title, grouped);
    fig_page_text(page, box.x + box.width / 2, box.y + box.height + 26,
                  FIG_ALIGN_CENTER, text, FIG_LETTERS_SMALL, FIG_ROLE_INK);
    name_axes(page, box);
}

static void draw(fig_page *page, FILE *numbers)
{
    const double pitch = fig_page_width(page) / SCENES, side = 104;
    for (int i = 0; i < SCENES; i++) {
        fig_box box = {pitch * i + (pitch - side) / 2 + 4, 6, side, side};
        draw_scene(page, box, &scenes[i], numbers);
    }
}

const fig_figure fig_inclusion_boxes = {
    .name = "inclusion-boxes",
    .title = "Boxes that an inclusion method looks at",
    .width = FIG_PAGE_WIDTH,
    .height = 146,
    .draw = draw,
};

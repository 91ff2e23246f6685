// The Morton curve in the plane: through the cells of a small grid, and through
// points at random, a color for every sixteen.
#include "kit/figures.h"

#include "kit/random.h"
#include "renderer/plot.h"
#include "surface/tree.h"

#include <math.h>
#include <string.h>

enum {
    SIDE = 8,      ///< cells of the grid along an axis
    SIDE_BITS = 3, ///< of a cell's number
    CELLS = SIDE * SIDE,
    POINTS = 320,
    LEAVES = POINTS / TF_LANES,
    MARKED_X = 5,
    MARKED_Y = 3
};

static const double pi = 3.141592653589793;
static const double panel_side = 160, gap = 18, panel_left = 42, panel_top = 6;

static const tf_box whole = {.high = {1, 1}};

static uint32_t key_at(double x, double y)
{
    const tf_path path = {.at = {(float)x, (float)y}};
    const tf_morton_grid grid = tf_morton_grid_of(&whole, 1);
    return tf_morton_key(&path, &grid);
}

// The grid ---------------------------------------------------------------

/// The place of a cell along the curve through the grid: of the library's key
/// the leading bits of x and y.
static int cell_key(int x, int y)
{
    uint32_t key = key_at((x + 0.5) / SIDE, (y + 0.5) / SIDE);
    int place = 0;
    for (int bit = 9; bit > 9 - SIDE_BITS; bit--)
        place = place << 2 | (int)(key >> (3 * bit + 1) & 1) << 1 |
                (int)(key >> 3 * bit & 1);
    return place;
}

static fig_plot plot_of(int panel)
{
    return (fig_plot){.box = {panel_left + panel * (panel_side + gap),
                              panel_top, panel_side, panel_side},
                      .x = {0, 1},
                      .y = {0, 1}};
}

static fig_point cell_place(const fig_plot *plot, double x, double y)
{
    return fig_plot_place(plot, (x + 0.5) / SIDE, (y + 0.5) / SIDE);
}

static void write_bits(int number, int bits, char text[])
{
    for (int i = 0; i < bits; i++)
        text[i] = (char)('0' + (number >> (bits - 1 - i) & 1));
    text[bits] = '\0';
}

/// Lines between the cells, stronger between quarters, and the bits of columns
/// and rows.
static void draw_cells(fig_page *page, const fig_plot *plot)
{
    for (int i = 0; i <= SIDE; i++) {
        double at = (double)i / SIDE;
        fig_stroke stroke = {
            .paint = {.role = FIG_ROLE_NEUTRAL, .opacity = 0.7},
            .width = i % (SIDE / 2) == 0 ? FIG_WIDTH_LINE : FIG_WIDTH_HAIR};
        fig_point across[2] = {fig_plot_place(plot, 0, at),
                               fig_plot_place(plot, 1, at)};
        fig_point up[2] = {fig_plot_place(plot, at, 0),
                           fig_plot_place(plot, at, 1)};
        fig_page_line(page, 2, across, stroke);
        fig_page_line(page, 2, up, stroke);
    }
    for (int i = 0; i < SIDE; i++) {
        char text[SIDE_BITS + 1];
        write_bits(i, SIDE_BITS, text);
        fig_point column = cell_place(plot, i, -0.5);
        fig_point row = cell_place(plot, -0.5, i);
        fig_page_text(page, column.x, column.y + 11, FIG_ALIGN_CENTER, text,
                      FIG_LETTERS_SMALL - 1, FIG_ROLE_EDGE);
        fig_page_text(page, row.x - 4, row.y + 3, FIG_ALIGN_RIGHT, text,
                      FIG_LETTERS_SMALL - 1, FIG_ROLE_OTHER_EDGE);
    }
}

static void draw_grid(fig_page *page, FILE *numbers)
{
    fig_plot plot = plot_of(0);
    fig_point mark = cell_place(&plot, MARKED_X - 0.5, MARKED_Y + 0.5);
    double cell = panel_side / SIDE;
    fig_page_fill_box(page, (fig_box){mark.x, mark.y, cell, cell},
                      (fig_paint){.role = FIG_ROLE_CONTACT, .opacity = 0.35});
    draw_cells(page, &plot);
    fig_point at[CELLS];
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++)
            at[cell_key(x, y)] = cell_place(&plot, x, y);
    fig_page_line(
        page, CELLS, at,
        (fig_stroke){.paint.role = FIG_ROLE_POINT, .width = FIG_WIDTH_LINE});
    for (int i = 0; i < CELLS; i++)
        fig_page_dot(page, at[i].x, at[i].y, i == 0 || i == CELLS - 1 ? 5 : 2.4,
                     (fig_paint){.role = FIG_ROLE_POINT});
    fig_number(numbers, "marked", cell_key(MARKED_X, MARKED_Y));
}

// Points -----------------------------------------------------------------

/// Points in a disc, in Morton order.
static void place_points(double x[POINTS][2])
{
    static tf_keyed keyed[2][POINTS];
    static tf_digit_counts counts[TF_SORT_PARTS];
    double placed[POINTS][2];
    uint64_t random = 2026;
    for (int i = 0; i < POINTS; i++) {
        double radius = 0.49 * sqrt(fig_random_number(&random));
        double angle = 2 * pi * fig_random_number(&random);
        placed[i][0] = 0.5 + radius * cos(angle);
        placed[i][1] = 0.5 + radius * sin(angle);
        keyed[0][i] = (tf_keyed){key_at(placed[i][0], placed[i][1]), i};
    }
    const tf_keyed *sorted =
        tf_morton_sort(POINTS, keyed[0], keyed[1], counts, NULL);
    for (int i = 0; i < POINTS; i++)
        memcpy(x[i], placed[sorted[i].element], sizeof x[i]);
}

/// The rectangle around the points of a leaf; returns its half circumference.
static double draw_leaf(fig_page *page, const fig_plot *plot, int leaf,
                        double x[POINTS][2])
{
    static const fig_role roles[] = {FIG_ROLE_POINT, FIG_ROLE_EDGE,
                                     FIG_ROLE_OTHER_EDGE, FIG_ROLE_TRIANGLE};
    fig_role role = roles[leaf % 4];
    double low[2] = {1, 1}, high[2] = {0, 0};
    fig_point at[TF_LANES];
    for (int i = 0; i < TF_LANES; i++) {
        const double *point = x[TF_LANES * leaf + i];
        at[i] = fig_plot_place(plot, point[0], point[1]);
        fig_page_dot(page, at[i].x, at[i].y, 3.2, (fig_paint){.role = role});
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], point[k]);
            high[k] = fmax(high[k], point[k]);
        }
    }
    fig_point from = fig_plot_place(plot, low[0], high[1]);
    fig_point to = fig_plot_place(plot, high[0], low[1]);
    fig_page_fill_box(page,
                      (fig_box){from.x, from.y, to.x - from.x, to.y - from.y},
                      (fig_paint){.role = role, .opacity = 0.2});
    fig_page_line(page, TF_LANES, at,
                  (fig_stroke){.paint.role = role, .width = FIG_WIDTH_HAIR});
    return high[0] - low[0] + high[1] - low[1];
}

static void draw_points(fig_page *page, FILE *numbers)
{
    static double x[POINTS][2];
    place_points(x);
    fig_plot plot = plot_of(1);
    double sizes = 0;
    for (int leaf = 0; leaf < LEAVES; leaf++)
        sizes += draw_leaf(page, &plot, leaf, x);
    fig_number(numbers, "points", POINTS);
    fig_number(numbers, "leaves", LEAVES);
    fig_number(numbers, "mean_side", sizes / (2 * LEAVES));
}

static void draw(fig_page *page, FILE *numbers)
{
    draw_grid(page, numbers);
    draw_points(page, numbers);
}

const fig_figure fig_z_order = {
    .name = "z-order",
    .title = "The Morton curve through a grid and through points",
    .width = FIG_PAGE_WIDTH,
    .height = 194,
    .draw = draw,
};

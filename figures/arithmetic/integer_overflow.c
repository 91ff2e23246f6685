// On which side of a plane points are, by determinants in 64 bits, for
// coordinates of 19, 20 and 21 bits.
#include "arithmetic/functions.h"
#include "kit/figures.h"

#include "arithmetic/integer.h"

#include <math.h>
#include <stdint.h>

enum {
    CELLS = 255, // cells along each side of a map
    MAPS = 3
};

static const int bits[MAPS] = {19, 20, 21};

static const double map_side = 116, gap = 12, map_top = 8;

/// What became of the signs of a map.
typedef struct outcome {
    int wrong;
    double largest; ///< the largest determinant, in absolute value
} outcome;

/// An entry in 64 bits; a difference of two integers never fails to fit.
static uint64_t entry(const tf_differences *d, int i, int j)
{
    int k = d->axis[j];
    return (uint64_t)((int64_t)d->to[i]->x[k] - (int64_t)d->from[i]->x[k]);
}

static uint64_t minor(const tf_differences *d, int j)
{
    int next = (j + 1) % 3, last = (j + 2) % 3;
    return entry(d, 1, next) * entry(d, 2, last) -
           entry(d, 1, last) * entry(d, 2, next);
}

/// The sign of what 64 bits keep of a 3 x 3 determinant.  Unsigned integers,
/// unlike signed ones, are allowed to go around.
static tf_sign wrapped_sign(const tf_differences *d)
{
    uint64_t sum = 0;
    for (int j = 0; j < 3; j++)
        sum += entry(d, 0, j) * minor(d, j);
    if (sum == 0)
        return TF_ZERO;
    return sum >> 63 ? TF_NEGATIVE : TF_POSITIVE;
}

/// A coordinate of the center of a map's i-th cell.
static double coordinate(int i, double most)
{
    return trunc(most * (2 * i - (CELLS - 1)) / CELLS);
}

/// Judge the points (x, y, 0) against the plane x + y + z = -most, the highest
/// row first.
static outcome fill_map(int size, const fig_theme *theme, fig_rgb cell[])
{
    static const fig_paint paint[] = {{.role = FIG_ROLE_NEGATIVE},
                                      {.role = FIG_ROLE_PAPER},
                                      {.role = FIG_ROLE_POSITIVE}};
    double most = ldexp(1, size) - 1;
    tf_event q = {.x = {most, -most, -most}}, r = {.x = {-most, most, -most}},
             s = {.x = {-most, -most, most}};
    outcome found = {.wrong = 0};
    for (int j = CELLS - 1; j >= 0; j--)
        for (int i = 0; i < CELLS; i++) {
            tf_event p = {.x = {coordinate(i, most), coordinate(j, most), 0}};
            // In this order a point above the plane is on the positive side.
            tf_differences d = {.n = 3,
                                .to = {&r, &q, &s},
                                .from = {&p, &p, &p},
                                .axis = {0, 1, 2}};
            tf_sign sign = size <= tf_integer64.bits[3] ? tf_integer64.sign(&d)
                                                        : wrapped_sign(&d);
            found.wrong += sign != tf_integer128.sign(&d);
            found.largest =
                fmax(found.largest, fabs(tf_integer128.value(&d).number));
            *cell++ = fig_paint_color(theme, paint[sign + 1]);
        }
    return found;
}

static fig_box map_box(int i)
{
    double margin = (FIG_PAGE_WIDTH - MAPS * map_side - (MAPS - 1) * gap) / 2;
    return (fig_box){margin + i * (map_side + gap), map_top, map_side,
                     map_side};
}

/// The line in which the plane meets the map, from the middle of its left side
/// to the middle of its lower one.
static void draw_line(fig_page *page, fig_box box)
{
    fig_point end[2] = {{box.x, box.y + box.height / 2},
                        {box.x + box.width / 2, box.y + box.height}};
    fig_page_line(page, 2, end,
                  (fig_stroke){.width = FIG_WIDTH_LINE, .under_labels = true});
}

static void print_outcome(FILE *numbers, int size, const outcome *found)
{
    char key[32];
    snprintf(key, sizeof key, "wrong_%d", size);
    fig_number(numbers, key, found->wrong);
    snprintf(key, sizeof key, "wrong_percent_%d", size);
    fig_number(numbers, key, 100.0 * found->wrong / (CELLS * CELLS));
    snprintf(key, sizeof key, "largest_log2_%d", size);
    fig_number(numbers, key, log2(found->largest));
}

static void draw_map(fig_page *page, int i, FILE *numbers)
{
    static fig_rgb cell[CELLS * CELLS];
    fig_box box = map_box(i);
    outcome found = fill_map(bits[i], fig_page_theme(page), cell);
    fig_page_map(page, box, CELLS, CELLS, cell);
    draw_line(page, box);
    char text[64];
    snprintf(text, sizeof text, "*%d bits:* %.3g%% wrong", bits[i],
             100.0 * found.wrong / (CELLS * CELLS));
    fig_page_caption(page, box, text);
    print_outcome(numbers, bits[i], &found);
}

static void draw(fig_page *page, FILE *numbers)
{
    for (int i = 0; i < MAPS; i++)
        draw_map(page, i, numbers);
}

const fig_figure fig_integer_overflow = {
    .name = "integer-overflow",
    .title = "Determinants in 64 bits, of coordinates that have too many",
    .width = FIG_PAGE_WIDTH,
    .height = 148,
    .draw = draw,
};

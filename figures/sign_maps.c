// The sign of a determinant near the line where it is zero, a pixel a double.
#include "figures.h"

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "stage/plot.h"

enum {
    CELLS = 256, // doubles along each side of a map
    MAPS = 3,
    SIGNS = 4
};

/// The step from a double in [0.5, 1) to the next.
static const double step = 0x1p-53;

/// The line goes through these two points on the diagonal.
static const double near_end = 12, far_end = 24;

static const double map_side = 116, gap = 12, map_top = 126;

/// A way to find signs, and what became of it.
typedef struct sign_map {
    const char *key, *title;
    tf_sign (*sign)(const tf_differences *differences);
    int count[SIGNS]; ///< by sign, TF_NEGATIVE first
    int wrong;        ///< claims that are not so
    int opposite;     ///< of them, positive for negative or the reverse
} sign_map;

/// The sign of the rounded determinant, as if there were no rounding.
static tf_sign rounded_sign(const tf_differences *differences)
{
    double number = tf_differences_estimate(differences).number;
    return (tf_sign)((number > 0) - (number < 0));
}

/// On which side of the line a cell lies: positive is to its left.
static tf_sign cell_sign(tf_sign (*sign)(const tf_differences *), int i, int j)
{
    tf_event p = {.x = {0.5 + i * step, 0.5 + j * step}};
    tf_event q = {.x = {near_end, near_end}}, r = {.x = {far_end, far_end}};
    tf_differences d = {
        .n = 2, .to = {&q, &r}, .from = {&p, &p}, .axis = {0, 1}};
    return sign(&d);
}

/// Unknown is paler than its role, for the line to stand out on it.
static tf_paint sign_paint(tf_sign sign)
{
    static const tf_paint paint[SIGNS] = {
        {.role = TF_ROLE_NEGATIVE},
        {.role = TF_ROLE_PAPER},
        {.role = TF_ROLE_POSITIVE},
        {.role = TF_ROLE_UNCERTAIN, .shade = -0.4}};
    return paint[sign + 1];
}

static void count_sign(sign_map *map, tf_sign found, tf_sign exact)
{
    map->count[found + 1]++;
    map->wrong += found != TF_UNKNOWN && found != exact;
    map->opposite += found * exact == -1;
}

/// Find all signs, and paint them with the highest row of cells first.
static void fill_map(sign_map *map, const tf_theme *theme, tf_rgb cell[])
{
    for (int j = CELLS - 1; j >= 0; j--)
        for (int i = 0; i < CELLS; i++) {
            tf_sign found = cell_sign(map->sign, i, j);
            count_sign(map, found, cell_sign(tf_exact.sign, i, j));
            *cell++ = tf_paint_color(theme, sign_paint(found));
        }
}

static tf_box map_box(int i)
{
    double margin = (TF_FIGURE_WIDTH - MAPS * map_side - (MAPS - 1) * gap) / 2;
    return (tf_box){margin + i * (map_side + gap), map_top, map_side, map_side};
}

static void outline(tf_page *page, tf_box box)
{
    double right = box.x + box.width, below = box.y + box.height;
    double corner[4][2] = {
        {box.x, box.y}, {right, box.y}, {right, below}, {box.x, below}};
    tf_page_line(page, 4, (const double(*)[2])corner,
                 (tf_stroke){.paint = {.role = TF_ROLE_NEUTRAL},
                             .width = TF_WIDTH_HAIR,
                             .closed = true});
}

/// The true line, from the lower left corner of a box to the upper right one.
static void draw_diagonal(tf_page *page, tf_box box, double width)
{
    double end[2][2] = {{box.x, box.y + box.height},
                        {box.x + box.width, box.y}};
    tf_page_line(page, 2, (const double(*)[2])end,
                 (tf_stroke){.width = width, .under_labels = true});
}

static void draw_map(tf_page *page, tf_box box, sign_map *map)
{
    static tf_rgb cell[CELLS * CELLS];
    fill_map(map, tf_page_theme(page), cell);
    tf_page_map(page, box, CELLS, CELLS, cell);
    draw_diagonal(page, box, TF_WIDTH_THIN);
    outline(page, box);
}

/// Tell below a map how many of its signs are wrong, or else not known.
static void caption_map(tf_page *page, tf_box box, const sign_map *map)
{
    int unknown = map->count[TF_UNKNOWN + 1];
    int count = unknown > 0 ? unknown : map->wrong;
    const char *what = unknown > 0 ? "unknown" : "wrong";
    char text[64];
    if (count < 1000)
        snprintf(text, sizeof text, "*%s:* %d %s", map->title, count, what);
    else
        snprintf(text, sizeof text, "*%s:* %d\u2009%03d %s", map->title,
                 count / 1000, count % 1000, what);
    tf_page_caption(page, box, text);
}

static void print_map(FILE *numbers, const sign_map *map)
{
    static const char *const name[] = {"negative", "zero",  "positive",
                                       "unknown",  "wrong", "opposite"};
    int value[] = {map->count[0], map->count[1], map->count[2],
                   map->count[3], map->wrong,    map->opposite};
    for (int i = 0; i < 6; i++) {
        char key[32];
        snprintf(key, sizeof key, "%s_%s", map->key, name[i]);
        tf_figure_number(numbers, key, value[i]);
    }
}

/// Fill the two sides of the diagonal of a box with the colours of their signs.
static void fill_sides(tf_page *page, tf_box box)
{
    double right = box.x + box.width, below = box.y + box.height;
    double left_side[3][2] = {{box.x, below}, {right, box.y}, {box.x, box.y}};
    double right_side[3][2] = {{box.x, below}, {right, box.y}, {right, below}};
    tf_page_fill(page, 3, (const double(*)[2])left_side,
                 (tf_paint){TF_ROLE_POSITIVE, .opacity = 0.35});
    tf_page_fill(page, 3, (const double(*)[2])right_side,
                 (tf_paint){TF_ROLE_NEGATIVE, .opacity = 0.35});
}

/// A point of the diagonal of the plot, with its name.
static void draw_point(tf_page *page, const tf_plot *plot, double at,
                       tf_role role, tf_side side, const char *name)
{
    double place[2];
    tf_plot_place(plot, at, at, place);
    tf_page_dot(page, place[0], place[1], 4.5, (tf_paint){.role = role});
    tf_page_label(page, place[0], place[1],
                  (tf_label){.text = name, .role = role, .side = side});
}

/// Lines from a point of the plot to the ends of the upper side of a box.
static void draw_magnifier(tf_page *page, const tf_plot *plot, double at,
                           tf_box box)
{
    double line[3][2] = {{box.x, box.y}, {0}, {box.x + box.width, box.y}};
    tf_plot_place(plot, at, at, line[1]);
    tf_page_line(page, 3, (const double(*)[2])line,
                 (tf_stroke){.paint = {.role = TF_ROLE_NEUTRAL},
                             .width = TF_WIDTH_HAIR});
}

/// Draw the line as a whole, and where on it the cells are.
static void draw_whole_line(tf_page *page)
{
    tf_box first = map_box(0), last = map_box(MAPS - 1);
    tf_plot plot = {.box = {first.x, 6, last.x + map_side - first.x, 98},
                    .x = {-1.5, 27},
                    .y = {-1.5, 27}};
    fill_sides(page, plot.box);
    draw_magnifier(page, &plot, 0.5, first);
    draw_diagonal(page, plot.box, TF_WIDTH_LINE);
    draw_point(page, &plot, near_end, TF_ROLE_INK, TF_SIDE_SE,
               "$q = (12, 12)$");
    draw_point(page, &plot, far_end, TF_ROLE_INK, TF_SIDE_SE, "$r = (24, 24)$");
    draw_point(page, &plot, 0.5, TF_ROLE_POINT, TF_SIDE_NW, "$p$");
    tf_page_text(page, last.x + map_side - 6, 96, TF_ALIGN_RIGHT,
                 "$p = (0.5 + i u, 0.5 + j u)$, $u = 2^{-53}$, "
                 "$0 ≤ i, j < 256$",
                 TF_LETTERS_SMALL, TF_ROLE_POINT);
}

/// A coloured square and what it stands for; returns where the text ends.
static double draw_key(tf_page *page, double x, tf_sign sign, const char *text)
{
    double y = TF_FIGURE_HEIGHT - 12, width, height;
    tf_box swatch = {x, y - 7, 8, 8};
    tf_page_fill_box(page, swatch, sign_paint(sign));
    outline(page, swatch);
    tf_page_text(page, x + 12, y, TF_ALIGN_LEFT, text, TF_LETTERS_SMALL,
                 TF_ROLE_INK);
    tf_page_measure(page, text, TF_LETTERS_SMALL, &width, &height);
    return x + 12 + width;
}

/// Tell at the lower border what the colours stand for.
static void draw_legend(tf_page *page)
{
    double x = 82;
    x = draw_key(page, x, TF_POSITIVE, "positive") + 22;
    x = draw_key(page, x, TF_ZERO, "zero") + 22;
    x = draw_key(page, x, TF_NEGATIVE, "negative") + 22;
    draw_key(page, x, TF_UNKNOWN, "unknown");
}

static void draw(tf_page *page, FILE *numbers)
{
    sign_map map[MAPS] = {
        {.key = "naive", .title = "rounded", .sign = rounded_sign},
        {.key = "clamped", .title = "clamped", .sign = tf_clamped.sign},
        {.key = "exact", .title = "exact", .sign = tf_exact.sign}};
    draw_whole_line(page);
    for (int i = 0; i < MAPS; i++) {
        draw_map(page, map_box(i), &map[i]);
        caption_map(page, map_box(i), &map[i]);
        print_map(numbers, &map[i]);
    }
    draw_legend(page);
}

const tf_figure tf_figure_sign_maps = {
    .name = "sign-maps",
    .title = "The sign of a determinant near its zero, a pixel a double",
    .width = TF_FIGURE_WIDTH,
    .height = TF_FIGURE_HEIGHT,
    .draw = draw,
};

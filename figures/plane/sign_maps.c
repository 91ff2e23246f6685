// The sign of a determinant near the line where it is zero, a pixel a double.
#include "arithmetic/functions.h"
#include "kit/figures.h"

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/filter.h"
#include "renderer/plot.h"

enum {
    CELLS = 256, // doubles along each side of a map
    MAPS = 3,
    SIGNS = 4
};

/// The step from a double in [0.5, 1) to the next.
static const double step = 0x1p-53;

/// The line goes through these two points on the diagonal.
static const double near_end = 12, far_end = 24;

static const double map_side = 116, gap = 12, map_top = 148, plot_top = 6;

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

/// Zero is the lightest color of a map, and the line across it the darkest.
static fig_paint zero_paint(const fig_theme *theme)
{
    return (fig_paint){.role = theme->dark ? FIG_ROLE_INK : FIG_ROLE_PAPER};
}

static fig_paint line_paint(const fig_theme *theme)
{
    return (fig_paint){.role = theme->dark ? FIG_ROLE_PAPER : FIG_ROLE_INK};
}

/// Unknown is paler than its role, for the line to stand out on it.
static fig_paint sign_paint(const fig_theme *theme, tf_sign sign)
{
    const fig_paint paint[SIGNS] = {
        {.role = FIG_ROLE_NEGATIVE},
        zero_paint(theme),
        {.role = FIG_ROLE_POSITIVE},
        {.role = FIG_ROLE_UNCERTAIN, .shade = -0.4}};
    return paint[sign + 1];
}

static void count_sign(sign_map *map, tf_sign found, tf_sign exact)
{
    map->count[found + 1]++;
    map->wrong += found != TF_UNKNOWN && found != exact;
    map->opposite += found * exact == -1;
}

/// Find all signs, and paint them with the highest row of cells first.
static void fill_map(sign_map *map, const fig_theme *theme, fig_rgb cell[])
{
    for (int j = CELLS - 1; j >= 0; j--)
        for (int i = 0; i < CELLS; i++) {
            tf_sign found = cell_sign(map->sign, i, j);
            count_sign(map, found, cell_sign(tf_exact.sign, i, j));
            *cell++ = fig_paint_color(theme, sign_paint(theme, found));
        }
}

static fig_box map_box(int i)
{
    double margin = (FIG_PAGE_WIDTH - MAPS * map_side - (MAPS - 1) * gap) / 2;
    return (fig_box){margin + i * (map_side + gap), map_top, map_side,
                     map_side};
}

static void outline(fig_page *page, fig_box box)
{
    double right = box.x + box.width, below = box.y + box.height;
    fig_point corner[4] = {
        {box.x, box.y}, {right, box.y}, {right, below}, {box.x, below}};
    fig_page_line(page, 4, corner,
                  (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                               .width = FIG_WIDTH_HAIR,
                               .closed = true});
}

/// The true line, from the lower left corner of a box to the upper right one.
static void draw_diagonal(fig_page *page, fig_box box, double width,
                          fig_paint paint)
{
    fig_point end[2] = {{box.x, box.y + box.height},
                        {box.x + box.width, box.y}};
    fig_page_line(
        page, 2, end,
        (fig_stroke){.paint = paint, .width = width, .under_labels = true});
}

static void draw_map(fig_page *page, fig_box box, sign_map *map)
{
    static fig_rgb cell[CELLS * CELLS];
    fill_map(map, fig_page_theme(page), cell);
    fig_page_map(page, box, CELLS, CELLS, cell);
    draw_diagonal(page, box, FIG_WIDTH_THIN, line_paint(fig_page_theme(page)));
    outline(page, box);
}

/// Tell below a map how many of its signs are wrong, or else not known.
static void caption_map(fig_page *page, fig_box box, const sign_map *map)
{
    int unknown = map->count[TF_UNKNOWN + 1];
    int count = unknown > 0 ? unknown : map->wrong;
    const char *what = unknown > 0 ? "unknown" : "wrong";
    char number[FIG_GROUPED], text[64];
    fig_plot_grouped(count, number);
    snprintf(text, sizeof text, "*%s:* %s %s", map->title, number, what);
    fig_page_caption(page, box, text);
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
        fig_number(numbers, key, value[i]);
    }
}

/// Fill the two sides of the diagonal of a box with the colors of their signs.
static void fill_sides(fig_page *page, fig_box box)
{
    double right = box.x + box.width, below = box.y + box.height;
    fig_point left_side[3] = {{box.x, below}, {right, box.y}, {box.x, box.y}};
    fig_point right_side[3] = {{box.x, below}, {right, box.y}, {right, below}};
    fig_page_fill(page, 3, left_side,
                  (fig_paint){FIG_ROLE_POSITIVE, .opacity = 0.35});
    fig_page_fill(page, 3, right_side,
                  (fig_paint){FIG_ROLE_NEGATIVE, .opacity = 0.35});
}

/// A point of the diagonal of the plot, with its name.
static void draw_point(fig_page *page, const fig_plot *plot, double at,
                       fig_role role, fig_side side, const char *name)
{
    fig_point place = fig_plot_dot(page, plot, at, at, 4.5, role);
    fig_page_label(page, place.x, place.y,
                   (fig_label){.text = name, .role = role, .side = side});
}

/// Lines from a point of the plot to the ends of the upper side of a box.
static void draw_magnifier(fig_page *page, const fig_plot *plot, double at,
                           fig_box box)
{
    fig_point line[3] = {{box.x, box.y},
                         fig_plot_place(plot, at, at),
                         {box.x + box.width, box.y}};
    fig_page_line(page, 3, line,
                  (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                               .width = FIG_WIDTH_HAIR});
}

/// Draw the line as a whole, and where on it the cells are.
static void draw_whole_line(fig_page *page)
{
    fig_box first = map_box(0);
    fig_plot plot = {.box = {first.x, plot_top, map_side, map_side},
                     .x = {-1.5, 27},
                     .y = {-1.5, 27}};
    fill_sides(page, plot.box);
    draw_magnifier(page, &plot, 0.5, first);
    draw_diagonal(page, plot.box, FIG_WIDTH_LINE,
                  (fig_paint){.role = FIG_ROLE_INK});
    draw_point(page, &plot, near_end, FIG_ROLE_INK, FIG_SIDE_E,
               "$q = (12, 12)$");
    draw_point(page, &plot, far_end, FIG_ROLE_INK, FIG_SIDE_W,
               "$r = (24, 24)$");
    draw_point(page, &plot, 0.5, FIG_ROLE_POINT, FIG_SIDE_NW, "$p$");
}

/// The points that are the cells of a map.
static void write_cells(fig_page *page)
{
    double x = map_box(1).x;
    fig_page_text(page, x, plot_top + 14, FIG_ALIGN_LEFT,
                  "$p = (0.5 + i u, 0.5 + j u)$", FIG_LETTERS, FIG_ROLE_POINT);
    fig_page_text(page, x, plot_top + 30, FIG_ALIGN_LEFT,
                  "$u = 2^{-53}$, $0 ≤ i, j < 256$", FIG_LETTERS,
                  FIG_ROLE_POINT);
}

/// A colored square and what it stands for.
static void draw_key(fig_page *page, double x, double y, tf_sign sign,
                     const char *text)
{
    fig_box swatch = {x, y - 7, 8, 8};
    fig_page_fill_box(page, swatch, sign_paint(fig_page_theme(page), sign));
    outline(page, swatch);
    fig_page_text(page, x + 13, y, FIG_ALIGN_LEFT, text, FIG_LETTERS_SMALL,
                  FIG_ROLE_INK);
}

/// Show beside the line what the colors stand for.
static void draw_legend(fig_page *page)
{
    double x = map_box(1).x, y = plot_top + 60, line = 17;
    draw_key(page, x, y, TF_POSITIVE,
             "positive: $p$ is left of the path from $q$ to $r$");
    draw_key(page, x, y + line, TF_ZERO, "zero: $p$ is on the line");
    draw_key(page, x, y + 2 * line, TF_NEGATIVE,
             "negative: $p$ is right of it");
    draw_key(page, x, y + 3 * line, TF_UNKNOWN,
             "unknown: too close to call in doubles");
}

static void draw(fig_page *page, FILE *numbers)
{
    sign_map map[MAPS] = {
        {.key = "naive", .title = "rounded", .sign = rounded_sign},
        {.key = "clamped", .title = "clamped", .sign = tf_clamped.sign},
        {.key = "exact", .title = "exact", .sign = tf_exact.sign}};
    draw_whole_line(page);
    write_cells(page);
    for (int i = 0; i < MAPS; i++) {
        draw_map(page, map_box(i), &map[i]);
        caption_map(page, map_box(i), &map[i]);
        print_map(numbers, &map[i]);
    }
    draw_legend(page);
}

const fig_figure fig_sign_maps = {
    .name = "sign-maps",
    .title = "The sign of a determinant near its zero, a pixel a double",
    .width = FIG_PAGE_WIDTH,
    .height = 286,
    .draw = draw,
};

// The two triangles of a swept edge in the frame of the point, and the signs of
// the three determinants around each.
#include "arithmetic/functions.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "renderer/plot.h"

#include <math.h>

enum {
    CORNERS = 3,
    PATTERNS = 8, // a bit for each sign that is negative
    GRID = 160
};

/// A triangle of the sweep, seen from the point.
typedef struct seen {
    const char *title;
    tf_event corner[CORNERS];
    const char *name[CORNERS];
    fig_side side[CORNERS];
} seen;

// The point goes from (1, 3) to (2, 0), the edge from (0, 0), (4, 0) to (0, 1),
// (4, 2).
static const seen triangles[] = {
    {"$R_1$: *apart*",
     {{.x = {-1, -3}}, {.x = {3, -3}}, {.x = {2, 2}}},
     {"$e_0 - p$", "$e_1 - p$", "$e_1' - p'$"},
     {FIG_SIDE_SW, FIG_SIDE_SE, FIG_SIDE_NE}},
    {"$R_0$: *a hit*",
     {{.x = {-1, -3}}, {.x = {-2, 1}}, {.x = {2, 2}}},
     {"$e_0 - p$", "$e_0' - p'$", "$e_1' - p'$"},
     {FIG_SIDE_S, FIG_SIDE_NW, FIG_SIDE_NE}},
};

/// The sign of the determinant without corner i, as seen from q.
static int sign_without(const seen *s, int i, const tf_event *q)
{
    const tf_event *a = &s->corner[(i + 1) % CORNERS];
    const tf_event *b = &s->corner[(i + 2) % CORNERS];
    tf_differences d = {.n = 2, .to = {a, b}, .from = {q, q}, .axis = {0, 1}};
    return tf_exact.sign(&d);
}

/// Which signs are negative, counted so that none is in the triangle.
static int pattern_at(const seen *s, double x, double y)
{
    tf_event q = {.x = {x, y}};
    int turn = sign_without(s, 0, &s->corner[0]), pattern = 0;
    for (int i = 0; i < CORNERS; i++)
        pattern |= (sign_without(s, i, &q) * turn < 0) << i;
    return pattern;
}

static void write_pattern(fig_page *page, const fig_plot *plot, int pattern,
                          double x, double y)
{
    static const char *const text[PATTERNS] = {
        "$+$ $+$ $+$", "$-$ $+$ $+$", "$+$ $-$ $+$", "$-$ $-$ $+$",
        "$+$ $+$ $-$", "$-$ $+$ $-$", "$+$ $-$ $-$", "$-$ $-$ $-$"};
    fig_point at = fig_plot_place(plot, x, y);
    fig_page_text(page, at.x, at.y + 3, FIG_ALIGN_CENTER, text[pattern],
                  FIG_LETTERS_SMALL,
                  pattern == 0 ? FIG_ROLE_CONTACT : FIG_ROLE_INK);
}

/// How much room a pattern has that is written at a place: up to the border of
/// the plot, the lines along the triangle's sides and its corners.
static double room_at(const fig_plot *plot, const seen *s, double x, double y)
{
    // Half the extent of a pattern, in units of the plot.
    static const double half_width = 0.85, half_height = 0.35;
    double room = fmin(fmin(x - plot->x[0], plot->x[1] - x) - half_width,
                       fmin(y - plot->y[0], plot->y[1] - y) - half_height);
    for (int i = 0; i < CORNERS; i++) {
        const double *a = s->corner[i].x, *b = s->corner[(i + 1) % CORNERS].x;
        double dx = b[0] - a[0], dy = b[1] - a[1];
        double off = fabs(dx * (y - a[1]) - dy * (x - a[0]));
        double extent = fabs(dx) * half_height + fabs(dy) * half_width;
        room = fmin(room, (off - extent) / hypot(dx, dy));
        // The name of a corner stands beside it.
        room = fmin(room, hypot(x - a[0], y - a[1]) - 2.2);
    }
    return room;
}

/// Write each pattern where its region has the most room.
static void write_patterns(fig_page *page, const fig_plot *plot, const seen *s)
{
    double place[PATTERNS][2], most[PATTERNS];
    for (int p = 0; p < PATTERNS; p++)
        most[p] = -INFINITY;
    for (int i = 0; i < GRID * GRID; i++) {
        int row = i / GRID;
        double x = (i % GRID + 0.5) / GRID, y = (row + 0.5) / GRID;
        x = plot->x[0] + x * (plot->x[1] - plot->x[0]);
        y = plot->y[0] + y * (plot->y[1] - plot->y[0]);
        int pattern = pattern_at(s, x, y);
        double room = room_at(plot, s, x, y);
        // The one of the triangle makes room for the origin.
        if (pattern == 0)
            room = fmin(room, fabs(y) - 0.7);
        if (room > most[pattern]) {
            most[pattern] = room;
            place[pattern][0] = x;
            place[pattern][1] = y;
        }
    }
    for (int p = 0; p < PATTERNS; p++)
        if (most[p] > -INFINITY)
            write_pattern(page, plot, p, place[p][0], place[p][1]);
}

static void draw_sides(fig_page *page, const fig_plot *plot, const seen *s)
{
    fig_point corner[CORNERS];
    for (int i = 0; i < CORNERS; i++) {
        const double *a = s->corner[i].x, *b = s->corner[(i + 1) % CORNERS].x;
        double dx = 20 * (b[0] - a[0]), dy = 20 * (b[1] - a[1]);
        fig_point line[2] = {{a[0] - dx, a[1] - dy}, {b[0] + dx, b[1] + dy}};
        fig_plot_curve(page, plot, 2, line,
                       (fig_stroke){.paint.role = FIG_ROLE_EDGE,
                                    .width = FIG_WIDTH_THIN,
                                    .dash = 2.5});
        corner[i] = fig_plot_place(plot, a[0], a[1]);
    }
    fig_page_fill(page, CORNERS, corner,
                  (fig_paint){.role = FIG_ROLE_EDGE, .opacity = 0.25});
    fig_page_line(page, CORNERS, corner,
                  (fig_stroke){.paint.role = FIG_ROLE_EDGE,
                               .width = FIG_WIDTH_LINE,
                               .closed = true});
    for (int i = 0; i < CORNERS; i++) {
        fig_page_dot(page, corner[i].x, corner[i].y, 5,
                     (fig_paint){.role = FIG_ROLE_EDGE});
        fig_page_label(page, corner[i].x, corner[i].y,
                       (fig_label){.text = s->name[i],
                                   .role = FIG_ROLE_EDGE,
                                   .side = s->side[i],
                                   .gap = 6});
    }
}

static void draw_seen(fig_page *page, const seen *s, fig_box box)
{
    fig_plot plot = {.box = box, .x = {-5, 6}, .y = {-5.8, 5.2}};
    draw_sides(page, &plot, s);
    write_patterns(page, &plot, s);
    fig_plot_dot(page, &plot, 0, 0, 6, FIG_ROLE_POINT);
    fig_page_caption(page, box, s->title);
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = (fig_page_width(page) - 16) / 2;
    for (int i = 0; i < 2; i++) {
        draw_seen(page, &triangles[i],
                  (fig_box){i * (width + 16), 6, width, width * 10 / 11});
        fig_number(numbers, i == 0 ? "apart_pattern" : "hit_pattern",
                   pattern_at(&triangles[i], 0, 0));
    }
}

const fig_figure fig_sign_regions = {
    .name = "sign-regions",
    .title = "The signs around a triangle in the frame of the point",
    .width = FIG_PAGE_WIDTH,
    .height = 190,
    .draw = draw,
};

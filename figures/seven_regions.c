// The two triangles of a swept edge in the frame of the point, and the signs of
// the three determinants around each.
#include "figures.h"

#include "arithmetic/exact.h"
#include "stage/plot.h"

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
    tf_side side[CORNERS];
} seen;

// The point goes from (1, 3) to (2, 0), the edge from (0, 0), (4, 0) to (0, 1),
// (4, 2).
static const seen triangles[] = {
    {"$R_1$: *apart*",
     {{.x = {-1, -3}}, {.x = {3, -3}}, {.x = {2, 2}}},
     {"$e_0 - p$", "$e_1 - p$", "$e_1' - p'$"},
     {TF_SIDE_SW, TF_SIDE_SE, TF_SIDE_NE}},
    {"$R_0$: *a hit*",
     {{.x = {-1, -3}}, {.x = {-2, 1}}, {.x = {2, 2}}},
     {"$e_0 - p$", "$e_0' - p'$", "$e_1' - p'$"},
     {TF_SIDE_S, TF_SIDE_NW, TF_SIDE_NE}},
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

static void write_pattern(tf_page *page, const tf_plot *plot, int pattern,
                          double x, double y)
{
    static const char *const text[PATTERNS] = {
        "$+$ $+$ $+$", "$-$ $+$ $+$", "$+$ $-$ $+$", "$-$ $-$ $+$",
        "$+$ $+$ $-$", "$-$ $+$ $-$", "$+$ $-$ $-$", "$-$ $-$ $-$"};
    double at[2];
    tf_plot_place(plot, x, y, at);
    tf_page_text(page, at[0], at[1] + 3, TF_ALIGN_CENTER, text[pattern],
                 TF_LETTERS_SMALL,
                 pattern == 0 ? TF_ROLE_CONTACT : TF_ROLE_INK);
}

/// Write each pattern in the middle of what is seen of its region.
static void write_patterns(tf_page *page, const tf_plot *plot, const seen *s)
{
    double sum[PATTERNS][2] = {{0}};
    int count[PATTERNS] = {0};
    for (int i = 0; i < GRID * GRID; i++) {
        int row = i / GRID;
        double x = (i % GRID + 0.5) / GRID, y = (row + 0.5) / GRID;
        x = plot->x[0] + x * (plot->x[1] - plot->x[0]);
        y = plot->y[0] + y * (plot->y[1] - plot->y[0]);
        int pattern = pattern_at(s, x, y);
        sum[pattern][0] += x;
        sum[pattern][1] += y;
        count[pattern]++;
    }
    // The one of the triangle makes room for the origin.
    for (int p = 0; p < PATTERNS; p++)
        if (count[p] > 0)
            write_pattern(page, plot, p, sum[p][0] / count[p],
                          sum[p][1] / count[p] + (p == 0 ? 0.75 : 0));
}

static void draw_sides(tf_page *page, const tf_plot *plot, const seen *s)
{
    double corner[CORNERS][2];
    for (int i = 0; i < CORNERS; i++) {
        const double *a = s->corner[i].x, *b = s->corner[(i + 1) % CORNERS].x;
        double line[2][2];
        for (int k = 0; k < 2; k++) {
            line[0][k] = a[k] - 20 * (b[k] - a[k]);
            line[1][k] = b[k] + 20 * (b[k] - a[k]);
        }
        tf_plot_curve(page, plot, 2, (const double(*)[2])line,
                      (tf_stroke){.paint.role = TF_ROLE_EDGE,
                                  .width = TF_WIDTH_THIN,
                                  .dash = 2.5});
        tf_plot_place(plot, a[0], a[1], corner[i]);
    }
    tf_page_fill(page, CORNERS, (const double(*)[2])corner,
                 (tf_paint){.role = TF_ROLE_EDGE, .opacity = 0.25});
    tf_page_line(page, CORNERS, (const double(*)[2])corner,
                 (tf_stroke){.paint.role = TF_ROLE_EDGE,
                             .width = TF_WIDTH_LINE,
                             .closed = true});
    for (int i = 0; i < CORNERS; i++) {
        tf_page_dot(page, corner[i][0], corner[i][1], 5,
                    (tf_paint){.role = TF_ROLE_EDGE});
        tf_page_label(page, corner[i][0], corner[i][1],
                      (tf_label){.text = s->name[i],
                                 .role = TF_ROLE_EDGE,
                                 .side = s->side[i]});
    }
}

static void draw_seen(tf_page *page, const seen *s, tf_box box)
{
    tf_plot plot = {.box = box, .x = {-5, 6}, .y = {-5.8, 5.2}};
    draw_sides(page, &plot, s);
    write_patterns(page, &plot, s);
    double origin[2];
    tf_plot_place(&plot, 0, 0, origin);
    tf_page_dot(page, origin[0], origin[1], 6,
                (tf_paint){.role = TF_ROLE_POINT});
    tf_page_caption(page, box, s->title);
}

static void draw(tf_page *page, FILE *numbers)
{
    double width = (tf_page_width(page) - 16) / 2;
    for (int i = 0; i < 2; i++) {
        draw_seen(page, &triangles[i],
                  (tf_box){i * (width + 16), 6, width, width * 10 / 11});
        tf_figure_number(numbers, i == 0 ? "apart_pattern" : "hit_pattern",
                         pattern_at(&triangles[i], 0, 0));
    }
}

const tf_figure tf_figure_seven_regions = {
    .name = "seven-regions",
    .title = "The signs around a triangle in the frame of the point",
    .width = TF_FIGURE_WIDTH,
    .height = 190,
    .draw = draw,
};

// A path in the plane of a triangle enters it and leaves it through its legs.
#include "base/require.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "intersect/cascade.h"
#include "kit/worlds.h"
#include "query/query.h"
#include "renderer/plot.h"

/// A path and a triangle in one plane of space-time.  All lie on a line of
/// space; a place is how far along.
typedef struct flat {
    const char *title;
    double path[2];    ///< at t = 0, 1
    double base[2][2]; ///< at t = 0, 1; the apex is twice the same
    int base_time;
    const char *key;
} flat;

static const flat flats[] = {
    {"*base at* $t = 1$", {0.05, 0.8}, {{0.5, 0.5}, {0.2, 0.95}}, 1, "end"},
    {"*base at* $t = 0$", {0, 0.75}, {{0.15, 0.9}, {0.45, 0.45}}, 0, "start"},
    {"*base at* $t = 0$, *from within*",
     {0.3, 0.9},
     {{0.1, 0.85}, {0.35, 0.35}},
     0,
     "within"},
};

/// Place a vertex on the line y = x / 2.
static tf_worldline vertex_between(double start, double end)
{
    return tf_worldline_between(2, (double[]){start, start / 2},
                                (double[]){end, end / 2});
}

/// When the path and the triangle first meet, -1 if they do not.
static double triangle_time(const flat *f)
{
    tf_worldline point = vertex_between(f->path[0], f->path[1]);
    tf_worldline edge[2] = {vertex_between(f->base[0][0], f->base[1][0]),
                            vertex_between(f->base[0][1], f->base[1][1])};
    tf_simplex path[1], sweep[2];
    tf_sweep(1, &point, path);
    tf_sweep(2, edge, sweep);
    tf_pair pair = tf_pair_of(&path[0], &sweep[f->base_time], 2);
    tf_intersection meeting = tf_intersect(&tf_exact, &pair, TF_WITH_POINT);
    return meeting.verdict == TF_HIT ? (meeting.toi_lo + meeting.toi_hi) / 2
                                     : -1;
}

/// When the path first meets a leg, -1 if it does not: a leg is an edge of no
/// length.
static double leg_time(const flat *f, int leg)
{
    tf_worldline point = vertex_between(f->path[0], f->path[1]);
    tf_worldline end = vertex_between(f->base[0][leg], f->base[1][leg]);
    tf_contact contact;
    tf_status status = tf_query(&tf_exact, 2, 1, &point, 2,
                                (tf_worldline[]){end, end}, &contact);
    TF_REQUIRE(status == TF_OK);
    return fig_toi(&contact);
}

static void draw_segment(fig_page *page, const fig_plot *plot, double start,
                         double end, fig_role role, double width)
{
    fig_plot_curve(page, plot, 2, (fig_point[]){{start, 0}, {end, 1}},
                   (fig_stroke){.paint.role = role, .width = width});
}

static void draw_triangle(fig_page *page, const fig_plot *plot, const flat *f)
{
    int t = f->base_time;
    fig_point corner[3] = {fig_plot_place(plot, f->base[t][0], t),
                           fig_plot_place(plot, f->base[t][1], t),
                           fig_plot_place(plot, f->base[1 - t][0], 1 - t)};
    fig_page_fill(page, 3, corner,
                  (fig_paint){.role = FIG_ROLE_EDGE, .opacity = 0.25});
    fig_page_line(page, 2, corner,
                  (fig_stroke){.paint.role = FIG_ROLE_EDGE,
                               .width = FIG_WIDTH_THIN,
                               .dash = 3});
    for (int leg = 0; leg < 2; leg++)
        draw_segment(page, plot, f->base[0][leg], f->base[1][leg],
                     FIG_ROLE_EDGE, FIG_WIDTH_LINE);
}

/// Mark the path at a time, and write the time beside.
static void mark(fig_page *page, const fig_plot *plot, const flat *f, double t,
                 fig_role role, const char *what)
{
    char text[64];
    fig_point at = fig_plot_dot(
        page, plot, f->path[0] + t * (f->path[1] - f->path[0]), t, 6, role);
    snprintf(text, sizeof text, "%s%.3g", what, t);
    fig_page_label(page, at.x, at.y,
                   (fig_label){.text = text,
                               .role = role,
                               .size = FIG_LETTERS_SMALL,
                               .side = FIG_SIDE_E});
}

static void draw_flat(fig_page *page, const flat *f, fig_box box, FILE *numbers)
{
    fig_plot plot = {.box = box,
                     .x = {-0.1, 1.1},
                     .y = {0, 1},
                     .ticks_x = -1,
                     .ticks_y = -1};
    fig_plot_frame(page, &plot);
    draw_triangle(page, &plot, f);
    draw_segment(page, &plot, f->path[0], f->path[1], FIG_ROLE_POINT, 2);

    double first = triangle_time(f);
    char key[32];
    snprintf(key, sizeof key, "%s_time", f->key);
    fig_number(numbers, key, first);
    for (int leg = 0; leg < 2; leg++) {
        double t = leg_time(f, leg);
        if (t < 0 || t == first)
            continue;
        mark(page, &plot, f, t, FIG_ROLE_NEUTRAL, "");
        snprintf(key, sizeof key, "%s_leg_%d", f->key, leg);
        fig_number(numbers, key, t);
    }
    mark(page, &plot, f, first, FIG_ROLE_CONTACT, "");
    fig_page_text(page, box.x - 4, box.y + 6, FIG_ALIGN_RIGHT, "$t$",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    fig_page_text(page, box.x + box.width, box.y + box.height + 11,
                  FIG_ALIGN_RIGHT, "$x$", FIG_LETTERS_SMALL, FIG_ROLE_INK);
    fig_page_caption(page, (fig_box){box.x, box.y, box.width, box.height + 8},
                     f->title);
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = (fig_page_width(page) - 3 * 12 - 3 * 6) / 3;
    for (int i = 0; i < 3; i++)
        draw_flat(page, &flats[i],
                  (fig_box){12 + i * (width + 18), 8, width, 118}, numbers);
}

const fig_figure fig_coplanar_path = {
    .name = "coplanar-path",
    .title = "A path in the plane of a triangle, and the triangle's legs",
    .width = FIG_PAGE_WIDTH,
    .height = 158,
    .draw = draw,
};

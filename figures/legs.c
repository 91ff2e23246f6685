// A path in the plane of a triangle enters it and leaves it through its legs.
#include "figures.h"

#include "arithmetic/exact.h"
#include "query/point_edge.h"
#include "spacetime/meet.h"
#include "stage/plot.h"

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
    {"*base at* $t = 1$", {0.05, 0.8}, {{0.5, 0.5}, {0.2, 0.95}}, 1, "late"},
    {"*base at* $t = 0$", {0, 0.75}, {{0.15, 0.9}, {0.45, 0.45}}, 0, "early"},
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
    tf_meeting meeting = tf_meet(&tf_exact, &pair);
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
    tf_status status =
        tf_point_edge(&tf_exact, &point, (tf_worldline[]){end, end}, &contact);
    TF_REQUIRE(status == TF_OK);
    return contact.verdict == TF_HIT ? (contact.toi_lo + contact.toi_hi) / 2
                                     : -1;
}

static void draw_segment(tf_page *page, const tf_plot *plot, double start,
                         double end, tf_role role, double width)
{
    double at[2][2] = {{start, 0}, {end, 1}};
    tf_plot_curve(page, plot, 2, (const double(*)[2])at,
                  (tf_stroke){.paint.role = role, .width = width});
}

static void draw_triangle(tf_page *page, const tf_plot *plot, const flat *f)
{
    double corner[3][2];
    int t = f->base_time;
    tf_plot_place(plot, f->base[t][0], t, corner[0]);
    tf_plot_place(plot, f->base[t][1], t, corner[1]);
    tf_plot_place(plot, f->base[1 - t][0], 1 - t, corner[2]);
    tf_page_fill(page, 3, (const double(*)[2])corner,
                 (tf_paint){.role = TF_ROLE_EDGE, .opacity = 0.25});
    tf_page_line(page, 2, (const double(*)[2])corner,
                 (tf_stroke){.paint.role = TF_ROLE_EDGE,
                             .width = TF_WIDTH_THIN,
                             .dash = 3});
    for (int leg = 0; leg < 2; leg++)
        draw_segment(page, plot, f->base[0][leg], f->base[1][leg], TF_ROLE_EDGE,
                     TF_WIDTH_LINE);
}

/// Mark the path at a time, and write the time beside.
static void mark(tf_page *page, const tf_plot *plot, const flat *f, double t,
                 tf_role role, const char *what)
{
    double at[2];
    char text[64];
    tf_plot_place(plot, f->path[0] + t * (f->path[1] - f->path[0]), t, at);
    tf_page_dot(page, at[0], at[1], 6, (tf_paint){.role = role});
    snprintf(text, sizeof text, "%s%.3g", what, t);
    tf_page_label(page, at[0], at[1],
                  (tf_label){.text = text,
                             .role = role,
                             .size = TF_LETTERS_SMALL,
                             .side = TF_SIDE_E});
}

static void draw_flat(tf_page *page, const flat *f, tf_box box, FILE *numbers)
{
    tf_plot plot = {.box = box,
                    .x = {-0.1, 1.1},
                    .y = {0, 1},
                    .ticks_x = -1,
                    .ticks_y = -1};
    tf_plot_frame(page, &plot);
    draw_triangle(page, &plot, f);
    draw_segment(page, &plot, f->path[0], f->path[1], TF_ROLE_POINT, 2);

    double first = triangle_time(f);
    char key[32];
    snprintf(key, sizeof key, "%s_time", f->key);
    tf_figure_number(numbers, key, first);
    for (int leg = 0; leg < 2; leg++) {
        double t = leg_time(f, leg);
        if (t < 0 || t == first)
            continue;
        mark(page, &plot, f, t, TF_ROLE_NEUTRAL, "");
        snprintf(key, sizeof key, "%s_leg_%d", f->key, leg);
        tf_figure_number(numbers, key, t);
    }
    mark(page, &plot, f, first, TF_ROLE_CONTACT, "");
    tf_page_text(page, box.x - 4, box.y + 6, TF_ALIGN_RIGHT, "$t$",
                 TF_LETTERS_SMALL, TF_ROLE_INK);
    tf_page_caption(page, box, f->title);
}

static void draw(tf_page *page, FILE *numbers)
{
    double width = (tf_page_width(page) - 3 * 12 - 2 * 6) / 3;
    for (int i = 0; i < 3; i++)
        draw_flat(page, &flats[i],
                  (tf_box){12 + i * (width + 18), 8, width, 118}, numbers);
}

const tf_figure tf_figure_legs = {
    .name = "legs",
    .title = "A path in the plane of a triangle, and the triangle's legs",
    .width = TF_FIGURE_WIDTH,
    .height = 150,
    .draw = draw,
};

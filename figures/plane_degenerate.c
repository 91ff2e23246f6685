// Four degenerate encounters of a point and an edge in the plane: above their
// space-time, below it the projections on x-t and y-t that decide.
#include "arithmetic/exact.h"
#include "figures.h"
#include "query/point_edge.h"
#include "stage/plot.h"
#include "worlds.h"

#include <math.h>

enum {
    CASES = 4,
    POINT_AND_EDGE = 3
};

typedef struct encounter {
    const char *key, *title;
    double start[POINT_AND_EDGE][2], end[POINT_AND_EDGE][2]; ///< p, a, b
} encounter;

static const encounter encounters[CASES] = {
    {"parallel",
     "parallel motion",
     {{0.75, 0.25}, {0, 0.25}, {0.5, 0.25}},
     {{1, 0.875}, {0.25, 0.875}, {0.75, 0.875}}},
    {"point_like",
     "edge of no length",
     {{0, 0.375}, {0.875, 0.875}, {0.875, 0.875}},
     {{1, 0.625}, {0.125, 0.125}, {0.125, 0.125}}},
    {"within_plane",
     "path in the sweep’s plane",
     {{0, 0.125}, {0.25, 0.3125}, {0.75, 0.6875}},
     {{1, 0.875}, {0.25, 0.3125}, {0.75, 0.6875}}},
    {"vertex",
     "meeting at a vertex",
     {{0, 0.25}, {1, 0.25}, {0.5, 0}},
     {{1, 0.75}, {0.875, 0.875}, {0.5, 1}}},
};

/// An encounter and the library's answer.
typedef struct solved {
    const encounter *is;
    tf_worldline vertex[POINT_AND_EDGE];
    tf_simplex path;     ///< of the point
    tf_simplex sweep[2]; ///< of the edge
    tf_contact contact;
    double toi;
    double place[3]; ///< of the contact in the world, if there is one
} solved;

static void solve(const encounter *e, solved *s)
{
    s->is = e;
    for (int i = 0; i < POINT_AND_EDGE; i++)
        s->vertex[i] = tf_worldline_between(2, e->start[i], e->end[i]);
    tf_sweep(1, s->vertex, &s->path);
    tf_sweep(2, s->vertex + 1, s->sweep);
    tf_point_edge(&tf_exact, &s->vertex[0], s->vertex + 1, &s->contact);
    s->toi = (s->contact.toi_lo + s->contact.toi_hi) / 2;
    tf_worldline_place(&s->vertex[0], 2, s->toi, s->place);
    s->place[2] = s->toi;
}

static bool is_hit(const solved *s)
{
    return s->contact.verdict == TF_HIT;
}

static void print_numbers(const solved *s, FILE *numbers)
{
    char key[64];
    snprintf(key, sizeof key, "%s_hit", s->is->key);
    tf_figure_number(numbers, key, is_hit(s));
    if (!is_hit(s))
        return;
    snprintf(key, sizeof key, "%s_time", s->is->key);
    tf_figure_number(numbers, key, s->toi);
    snprintf(key, sizeof key, "%s_degenerate", s->is->key);
    tf_figure_number(numbers, key, s->contact.decision == TF_DEGENERATE);
    snprintf(key, sizeof key, "%s_touching", s->is->key);
    tf_figure_number(numbers, key, s->contact.decision == TF_TOUCHING);
}

// Space-time -------------------------------------------------------------

static const double event_ball = 5;

static void add_edge_at(tf_scene *scene, const solved *s, int time)
{
    const tf_paint paint = {.role = TF_ROLE_EDGE};
    double end[2][3];
    for (int i = 0; i < 2; i++) {
        tf_world_of_event(&s->vertex[1 + i].at[time], end[i]);
        tf_scene_ball(scene, end[i], event_ball, paint);
    }
    tf_scene_tube(scene, end[0], end[1], TF_WIDTH_TUBE, paint);
}

static void add_sweep(tf_scene *scene, const solved *s)
{
    for (int j = 0; j < 2; j++) {
        double corner[3][3];
        tf_world_of_simplex(&s->sweep[j], corner);
        tf_scene_triangle(scene, (const double(*)[3])corner, TF_WIDTH_THIN,
                          (tf_paint){.role = TF_ROLE_EDGE, .opacity = 0.4});
        // A sweep of no area still has its worldline.
        tf_scene_tube(scene, corner[s->sweep[j].mover],
                      corner[s->sweep[j].mover + 1], TF_WIDTH_LINE,
                      (tf_paint){.role = TF_ROLE_EDGE});
    }
    add_edge_at(scene, s, 0);
    add_edge_at(scene, s, 1);
}

static void add_path(tf_scene *scene, const solved *s)
{
    const tf_paint paint = {.role = TF_ROLE_POINT};
    double at[2][3];
    tf_world_of_simplex(&s->path, at);
    tf_scene_worldline(scene, at[0], at[1], TF_WIDTH_TUBE, paint);
    tf_scene_ball(scene, at[0], event_ball, paint);
    tf_scene_ball(scene, at[1], event_ball, paint);
}

/// Name the events of an encounter.
static void add_names(tf_panel *panel, const solved *s)
{
    static const char *const name[POINT_AND_EDGE][2] = {
        {"$p$", "$p'$"}, {"$a$", "$a'$"}, {"$b$", "$b'$"}};
    for (int i = 0; i < POINT_AND_EDGE; i++)
        for (int time = 0; time < 2; time++) {
            double at[3];
            tf_world_of_event(&s->vertex[i].at[time], at);
            tf_panel_label(
                panel, at,
                (tf_label){.text = name[i][time],
                           .role = i == 0 ? TF_ROLE_POINT : TF_ROLE_EDGE,
                           .side = time ? TF_SIDE_N : TF_SIDE_S});
        }
}

static void add_times(tf_panel *panel)
{
    tf_panel_label(panel, (double[]){0, 1, 1},
                   (tf_label){.text = "$t = 1$",
                              .role = TF_ROLE_END,
                              .size = TF_LETTERS_SMALL,
                              .side = TF_SIDE_N,
                              .gap = 2});
    tf_panel_label(panel, (double[]){1, 0, 0},
                   (tf_label){.text = "$t = 0$",
                              .role = TF_ROLE_START,
                              .size = TF_LETTERS_SMALL,
                              .side = TF_SIDE_S,
                              .gap = 2});
}

static void draw_space_time(tf_page *page, const solved *s, tf_box box)
{
    tf_panel *panel = tf_page_panel(page, box);
    tf_panel_look(panel, (tf_camera){.azimuth = 28,
                                     .elevation = 20,
                                     .height = 1.75,
                                     .center = {0.5, 0.5, 0.5}});
    tf_scene *scene = tf_panel_scene(panel);
    tf_world_floors(scene, 1, 1, 0.25);
    add_sweep(scene, s);
    add_path(scene, s);
    if (is_hit(s))
        tf_scene_ball(scene, s->place, TF_WIDTH_MARK,
                      (tf_paint){.role = TF_ROLE_CONTACT});
    // The first two name things for all.
    if (s->is == &encounters[0])
        add_names(panel, s);
    if (s->is == &encounters[1])
        add_times(panel);
}

// Projections ------------------------------------------------------------

/// The shadow of a simplex on the axis `axis` and time.  A path is wide, to be
/// seen where the shadow of a sweep lies on it.
static void draw_shadow(tf_page *page, const tf_plot *plot, int axis,
                        const tf_simplex *simplex, tf_role role)
{
    double at[TF_EVENTS][2];
    for (int i = 0; i < simplex->count && i < TF_EVENTS; i++)
        tf_plot_place(plot, simplex->event[i]->x[axis], simplex->event[i]->t,
                      at[i]);
    if (simplex->count > 2)
        tf_page_fill(page, simplex->count, (const double(*)[2])at,
                     (tf_paint){.role = role, .opacity = 0.25});
    tf_page_line(page, simplex->count, (const double(*)[2])at,
                 (tf_stroke){.paint.role = role,
                             .width = simplex->count > 2 ? 0.8 : 2,
                             .closed = simplex->count > 2});
}

static void draw_projection(tf_page *page, const solved *s, int axis,
                            tf_box box)
{
    tf_plot plot = {.box = box,
                    .x = {-0.08, 1.08},
                    .y = {0, 1},
                    .ticks_x = -1,
                    .ticks_y = -1};
    tf_plot_frame(page, &plot);
    draw_shadow(page, &plot, axis, &s->path, TF_ROLE_POINT);
    draw_shadow(page, &plot, axis, &s->sweep[0], TF_ROLE_EDGE);
    draw_shadow(page, &plot, axis, &s->sweep[1], TF_ROLE_EDGE);
    if (is_hit(s)) {
        double at[2];
        tf_plot_place(&plot, s->place[axis], s->place[2], at);
        tf_page_dot(page, at[0], at[1], 5, (tf_paint){.role = TF_ROLE_CONTACT});
    }
    tf_page_text(page, box.x + box.width, box.y + box.height + 9,
                 TF_ALIGN_RIGHT, axis == 0 ? "$x$" : "$y$", TF_LETTERS_SMALL,
                 TF_ROLE_INK);
    tf_page_text(page, box.x - 3, box.y + 6, TF_ALIGN_RIGHT, "$t$",
                 TF_LETTERS_SMALL, TF_ROLE_INK);
}

// The gallery ------------------------------------------------------------

static void write_verdict(tf_page *page, const solved *s, double x, double y)
{
    if (!is_hit(s)) {
        tf_page_text(page, x, y, TF_ALIGN_CENTER, "apart", TF_LETTERS,
                     TF_ROLE_INK);
        tf_page_text(page, x, y + 13, TF_ALIGN_CENTER,
                     "*as the $x$–$t$ shadows are*", TF_LETTERS_SMALL,
                     TF_ROLE_INK);
        return;
    }
    char text[64];
    snprintf(text, sizeof text, "hit at $t = %g$", s->toi);
    tf_page_text(page, x, y, TF_ALIGN_CENTER, text, TF_LETTERS,
                 TF_ROLE_CONTACT);
    tf_page_text(page, x, y + 13, TF_ALIGN_CENTER,
                 s->contact.decision == TF_DEGENERATE ? "*degenerate*"
                                                      : "*touching*",
                 TF_LETTERS_SMALL, TF_ROLE_INK);
}

static void draw_encounter(tf_page *page, const solved *s, tf_box column)
{
    double middle = column.x + column.width / 2;
    tf_page_text(page, middle, 13, TF_ALIGN_CENTER, s->is->title,
                 TF_LETTERS_SMALL, TF_ROLE_INK);
    draw_space_time(page, s, (tf_box){column.x, 18, column.width, 122});
    draw_projection(page, s, 0, (tf_box){column.x + 10, 150, 32, 56});
    draw_projection(page, s, 1, (tf_box){middle + 9, 150, 32, 56});
    write_verdict(page, s, middle, 234);
}

static void draw(tf_page *page, FILE *numbers)
{
    double width = tf_page_width(page) / CASES;
    for (int i = 0; i < CASES; i++) {
        solved s;
        solve(&encounters[i], &s);
        draw_encounter(page, &s,
                       (tf_box){i * width, 0, width, tf_page_height(page)});
        print_numbers(&s, numbers);
    }
}

const tf_figure tf_figure_plane_degenerate = {
    .name = "plane-degenerate",
    .title = "Degenerate encounters in the plane and their projections",
    .width = TF_FIGURE_WIDTH,
    .height = 256,
    .draw = draw,
};

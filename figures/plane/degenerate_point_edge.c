// Four degenerate encounters of a point and an edge in the plane: above their
// space-time, below it the projections on x-t and y-t that decide.
#include "arithmetic/exact.h"
#include "kit/figures.h"
#include "kit/worlds.h"
#include "query/query.h"
#include "renderer/plot.h"

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
     "touching at a vertex",
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
    tf_vector place; ///< of the contact in the world, if there is one
} solved;

static void solve(const encounter *e, solved *s)
{
    s->is = e;
    for (int i = 0; i < POINT_AND_EDGE; i++)
        s->vertex[i] = tf_worldline_between(2, e->start[i], e->end[i]);
    tf_sweep(1, s->vertex, &s->path);
    tf_sweep(2, s->vertex + 1, s->sweep);
    tf_query(&tf_exact, 2, 1, &s->vertex[0], 2, s->vertex + 1, &s->contact);
    s->toi = fig_toi(&s->contact);
    s->place = fig_worldline_place(&s->vertex[0], 2, s->toi);
    s->place.x[2] = s->toi;
}

static bool is_hit(const solved *s)
{
    return s->contact.verdict == TF_HIT;
}

static void print_numbers(const solved *s, FILE *numbers)
{
    char key[64];
    snprintf(key, sizeof key, "%s_hit", s->is->key);
    fig_number(numbers, key, is_hit(s));
    if (!is_hit(s))
        return;
    snprintf(key, sizeof key, "%s_time", s->is->key);
    fig_number(numbers, key, s->toi);
    snprintf(key, sizeof key, "%s_degenerate", s->is->key);
    fig_number(numbers, key, s->contact.classification == TF_DEGENERATE);
    snprintf(key, sizeof key, "%s_touching", s->is->key);
    fig_number(numbers, key, s->contact.classification == TF_TOUCHING);
}

// Space-time -------------------------------------------------------------

static const double event_ball = 5;

static void add_sweep(fig_scene *scene, const solved *s)
{
    for (int j = 0; j < 2; j++) {
        tf_vector corner[3];
        fig_world_of_simplex(&s->sweep[j], corner);
        fig_scene_triangle(scene, corner, FIG_WIDTH_THIN,
                           (fig_paint){.role = FIG_ROLE_EDGE, .opacity = 0.4});
        // A sweep of no area still has its worldline.
        fig_scene_tube(scene, corner[s->sweep[j].pivot],
                       corner[s->sweep[j].pivot + 1], FIG_WIDTH_LINE,
                       (fig_paint){.role = FIG_ROLE_EDGE});
    }
    fig_world_ends(scene, s->vertex + 1);
    for (int i = 0; i < 4; i++)
        fig_scene_ball(scene,
                       fig_world_of_event(&s->vertex[1 + i % 2].at[i / 2]),
                       event_ball, (fig_paint){.role = FIG_ROLE_EDGE});
}

static void add_path(fig_scene *scene, const solved *s)
{
    const fig_paint paint = {.role = FIG_ROLE_POINT};
    tf_vector at[2];
    fig_world_of_simplex(&s->path, at);
    fig_scene_worldline(scene, at[0], at[1], FIG_WIDTH_TUBE, paint);
    fig_scene_ball(scene, at[0], event_ball, paint);
    fig_scene_ball(scene, at[1], event_ball, paint);
}

/// Name the events of an encounter.
static void add_names(fig_panel *panel, const solved *s)
{
    static const char *const name[POINT_AND_EDGE][2] = {
        {"$p$", "$p'$"}, {"$a$", "$a'$"}, {"$b$", "$b'$"}};
    for (int i = 0; i < POINT_AND_EDGE; i++)
        for (int time = 0; time < 2; time++) {
            tf_vector at = fig_world_of_event(&s->vertex[i].at[time]);
            fig_panel_label(
                panel, at,
                (fig_label){.text = name[i][time],
                            .role = i == 0 ? FIG_ROLE_POINT : FIG_ROLE_EDGE,
                            .side = time ? FIG_SIDE_N : FIG_SIDE_S});
        }
}

static void add_times(fig_panel *panel)
{
    fig_panel_label(panel, (tf_vector){{0, 1, 1}},
                    (fig_label){.text = "$t = 1$",
                                .role = FIG_ROLE_END,
                                .size = FIG_LETTERS_SMALL,
                                .side = FIG_SIDE_N,
                                .gap = 2});
    fig_panel_label(panel, (tf_vector){{1, 0, 0}},
                    (fig_label){.text = "$t = 0$",
                                .role = FIG_ROLE_START,
                                .size = FIG_LETTERS_SMALL,
                                .side = FIG_SIDE_S,
                                .gap = 2});
}

static void draw_space_time(fig_page *page, const solved *s, fig_box box)
{
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.azimuth = 28,
                                       .elevation = 20,
                                       .height = 1.75,
                                       .center = {{0.5, 0.5, 0.5}}});
    fig_scene *scene = fig_panel_scene(panel);
    fig_world_floors(scene, 1, 1, 0.25);
    add_sweep(scene, s);
    add_path(scene, s);
    if (is_hit(s))
        fig_scene_ball(scene, s->place, FIG_WIDTH_MARK,
                       (fig_paint){.role = FIG_ROLE_CONTACT});
    // The first two name things for all.
    if (s->is == &encounters[0])
        add_names(panel, s);
    if (s->is == &encounters[1])
        add_times(panel);
}

// Projections ------------------------------------------------------------

/// The shadow of a simplex on the axis `axis` and time.  A path is wide, to be
/// seen where the shadow of a sweep lies on it.
static void draw_shadow(fig_page *page, const fig_plot *plot, int axis,
                        const tf_simplex *simplex, fig_role role)
{
    fig_point at[TF_EVENTS];
    for (int i = 0; i < simplex->count && i < TF_EVENTS; i++)
        at[i] = fig_plot_place(plot, simplex->event[i]->x[axis],
                               simplex->event[i]->t);
    if (simplex->count > 2)
        fig_page_fill(page, simplex->count, at,
                      (fig_paint){.role = role, .opacity = 0.25});
    fig_page_line(page, simplex->count, at,
                  (fig_stroke){.paint.role = role,
                               .width = simplex->count > 2 ? 0.8 : 2,
                               .closed = simplex->count > 2});
}

static void draw_projection(fig_page *page, const solved *s, int axis,
                            fig_box box)
{
    fig_plot plot = {.box = box,
                     .x = {-0.08, 1.08},
                     .y = {0, 1},
                     .ticks_x = -1,
                     .ticks_y = -1};
    fig_plot_frame(page, &plot);
    draw_shadow(page, &plot, axis, &s->path, FIG_ROLE_POINT);
    draw_shadow(page, &plot, axis, &s->sweep[0], FIG_ROLE_EDGE);
    draw_shadow(page, &plot, axis, &s->sweep[1], FIG_ROLE_EDGE);
    if (is_hit(s)) {
        fig_plot_dot(page, &plot, s->place.x[axis], s->place.x[2], 5,
                     FIG_ROLE_CONTACT);
    }
    fig_page_text(page, box.x + box.width, box.y + box.height + 9,
                  FIG_ALIGN_RIGHT, axis == 0 ? "$x$" : "$y$", FIG_LETTERS_SMALL,
                  FIG_ROLE_INK);
    fig_page_text(page, box.x - 3, box.y + 6, FIG_ALIGN_RIGHT, "$t$",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

// The gallery ------------------------------------------------------------

static void write_verdict(fig_page *page, const solved *s, double x, double y)
{
    if (!is_hit(s)) {
        fig_page_text(page, x, y, FIG_ALIGN_CENTER, "apart", FIG_LETTERS,
                      FIG_ROLE_INK);
        fig_page_text(page, x, y + 13, FIG_ALIGN_CENTER,
                      "*as the $x$–$t$ projections are*", FIG_LETTERS_SMALL,
                      FIG_ROLE_INK);
        return;
    }
    char text[64];
    snprintf(text, sizeof text, "hit at $t = %g$", s->toi);
    fig_page_text(page, x, y, FIG_ALIGN_CENTER, text, FIG_LETTERS,
                  FIG_ROLE_CONTACT);
    fig_page_text(page, x, y + 13, FIG_ALIGN_CENTER,
                  s->contact.classification == TF_DEGENERATE ? "*degenerate*"
                                                             : "*touching*",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw_encounter(fig_page *page, const solved *s, fig_box column)
{
    double middle = column.x + column.width / 2;
    fig_page_text(page, middle, 13, FIG_ALIGN_CENTER, s->is->title,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    draw_space_time(page, s, (fig_box){column.x, 18, column.width, 122});
    draw_projection(page, s, 0, (fig_box){column.x + 10, 150, 32, 56});
    draw_projection(page, s, 1, (fig_box){middle + 9, 150, 32, 56});
    write_verdict(page, s, middle, 234);
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = fig_page_width(page) / CASES;
    for (int i = 0; i < CASES; i++) {
        solved s;
        solve(&encounters[i], &s);
        draw_encounter(page, &s,
                       (fig_box){i * width, 0, width, fig_page_height(page)});
        print_numbers(&s, numbers);
    }
}

const fig_figure fig_degenerate_point_edge = {
    .name = "degenerate-point-edge",
    .title = "Degenerate encounters in the plane and their projections",
    .width = FIG_PAGE_WIDTH,
    .height = 256,
    .draw = draw,
};

// A point meets a moving edge: the picture of it in plane space-time.
#include "base/require.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "geometry/sweep.h"
#include "kit/film.h"
#include "kit/worlds.h"
#include "query/query.h"

// What the unit of the coordinates is in the drawing, a cell of its floors; with
// 3/8 all of them are exact.
static const double cell = 0.375;

/// What moves, and where it meets.
typedef struct scenario {
    tf_worldline point, edge[2];
    tf_contact contact;
} scenario;

static tf_worldline move(double x0, double y0, double x1, double y1)
{
    return tf_worldline_between(2, (double[]){x0 * cell, y0 * cell},
                                (double[]){x1 * cell, y1 * cell});
}

static scenario make_scenario(void)
{
    scenario s = {.point = move(1, 3, 2, 0),
                  .edge = {move(0, 0, 0, 1), move(4, 0, 4, 2)}};
    tf_status status =
        tf_query(&tf_exact, 2, 1, &s.point, 2, s.edge, &s.contact);
    TF_REQUIRE(status == TF_OK && s.contact.verdict == TF_HIT);
    return s;
}

/// The worldline of a vertex with its two events and their names, if any.
static void draw_vertex(fig_panel *panel, const tf_worldline *vertex,
                        double width, fig_role role, const fig_label name[2])
{
    fig_scene *scene = fig_panel_scene(panel);
    tf_vector at[2];
    for (int t = 0; t < 2; t++) {
        at[t] = fig_world_of_event(&vertex->at[t]);
        fig_scene_ball(scene, at[t], FIG_WIDTH_BALL, (fig_paint){.role = role});
        if (name)
            fig_panel_label(panel, at[t], name[t]);
    }
    fig_scene_worldline(scene, at[0], at[1], width, (fig_paint){.role = role});
}

/// The point's worldline.  In a film its names are in fixed places, as the
/// present passes them.
static void draw_point(fig_panel *panel, const tf_worldline *point, bool moves)
{
    static const fig_label name[2] = {{.text = "$p$", .side = FIG_SIDE_E},
                                      {.text = "$p'$", .side = FIG_SIDE_N}};
    draw_vertex(panel, point, FIG_WIDTH_TUBE, FIG_ROLE_POINT,
                moves ? NULL : name);
}

/// The two triangles that the edge sweeps, and the edge at both ends.
static void draw_sweep(fig_scene *scene, const tf_worldline edge[2])
{
    tf_simplex sweep[2];
    tf_sweep(2, edge, sweep);
    for (int i = 0; i < 2; i++) {
        tf_vector corner[3];
        fig_world_of_simplex(&sweep[i], corner);
        fig_scene_triangle(
            scene, corner, FIG_WIDTH_THIN,
            (fig_paint){.role = FIG_ROLE_EDGE, .opacity = i == 0 ? 0.4 : 0.55});
    }
    fig_world_ends(scene, edge);
}

/// The point and the edge as they are at the time t.  Returns where the point
/// is.
static tf_vector draw_present(fig_scene *scene, const scenario *s, double t,
                              double ball, double width, fig_role role)
{
    tf_vector edge[3];
    fig_world_of_edge(s->edge, t, edge);
    fig_scene_path(scene, 3, edge, width, (fig_paint){.role = role});
    tf_vector at = fig_worldline_place(&s->point, 2, t);
    at.x[2] = t;
    fig_scene_ball(scene, at, ball, (fig_paint){.role = role});
    return at;
}

static void draw_contact(fig_panel *panel, const scenario *s)
{
    tf_vector at =
        draw_present(fig_panel_scene(panel), s, fig_toi(&s->contact),
                     FIG_WIDTH_MARK, FIG_WIDTH_LINE, FIG_ROLE_CONTACT);
    fig_panel_label(panel, at,
                    (fig_label){.text = "contact",
                                .role = FIG_ROLE_CONTACT,
                                .side = FIG_SIDE_SE,
                                .leader = true});
}

static void draw_names(fig_panel *panel)
{
    fig_panel_axes(panel, (tf_vector){{-0.5, -0.2, 0}},
                   (tf_vector){{cell, cell, cell}},
                   (const char *[]){"$x$", "$y$", "$t$"});
    fig_panel_label(panel, (tf_vector){{0, 3 * cell, 0}},
                    (fig_label){.text = "$t = 0$",
                                .role = FIG_ROLE_START,
                                .side = FIG_SIDE_W,
                                .gap = 3});
    fig_panel_label(panel, (tf_vector){{0, 3 * cell, 1}},
                    (fig_label){.text = "$t = 1$",
                                .role = FIG_ROLE_END,
                                .side = FIG_SIDE_W,
                                .gap = 3});
}

/// What only a film shows in letters: the time, and the names of the point.
static void draw_time(fig_page *page, const fig_panel *panel, const scenario *s,
                      double t)
{
    fig_film_name(page, panel, fig_world_of_event(&s->point.at[0]), 9, 2, "$p$",
                  FIG_ROLE_INK);
    fig_film_name(page, panel, fig_world_of_event(&s->point.at[1]), 0, -10,
                  "$p'$", FIG_ROLE_INK);
    fig_film_clock(page, 4, FIG_PAGE_HEIGHT - 8, 130, t, fig_toi(&s->contact),
                   "");
}

static void print_contact(FILE *numbers, const tf_contact *contact)
{
    fig_number(numbers, "toi_lo", contact->toi_lo);
    fig_number(numbers, "toi_hi", contact->toi_hi);
    fig_number(numbers, "barycentric_e0", contact->barycentric[1][0]);
    fig_number(numbers, "barycentric_e1", contact->barycentric[1][1]);
}

static void draw(fig_page *page, FILE *numbers)
{
    scenario s = make_scenario();
    fig_panel *panel =
        fig_page_panel(page, (fig_box){0, 0, FIG_PAGE_WIDTH, FIG_PAGE_HEIGHT});
    fig_panel_look(
        panel, (fig_camera){.azimuth = -24, .elevation = 20, .distance = 6});
    fig_panel_margin(panel, 16);
    fig_scene *scene = fig_panel_scene(panel);
    fig_world_floors(scene, 4 * cell, 3 * cell, cell);
    draw_sweep(scene, s.edge);
    draw_vertex(panel, &s.edge[0], FIG_WIDTH_LINE, FIG_ROLE_EDGE,
                (fig_label[]){{.text = "$e_0$", .side = FIG_SIDE_W},
                              {.text = "$e_0'$", .side = FIG_SIDE_NW}});
    draw_vertex(panel, &s.edge[1], FIG_WIDTH_LINE, FIG_ROLE_EDGE,
                (fig_label[]){{.text = "$e_1$", .side = FIG_SIDE_E},
                              {.text = "$e_1'$", .side = FIG_SIDE_NE}});
    draw_point(panel, &s.point, fig_page_moves(page));
    double toi = fig_toi(&s.contact);
    double t = fig_film_time(page, numbers, toi, toi);
    if (t >= toi)
        draw_contact(panel, &s);
    if (fig_page_moves(page))
        draw_present(scene, &s, t, FIG_WIDTH_BALL, FIG_WIDTH_TUBE,
                     FIG_ROLE_INK);
    draw_names(panel);
    if (fig_page_moves(page))
        draw_time(page, panel, &s, t);
    print_contact(numbers, &s.contact);
}

const fig_figure fig_edge_sweep = {
    .name = "edge-sweep",
    .title = "The sweep of an edge and the worldline of a point",
    .width = FIG_PAGE_WIDTH,
    .height = FIG_PAGE_HEIGHT,
    .moves = true,
    .draw = draw,
};

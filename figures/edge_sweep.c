// A point meets a moving edge: the picture of it in plane space-time.
#include "figures.h"

#include "arithmetic/exact.h"
#include "query/point_edge.h"
#include "spacetime/sweep.h"
#include "worlds.h"

/// What moves, and where it meets.
typedef struct scenario {
    tf_worldline point, edge[2];
    tf_contact contact;
} scenario;

static scenario make_scenario(void)
{
    scenario s = {
        .point = tf_worldline_between(2, (double[]){1.2, 0.1},
                                      (double[]){0.75, 1.15}),
        .edge = {tf_worldline_between(2, (double[]){0.15, 1.05},
                                      (double[]){0.35, 0.3}),
                 tf_worldline_between(2, (double[]){1.5, 0.9},
                                      (double[]){1.6, 0.85})},
    };
    tf_status status = tf_point_edge(&tf_exact, &s.point, s.edge, &s.contact);
    TF_REQUIRE(status == TF_OK && s.contact.verdict == TF_HIT);
    return s;
}

/// The worldline of a vertex with its two events and their names.
static void draw_vertex(tf_panel *panel, const tf_worldline *vertex,
                        double width, tf_role role, const tf_label name[2])
{
    tf_scene *scene = tf_panel_scene(panel);
    double at[2][3];
    for (int t = 0; t < 2; t++) {
        tf_world_of_event(&vertex->at[t], at[t]);
        tf_scene_ball(scene, at[t], TF_WIDTH_BALL, (tf_paint){.role = role});
        tf_panel_label(panel, at[t], name[t]);
    }
    tf_scene_worldline(scene, at[0], at[1], width, (tf_paint){.role = role});
}

/// The two triangles that the edge sweeps, and the edge at both ends.
static void draw_sweep(tf_scene *scene, const tf_worldline edge[2])
{
    tf_simplex sweep[2];
    tf_sweep(2, edge, sweep);
    for (int i = 0; i < 2; i++) {
        double corner[3][3];
        tf_world_of_simplex(&sweep[i], corner);
        tf_scene_triangle(
            scene, (const double(*)[3])corner, TF_WIDTH_THIN,
            (tf_paint){.role = TF_ROLE_EDGE, .opacity = i == 0 ? 0.4 : 0.55});
    }
    for (int t = 0; t < 2; t++) {
        double end[2][3];
        for (int i = 0; i < 2; i++)
            tf_world_of_event(&edge[i].at[t], end[i]);
        tf_scene_tube(scene, end[0], end[1], TF_WIDTH_TUBE,
                      (tf_paint){.role = TF_ROLE_EDGE});
    }
}

/// The event of contact, and the edge as it is at that time.
static void draw_contact(tf_panel *panel, const scenario *s)
{
    tf_scene *scene = tf_panel_scene(panel);
    double t = (s->contact.toi_lo + s->contact.toi_hi) / 2, at[3];
    double edge[3][3];
    tf_world_of_edge(s->edge, t, edge);
    tf_scene_path(scene, 3, (const double(*)[3])edge, TF_WIDTH_LINE,
                  (tf_paint){.role = TF_ROLE_CONTACT});
    tf_worldline_place(&s->point, 2, t, at);
    at[2] = t;
    tf_scene_ball(scene, at, TF_WIDTH_MARK,
                  (tf_paint){.role = TF_ROLE_CONTACT});
    tf_panel_label(panel, at,
                   (tf_label){.text = "contact",
                              .role = TF_ROLE_CONTACT,
                              .side = TF_SIDE_SE,
                              .leader = true});
}

/// The point and the edge as they are at the time of a film.
static void draw_present(tf_scene *scene, const scenario *s, double t)
{
    double edge[3][3], at[3];
    tf_world_of_edge(s->edge, t, edge);
    tf_scene_path(scene, 3, (const double(*)[3])edge, TF_WIDTH_TUBE,
                  (tf_paint){.role = TF_ROLE_INK});
    tf_worldline_place(&s->point, 2, t, at);
    at[2] = t;
    tf_scene_ball(scene, at, TF_WIDTH_BALL, (tf_paint){.role = TF_ROLE_INK});
}

static void draw_names(tf_panel *panel)
{
    tf_panel_axes(panel, (double[]){0, 0, 0}, (double[]){0.4, 0.5, 0.36},
                  (const char *[]){"$x$", "$y$", "$t$"});
    tf_panel_label(panel, (double[]){1.75, 1.25, 0},
                   (tf_label){.text = "$t = 0$",
                              .role = TF_ROLE_START,
                              .side = TF_SIDE_E,
                              .gap = 3});
    tf_panel_label(panel, (double[]){1.75, 1.25, 1},
                   (tf_label){.text = "$t = 1$",
                              .role = TF_ROLE_END,
                              .side = TF_SIDE_E,
                              .gap = 3});
}

static void print_contact(FILE *numbers, const tf_contact *contact)
{
    tf_figure_number(numbers, "toi_lo", contact->toi_lo);
    tf_figure_number(numbers, "toi_hi", contact->toi_hi);
    tf_figure_number(numbers, "weight_e0", contact->weight[1][0]);
    tf_figure_number(numbers, "weight_e1", contact->weight[1][1]);
}

static void draw(tf_page *page, FILE *numbers)
{
    scenario s = make_scenario();
    tf_panel *panel =
        tf_page_panel(page, (tf_box){0, 0, TF_FIGURE_WIDTH, TF_FIGURE_HEIGHT});
    tf_panel_look(panel,
                  (tf_camera){.azimuth = -24, .elevation = 20, .distance = 6});
    tf_panel_margin(panel, 16);
    tf_scene *scene = tf_panel_scene(panel);
    tf_world_floors(scene, 1.75, 1.25, 0.25);
    draw_sweep(scene, s.edge);
    draw_vertex(panel, &s.edge[0], TF_WIDTH_LINE, TF_ROLE_EDGE,
                (tf_label[]){{.text = "$e_0$", .side = TF_SIDE_W},
                             {.text = "$e_0'$", .side = TF_SIDE_NW}});
    draw_vertex(panel, &s.edge[1], TF_WIDTH_LINE, TF_ROLE_EDGE,
                (tf_label[]){{.text = "$e_1$", .side = TF_SIDE_E},
                             {.text = "$e_1'$", .side = TF_SIDE_NE}});
    draw_vertex(panel, &s.point, TF_WIDTH_TUBE, TF_ROLE_POINT,
                (tf_label[]){{.text = "$p$", .side = TF_SIDE_S},
                             {.text = "$p'$", .side = TF_SIDE_N}});
    draw_contact(panel, &s);
    if (tf_page_moves(page))
        draw_present(scene, &s, tf_page_time(page));
    draw_names(panel);
    print_contact(numbers, &s.contact);
}

const tf_figure tf_figure_edge_sweep = {
    .name = "edge-sweep",
    .title = "The sweep of an edge and the worldline of a point",
    .width = TF_FIGURE_WIDTH,
    .height = TF_FIGURE_HEIGHT,
    .moves = true,
    .draw = draw,
};

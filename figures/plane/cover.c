// The cover: a ring of edges turns in the plane and sweeps a vase in
// space-time; a point flies into it through its wall.
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "geometry/sweep.h"
#include "kit/worlds.h"
#include "query/query.h"

enum {
    CORNERS = 32 // of the ring
};

/// What moves, and where the point meets the ring first.
typedef struct scenario {
    tf_worldline point, ring[CORNERS];
    tf_contact contact;
    int hit_edge; ///< from the corner of that index to the next
    int hits;     ///< edges that the point touches during the step
} scenario;

static const double start_radius = 0.78, end_radius = 0.64;
static const double turn = 114; // degrees
static const double sheet_opacity = 0.5, ring_width = 1.5, mark_width = 12;

static const fig_camera camera = {
    .azimuth = 22, .elevation = 19, .distance = 4.5};

/// The corner of the ring with that index; `turned` is in degrees.
static void find_corner(int i, double radius, double turned, double at[2])
{
    const double degree = acos(-1) / 180;
    double angle = (360.0 * i / CORNERS + turned) * degree;
    at[0] = radius * cos(angle);
    at[1] = radius * sin(angle);
}

/// The edge from the corner i to the next, in increasing order of indices.
static void find_edge(const scenario *s, int i, tf_worldline edge[2])
{
    int next = (i + 1) % CORNERS;
    edge[0] = s->ring[i < next ? i : next];
    edge[1] = s->ring[i < next ? next : i];
}

static void make_motion(scenario *s)
{
    for (int i = 0; i < CORNERS; i++) {
        double start[2], end[2];
        find_corner(i, start_radius, 0, start);
        find_corner(i, end_radius, turn, end);
        s->ring[i] = tf_worldline_between(2, start, end);
    }
    s->point = tf_worldline_between(2, (double[]){0.62, -0.95},
                                    (double[]){-0.12, 0.3});
}

static void find_contact(scenario *s)
{
    for (int i = 0; i < CORNERS; i++) {
        tf_worldline edge[2];
        tf_contact contact;
        find_edge(s, i, edge);
        tf_query(&tf_exact, 2, 1, &s->point, 2, edge, &contact);
        if (contact.verdict != TF_HIT)
            continue;
        if (s->hits++ == 0 || contact.toi_lo < s->contact.toi_lo) {
            s->contact = contact;
            s->hit_edge = i;
        }
    }
}

/// The triangles that an edge sweeps, and the worldline of its first corner.
static void draw_sweep(fig_scene *scene, const tf_worldline edge[2])
{
    tf_simplex sweep[2];
    tf_sweep(2, edge, sweep);
    for (int i = 0; i < 2; i++) {
        tf_vector corner[3];
        fig_world_of_simplex(&sweep[i], corner);
        fig_scene_triangle(scene, corner, FIG_WIDTH_HAIR,
                           (fig_paint){.role = FIG_ROLE_EDGE,
                                       .opacity = sheet_opacity,
                                       .shade = i == 0 ? -0.3 : 0});
    }
    for (int t = 0; t < 2; t++)
        fig_scene_tube(
            scene, fig_world_of_event(&edge[0].at[t]),
            fig_world_of_event(&edge[1].at[t]), FIG_WIDTH_TUBE,
            (fig_paint){.role = t == 0 ? FIG_ROLE_START : FIG_ROLE_END});
}

/// The ring as it is at the time of the contact: each edge bends at its crease.
static void draw_present(fig_scene *scene, const scenario *s, double t)
{
    for (int i = 0; i < CORNERS; i++) {
        tf_worldline edge[2];
        tf_vector bent[3];
        find_edge(s, i, edge);
        fig_world_of_edge(edge, t, bent);
        fig_scene_path(scene, 3, bent, ring_width,
                       (fig_paint){.role = FIG_ROLE_CONTACT});
    }
}

static void draw_point(fig_scene *scene, const scenario *s, double t)
{
    tf_vector at[2] = {fig_world_of_event(&s->point.at[0]),
                       fig_world_of_event(&s->point.at[1])};
    tf_vector contact = fig_lerp(at[0], at[1], t);
    for (int i = 0; i < 2; i++)
        fig_scene_ball(scene, at[i], FIG_WIDTH_BALL,
                       (fig_paint){.role = FIG_ROLE_POINT});
    fig_scene_tube(scene, at[0], at[1], FIG_WIDTH_TUBE,
                   (fig_paint){.role = FIG_ROLE_POINT});
    fig_scene_ball(scene, contact, mark_width,
                   (fig_paint){.role = FIG_ROLE_CONTACT});
}

static void draw_times(fig_panel *panel, const scenario *s)
{
    static const fig_label name[2] = {
        {.text = "$t = 0$", .role = FIG_ROLE_START, .side = FIG_SIDE_SE},
        {.text = "$t = 1$", .role = FIG_ROLE_END, .side = FIG_SIDE_E}};
    static const int corner[2] = {1, 23};
    for (int t = 0; t < 2; t++)
        fig_panel_label(panel, fig_world_of_event(&s->ring[corner[t]].at[t]),
                        name[t]);
}

static void print_contact(const scenario *s, FILE *numbers)
{
    fig_number(numbers, "corners", CORNERS);
    fig_number(numbers, "hits", s->hits);
    fig_number(numbers, "hit_edge", s->hit_edge);
    fig_number(numbers, "toi", fig_toi(&s->contact));
}

static void draw(fig_page *page, FILE *numbers)
{
    scenario s = {.hits = 0};
    make_motion(&s);
    find_contact(&s);
    fig_panel *panel = fig_page_panel(
        page, (fig_box){0, 0, fig_page_width(page), fig_page_height(page)});
    fig_panel_look(panel, camera);
    fig_panel_margin(panel, 8);
    fig_scene *scene = fig_panel_scene(panel);
    for (int i = 0; i < CORNERS; i++) {
        tf_worldline edge[2];
        find_edge(&s, i, edge);
        draw_sweep(scene, edge);
    }
    draw_present(scene, &s, fig_toi(&s.contact));
    draw_point(scene, &s, fig_toi(&s.contact));
    draw_times(panel, &s);
    print_contact(&s, numbers);
}

const fig_figure fig_cover = {
    .name = "cover",
    .title = "A point enters a turning ring of edges",
    .width = FIG_PAGE_WIDTH,
    .height = 340,
    .draw = draw,
};

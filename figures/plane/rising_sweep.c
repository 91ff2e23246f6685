// A point and an edge of the plane in motion, and beside them their sweeps,
// which grow in plane space-time as the present rises.
#include "base/require.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "kit/film.h"
#include "kit/worlds.h"
#include "query/query.h"

/// Events are drawn at this fraction of their coordinates; a power of two
/// leaves the time of the contact as it is.
static const double scale = 0.25;

static const double point[2][2] = {{1, 3}, {2, 0}};
static const double edge[2][2][2] = {{{0, 0}, {0, 1}}, {{4, 0}, {4, 2}}};

static const fig_box plane_box = {4, 20, 168, 146},
                     solid_box = {178, 6, 206, 180},
                     solid_title = {196, 20, 160, 0};

typedef struct scenario {
    tf_worldline point, edge[2];
    double toi;
} scenario;

static tf_worldline scaled(const double from[2], const double to[2])
{
    return tf_worldline_between(2, (double[]){scale * from[0], scale * from[1]},
                                (double[]){scale * to[0], scale * to[1]});
}

static scenario make_scenario(void)
{
    scenario s = {
        scaled(point[0], point[1]),
        {scaled(edge[0][0], edge[0][1]), scaled(edge[1][0], edge[1][1])},
        0};
    tf_contact contact;
    tf_status status = tf_query(&tf_exact, 2, 1, &s.point, 2, s.edge, &contact);
    TF_REQUIRE(status == TF_OK && contact.verdict == TF_HIT);
    s.toi = fig_toi(&contact);
    return s;
}

/// Where the point is at the time t, at the height of that time or, if it is
/// flat, at 0.
static tf_vector place_at(const tf_worldline *vertex, double t, bool flat)
{
    tf_vector place = fig_worldline_place(vertex, 2, t);
    place.x[2] = flat ? 0 : t;
    return place;
}

static void find_edge(const scenario *s, double t, bool flat,
                      tf_vector place[3])
{
    fig_world_of_edge(s->edge, t, place);
    for (int i = 0; i < 3 && flat; i++)
        place[i].x[2] = 0;
}

static void reach_all(fig_scene *scene, bool flat)
{
    for (int x = 0; x < 2; x++)
        for (int y = 0; y < 2; y++)
            for (int t = 0; t < (flat ? 1 : 2); t++)
                fig_scene_reach(scene,
                                (tf_vector){{4 * scale * x, 3 * scale * y, t}});
}

/// The point and the edge at the time t, and where they met.
static void draw_present(fig_scene *scene, const scenario *s, double t,
                         bool flat)
{
    tf_vector place[3];
    find_edge(s, t, flat, place);
    fig_scene_path(scene, 3, place, FIG_WIDTH_TUBE,
                   (fig_paint){.role = FIG_ROLE_EDGE});
    for (int i = 0; i < 3; i += 2)
        fig_scene_ball(scene, place[i], 5, (fig_paint){.role = FIG_ROLE_EDGE});
    fig_scene_ball(scene, place_at(&s->point, t, flat), 5,
                   (fig_paint){.role = FIG_ROLE_POINT});
    if (t >= s->toi)
        fig_scene_ball(scene, place_at(&s->point, s->toi, flat), FIG_WIDTH_MARK,
                       (fig_paint){.role = FIG_ROLE_CONTACT});
}

/// The plane at the time t, with the ways of all vertices so far.
static void draw_plane(fig_page *page, const scenario *s, double t)
{
    fig_page_fill_box(page, plane_box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    fig_panel *panel = fig_page_panel(page, plane_box);
    fig_panel_look(panel, (fig_camera){.elevation = 90});
    fig_panel_margin(panel, 22);
    fig_panel_fix(panel);
    fig_scene *scene = fig_panel_scene(panel);
    reach_all(scene, true);
    const tf_worldline *vertex[] = {&s->point, &s->edge[0], &s->edge[1]};
    for (int i = 0; i < 3; i++)
        fig_scene_dashes(scene, place_at(vertex[i], 0, true),
                         place_at(vertex[i], 1, true), FIG_WIDTH_HAIR, 2,
                         (fig_paint){.role = FIG_ROLE_NEUTRAL});
    tf_vector first[3];
    find_edge(s, 0, true, first);
    fig_scene_dashes(scene, first[0], first[2], FIG_WIDTH_HAIR, 2,
                     (fig_paint){.role = FIG_ROLE_EDGE});
    draw_present(scene, s, t, true);
    tf_vector place[3];
    find_edge(s, t, true, place);
    fig_film_name(page, panel, place[0], -11, 0, "$e_0$", FIG_ROLE_EDGE);
    fig_film_name(page, panel, place[2], 11, 0, "$e_1$", FIG_ROLE_EDGE);
    fig_film_name(page, panel, place_at(&s->point, t, true), 9, -10, "$p$",
                  FIG_ROLE_POINT);
    fig_page_title(page, plane_box, "the plane");
}

/// What the edge has swept by the time t: the lower parts of two triangles.
static void draw_sweep(fig_scene *scene, const scenario *s, double t)
{
    tf_vector e0 = place_at(&s->edge[0], 0, false);
    tf_vector e1 = place_at(&s->edge[1], 0, false), now[3];
    find_edge(s, t, false, now);
    const tf_vector part[3][3] = {
        {e0, now[0], now[1]}, {e0, e1, now[1]}, {e1, now[2], now[1]}};
    for (int i = 0; i < 3 && t > 0; i++)
        fig_scene_triangle(
            scene, part[i], 0,
            (fig_paint){.role = FIG_ROLE_EDGE, .opacity = i == 0 ? 0.55 : 0.4});
    if (t > 0)
        fig_scene_tube(scene, e0, now[1], FIG_WIDTH_THIN,
                       (fig_paint){.role = FIG_ROLE_EDGE, .shade = 0.3});
}

/// The same in space-time, and all that was before.
static void draw_solid(fig_page *page, const scenario *s, double t)
{
    fig_panel *panel = fig_page_panel(page, solid_box);
    fig_panel_look(panel, (fig_camera){.azimuth = -20, .elevation = 22});
    fig_panel_margin(panel, 20);
    fig_page_title(page, solid_title, "space-time");
    fig_scene *scene = fig_panel_scene(panel);
    reach_all(scene, false);
    fig_world_floors(scene, 4 * scale, 3 * scale, scale);
    fig_scene_grid(scene, (tf_vector){{0, 0, t}},
                   (tf_vector){{4 * scale, 0, 0}},
                   (tf_vector){{0, 3 * scale, 0}}, 1, 1, FIG_ROLE_NEUTRAL);
    draw_sweep(scene, s, t);
    const tf_worldline *vertex[] = {&s->point, &s->edge[0], &s->edge[1]};
    for (int i = 0; i < 3; i++) {
        fig_paint paint = {.role = i == 0 ? FIG_ROLE_POINT : FIG_ROLE_EDGE};
        tf_vector now = place_at(vertex[i], t, false);
        fig_scene_ball(scene, place_at(vertex[i], 0, false), 4, paint);
        fig_scene_dashes(scene, now, place_at(vertex[i], 1, false),
                         FIG_WIDTH_HAIR, 2,
                         (fig_paint){.role = FIG_ROLE_NEUTRAL});
        if (t > 0)
            fig_scene_tube(scene, place_at(vertex[i], 0, false), now,
                           FIG_WIDTH_LINE, paint);
    }
    draw_present(scene, s, t, false);
    tf_vector corner = {{4 * scale, 0, 0}}, above = {{4 * scale, 0, 1}};
    fig_film_name(page, panel, corner, 14, 6, "$t = 0$", FIG_ROLE_START);
    fig_film_name(page, panel, above, 18, 0, "$t = 1$", FIG_ROLE_END);
}

static void draw(fig_page *page, FILE *numbers)
{
    scenario s = make_scenario();
    double t = fig_film_time(page, numbers, s.toi, s.toi);
    draw_plane(page, &s, t);
    draw_solid(page, &s, t);
    fig_film_clock(page, plane_box.x, 196, FIG_PAGE_WIDTH - 2 * plane_box.x, t,
                   s.toi, "contact");
    fig_number(numbers, "toi", s.toi);
}

const fig_figure fig_rising_sweep = {
    .name = "rising-sweep",
    .title = "A point and an edge in motion, and their growing sweeps",
    .width = FIG_PAGE_WIDTH,
    .height = 206,
    .moves = true,
    .draw = draw,
};

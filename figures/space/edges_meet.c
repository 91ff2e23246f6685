// Two edges move and meet: the edges as they are, bent, and the sheets that
// they have swept so far, from two sides.
#include "base/require.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "kit/film.h"
#include "kit/worlds.h"
#include "query/query.h"

enum {
    EDGES = 2
};

// They meet at half time.
static const double start[EDGES][2][3] = {
    {{-2.625, -1, -1}, {1.375, 0.5, -2}},
    {{0.5, -1.375, 2.75}, {-0.5, 2.625, 1.5}}};
static const double finish[EDGES][2][3] = {
    {{-2.875, -0.5, 0.5}, {1.375, -0.5, 2.75}},
    {{-0.25, -1.375, -2}, {0.75, 2.625, -1}}};

static const fig_role role[EDGES] = {FIG_ROLE_EDGE, FIG_ROLE_OTHER_EDGE};

typedef struct encounter {
    tf_worldline edge[EDGES][2];
    double toi;
    tf_vector place; ///< of the contact
} encounter;

/// An edge at the time t: its first end, the crease and its second end.
static void find_edge(const tf_worldline edge[2], double t, tf_vector place[3])
{
    tf_simplex sweep[2];
    tf_sweep(2, edge, sweep);
    fig_slice second = fig_slice_of(&sweep[0], 3, t);
    fig_slice first = fig_slice_of(&sweep[1], 3, t);
    place[0] = first.corner[0];
    place[1] = first.corner[1];
    place[2] = second.corner[1];
}

/// Where the point with the weight s of the second end is at the time t, which
/// is the weight of the crease.
static tf_vector painted_place(const tf_worldline edge[2], double s, double t)
{
    tf_vector now[3];
    find_edge(edge, t, now);
    return s < t ? fig_lerp(now[0], now[1], s / t)
                 : fig_lerp(now[1], now[2], (s - t) / (1 - t));
}

static void solve(encounter *e)
{
    for (int k = 0; k < EDGES; k++)
        for (int i = 0; i < 2; i++)
            e->edge[k][i] = tf_worldline_between(3, start[k][i], finish[k][i]);
    tf_contact contact;
    tf_status status =
        tf_query(&tf_exact, 3, 2, e->edge[0], 2, e->edge[1], &contact);
    TF_REQUIRE(status == TF_OK && contact.verdict == TF_HIT);
    e->toi = fig_toi(&contact);
    e->place = painted_place(e->edge[0], contact.barycentric[0][1], e->toi);
}

/// All that the edges reach, the ways of their ends, and what they have swept
/// by the time t.
static void draw_sheets(fig_scene *scene, const tf_worldline edge[2], double t,
                        fig_role own)
{
    tf_vector now[3], end[2][2];
    find_edge(edge, t, now);
    for (int i = 0; i < 2; i++) {
        for (int at = 0; at < 2; at++)
            end[i][at] = fig_worldline_place(&edge[i], 3, at);
        fig_scene_reach(scene, end[i][1]);
        fig_scene_dashes(scene, end[i][0], end[i][1], FIG_WIDTH_HAIR, 2,
                         (fig_paint){.role = FIG_ROLE_NEUTRAL});
    }
    if (t == 0)
        return;
    const tf_vector part[3][3] = {{end[0][0], now[0], now[1]},
                                  {end[0][0], end[1][0], now[1]},
                                  {end[1][0], now[2], now[1]}};
    for (int i = 0; i < 3; i++)
        fig_scene_triangle(scene, part[i], 0,
                           (fig_paint){.role = own, .opacity = 0.3});
    fig_scene_tube(scene, end[0][0], now[1], FIG_WIDTH_HAIR,
                   (fig_paint){.role = own, .shade = 0.3});
}

static void draw_edge(fig_scene *scene, const tf_worldline edge[2], double t,
                      fig_role own)
{
    tf_vector now[3];
    find_edge(edge, t, now);
    fig_scene_path(scene, 3, now, FIG_WIDTH_TUBE, (fig_paint){.role = own});
    for (int i = 0; i < 3; i++)
        if (i != 1 || (t > 0 && t < 1))
            fig_scene_ball(scene, now[i], i == 1 ? 3.6 : 5,
                           (fig_paint){.role = own});
}

/// A side to look from, and where the names of the ends are from there.
typedef struct view {
    fig_camera camera;
    fig_box box;
    double dx[EDGES][2], dy[EDGES][2];
} view;

static const view views[2] = {{{.azimuth = 57, .elevation = 18},
                               {0, 20, 190, 188},
                               {{-9, 9}, {-10, 10}},
                               {{7, 7}, {5, 5}}},
                              {{.azimuth = -20, .elevation = 12},
                               {194, 20, 190, 188},
                               {{-10, 10}, {-9, -9}},
                               {{0, 0}, {0, -8}}}};

static void draw_view(fig_page *page, const view *v, const encounter *e,
                      double t)
{
    static const char *const name[EDGES][2] = {{"$a_0$", "$a_1$"},
                                               {"$b_0$", "$b_1$"}};
    fig_panel *panel = fig_page_panel(page, v->box);
    fig_panel_look(panel, v->camera);
    fig_panel_margin(panel, 16);
    fig_scene *scene = fig_panel_scene(panel);
    for (int k = 0; k < EDGES; k++) {
        draw_sheets(scene, e->edge[k], t, role[k]);
        draw_edge(scene, e->edge[k], t, role[k]);
    }
    if (t >= e->toi)
        fig_scene_ball(scene, e->place, FIG_WIDTH_MARK,
                       (fig_paint){.role = FIG_ROLE_CONTACT});
    for (int k = 0; k < EDGES; k++)
        for (int i = 0; i < 2; i++)
            fig_film_name(page, panel,
                          fig_worldline_place(&e->edge[k][i], 3, t),
                          v->dx[k][i], v->dy[k][i], name[k][i], role[k]);
}

static void draw(fig_page *page, FILE *numbers)
{
    encounter e;
    solve(&e);
    double t = fig_film_time(page, numbers, e.toi, e.toi);
    for (int i = 0; i < 2; i++)
        draw_view(page, &views[i], &e, t);
    fig_page_title(page, views[0].box, "from one side");
    fig_page_title(page, views[1].box, "from another");
    fig_film_clock(page, 4, 224, FIG_PAGE_WIDTH - 8, t, e.toi, "contact");
    fig_number(numbers, "toi", e.toi);
}

const fig_figure fig_edges_meet = {
    .name = "edges-meet",
    .title = "Two moving edges and what they sweep, from two sides",
    .width = FIG_PAGE_WIDTH,
    .height = 234,
    .moves = true,
    .draw = draw,
};

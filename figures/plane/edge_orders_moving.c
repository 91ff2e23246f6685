// The same edge in the two orders of its ends, side by side, as it moves, and a
// point that meets it in one of them.
#include "base/require.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "kit/film.h"
#include "kit/worlds.h"
#include "query/query.h"

enum {
    ORDERS = 2,
    BEND = 3
};

/// The left and the right end of the edge, each from its start to its end.
static const double end[2][2][2] = {{{0, 0}, {0, 1}}, {{4, 0}, {4, 2}}};

static const double point[2][2] = {{4.5, 0.5}, {0.5, 1.5}};

static const fig_box panel_box[ORDERS] = {{4, 20, 184, 104},
                                          {196, 20, 184, 104}};

/// A motion of the edge, and when the point meets it; -1: never.
typedef struct motion {
    tf_worldline point, edge[2];
    bool swapped; ///< the right end is the first
    double toi;
} motion;

static motion make_motion(bool swapped)
{
    motion m = {.point = tf_worldline_between(2, point[0], point[1]),
                .swapped = swapped};
    for (int i = 0; i < 2; i++) {
        int own = swapped ? 1 - i : i;
        m.edge[i] = tf_worldline_between(2, end[own][0], end[own][1]);
    }
    tf_contact contact;
    tf_status status = tf_query(&tf_exact, 2, 1, &m.point, 2, m.edge, &contact);
    TF_REQUIRE(status == TF_OK);
    m.toi = fig_toi(&contact);
    return m;
}

static tf_vector place_at(const tf_worldline *vertex, double t)
{
    return fig_worldline_place(vertex, 2, t);
}

static void find_edge(const motion *m, double t, tf_vector place[BEND])
{
    fig_world_of_edge(m->edge, t, place);
    for (int i = 0; i < BEND; i++)
        place[i].x[2] = 0;
}

/// The ways of the vertices, where the crease passes, and the straight edge.
static void draw_ways(fig_scene *scene, const motion *m, double t)
{
    const fig_paint faint = {.role = FIG_ROLE_NEUTRAL};
    const tf_worldline *vertex[] = {&m->point, &m->edge[0], &m->edge[1]};
    for (int i = 0; i < 3; i++)
        fig_scene_dashes(scene, place_at(vertex[i], 0), place_at(vertex[i], 1),
                         FIG_WIDTH_HAIR, 2, faint);
    fig_scene_dashes(scene, place_at(&m->edge[0], t), place_at(&m->edge[1], t),
                     FIG_WIDTH_THIN, 3, (fig_paint){.role = FIG_ROLE_EDGE});
    fig_scene_tube(scene, place_at(&m->point, 0), place_at(&m->point, t),
                   FIG_WIDTH_LINE, (fig_paint){.role = FIG_ROLE_POINT});
}

static void draw_names(fig_page *page, const fig_panel *panel, const motion *m,
                       double t)
{
    static const char *const name[] = {"$e_0$", "$e_1$"};
    for (int i = 0; i < 2; i++)
        fig_film_name(page, panel, place_at(&m->edge[i], t),
                      (i == 0) != m->swapped ? -11 : 11, 0, name[i],
                      FIG_ROLE_EDGE);
    fig_film_name(page, panel, place_at(&m->point, t), 3, -11, "$p$",
                  FIG_ROLE_POINT);
}

static void draw_motion(fig_page *page, fig_box box, const motion *m, double t)
{
    fig_page_fill_box(page, box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.elevation = 90});
    fig_panel_margin(panel, 22);
    fig_panel_fix(panel);
    fig_scene *scene = fig_panel_scene(panel);
    draw_ways(scene, m, t);
    tf_vector now[BEND];
    find_edge(m, t, now);
    fig_scene_path(scene, BEND, now, FIG_WIDTH_TUBE,
                   (fig_paint){.role = FIG_ROLE_EDGE});
    for (int i = 0; i < BEND; i++)
        fig_scene_ball(scene, now[i], i == 1 ? 3.6 : 5,
                       (fig_paint){.role = FIG_ROLE_EDGE});
    fig_scene_ball(scene, place_at(&m->point, t), FIG_WIDTH_BALL,
                   (fig_paint){.role = FIG_ROLE_POINT});
    if (m->toi >= 0 && t >= m->toi)
        fig_scene_ball(scene, place_at(&m->point, m->toi), FIG_WIDTH_MARK,
                       (fig_paint){.role = FIG_ROLE_CONTACT});
    draw_names(page, panel, m, t);
    fig_page_title(page, box,
                   m->swapped ? "left end pulls first"
                              : "right end pulls first");
}

static void draw(fig_page *page, FILE *numbers)
{
    const motion m[ORDERS] = {make_motion(false), make_motion(true)};
    double t = fig_film_time(page, numbers, m[0].toi, m[0].toi);
    for (int i = 0; i < ORDERS; i++)
        draw_motion(page, panel_box[i], &m[i], t);
    fig_film_clock(page, 4, 150, FIG_PAGE_WIDTH - 8, t, m[0].toi,
                   "contact on the left");
    fig_number(numbers, "toi", m[0].toi);
    fig_number(numbers, "toi_swapped", m[1].toi);
}

const fig_figure fig_edge_orders_moving = {
    .name = "edge-orders-moving",
    .title = "An edge in motion in the two orders of its ends",
    .width = FIG_PAGE_WIDTH,
    .height = 160,
    .moves = true,
    .draw = draw,
};

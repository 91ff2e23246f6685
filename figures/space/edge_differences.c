// Two edges of the plane at the start, in contact and at the end of a step, and
// the differences of their points on the border of the square of weights: a
// closed curve that passes the origin when an end of an edge meets the other.
#include "base/require.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "kit/film.h"
#include "kit/worlds.h"
#include "query/query.h"

#include <math.h>

enum {
    EDGES = 2,
    COLUMNS = 3,
    BEND = 3,             ///< the points of a bent edge
    BAND = 4 * (BEND - 1) ///< the corners of the curve
};

static const double start[EDGES][2][2] = {{{-1.3, -0.3}, {-0.35, 0.45}},
                                          {{0.3, -0.9}, {0.5, 0.8}}};
static const double end[EDGES][2][2] = {{{-0.75, -0.35}, {0.85, 0.1}},
                                        {{0.1, -0.7}, {0.15, 1}}};

static const fig_role role[EDGES] = {FIG_ROLE_EDGE, FIG_ROLE_OTHER_EDGE};
static const double row_top[2] = {20, 138}, row_height[2] = {104, 112};

typedef struct encounter {
    tf_worldline edge[EDGES][2];
    double toi;
} encounter;

/// The second end of the first edge meets the second edge.
static void solve(encounter *e)
{
    for (int k = 0; k < EDGES; k++)
        for (int i = 0; i < 2; i++)
            e->edge[k][i] = tf_worldline_between(2, start[k][i], end[k][i]);
    tf_contact contact;
    tf_status status =
        tf_query(&tf_exact, 2, 1, &e->edge[0][1], 2, e->edge[1], &contact);
    TF_REQUIRE(status == TF_OK && contact.verdict == TF_HIT);
    e->toi = fig_toi(&contact);
}

/// An edge at the time t, flat in the world: its ends and the crease between.
static void find_edge(const tf_worldline edge[2], double t, tf_vector place[])
{
    fig_world_of_edge(edge, t, place);
    for (int i = 0; i < BEND; i++)
        place[i].x[2] = 0;
}

/// The differences of the edges' points at the time t, once around the border
/// of the square of their weights.
static void find_band(const encounter *e, double t, tf_vector band[BAND])
{
    tf_vector first[BEND], second[BEND];
    find_edge(e->edge[0], t, first);
    find_edge(e->edge[1], t, second);
    int last = BEND - 1, count = 0;
    for (int i = 0; i < last; i++)
        band[count++] = fig_difference(first[i], second[0]);
    for (int i = 0; i < last; i++)
        band[count++] = fig_difference(first[last], second[i]);
    for (int i = 0; i < last; i++)
        band[count++] = fig_difference(first[last - i], second[last]);
    for (int i = 0; i < last; i++)
        band[count++] = fig_difference(first[0], second[last - i]);
}

/// How often the curve goes around the origin.
static double winding_number(const tf_vector band[BAND])
{
    double turns = 0;
    for (int i = 0; i < BAND; i++) {
        tf_vector a = band[i], b = band[(i + 1) % BAND];
        turns += atan2(fig_cross(a, b).x[2], tf_vector_dot(a, b));
    }
    return round(turns / (2 * acos(-1))) + 0.0;
}

static fig_box column_box(const fig_page *page, int row, int column)
{
    double width = fig_page_width(page) / COLUMNS;
    return (fig_box){width * column + 4, row_top[row], width - 8,
                     row_height[row]};
}

static fig_panel *begin_panel(fig_page *page, fig_box box)
{
    fig_page_fill_box(page, box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.elevation = 90});
    fig_panel_margin(panel, 14);
    fig_panel_fix(panel);
    return panel;
}

static void draw_edges(fig_page *page, fig_box box, const encounter *e,
                       double t)
{
    static const char *const name[EDGES][2] = {{"$e_0$", "$e_1$"},
                                               {"$g_0$", "$g_1$"}};
    static const double dx[EDGES][2] = {{0, 0}, {10, 10}},
                        dy[EDGES][2] = {{10, -10}, {0, 0}};
    fig_panel *panel = begin_panel(page, box);
    fig_scene *scene = fig_panel_scene(panel);
    for (int k = 0; k < EDGES; k++) {
        tf_vector place[BEND];
        for (int at = 0; at < 2; at++) {
            find_edge(e->edge[k], at, place);
            for (int i = 0; i < BEND; i++)
                fig_scene_reach(scene, place[i]);
        }
        find_edge(e->edge[k], t, place);
        fig_scene_path(scene, BEND, place, FIG_WIDTH_TUBE,
                       (fig_paint){.role = role[k]});
        for (int i = 0; i < 2; i++) {
            tf_vector at = place[i == 0 ? 0 : BEND - 1];
            fig_scene_ball(scene, at, 4.5, (fig_paint){.role = role[k]});
            fig_film_name(page, panel, at, dx[k][i], dy[k][i], name[k][i],
                          role[k]);
        }
    }
    if (t == e->toi || (fig_page_moves(page) && t > e->toi)) {
        tf_vector place[BEND];
        find_edge(e->edge[0], e->toi, place);
        fig_scene_ball(scene, place[BEND - 1], FIG_WIDTH_BALL,
                       (fig_paint){.role = FIG_ROLE_CONTACT});
    }
}

static void draw_band(fig_page *page, fig_box box, const encounter *e, double t)
{
    static const tf_vector origin = {{0, 0, 0}};
    tf_vector band[BAND];
    fig_panel *panel = begin_panel(page, box);
    fig_scene *scene = fig_panel_scene(panel);
    for (int at = 0; at < 2; at++) {
        find_band(e, at, band);
        for (int i = 0; i < BAND; i++)
            fig_scene_reach(scene, band[i]);
    }
    find_band(e, t, band);
    fig_panel_fill(panel, BAND, band,
                   (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.2});
    // The edge of one color moves along while an end of the other stands.
    for (int i = 0; i < BAND; i++) {
        tf_vector side[2] = {band[i], band[(i + 1) % BAND]};
        int moving = i / (BEND - 1) % 2;
        fig_panel_line(
            panel, 2, side,
            (fig_stroke){.paint = {.role = role[moving]}, .width = 1.8});
    }
    bool touching = t == e->toi;
    bool touched = touching || (fig_page_moves(page) && t > e->toi);
    fig_scene_ball(
        scene, origin, touched ? FIG_WIDTH_BALL : 5,
        (fig_paint){.role = touched ? FIG_ROLE_CONTACT : FIG_ROLE_INK});
    char text[48] = "through the origin";
    if (!touching)
        snprintf(text, sizeof text, "winding number %g",
                 fabs(winding_number(band)));
    fig_page_caption(page, box, text);
}

static void draw_strip(fig_page *page, const encounter *e)
{
    const double time[COLUMNS] = {0, e->toi, 1};
    for (int i = 0; i < COLUMNS; i++) {
        char text[32];
        snprintf(text, sizeof text, i == 1 ? "$t = %.2f$" : "$t = %g$",
                 time[i]);
        fig_page_title(page, column_box(page, 0, i), text);
        draw_edges(page, column_box(page, 0, i), e, time[i]);
        draw_band(page, column_box(page, 1, i), e, time[i]);
    }
}

/// One time of a film: both pictures side by side.
static void draw_moment(fig_page *page, const encounter *e, double t)
{
    const double height = fig_page_height(page);
    draw_edges(page, (fig_box){4, 4, 184, height - 48}, e, t);
    draw_band(page, (fig_box){196, 4, 184, height - 48}, e, t);
    fig_film_clock(page, 4, height - 12, FIG_PAGE_WIDTH - 8, t, e->toi,
                   "contact");
}

static void draw(fig_page *page, FILE *numbers)
{
    encounter e;
    solve(&e);
    double t = fig_film_time(page, numbers, e.toi, e.toi);
    if (fig_page_moves(page))
        draw_moment(page, &e, t);
    else
        draw_strip(page, &e);
    tf_vector band[BAND];
    fig_number(numbers, "toi", e.toi);
    find_band(&e, 0, band);
    fig_number(numbers, "winding_start", fabs(winding_number(band)));
    find_band(&e, 1, band);
    fig_number(numbers, "winding_end", fabs(winding_number(band)));
}

const fig_figure fig_edge_differences = {
    .name = "edge-differences",
    .title = "The differences of two edges, a band around the origin",
    .width = FIG_PAGE_WIDTH,
    .height = 272,
    .moves = true,
    .draw = draw,
};

// Two edges of the plane at the start, in contact and at the end of a step, and
// the differences of their points on the border of the square of weights: a
// closed curve that passes the origin when an end of an edge meets the other.
#include "figures.h"

#include "arithmetic/exact.h"
#include "query/point_edge.h"
#include "stage/vector.h"
#include "worlds.h"

#include <math.h>
#include <stddef.h>

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

static const tf_role role[EDGES] = {TF_ROLE_EDGE, TF_ROLE_OTHER_EDGE};
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
        tf_point_edge(&tf_exact, &e->edge[0][1], e->edge[1], &contact);
    TF_REQUIRE(status == TF_OK && contact.verdict == TF_HIT);
    e->toi = (contact.toi_lo + contact.toi_hi) / 2;
}

/// An edge at the time t, flat in the world: its ends and the crease between.
static void find_edge(const tf_worldline edge[2], double t, double place[][3])
{
    tf_world_of_edge(edge, t, place);
    for (int i = 0; i < BEND; i++)
        place[i][2] = 0;
}

/// The differences of the edges' points at the time t, once around the border of
/// the square of their weights.
static void find_band(const encounter *e, double t, double band[BAND][3])
{
    double first[BEND][3], second[BEND][3];
    find_edge(e->edge[0], t, first);
    find_edge(e->edge[1], t, second);
    int last = BEND - 1, count = 0;
    for (int i = 0; i < last; i++)
        tf_add(first[i], -1, second[0], band[count++]);
    for (int i = 0; i < last; i++)
        tf_add(first[last], -1, second[i], band[count++]);
    for (int i = 0; i < last; i++)
        tf_add(first[last - i], -1, second[last], band[count++]);
    for (int i = 0; i < last; i++)
        tf_add(first[0], -1, second[last - i], band[count++]);
}

/// How often the curve goes around the origin.
static double winding_number(const double band[BAND][3])
{
    double turns = 0;
    for (int i = 0; i < BAND; i++) {
        const double *a = band[i], *b = band[(i + 1) % BAND];
        turns += atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
    }
    return round(turns / (2 * acos(-1))) + 0.0;
}

static tf_box column_box(const tf_page *page, int row, int column)
{
    double width = tf_page_width(page) / COLUMNS;
    return (tf_box){width * column + 4, row_top[row], width - 8,
                    row_height[row]};
}

static tf_panel *begin_panel(tf_page *page, tf_box box)
{
    tf_page_fill_box(page, box,
                     (tf_paint){.role = TF_ROLE_NEUTRAL, .opacity = 0.09});
    tf_panel *panel = tf_page_panel(page, box);
    tf_panel_look(panel, (tf_camera){.elevation = 90});
    tf_panel_margin(panel, 14);
    tf_panel_fix(panel);
    return panel;
}

static void draw_edges(tf_page *page, tf_box box, const encounter *e, double t)
{
    static const char *const name[EDGES][2] = {{"$e_0$", "$e_1$"},
                                               {"$g_0$", "$g_1$"}};
    static const tf_side side[EDGES][2] = {{TF_SIDE_S, TF_SIDE_N},
                                           {TF_SIDE_E, TF_SIDE_E}};
    tf_panel *panel = begin_panel(page, box);
    tf_scene *scene = tf_panel_scene(panel);
    for (int k = 0; k < EDGES; k++) {
        double place[BEND][3];
        for (int at = 0; at < 2; at++) {
            find_edge(e->edge[k], at, place);
            for (int i = 0; i < BEND; i++)
                tf_scene_reach(scene, place[i]);
        }
        find_edge(e->edge[k], t, place);
        tf_scene_path(scene, BEND, (const double(*)[3])place, TF_WIDTH_TUBE,
                      (tf_paint){.role = role[k]});
        for (int i = 0; i < 2; i++) {
            double *at = place[(ptrdiff_t)i * (BEND - 1)];
            tf_scene_ball(scene, at, 4.5, (tf_paint){.role = role[k]});
            tf_panel_label(panel, at,
                           (tf_label){.text = name[k][i],
                                      .size = TF_LETTERS_SMALL,
                                      .role = role[k],
                                      .side = side[k][i],
                                      .gap = 4});
        }
    }
    if (t == e->toi) {
        double place[BEND][3];
        find_edge(e->edge[0], t, place);
        tf_scene_ball(scene, place[BEND - 1], TF_WIDTH_BALL,
                      (tf_paint){.role = TF_ROLE_CONTACT});
    }
}

static void draw_band(tf_page *page, tf_box box, const encounter *e, double t)
{
    static const double origin[3] = {0, 0, 0};
    double band[BAND][3];
    tf_panel *panel = begin_panel(page, box);
    tf_scene *scene = tf_panel_scene(panel);
    for (int at = 0; at < 2; at++) {
        find_band(e, at, band);
        for (int i = 0; i < BAND; i++)
            tf_scene_reach(scene, band[i]);
    }
    find_band(e, t, band);
    tf_panel_fill(panel, BAND, (const double(*)[3])band,
                  (tf_paint){.role = TF_ROLE_TRIANGLE, .opacity = 0.15});
    // The edge of one color moves along while an end of the other stands.
    for (int i = 0; i < BAND; i++) {
        double side[2][3];
        tf_add(band[i], 0, origin, side[0]);
        tf_add(band[(i + 1) % BAND], 0, origin, side[1]);
        int moving = i / (BEND - 1) % 2;
        tf_panel_line(
            panel, 2, (const double(*)[3])side,
            (tf_stroke){.paint = {.role = role[moving]}, .width = 1.8});
    }
    bool touching = t == e->toi;
    tf_scene_ball(scene, origin, touching ? TF_WIDTH_BALL : 5,
                  (tf_paint){.role = touching ? TF_ROLE_CONTACT : TF_ROLE_INK});
    char text[48] = "through the origin";
    if (!touching)
        snprintf(text, sizeof text, "winding number %g",
                 fabs(winding_number((const double(*)[3])band)));
    tf_page_caption(page, box, text);
}

static void draw(tf_page *page, FILE *numbers)
{
    encounter e;
    solve(&e);
    const double time[COLUMNS] = {0, e.toi, 1};
    for (int i = 0; i < COLUMNS; i++) {
        char text[32];
        snprintf(text, sizeof text, i == 1 ? "$t = %.2f$" : "$t = %g$",
                 time[i]);
        tf_page_title(page, column_box(page, 0, i), text);
        draw_edges(page, column_box(page, 0, i), &e, time[i]);
        draw_band(page, column_box(page, 1, i), &e, time[i]);
    }
    double band[BAND][3];
    tf_figure_number(numbers, "toi", e.toi);
    find_band(&e, 0, band);
    tf_figure_number(numbers, "winding_start",
                     fabs(winding_number((const double(*)[3])band)));
    find_band(&e, 1, band);
    tf_figure_number(numbers, "winding_end",
                     fabs(winding_number((const double(*)[3])band)));
}

const tf_figure tf_figure_winding = {
    .name = "winding",
    .title = "The differences of two edges, a band around the origin",
    .width = TF_FIGURE_WIDTH,
    .height = 272,
    .draw = draw,
};

// An edge that turns like a propeller, seen from the side, and one that stands
// across it, seen as a point: with the ends in one order the bent edge meets it
// and the straight one does not, with the other order the reverse.
#include "figures.h"

#include "arithmetic/exact.h"
#include "query/edge_edge.h"
#include "stage/vector.h"
#include "worlds.h"

#include <stddef.h>

enum {
    BEND = 3, ///< the points of a bent edge
    GHOSTS = 3
};

/// A query and how it is shown.
typedef struct scenario {
    const char *key, *caption;
    double start[2][3], end[2][3]; ///< of the propeller
    double bar[2][2];              ///< x and z of the bar at both times
    double time;                   ///< shown
    const char *name[2];
} scenario;

static const scenario scenarios[2] = {
    {.key = "up",
     .caption = "$a_1$ right: the bent edge meets the bar",
     .start = {{-1, 0, 0}, {1, 0, 0}},
     .end = {{-1, 0, -1}, {1, 0, 1}},
     .bar = {{0, 0.375}, {0, 0.375}},
     .time = 0.375,
     .name = {"$a_0$", "$a_1$"}},
    {.key = "down",
     .caption = "$a_1$ left: the straight edge meets the bar",
     .start = {{1, 0, 0}, {-1, 0, 0}},
     .end = {{1, 0, 1}, {-1, 0, -1}},
     .bar = {{1, 0.1875}, {0, 0.1875}},
     .time = 0.25,
     .name = {"$a_0$", "$a_1$"}},
};

static void make_propeller(const scenario *s, tf_worldline edge[2])
{
    for (int i = 0; i < 2; i++)
        edge[i] = tf_worldline_between(3, s->start[i], s->end[i]);
}

/// Seen from the side: x to the right and z up.
static void find_side_view(const double place[3], double world[3])
{
    world[0] = place[0];
    world[1] = place[2];
    world[2] = 0;
}

/// The first end, the crease and the second end at the time t.
static void find_bent(const tf_worldline edge[2], double t,
                      double place[BEND][3])
{
    tf_simplex sweep[2];
    tf_sweep(2, edge, sweep);
    tf_slice second = tf_slice_of(&sweep[0], 3, t);
    tf_slice first = tf_slice_of(&sweep[1], 3, t);
    find_side_view(first.corner[0], place[0]);
    find_side_view(first.corner[1], place[1]);
    find_side_view(second.corner[1], place[2]);
}

static void draw_propeller(tf_panel *panel, const scenario *s)
{
    tf_worldline edge[2];
    make_propeller(s, edge);
    tf_scene *scene = tf_panel_scene(panel);
    for (int i = 0; i <= GHOSTS; i++) {
        bool last = i == GHOSTS;
        tf_paint paint = {.role = TF_ROLE_EDGE, .shade = last ? 0 : -0.55};
        double place[BEND][3];
        find_bent(edge, s->time * i / GHOSTS, place);
        tf_scene_path(scene, BEND, (const double(*)[3])place,
                      last ? TF_WIDTH_TUBE : TF_WIDTH_LINE, paint);
        if (!last)
            continue;
        tf_scene_dashes(scene, place[0], place[BEND - 1], TF_WIDTH_LINE, 4,
                        (tf_paint){.role = TF_ROLE_NEUTRAL});
        for (int j = 0; j < 2; j++) {
            double *at = place[(ptrdiff_t)j * (BEND - 1)];
            tf_scene_ball(scene, at, TF_WIDTH_BALL, paint);
            tf_panel_label(
                panel, at,
                (tf_label){.text = s->name[j],
                           .role = TF_ROLE_EDGE,
                           .side = at[0] < 0 ? TF_SIDE_S : TF_SIDE_N});
        }
    }
}

static void draw_bar(tf_panel *panel, const scenario *s)
{
    double way[2][3], at[3];
    for (int t = 0; t < 2; t++)
        find_side_view((double[]){s->bar[t][0], 0, s->bar[t][1]}, way[t]);
    tf_scene *scene = tf_panel_scene(panel);
    if (way[0][0] != way[1][0])
        tf_scene_arrow(scene, way[0], way[1], TF_WIDTH_THIN,
                       (tf_paint){.role = TF_ROLE_OTHER_EDGE});
    for (int k = 0; k < 3; k++)
        at[k] = (1 - s->time) * way[0][k] + s->time * way[1][k];
    tf_scene_ball(scene, at, TF_WIDTH_MARK,
                  (tf_paint){.role = TF_ROLE_OTHER_EDGE});
    tf_panel_label(panel, at,
                   (tf_label){.text = "$b$",
                              .role = TF_ROLE_OTHER_EDGE,
                              .side = TF_SIDE_N,
                              .gap = 7});
}

static void print_numbers(const scenario *s, FILE *numbers)
{
    tf_worldline edge[2], bar[2];
    make_propeller(s, edge);
    for (int i = 0; i < 2; i++) {
        double y = i == 0 ? -1 : 1;
        bar[i] =
            tf_worldline_between(3, (double[]){s->bar[0][0], y, s->bar[0][1]},
                                 (double[]){s->bar[1][0], y, s->bar[1][1]});
    }
    tf_contact contact;
    tf_status status = tf_edge_edge(&tf_exact, edge, bar, &contact);
    TF_REQUIRE(status == TF_OK);
    char key[16];
    snprintf(key, sizeof key, "%s_hit", s->key);
    tf_figure_number(numbers, key, contact.verdict == TF_HIT);
    if (contact.verdict != TF_HIT)
        return;
    snprintf(key, sizeof key, "%s_toi", s->key);
    tf_figure_number(numbers, key, (contact.toi_lo + contact.toi_hi) / 2);
}

static void draw(tf_page *page, FILE *numbers)
{
    for (int i = 0; i < 2; i++) {
        const scenario *s = &scenarios[i];
        double width = tf_page_width(page) / 2;
        tf_box box = {width * i, 4, width, 110};
        tf_panel *panel = tf_page_panel(page, box);
        tf_panel_look(panel, (tf_camera){.elevation = 90});
        tf_panel_fix(panel);
        draw_propeller(panel, s);
        draw_bar(panel, s);
        char text[96];
        snprintf(text, sizeof text, "%s, $t = %g$", s->caption, s->time);
        tf_page_caption(page, box, text);
        print_numbers(s, numbers);
    }
}

const tf_figure tf_figure_propeller = {
    .name = "propeller",
    .title = "A propeller in two orders, and a bar across it",
    .width = TF_FIGURE_WIDTH,
    .height = 136,
    .draw = draw,
};

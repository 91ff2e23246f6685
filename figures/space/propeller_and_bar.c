// An edge that turns like a propeller, seen from the side, and one that stands
// across it, seen as a point: with the ends in one order the bent edge meets it
// and the straight one does not, with the other order the reverse.
#include "base/require.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "kit/worlds.h"
#include "query/query.h"

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
     .caption = "$a_1$ right: the bent edge hits the bar",
     .start = {{-1, 0, 0}, {1, 0, 0}},
     .end = {{-1, 0, -1}, {1, 0, 1}},
     .bar = {{0, 0.375}, {0, 0.375}},
     .time = 0.375,
     .name = {"$a_0$", "$a_1$"}},
    {.key = "down",
     .caption = "$a_1$ left: the straight edge hits the bar",
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
static tf_vector side_view(tf_vector place)
{
    return (tf_vector){{place.x[0], place.x[2], 0}};
}

/// The first end, the crease and the second end at the time t.
static void find_bent(const tf_worldline edge[2], double t,
                      tf_vector place[BEND])
{
    tf_simplex sweep[2];
    tf_sweep(2, edge, sweep);
    fig_slice second = fig_slice_of(&sweep[0], 3, t);
    fig_slice first = fig_slice_of(&sweep[1], 3, t);
    place[0] = side_view(first.corner[0]);
    place[1] = side_view(first.corner[1]);
    place[2] = side_view(second.corner[1]);
}

static void draw_propeller(fig_panel *panel, const scenario *s)
{
    tf_worldline edge[2];
    make_propeller(s, edge);
    fig_scene *scene = fig_panel_scene(panel);
    for (int i = 0; i <= GHOSTS; i++) {
        bool last = i == GHOSTS;
        fig_paint paint = {.role = FIG_ROLE_EDGE, .shade = last ? 0 : -0.55};
        tf_vector place[BEND];
        find_bent(edge, s->time * i / GHOSTS, place);
        fig_scene_path(scene, BEND, place,
                       last ? FIG_WIDTH_TUBE : FIG_WIDTH_LINE, paint);
        if (!last)
            continue;
        fig_scene_dashes(scene, place[0], place[BEND - 1], FIG_WIDTH_LINE, 4,
                         (fig_paint){.role = FIG_ROLE_NEUTRAL});
        for (int j = 0; j < 2; j++) {
            tf_vector at = place[j == 0 ? 0 : BEND - 1];
            fig_scene_ball(scene, at, FIG_WIDTH_BALL, paint);
            fig_panel_label(
                panel, at,
                (fig_label){.text = s->name[j],
                            .role = FIG_ROLE_EDGE,
                            .side = at.x[0] < 0 ? FIG_SIDE_S : FIG_SIDE_N});
        }
    }
}

static void draw_bar(fig_panel *panel, const scenario *s)
{
    tf_vector way[2];
    for (int t = 0; t < 2; t++)
        way[t] = (tf_vector){{s->bar[t][0], s->bar[t][1], 0}};
    fig_scene *scene = fig_panel_scene(panel);
    if (way[0].x[0] != way[1].x[0])
        fig_scene_arrow(scene, way[0], way[1], FIG_WIDTH_THIN,
                        (fig_paint){.role = FIG_ROLE_OTHER_EDGE});
    tf_vector at = fig_lerp(way[0], way[1], s->time);
    fig_scene_ball(scene, at, FIG_WIDTH_MARK,
                   (fig_paint){.role = FIG_ROLE_OTHER_EDGE});
    fig_panel_label(panel, at,
                    (fig_label){.text = "$b$",
                                .role = FIG_ROLE_OTHER_EDGE,
                                .side = FIG_SIDE_N,
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
    tf_status status = tf_query(&tf_exact, 3, 2, edge, 2, bar, &contact);
    TF_REQUIRE(status == TF_OK);
    char key[16];
    snprintf(key, sizeof key, "%s_hit", s->key);
    fig_number(numbers, key, contact.verdict == TF_HIT);
    if (contact.verdict != TF_HIT)
        return;
    snprintf(key, sizeof key, "%s_toi", s->key);
    fig_number(numbers, key, fig_toi(&contact));
}

static void draw(fig_page *page, FILE *numbers)
{
    for (int i = 0; i < 2; i++) {
        const scenario *s = &scenarios[i];
        double width = fig_page_width(page) / 2;
        fig_box box = {width * i, 4, width, 110};
        fig_panel *panel = fig_page_panel(page, box);
        fig_panel_look(panel, (fig_camera){.elevation = 90});
        fig_panel_fix(panel);
        draw_propeller(panel, s);
        draw_bar(panel, s);
        char text[96];
        snprintf(text, sizeof text, "%s, $t = %g$", s->caption, s->time);
        fig_page_caption(page, box, text);
        print_numbers(s, numbers);
    }
}

const fig_figure fig_propeller_and_bar = {
    .name = "propeller-and-bar",
    .title = "A propeller in two orders, and a bar across it",
    .width = FIG_PAGE_WIDTH,
    .height = 136,
    .draw = draw,
};

// Wherever a vertex is inserted on an edge, its move sweeps over the same
// tetrahedron.
#include "kit/figures.h"
#include "kit/patches.h"

enum {
    SHOWN = 3,
    PLACES = 5
};

/// Where q is on the edge ab.
static const double parts[SHOWN] = {0.2, 0.5, 0.8};

static const tf_vector places[PLACES - 1] = {
    {{-1, 0, 0}}, {{1, 0, 0}}, {{0.2, 1.1, 0}}, {{0.05, -0.1, 0.8}}};

static void draw_wedge(fig_page *page, fig_box box, double part)
{
    static const int halves[2][4] = {{4, 3, 0, 2}, {4, 3, 2, 1}};
    static const char *const name[] = {"$a$", "$b$", "$c$", "$e$", "$q$"};
    static const fig_side side[] = {FIG_SIDE_W, FIG_SIDE_E, FIG_SIDE_E,
                                    FIG_SIDE_N, FIG_SIDE_S};
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.azimuth = -20, .elevation = 24});
    fig_panel_margin(panel, 15);
    fig_scene *scene = fig_panel_scene(panel);
    tf_vector at[PLACES];
    for (int i = 0; i < PLACES - 1; i++)
        at[i] = places[i];
    at[4] = fig_lerp(places[0], places[1], part);
    for (int i = 0; i < 2; i++)
        fig_patch_body(
            scene, at, halves[i],
            (fig_paint){.role = i == 0 ? FIG_ROLE_EDGE : FIG_ROLE_OTHER_EDGE,
                        .opacity = 0.25});
    fig_scene_tube(scene, at[0], at[1], FIG_WIDTH_TUBE,
                   (fig_paint){.role = FIG_ROLE_TRIANGLE, .shade = 0.3});
    fig_scene_arrow(scene, at[4], at[3], FIG_WIDTH_LINE,
                    (fig_paint){.role = FIG_ROLE_POINT});
    for (int i = 0; i < PLACES; i++) {
        fig_role role = i >= 3 ? FIG_ROLE_POINT : FIG_ROLE_TRIANGLE;
        fig_scene_ball(scene, at[i], 5, (fig_paint){.role = role});
        fig_panel_label(panel, at[i],
                        (fig_label){.text = name[i],
                                    .size = FIG_LETTERS_SMALL,
                                    .side = side[i],
                                    .gap = 4});
    }
}

static double volume(tf_vector a, tf_vector b, tf_vector c, tf_vector d)
{
    return tf_vector_dot(fig_cross(fig_difference(b, a), fig_difference(c, a)),
                         fig_difference(d, a)) /
           6;
}

/// How much of the wedge the two tetrahedra are.
static double share(double part)
{
    const tf_vector *x = places;
    tf_vector q = fig_lerp(x[0], x[1], part);
    double both = volume(q, x[3], x[0], x[2]) + volume(q, x[3], x[2], x[1]);
    return both / volume(x[0], x[3], x[2], x[1]);
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = fig_page_width(page) / SHOWN;
    for (int i = 0; i < SHOWN; i++) {
        draw_wedge(page, (fig_box){width * i, 0, width, fig_page_height(page)},
                   parts[i]);
        char key[16];
        snprintf(key, sizeof key, "share_%d", i);
        fig_number(numbers, key, share(parts[i]));
    }
}

const fig_figure fig_split_positions = {
    .name = "split-positions",
    .title = "Wherever an edge is split, the same is swept over",
    .width = FIG_PAGE_WIDTH,
    .height = 112,
    .draw = draw,
};

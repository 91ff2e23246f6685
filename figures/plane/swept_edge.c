// What an edge sweeps in plane space-time: two triangles, the crack between two
// sheets that are cut along different diagonals, and the patch of linear
// motion, over the same four events.
#include "kit/figures.h"

#include "geometry/sweep.h"
#include "kit/worlds.h"

enum {
    PANELS = 3,
    SAMPLES = 25 // of the patch, along either side
};

static const double panel_width = FIG_PAGE_WIDTH / PANELS, panel_height = 132;

/// Seen from the side, where the crack is open.
static const fig_camera camera = {.azimuth = 22, .elevation = 28};

/// How long a step is drawn, in units of the plane.
static const double step_height = 3;

/// The time of the slices.
static const double middle = 0.5;

static void make_edge(tf_worldline edge[2])
{
    edge[0] = tf_worldline_between(2, (double[]){0, 2}, (double[]){0, 0});
    edge[1] = tf_worldline_between(2, (double[]){3, 0}, (double[]){3, 2});
}

/// Space-time as it is drawn, with a longer axis of time.
static tf_vector stretched(tf_vector world)
{
    world.x[2] *= step_height;
    return world;
}

/// The edge with its ends in the other order.
static void turn_edge(const tf_worldline edge[2], tf_worldline turned[2])
{
    for (int i = 0; i < 2; i++)
        turned[i] = edge[1 - i];
}

/// The names of the edge's events, its ends at both times and its worldlines.
static void draw_frame(fig_panel *panel, const tf_worldline edge[2])
{
    static const fig_label name[2][2] = {
        {{.text = "$e_0$", .side = FIG_SIDE_SW},
         {.text = "$e_0'$", .side = FIG_SIDE_N}},
        {{.text = "$e_1$", .side = FIG_SIDE_SE},
         {.text = "$e_1'$", .side = FIG_SIDE_N}}};
    fig_scene *scene = fig_panel_scene(panel);
    fig_paint paint = {.role = FIG_ROLE_EDGE};
    tf_vector at[2][2];
    for (int i = 0; i < 2; i++) {
        for (int t = 0; t < 2; t++) {
            at[i][t] = stretched(fig_world_of_event(&edge[i].at[t]));
            fig_scene_ball(scene, at[i][t], FIG_WIDTH_BALL, paint);
            fig_panel_label(panel, at[i][t], name[i][t]);
        }
        fig_scene_tube(scene, at[i][0], at[i][1], FIG_WIDTH_LINE, paint);
    }
    for (int t = 0; t < 2; t++)
        fig_scene_tube(scene, at[0][t], at[1][t], FIG_WIDTH_TUBE, paint);
}

static fig_panel *begin_panel(fig_page *page, int number,
                              const tf_worldline edge[2], const char *title)
{
    fig_box box = {number * panel_width, 18, panel_width, panel_height};
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, camera);
    fig_panel_margin(panel, 15);
    draw_frame(panel, edge);
    fig_page_title(page, box, title);
    return panel;
}

/// The bent edge at half time, stretched.
static void find_slice(const tf_worldline edge[2], tf_vector slice[3])
{
    fig_world_of_edge(edge, middle, slice);
    for (int i = 0; i < 3; i++)
        slice[i] = stretched(slice[i]);
}

/// The two triangles of a sweep, with their diagonal and their slice.
static void draw_sheet(fig_scene *scene, const tf_worldline edge[2],
                       fig_role role, double opacity)
{
    tf_simplex sweep[2];
    tf_sweep(2, edge, sweep);
    for (int i = 0; i < 2; i++) {
        tf_vector corner[3];
        fig_world_of_simplex(&sweep[i], corner);
        for (int j = 0; j < 3; j++)
            corner[j] = stretched(corner[j]);
        fig_scene_triangle(scene, corner, 0,
                           (fig_paint){.role = role, .opacity = opacity});
    }
    fig_scene_tube(scene, stretched(fig_world_of_event(&edge[0].at[0])),
                   stretched(fig_world_of_event(&edge[1].at[1])),
                   FIG_WIDTH_LINE, (fig_paint){.role = role});
    tf_vector slice[3];
    find_slice(edge, slice);
    fig_scene_path(scene, 3, slice, FIG_WIDTH_TUBE, (fig_paint){.role = role});
}

/// The staircase: one diagonal, two flat triangles.
static void draw_triangles(fig_page *page, const tf_worldline edge[2])
{
    fig_panel *panel = begin_panel(page, 0, edge, "two triangles");
    draw_sheet(fig_panel_scene(panel), edge, FIG_ROLE_EDGE, 0.5);
    fig_panel_axes(panel, (tf_vector){{0, 0, 0}}, (tf_vector){{0.7, 0.7, 0.8}},
                   (const char *[]){"$x$", "$y$", "$t$"});
}

/// Both diagonals, and what is between the two sheets at half time.
static void draw_crack(fig_page *page, const tf_worldline edge[2])
{
    fig_panel *panel = begin_panel(page, 1, edge, "a crack");
    fig_scene *scene = fig_panel_scene(panel);
    tf_worldline turned[2];
    turn_edge(edge, turned);
    draw_sheet(scene, edge, FIG_ROLE_EDGE, 0.5);
    draw_sheet(scene, turned, FIG_ROLE_OTHER_EDGE, 0.3);
    tf_vector upper[3], lower[3];
    find_slice(edge, upper);
    find_slice(turned, lower);
    for (int end = 0; end < 3; end += 2)
        fig_scene_triangle(scene, (tf_vector[]){upper[1], lower[1], upper[end]},
                           0,
                           (fig_paint){.role = FIG_ROLE_INK, .opacity = 0.35});
}

/// The point with the barycentric coordinate s of the edge's second vertex, if
/// all points of the edge move linearly.
static tf_vector linear_point(const tf_worldline edge[2], double s, double t)
{
    tf_vector world = fig_lerp(fig_worldline_place(&edge[0], 2, t),
                               fig_worldline_place(&edge[1], 2, t), s);
    world.x[2] = t;
    return stretched(world);
}

/// Linear motion: a curved patch.
static void draw_patch(fig_page *page, const tf_worldline edge[2])
{
    fig_panel *panel = begin_panel(page, 2, edge, "linear motion");
    fig_scene *scene = fig_panel_scene(panel);
    tf_vector at[SAMPLES * SAMPLES];
    for (int i = 0; i < SAMPLES; i++)
        for (int j = 0; j < SAMPLES; j++)
            at[i * SAMPLES + j] =
                linear_point(edge, j / (SAMPLES - 1.0), i / (SAMPLES - 1.0));
    fig_scene_patch(scene, SAMPLES, SAMPLES, at, 3,
                    (fig_paint){.role = FIG_ROLE_EDGE, .opacity = 0.45});
    fig_scene_tube(scene, linear_point(edge, 0, middle),
                   linear_point(edge, 1, middle), FIG_WIDTH_TUBE,
                   (fig_paint){.role = FIG_ROLE_EDGE});
}

static void draw(fig_page *page, FILE *numbers)
{
    tf_worldline edge[2], turned[2];
    make_edge(edge);
    turn_edge(edge, turned);
    draw_triangles(page, edge);
    draw_crack(page, edge);
    draw_patch(page, edge);
    tf_vector upper[3], lower[3];
    fig_world_of_edge(edge, middle, upper);
    fig_world_of_edge(turned, middle, lower);
    fig_number(numbers, "gap", fig_length(fig_difference(upper[1], lower[1])));
}

const fig_figure fig_swept_edge = {
    .name = "swept-edge",
    .title = "What an edge sweeps: triangles, a crack, a curved patch",
    .width = FIG_PAGE_WIDTH,
    .height = 154,
    .draw = draw,
};

// The two triangles that the library lets an edge sweep, and the curved patch
// of an edge whose points all move linearly, over the same four events.
#include "kit/figures.h"

#include "geometry/sweep.h"
#include "kit/film.h"
#include "kit/worlds.h"

enum {
    SAMPLES = 25 // of the patch, along either side
};

/// The time at which the two are compared, where the distance is largest.
static const double middle = 0.5;

static const fig_role sweep_role = FIG_ROLE_EDGE,
                      patch_role = FIG_ROLE_OTHER_EDGE;

static const fig_box sweep_box = {0, 0, 192, 190},
                     patch_box = {192, 0, 192, 190},
                     slice_box = {104, 204, 184, 84};

static void make_edge(tf_worldline edge[2])
{
    edge[0] =
        tf_worldline_between(2, (double[]){0.1, 0.75}, (double[]){0.3, 0.05});
    edge[1] =
        tf_worldline_between(2, (double[]){1.25, 0.15}, (double[]){1.05, 0.95});
}

/// The point with the weight s of the edge's second vertex, if all points of
/// the edge move linearly.
static tf_vector linear_point(const tf_worldline edge[2], double s, double t)
{
    tf_vector world = fig_lerp(fig_worldline_place(&edge[0], 2, t),
                               fig_worldline_place(&edge[1], 2, t), s);
    world.x[2] = t;
    return world;
}

/// The edge of linear motion at the time t, as world points.
static void find_straight(const tf_worldline edge[2], double t,
                          tf_vector world[2])
{
    world[0] = linear_point(edge, 0, t);
    world[1] = linear_point(edge, 1, t);
}

/// The names of the edge's events, its ends at both times and its worldlines.
static void draw_frame(fig_panel *panel, const tf_worldline edge[2])
{
    static const fig_label name[2][2] = {
        {{.text = "$e_0$", .side = FIG_SIDE_W},
         {.text = "$e_0'$", .side = FIG_SIDE_W}},
        {{.text = "$e_1$", .side = FIG_SIDE_E},
         {.text = "$e_1'$", .side = FIG_SIDE_NE}}};
    fig_scene *scene = fig_panel_scene(panel);
    fig_paint paint = {.role = FIG_ROLE_EDGE};
    tf_vector at[2][2];
    for (int i = 0; i < 2; i++)
        for (int t = 0; t < 2; t++) {
            at[i][t] = fig_world_of_event(&edge[i].at[t]);
            fig_scene_ball(scene, at[i][t], FIG_WIDTH_BALL, paint);
            fig_panel_label(panel, at[i][t], name[i][t]);
        }
    fig_world_ends(scene, edge);
    for (int i = 0; i < 2; i++)
        fig_scene_tube(scene, at[i][0], at[i][1], FIG_WIDTH_LINE, paint);
}

static fig_panel *begin_panel(fig_page *page, fig_box box,
                              const tf_worldline edge[2])
{
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.azimuth = 30, .elevation = 24});
    draw_frame(panel, edge);
    return panel;
}

/// The staircase: two flat triangles.
static void draw_triangles(fig_page *page, const tf_worldline edge[2], double t)
{
    fig_panel *panel = begin_panel(page, sweep_box, edge);
    fig_scene *scene = fig_panel_scene(panel);
    tf_simplex sweep[2];
    tf_sweep(2, edge, sweep);
    for (int i = 0; i < 2; i++) {
        tf_vector corner[3];
        fig_world_of_simplex(&sweep[i], corner);
        fig_scene_triangle(scene, corner, FIG_WIDTH_THIN,
                           (fig_paint){.role = sweep_role, .opacity = 0.45});
    }
    tf_vector bent[3];
    fig_world_of_edge(edge, t, bent);
    fig_scene_path(scene, 3, bent, FIG_WIDTH_TUBE,
                   (fig_paint){.role = sweep_role});
    fig_panel_axes(panel, (tf_vector){{0.3, 0.05, 0}},
                   (tf_vector){{0.3, 0.3, 0.35}},
                   (const char *[]){"$x$", "$y$", "$t$"});
    fig_page_caption(page, sweep_box, "*two triangles*");
}

/// Linear motion: a curved patch.
static void draw_patch(fig_page *page, const tf_worldline edge[2], double t)
{
    fig_panel *panel = begin_panel(page, patch_box, edge);
    fig_scene *scene = fig_panel_scene(panel);
    tf_vector at[SAMPLES * SAMPLES], straight[2];
    for (int i = 0; i < SAMPLES; i++)
        for (int j = 0; j < SAMPLES; j++)
            at[i * SAMPLES + j] =
                linear_point(edge, j / (SAMPLES - 1.0), i / (SAMPLES - 1.0));
    fig_scene_patch(scene, SAMPLES, SAMPLES, at, 4,
                    (fig_paint){.role = patch_role, .opacity = 0.45});
    find_straight(edge, t, straight);
    fig_scene_tube(scene, straight[0], straight[1], FIG_WIDTH_TUBE,
                   (fig_paint){.role = patch_role});
    fig_page_caption(page, patch_box, "*linear motion*");
}

/// The point of the segment from a to b that is closest to p.
static tf_vector closest_point(tf_vector p, tf_vector a, tf_vector b)
{
    tf_vector along = fig_difference(b, a);
    double s = tf_vector_dot(fig_difference(p, a), along) /
               tf_vector_dot(along, along);
    return fig_combination(a, fmin(fmax(s, 0), 1), along);
}

static double distance(tf_vector a, tf_vector b)
{
    return fig_length(fig_difference(b, a));
}

/// All places of the edge, as seen from above.
static void reach_all(fig_scene *scene, const tf_worldline edge[2])
{
    for (int i = 0; i < 2; i++)
        for (int end = 0; end < 2; end++)
            fig_scene_reach(scene, fig_worldline_place(&edge[i], 2, end));
}

/// Both edges at the time t, seen from above, with the gap between them.
static void draw_slice(fig_page *page, const tf_worldline edge[2], double t)
{
    tf_vector bent[3], straight[2];
    fig_world_of_edge(edge, t, bent);
    find_straight(edge, t, straight);
    for (int i = 0; i < 3; i++)
        bent[i].x[2] = straight[i % 2].x[2] = 0;
    fig_panel *panel = fig_page_panel(page, slice_box);
    fig_panel_look(panel, (fig_camera){.elevation = 90});
    fig_panel_margin(panel, 10);
    fig_panel_fix(panel);
    fig_scene *scene = fig_panel_scene(panel);
    reach_all(scene, edge);
    fig_scene_tube(scene, straight[0], straight[1], FIG_WIDTH_TUBE,
                   (fig_paint){.role = patch_role});
    fig_scene_path(scene, 3, bent, FIG_WIDTH_TUBE,
                   (fig_paint){.role = sweep_role});
    for (int i = 0; i < 3; i += 2)
        fig_scene_ball(scene, bent[i], FIG_WIDTH_BALL,
                       (fig_paint){.role = sweep_role});
    tf_vector gap[2] = {bent[1],
                        closest_point(bent[1], straight[0], straight[1])};
    if (t > 0 && t < 1)
        fig_panel_line(
            panel, 2, gap,
            (fig_stroke){.width = FIG_WIDTH_THIN, .arrow = true, .both = true});
    char text[48];
    snprintf(text, sizeof text, "gap: $%.3f$", distance(gap[0], gap[1]));
    fig_page_text(page, slice_box.x + slice_box.width + 4,
                  slice_box.y + slice_box.height / 2 + 3, FIG_ALIGN_LEFT, text,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    snprintf(text, sizeof text, "both at $t = %.2f$:", t);
    fig_page_text(page, slice_box.x - 8, slice_box.y + slice_box.height / 2 + 3,
                  FIG_ALIGN_RIGHT, text, FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void print_numbers(const tf_worldline edge[2], FILE *numbers)
{
    tf_vector bent[3], straight[2];
    fig_world_of_edge(edge, middle, bent);
    find_straight(edge, middle, straight);
    tf_vector foot = closest_point(bent[1], straight[0], straight[1]);
    fig_number(numbers, "gap", distance(bent[1], foot));
    // In the staircase the weight of the crease is the time.
    tf_vector moved = linear_point(edge, middle, middle);
    fig_number(numbers, "shift", distance(bent[1], moved));
}

static void draw(fig_page *page, FILE *numbers)
{
    tf_worldline edge[2];
    make_edge(edge);
    double t = fig_film_time(page, numbers, middle, -1);
    draw_triangles(page, edge, t);
    draw_patch(page, edge, t);
    draw_slice(page, edge, t);
    print_numbers(edge, numbers);
}

const fig_figure fig_staircase_patch = {
    .name = "staircase-patch",
    .title = "The sweep of an edge in triangles, and by linear motion",
    .width = FIG_PAGE_WIDTH,
    .height = FIG_PAGE_HEIGHT,
    .moves = true,
    .draw = draw,
};

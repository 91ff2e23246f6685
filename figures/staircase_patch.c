// The two triangles that the library lets an edge sweep, and the curved patch
// of an edge whose points all move linearly, over the same four events.
#include "figures.h"

#include "spacetime/sweep.h"
#include "stage/vector.h"
#include "worlds.h"

enum {
    SAMPLES = 25 // of the patch, along either side
};

/// The time at which the two are compared, where the distance is largest.
static const double middle = 0.5;

static const tf_role sweep_role = TF_ROLE_EDGE, patch_role = TF_ROLE_OTHER_EDGE;

static const tf_box sweep_box = {0, 0, 192, 190},
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
static void find_linear(const tf_worldline edge[2], double s, double t,
                        double world[3])
{
    double end[2][3];
    for (int i = 0; i < 2; i++)
        tf_worldline_place(&edge[i], 2, t, end[i]);
    for (int k = 0; k < 2; k++)
        world[k] = (1 - s) * end[0][k] + s * end[1][k];
    world[2] = t;
}

/// The edge of linear motion at the time t, as world points.
static void find_straight(const tf_worldline edge[2], double t,
                          double world[2][3])
{
    find_linear(edge, 0, t, world[0]);
    find_linear(edge, 1, t, world[1]);
}

/// The names of the edge's events, its ends at both times and its worldlines.
static void draw_frame(tf_panel *panel, const tf_worldline edge[2])
{
    static const tf_label name[2][2] = {
        {{.text = "$e_0$", .side = TF_SIDE_W},
         {.text = "$e_0'$", .side = TF_SIDE_W}},
        {{.text = "$e_1$", .side = TF_SIDE_E},
         {.text = "$e_1'$", .side = TF_SIDE_NE}}};
    tf_scene *scene = tf_panel_scene(panel);
    tf_paint paint = {.role = TF_ROLE_EDGE};
    double at[2][2][3];
    for (int i = 0; i < 2; i++)
        for (int t = 0; t < 2; t++) {
            tf_world_of_event(&edge[i].at[t], at[i][t]);
            tf_scene_ball(scene, at[i][t], TF_WIDTH_BALL, paint);
            tf_panel_label(panel, at[i][t], name[i][t]);
        }
    for (int i = 0; i < 2; i++) {
        tf_scene_tube(scene, at[0][i], at[1][i], TF_WIDTH_TUBE, paint);
        tf_scene_tube(scene, at[i][0], at[i][1], TF_WIDTH_LINE, paint);
    }
}

static tf_panel *begin_panel(tf_page *page, tf_box box,
                             const tf_worldline edge[2])
{
    tf_panel *panel = tf_page_panel(page, box);
    tf_panel_look(panel, (tf_camera){.azimuth = 30, .elevation = 24});
    draw_frame(panel, edge);
    return panel;
}

/// The staircase: two flat triangles.
static void draw_triangles(tf_page *page, const tf_worldline edge[2])
{
    tf_panel *panel = begin_panel(page, sweep_box, edge);
    tf_scene *scene = tf_panel_scene(panel);
    tf_simplex sweep[2];
    tf_sweep(2, edge, sweep);
    for (int i = 0; i < 2; i++) {
        double corner[3][3];
        tf_world_of_simplex(&sweep[i], corner);
        tf_scene_triangle(scene, (const double(*)[3])corner, TF_WIDTH_THIN,
                          (tf_paint){.role = sweep_role, .opacity = 0.45});
    }
    double bent[3][3];
    tf_world_of_edge(edge, middle, bent);
    tf_scene_path(scene, 3, (const double(*)[3])bent, TF_WIDTH_TUBE,
                  (tf_paint){.role = sweep_role});
    tf_panel_axes(panel, (double[]){0.3, 0.05, 0}, (double[]){0.3, 0.3, 0.35},
                  (const char *[]){"$x$", "$y$", "$t$"});
    tf_page_caption(page, sweep_box, "*two triangles*");
}

/// Linear motion: a curved patch.
static void draw_patch(tf_page *page, const tf_worldline edge[2])
{
    tf_panel *panel = begin_panel(page, patch_box, edge);
    tf_scene *scene = tf_panel_scene(panel);
    double at[SAMPLES * SAMPLES][3], straight[2][3];
    for (int i = 0; i < SAMPLES; i++)
        for (int j = 0; j < SAMPLES; j++)
            find_linear(edge, j / (SAMPLES - 1.0), i / (SAMPLES - 1.0),
                        at[i * SAMPLES + j]);
    tf_scene_patch(scene, SAMPLES, SAMPLES, (const double(*)[3])at, 4,
                   (tf_paint){.role = patch_role, .opacity = 0.45});
    find_straight(edge, middle, straight);
    tf_scene_tube(scene, straight[0], straight[1], TF_WIDTH_TUBE,
                  (tf_paint){.role = patch_role});
    tf_page_caption(page, patch_box, "*linear motion*");
}

/// The point of the segment from a to b that is closest to p.
static void find_closest(const double p[3], const double a[3],
                         const double b[3], double closest[3])
{
    double along[3], off[3];
    tf_add(b, -1, a, along);
    tf_add(p, -1, a, off);
    double s = tf_dot(off, along) / tf_dot(along, along);
    tf_add(a, fmin(fmax(s, 0), 1), along, closest);
}

static double distance(const double a[3], const double b[3])
{
    double off[3];
    tf_add(b, -1, a, off);
    return sqrt(tf_dot(off, off));
}

/// Both edges at one time, seen from above, with the gap between them.
static void draw_slice(tf_page *page, const double bent[3][3],
                       const double straight[2][3], const double foot[3])
{
    tf_panel *panel = tf_page_panel(page, slice_box);
    tf_panel_look(panel, (tf_camera){.elevation = 90});
    tf_panel_margin(panel, 10);
    tf_panel_fix(panel);
    tf_scene *scene = tf_panel_scene(panel);
    tf_scene_tube(scene, straight[0], straight[1], TF_WIDTH_TUBE,
                  (tf_paint){.role = patch_role});
    tf_scene_path(scene, 3, bent, TF_WIDTH_TUBE,
                  (tf_paint){.role = sweep_role});
    for (int i = 0; i < 3; i += 2)
        tf_scene_ball(scene, bent[i], TF_WIDTH_BALL,
                      (tf_paint){.role = sweep_role});
    double gap[2][3], halfway[3];
    tf_add(bent[1], 0, bent[1], gap[0]);
    tf_add(foot, 0, foot, gap[1]);
    tf_panel_line(
        panel, 2, (const double(*)[3])gap,
        (tf_stroke){.width = TF_WIDTH_THIN, .arrow = true, .both = true});
    tf_add(gap[0], 1, gap[1], halfway);
    tf_scale_about((double[3]){0}, 0.5, halfway, halfway);
    tf_page_text(page, slice_box.x - 8, slice_box.y + slice_box.height / 2,
                 TF_ALIGN_RIGHT, "both at $t = 1/2$:", TF_LETTERS_SMALL,
                 TF_ROLE_INK);
    tf_panel_label(panel, halfway,
                   (tf_label){.text = "gap", .side = TF_SIDE_E, .gap = 4});
}

static void draw(tf_page *page, FILE *numbers)
{
    tf_worldline edge[2];
    make_edge(edge);
    draw_triangles(page, edge);
    draw_patch(page, edge);

    double bent[3][3], straight[2][3], foot[3], moved[3];
    tf_world_of_edge(edge, middle, bent);
    find_straight(edge, middle, straight);
    find_closest(bent[1], straight[0], straight[1], foot);
    draw_slice(page, (const double(*)[3])bent, (const double(*)[3])straight,
               foot);
    tf_figure_number(numbers, "gap", distance(bent[1], foot));
    // In the staircase the weight of the crease is the time.
    find_linear(edge, middle, middle, moved);
    tf_figure_number(numbers, "shift", distance(bent[1], moved));
}

const tf_figure tf_figure_staircase_patch = {
    .name = "staircase-patch",
    .title = "The sweep of an edge in triangles, and by linear motion",
    .width = TF_FIGURE_WIDTH,
    .height = TF_FIGURE_HEIGHT,
    .draw = draw,
};

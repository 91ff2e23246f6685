// The Morton curve through the leaves of two trees of triangles, as the library
// builds them: a disc in the plane, and one that is bent to a saddle.
#include "base/require.h"
#include "kit/figures.h"
#include "kit/film.h"
#include "kit/meshes.h"
#include "surface/tree.h"

#include <stdlib.h>

enum {
    MESHES = 2,
    RINGS = 18
};

static const char *const name[MESHES] = {"disc", "saddle"};
static const double height_of[MESHES] = {0, 0.42};
static const fig_camera camera[MESHES] = {{.elevation = 90},
                                          {.azimuth = 62, .elevation = 46}};
static const double text_room = 24;

/// The shades of the first and of the last leaf, and how much those of
/// neighbors differ besides.
static const double palest = -0.8, darkest = 0.3, between = 0.09;

/// How much darker lines are than their leaf.
static const double line_shade = 0.2;

/// How far off the triangles the curve runs, for it to be seen.
static const double lift = 0.035;

typedef struct forest {
    fig_some_mesh mesh;
    tf_tree tree;
    tf_vector *center; ///< of each leaf: the mean of its triangles' centers
    double length;     ///< of the curve through all centers
    double longest;    ///< of its pieces
} forest;

// The tree ---------------------------------------------------------------

static void build_tree(forest *f)
{
    const fig_some_mesh *mesh = &f->mesh;
    tf_motion rest = {3, mesh->vertices, mesh->x, mesh->x};
    tf_path *path = malloc((size_t)mesh->vertices * sizeof *path);
    TF_REQUIRE(path);
    tf_frame frame;
    int bad;
    TF_REQUIRE(tf_frame_of(3, &rest, NULL, &frame, &bad) == TF_OK);
    tf_vertex_paths(&frame, &rest, NULL, path);
    tf_tree_elements elements = {.count = mesh->triangles,
                                 .corners = 3,
                                 .corner = mesh->triangle,
                                 .vertex = path,
                                 .whole = &frame.whole};
    tf_tree_workspace workspace = {0};
    TF_REQUIRE(tf_tree_build(&f->tree, &elements, &workspace, NULL));
    tf_tree_workspace_free(&workspace);
    free(path);
}

static tf_vector corner_of(const forest *f, int triangle, int corner)
{
    int vertex = f->mesh.triangle[3 * triangle + corner];
    return fig_vector_of(f->mesh.x + 3 * (size_t)vertex);
}

static tf_vector normal_of(const forest *f, int triangle)
{
    tf_vector a = corner_of(f, triangle, 0);
    return fig_normalized(
        fig_cross(fig_difference(corner_of(f, triangle, 1), a),
                  fig_difference(corner_of(f, triangle, 2), a)));
}

static int leaf_size(const forest *f, int leaf)
{
    int size = 0;
    while (size < TF_LANES && f->tree.element[leaf][size] >= 0)
        size++;
    return size;
}

static tf_vector center_of(const forest *f, int leaf)
{
    int size = leaf_size(f, leaf);
    tf_vector sum = {{0}};
    for (int i = 0; i < size; i++)
        for (int c = 0; c < 3; c++)
            sum = fig_sum(sum, corner_of(f, f->tree.element[leaf][i], c));
    return tf_vector_scaled(1 / (3.0 * size), sum);
}

static int leaf_count(const forest *f)
{
    return f->tree.packs[0];
}

static forest grow(int i)
{
    forest f = {.mesh = fig_disc(RINGS, height_of[i])};
    build_tree(&f);
    f.center = malloc((size_t)leaf_count(&f) * sizeof *f.center);
    TF_REQUIRE(f.center);
    for (int leaf = 0; leaf < leaf_count(&f); leaf++)
        f.center[leaf] = center_of(&f, leaf);
    for (int leaf = 0; leaf + 1 < leaf_count(&f); leaf++) {
        double step =
            fig_length(fig_difference(f.center[leaf + 1], f.center[leaf]));
        f.length += step;
        f.longest = fmax(f.longest, step);
    }
    return f;
}

static void fell(forest *f)
{
    fig_some_mesh_free(&f->mesh);
    tf_tree_free(&f->tree);
    free(f->center);
}

static void print_numbers(const forest *f, const char *order, FILE *numbers)
{
    char key[32];
    snprintf(key, sizeof key, "%s_triangles", order);
    fig_number(numbers, key, f->mesh.triangles);
    snprintf(key, sizeof key, "%s_leaves", order);
    fig_number(numbers, key, leaf_count(f));
    snprintf(key, sizeof key, "%s_levels", order);
    fig_number(numbers, key, f->tree.levels);
    snprintf(key, sizeof key, "%s_length", order);
    fig_number(numbers, key, f->length);
    snprintf(key, sizeof key, "%s_longest", order);
    fig_number(numbers, key, f->longest);
}

// Drawing ----------------------------------------------------------------

/// How far along the curve a leaf is, 0 to 1.
static double along(const forest *f, int leaf)
{
    return (double)leaf / (leaf_count(f) - 1);
}

/// Whether a triangle draws its edge from one vertex to the next.  Only those
/// on the rim, in the last ring, are not another triangle's too, the other way.
static bool draws_edge(int from, int to)
{
    return from < to || to > 3 * RINGS * (RINGS - 1);
}

static void add_leaf(fig_scene *scene, const forest *f, int leaf)
{
    double shade = palest + (darkest - palest) * along(f, leaf) +
                   (leaf % 2 ? between : -between);
    for (int i = 0; i < leaf_size(f, leaf); i++) {
        int triangle = f->tree.element[leaf][i];
        const tf_vector corner[3] = {corner_of(f, triangle, 0),
                                     corner_of(f, triangle, 1),
                                     corner_of(f, triangle, 2)};
        fig_scene_triangle(scene, corner, 0,
                           (fig_paint){FIG_ROLE_EDGE, 1, shade});
        for (int c = 0; c < 3; c++) {
            const int *vertex = f->mesh.triangle + 3 * (size_t)triangle;
            if (draws_edge(vertex[c], vertex[(c + 1) % 3]))
                fig_scene_tube(
                    scene, corner[c], corner[(c + 1) % 3], FIG_WIDTH_HAIR,
                    (fig_paint){FIG_ROLE_EDGE, 1, shade + line_shade});
        }
    }
}

/// Where the curve passes a leaf: off its middle, on the outside.
static tf_vector pass(const forest *f, int leaf)
{
    tf_vector out = {{0}};
    for (int i = 0; i < leaf_size(f, leaf); i++)
        out = fig_sum(out, normal_of(f, f->tree.element[leaf][i]));
    return fig_combination(f->center[leaf], lift, fig_normalized(out));
}

static void add_curve(fig_scene *scene, const forest *f, double until)
{
    const fig_paint paint = {.role = FIG_ROLE_OTHER_EDGE};
    int last = leaf_count(f) - 1;
    fig_scene_ball(scene, pass(f, 0), FIG_WIDTH_BALL - 2, paint);
    for (int leaf = 0; leaf < last && along(f, leaf) < until; leaf++)
        fig_scene_tube(scene, pass(f, leaf), pass(f, leaf + 1), FIG_WIDTH_LINE,
                       paint);
    if (until >= 1)
        fig_scene_ball(scene, pass(f, last), FIG_WIDTH_BALL - 2, paint);
}

/// The curve is drawn as far as `until`, 0 to 1.
static void draw_forest(fig_page *page, const forest *f, int i, fig_box box,
                        double until)
{
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_margin(panel, 6);
    fig_panel_look(panel, camera[i]);
    if (i == 0)
        fig_panel_fix(panel);
    fig_scene *scene = fig_panel_scene(panel);
    for (int leaf = 0; leaf < leaf_count(f); leaf++)
        add_leaf(scene, f, leaf);
    add_curve(scene, f, until);
    char text[64];
    snprintf(text, sizeof text, "%s: %d triangles, %d leaves",
             i == 0 ? "in the plane" : "in space", f->mesh.triangles,
             leaf_count(f));
    fig_page_text(page, box.x + box.width / 2, box.y + box.height + 14,
                  FIG_ALIGN_CENTER, text, FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = fig_page_width(page), height = fig_page_height(page);
    double until = fig_film_time(page, numbers, 1, -1);
    const fig_box box[MESHES] = {
        {0, 0, 0.44 * width, height - text_room},
        {0.44 * width, 0, 0.56 * width, height - text_room}};
    for (int i = 0; i < MESHES; i++) {
        forest f = grow(i);
        draw_forest(page, &f, i, box[i], until);
        print_numbers(&f, name[i], numbers);
        fell(&f);
    }
}

const fig_figure fig_morton_curve = {
    .name = "morton-curve",
    .title = "The Morton curve through the leaves of two trees",
    .width = FIG_PAGE_WIDTH,
    .height = 196,
    .moves = true,
    .draw = draw,
};

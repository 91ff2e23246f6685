// The prism of all pairs of a point of an edge and a point of a triangle, and
// the differences of the pairs on its border: a closed surface that passes the
// origin when an end of the edge meets the triangle.
#include "base/require.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "kit/worlds.h"
#include "query/query.h"

#include <math.h>

enum {
    TIMES = 3,
    EDGE = 2,
    TRIANGLE = 3,
    BEND = 3,             ///< the points of a bent edge
    PARTS = 2 * 4 + 3 * 8 ///< the most triangles of a balloon
};

static const double edge_at[2][EDGE][3] = {{{0.35, 0.1, 0.8}, {0.2, 0.2, 1.7}},
                                           {{0, -0.3, -0.7}, {-0.2, 0, 0.5}}};
static const double triangle_at[2][TRIANGLE][3] = {
    {{-1, -0.7, -0.1}, {1, -0.8, 0.1}, {0.1, 1, 0}},
    {{-0.9, -0.9, 0.1}, {0.9, -0.7, 0}, {-0.1, 1, 0.15}}};

static const double column_width = 96, row_top[2] = {20, 132},
                    row_height[2] = {96, 112};

typedef struct encounter {
    tf_worldline edge[EDGE], triangle[TRIANGLE];
    double toi;
} encounter;

/// The first end of the edge meets the triangle.
static void solve(encounter *e)
{
    for (int i = 0; i < EDGE; i++)
        e->edge[i] = tf_worldline_between(3, edge_at[0][i], edge_at[1][i]);
    for (int i = 0; i < TRIANGLE; i++)
        e->triangle[i] =
            tf_worldline_between(3, triangle_at[0][i], triangle_at[1][i]);
    tf_contact contact;
    tf_status status =
        tf_query(&tf_exact, 3, 1, &e->edge[0], 3, e->triangle, &contact);
    TF_REQUIRE(status == TF_OK && contact.verdict == TF_HIT);
    e->toi = fig_toi(&contact);
}

/// An edge at the time t: its ends and the crease between.
static void bend(const tf_worldline *first, const tf_worldline *second,
                 double t, tf_vector place[BEND])
{
    tf_worldline crease = {{first->at[0], second->at[1]}};
    place[0] = fig_worldline_place(first, 3, t);
    place[1] = fig_worldline_place(&crease, 3, t);
    place[2] = fig_worldline_place(second, 3, t);
}

// The border's image ----------------------------------------------------------

/// Triangles around the origin, and whether each comes from an end of the edge.
typedef struct balloon {
    int count;
    tf_vector corner[PARTS][3];
    bool is_end[PARTS];
} balloon;

static void add_part(balloon *b, bool is_end, bool reversed, tf_vector first,
                     tf_vector second, tf_vector third)
{
    tf_vector *corner = b->corner[b->count];
    corner[0] = first;
    corner[1] = reversed ? third : second;
    corner[2] = reversed ? second : third;
    b->is_end[b->count++] = is_end;
}

/// The edge's end against all of the triangle.
static void add_end(balloon *b, const encounter *e, int end, double t)
{
    tf_vector at = fig_worldline_place(&e->edge[end], 3, t);
    tf_simplex sweep[TRIANGLE];
    tf_sweep(TRIANGLE, e->triangle, sweep);
    for (int j = 0; j < TRIANGLE; j++) {
        fig_slice slice = fig_slice_of(&sweep[j], 3, t);
        for (int i = 2; i < slice.count; i++)
            add_part(b, true, end == 1, fig_difference(at, slice.corner[0]),
                     fig_difference(at, slice.corner[i - 1]),
                     fig_difference(at, slice.corner[i]));
    }
}

/// The edge against the side of the triangle without vertex i.
static void add_side(balloon *b, const encounter *e, int i, double t)
{
    tf_vector edge[BEND], side[BEND];
    bend(&e->edge[0], &e->edge[1], t, edge);
    bend(&e->triangle[i == 0], &e->triangle[i == 2 ? 1 : 2], t, side);
    for (int k = 0; k < BEND - 1; k++)
        for (int m = 0; m < BEND - 1; m++) {
            tf_vector corner[4] = {fig_difference(edge[k], side[m]),
                                   fig_difference(edge[k + 1], side[m]),
                                   fig_difference(edge[k + 1], side[m + 1]),
                                   fig_difference(edge[k], side[m + 1])};
            for (int half = 1; half < 3; half++)
                add_part(b, false, i == 1, corner[0], corner[half],
                         corner[half + 1]);
        }
}

static balloon inflate(const encounter *e, double t)
{
    balloon b = {.count = 0};
    for (int i = 0; i < EDGE; i++)
        add_end(&b, e, i, t);
    for (int i = 0; i < TRIANGLE; i++)
        add_side(&b, e, i, t);
    return b;
}

/// The angle in space, with a sign, under which the origin sees a triangle.
static double solid_angle(const tf_vector corner[3])
{
    double length[3], sum = 1;
    for (int i = 0; i < 3; i++)
        sum *= length[i] = fig_length(corner[i]);
    for (int i = 0; i < 3; i++)
        sum +=
            length[i] * tf_vector_dot(corner[(i + 1) % 3], corner[(i + 2) % 3]);
    double volume = tf_vector_dot(fig_cross(corner[0], corner[1]), corner[2]);
    return 2 * atan2(volume, sum);
}

/// How often a balloon wraps around the origin.
static double degree(const balloon *b)
{
    double sum = 0;
    for (int i = 0; i < b->count; i++)
        sum += solid_angle(b->corner[i]);
    return round(sum / (4 * acos(-1))) + 0.0;
}

// Drawing ---------------------------------------------------------------------

static fig_box column_box(const fig_page *page, int row, int column)
{
    return (fig_box){fig_page_width(page) - (TIMES - column) * column_width + 2,
                     row_top[row], column_width - 4, row_height[row]};
}

static fig_panel *begin_panel(fig_page *page, fig_box box)
{
    fig_page_fill_box(page, box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.azimuth = 20, .elevation = 26});
    fig_panel_margin(panel, 9);
    return panel;
}

static void draw_elements(fig_page *page, fig_box box, const encounter *e,
                          double t)
{
    fig_scene *scene = fig_panel_scene(begin_panel(page, box));
    for (int at = 0; at < 2; at++) {
        for (int i = 0; i < EDGE; i++)
            fig_scene_reach(scene, fig_worldline_place(&e->edge[i], 3, at));
        for (int i = 0; i < TRIANGLE; i++)
            fig_scene_reach(scene, fig_worldline_place(&e->triangle[i], 3, at));
    }
    tf_simplex sweep[TRIANGLE];
    tf_sweep(TRIANGLE, e->triangle, sweep);
    for (int j = 0; j < TRIANGLE; j++) {
        fig_slice slice = fig_slice_of(&sweep[j], 3, t);
        for (int i = 2; i < slice.count; i++)
            fig_scene_triangle(
                scene,
                (tf_vector[]){slice.corner[0], slice.corner[i - 1],
                              slice.corner[i]},
                0, (fig_paint){.role = FIG_ROLE_TRIANGLE, .opacity = 0.6});
    }
    tf_vector edge[BEND];
    bend(&e->edge[0], &e->edge[1], t, edge);
    fig_scene_path(scene, BEND, edge, FIG_WIDTH_TUBE,
                   (fig_paint){.role = FIG_ROLE_EDGE});
    for (int i = 0; i < BEND; i += BEND - 1)
        fig_scene_ball(scene, edge[i], 4.5,
                       (fig_paint){.role = FIG_ROLE_POINT});
    if (t == e->toi)
        fig_scene_ball(scene, edge[0], FIG_WIDTH_BALL,
                       (fig_paint){.role = FIG_ROLE_CONTACT});
}

/// The rims of the squares: lines of pairs with one point that does not change.
static void draw_rims(fig_scene *scene, const encounter *e, double t)
{
    const fig_paint rim = {.role = FIG_ROLE_EDGE, .shade = 0.3};
    tf_vector edge[BEND], rims[BEND];
    bend(&e->edge[0], &e->edge[1], t, edge);
    for (int i = 0; i < TRIANGLE; i++) {
        tf_vector corner = fig_worldline_place(&e->triangle[i], 3, t);
        for (int k = 0; k < BEND; k++)
            rims[k] = fig_difference(edge[k], corner);
        fig_scene_path(scene, BEND, rims, FIG_WIDTH_LINE, rim);
        tf_vector side[BEND];
        bend(&e->triangle[i == 0], &e->triangle[i == 2 ? 1 : 2], t, side);
        for (int end = 0; end < BEND; end += BEND - 1) {
            for (int k = 0; k < BEND; k++)
                rims[k] = fig_difference(edge[end], side[k]);
            fig_scene_path(scene, BEND, rims, FIG_WIDTH_LINE, rim);
        }
    }
}

static void reach_balloons(fig_scene *scene, const encounter *e)
{
    for (int at = 0; at < 2; at++) {
        balloon b = inflate(e, at);
        for (int i = 0; i < b.count; i++)
            for (int k = 0; k < 3; k++)
                fig_scene_reach(scene, b.corner[i][k]);
    }
}

static void draw_balloon(fig_page *page, fig_box box, const encounter *e,
                         double t)
{
    fig_scene *scene = fig_panel_scene(begin_panel(page, box));
    reach_balloons(scene, e);
    balloon b = inflate(e, t);
    for (int i = 0; i < b.count; i++)
        fig_scene_triangle(
            scene, b.corner[i], 0,
            (fig_paint){.role = b.is_end[i] ? FIG_ROLE_POINT : FIG_ROLE_EDGE,
                        .opacity = 0.3});
    draw_rims(scene, e, t);
    bool touching = t == e->toi;
    fig_scene_ball(
        scene, (tf_vector){{0, 0, 0}}, touching ? FIG_WIDTH_BALL : 5,
        (fig_paint){.role = touching ? FIG_ROLE_CONTACT : FIG_ROLE_INK});
    char text[32] = "through the origin";
    if (!touching)
        snprintf(text, sizeof text, "degree %g", fabs(degree(&b)));
    fig_page_caption(page, box, text);
}

// The prism ------------------------------------------------------------------

/// Write what a color of the border stands for.
static void write_key(fig_page *page, double y, fig_role role, const char *what,
                      const char *against)
{
    fig_page_fill_box(page, (fig_box){2, y - 7, 8, 8},
                      (fig_paint){.role = role, .opacity = 0.5});
    fig_page_text(page, 14, y, FIG_ALIGN_LEFT, what, FIG_LETTERS_SMALL,
                  FIG_ROLE_INK);
    fig_page_text(page, 14, y + 11, FIG_ALIGN_LEFT, against, FIG_LETTERS_SMALL,
                  FIG_ROLE_INK);
}

/// The prism as an edge and a triangle at rest have it: the triangle lies, and
/// the edge is upright.
static void draw_prism(fig_page *page)
{
    static const tf_vector corner[2][TRIANGLE] = {
        {{{-0.6, -0.5, 0}}, {{0.6, -0.5, 0}}, {{0, 0.6, 0}}},
        {{{-0.6, -0.5, 1}}, {{0.6, -0.5, 1}}, {{0, 0.6, 1}}}};
    fig_box box = {0, row_top[1], column_width - 8, row_height[1]};
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.azimuth = 20, .elevation = 26});
    fig_panel_margin(panel, 20);
    fig_scene *scene = fig_panel_scene(panel);
    const fig_paint square = {.role = FIG_ROLE_EDGE, .opacity = 0.3};
    const fig_paint rim = {.role = FIG_ROLE_EDGE, .shade = 0.3};
    for (int i = 0; i < TRIANGLE; i++) {
        const tf_vector *low = corner[0], *high = corner[1];
        int j = (i + 1) % TRIANGLE;
        fig_scene_triangle(scene, (tf_vector[]){low[i], low[j], high[j]}, 0,
                           square);
        fig_scene_triangle(scene, (tf_vector[]){low[i], high[j], high[i]}, 0,
                           square);
        fig_scene_tube(scene, low[i], high[i], FIG_WIDTH_LINE, rim);
        for (int s = 0; s < 2; s++)
            fig_scene_tube(scene, corner[s][i], corner[s][j], FIG_WIDTH_LINE,
                           rim);
    }
    for (int s = 0; s < 2; s++) {
        fig_scene_triangle(scene, corner[s], 0,
                           (fig_paint){.role = FIG_ROLE_POINT, .opacity = 0.3});
        fig_panel_label(panel, corner[s][1],
                        (fig_label){.text = s == 0 ? "$s = 0$" : "$s = 1$",
                                    .size = FIG_LETTERS_SMALL,
                                    .side = s == 0 ? FIG_SIDE_S : FIG_SIDE_N,
                                    .gap = 3});
    }
    fig_page_caption(page, box, "the prism $K$");
    write_key(page, 48, FIG_ROLE_POINT, "end of the edge", "against triangle");
    write_key(page, 82, FIG_ROLE_EDGE, "edge against side", "of the triangle");
}

static void draw(fig_page *page, FILE *numbers)
{
    encounter e;
    solve(&e);
    const double time[TIMES] = {0, e.toi, 1};
    for (int i = 0; i < TIMES; i++) {
        char text[32];
        snprintf(text, sizeof text, i == 1 ? "$t = %.2f$" : "$t = %g$",
                 time[i]);
        fig_page_title(page, column_box(page, 0, i), text);
        draw_elements(page, column_box(page, 0, i), &e, time[i]);
        draw_balloon(page, column_box(page, 1, i), &e, time[i]);
    }
    draw_prism(page);
    balloon first = inflate(&e, 0), last = inflate(&e, 1);
    fig_number(numbers, "toi", e.toi);
    fig_number(numbers, "degree_start", fabs(degree(&first)));
    fig_number(numbers, "degree_end", fabs(degree(&last)));
}

const fig_figure fig_triangle_differences = {
    .name = "triangle-differences",
    .title = "Differences of an edge and a triangle, around the origin",
    .width = FIG_PAGE_WIDTH,
    .height = 264,
    .draw = draw,
};

// Two bent triangles cross at their creases in mid-step, and no point meets a
// triangle and no edge an edge.
#include "arithmetic/exact.h"
#include "kit/figures.h"
#include "kit/film.h"
#include "kit/worlds.h"
#include "query/query.h"

#include <math.h>

enum {
    TRIANGLES = 2,
    CORNERS = 3,
    SHOWN = 3,
    PARTS_MOST = CORNERS * CORNERS
};

static const double start[TRIANGLES][CORNERS][3] = {
    {{-3, -6, 6}, {6, -3, -1}, {6, 6, -4}},
    {{5, 5, -6}, {-3, -6, 3}, {-6, -2, -3}}};
static const double end[TRIANGLES][CORNERS][3] = {
    {{4, -5, 6}, {6, 3, -1}, {0, 6, -5}},
    {{-1, 3, -4}, {2, -6, 6}, {-5, 4, 1}}};

/// The times at which both triangles are shown, and those of the close-up.
static const double shown[SHOWN] = {0, 0.4375, 1},
                    closer[SHOWN] = {0.25, 0.34, 0.4375};

static const double text_room = 22;
static const fig_role role[TRIANGLES] = {FIG_ROLE_TRIANGLE,
                                         FIG_ROLE_OTHER_EDGE};
static const fig_camera camera = {.azimuth = -173, .elevation = 30};
static const fig_camera close_camera = {.azimuth = 130,
                                        .elevation = 30,
                                        .height = 10,
                                        .center = {{3.4, 1.2, -1.6}}};

typedef struct pair_of_triangles {
    tf_worldline corner[TRIANGLES][CORNERS];
    tf_simplex sweep[TRIANGLES][CORNERS];
} pair_of_triangles;

static void move(pair_of_triangles *pair)
{
    for (int k = 0; k < TRIANGLES; k++) {
        for (int i = 0; i < CORNERS; i++)
            pair->corner[k][i] =
                tf_worldline_between(3, start[k][i], end[k][i]);
        tf_sweep(CORNERS, pair->corner[k], pair->sweep[k]);
    }
}

// Contacts ---------------------------------------------------------------

/// Side i of a triangle, 0 to 2, in index order.
static void find_side(const tf_worldline corner[CORNERS], int i,
                      tf_worldline side[2])
{
    side[0] = corner[i == CORNERS - 1 ? 0 : i];
    side[1] = corner[i == CORNERS - 1 ? i : i + 1];
}

/// How many corners of one triangle meet the other one.
static int count_point_triangle(const pair_of_triangles *pair)
{
    int hits = 0;
    for (int k = 0; k < TRIANGLES; k++)
        for (int i = 0; i < CORNERS; i++) {
            tf_contact contact;
            tf_query(&tf_exact, 3, 1, &pair->corner[k][i], 3,
                     pair->corner[1 - k], &contact);
            hits += contact.verdict == TF_HIT;
        }
    return hits;
}

static int count_edge_edge(const pair_of_triangles *pair)
{
    int hits = 0;
    for (int i = 0; i < CORNERS; i++)
        for (int j = 0; j < CORNERS; j++) {
            tf_worldline first[2], second[2];
            tf_contact contact;
            find_side(pair->corner[0], i, first);
            find_side(pair->corner[1], j, second);
            tf_query(&tf_exact, 3, 2, first, 2, second, &contact);
            hits += contact.verdict == TF_HIT;
        }
    return hits;
}

// The crossing -----------------------------------------------------------

/// A straight part of the crossing of two bent triangles.
typedef struct segment {
    tf_vector end[2];
} segment;

typedef struct crossing {
    segment part[PARTS_MOST];
    int count;
    double length;
} crossing;

/// How far `point` is from the plane of a slice, up to a factor.
static double height_over(const fig_slice *slice, tf_vector normal,
                          tf_vector point)
{
    return tf_vector_dot(normal, fig_difference(point, slice->corner[0]));
}

static tf_vector normal_of(const fig_slice *slice)
{
    // The diagonals of a parallelogram, or two sides of a triangle.
    tf_vector u = fig_difference(slice->corner[2], slice->corner[0]);
    tf_vector v =
        fig_difference(slice->corner[slice->count - 1], slice->corner[1]);
    return fig_cross(u, v);
}

/// The part of the line point + s direction with from <= s <= to.
typedef struct line {
    tf_vector point, direction;
    double from, to;
} line;

/// Cut a line to a convex slice that it lies in the plane of.
static void cut_to_slice(const fig_slice *slice, line *l)
{
    tf_vector normal = normal_of(slice);
    for (int i = 0; i < slice->count; i++) {
        tf_vector side = fig_difference(slice->corner[(i + 1) % slice->count],
                                        slice->corner[i]);
        tf_vector inward = fig_cross(normal, side);
        tf_vector offset = fig_difference(l->point, slice->corner[i]);
        double depth = tf_vector_dot(inward, offset);
        double rate = tf_vector_dot(inward, l->direction);
        if (rate > 0)
            l->from = fmax(l->from, -depth / rate);
        else if (rate < 0)
            l->to = fmin(l->to, -depth / rate);
        else if (depth < 0)
            l->to = -INFINITY;
    }
}

/// The line in which the planes of two slices meet.  Nothing of it is left if
/// they are parallel or a slice has no area.
static line cut_planes(const fig_slice *a, const fig_slice *b)
{
    tf_vector normal_a = normal_of(a), normal_b = normal_of(b);
    line l = {.direction = fig_cross(normal_a, normal_b)};
    double square = tf_vector_dot(l.direction, l.direction);
    if (square == 0)
        return l;
    // From a corner of `a` within its plane to the plane of `b`.
    tf_vector along_a = fig_cross(l.direction, normal_a);
    double height = height_over(b, normal_b, a->corner[0]);
    l.point = fig_combination(a->corner[0], -height / square, along_a);
    l.from = -INFINITY;
    l.to = INFINITY;
    return l;
}

static void cross_slices(const fig_slice *a, const fig_slice *b,
                         crossing *crossed)
{
    line l = cut_planes(a, b);
    cut_to_slice(a, &l);
    cut_to_slice(b, &l);
    if (l.from >= l.to)
        return;
    crossed->part[crossed->count++] =
        (segment){{fig_combination(l.point, l.from, l.direction),
                   fig_combination(l.point, l.to, l.direction)}};
    crossed->length += (l.to - l.from) * fig_length(l.direction);
}

static crossing cross(const pair_of_triangles *pair, double t)
{
    crossing crossed = {.count = 0};
    for (int i = 0; i < CORNERS; i++)
        for (int j = 0; j < CORNERS; j++) {
            fig_slice a = fig_slice_of(&pair->sweep[0][i], 3, t);
            fig_slice b = fig_slice_of(&pair->sweep[1][j], 3, t);
            cross_slices(&a, &b, &crossed);
        }
    return crossed;
}

static void print_numbers(const pair_of_triangles *pair, FILE *numbers)
{
    fig_number(numbers, "point_triangle_hits", count_point_triangle(pair));
    fig_number(numbers, "edge_edge_hits", count_edge_edge(pair));
    fig_number(numbers, "time", shown[1]);
    fig_number(numbers, "time_before", closer[0]);
    fig_number(numbers, "time_after", closer[1]);
    fig_number(numbers, "length_start", cross(pair, shown[0]).length);
    fig_number(numbers, "length", cross(pair, shown[1]).length);
    fig_number(numbers, "length_before", cross(pair, closer[0]).length);
    fig_number(numbers, "length_after", cross(pair, closer[1]).length);
    fig_number(numbers, "length_end", cross(pair, shown[2]).length);
}

// Drawing ----------------------------------------------------------------

/// The state at the time t, which in a film the clock shows.
static void write_state(fig_page *page, fig_box box, double t, bool crosses)
{
    const char *state = crosses ? "crossing" : "clear";
    char text[64];
    snprintf(text, sizeof text, "$t = %g$: %s", t, state);
    fig_page_text(page, box.x + box.width / 2, box.y + box.height + 12,
                  FIG_ALIGN_CENTER, fig_page_moves(page) ? state : text,
                  FIG_LETTERS, crosses ? FIG_ROLE_CONTACT : FIG_ROLE_INK);
}

/// Let all times be seen from the same place.
static void reach_all(fig_scene *scene, const pair_of_triangles *pair)
{
    for (int k = 0; k < TRIANGLES; k++)
        for (int i = 0; i < CORNERS; i++)
            for (int t = 0; t < 2; t++)
                fig_scene_reach(scene,
                                fig_vector_of(pair->corner[k][i].at[t].x));
}

/// Both triangles and their crossing at one time.
static fig_panel *draw_time(fig_page *page, const pair_of_triangles *pair,
                            double t, fig_box box, fig_camera eye)
{
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, eye);
    fig_panel_margin(panel, 8);
    fig_scene *scene = fig_panel_scene(panel);
    if (fig_page_moves(page))
        reach_all(scene, pair);
    for (int k = 0; k < TRIANGLES; k++)
        fig_world_bent(scene, pair->corner[k], t, role[k]);
    crossing crossed = cross(pair, t);
    for (int i = 0; i < crossed.count; i++)
        fig_scene_tube(scene, crossed.part[i].end[0], crossed.part[i].end[1],
                       FIG_WIDTH_TUBE, (fig_paint){.role = FIG_ROLE_CONTACT});
    write_state(page, box, t, crossed.count > 0);
    return panel;
}

/// The crease of the orange edge that pierces the green triangle.
static void mark_crease(fig_panel *panel, const pair_of_triangles *pair,
                        double t, bool named)
{
    fig_slice first = fig_slice_of(&pair->sweep[1][2], 3, t);
    tf_vector crease = first.corner[1];
    fig_scene_ball(fig_panel_scene(panel), crease, FIG_WIDTH_BALL,
                   (fig_paint){.role = role[1], .shade = 0.25});
    if (named)
        fig_panel_label(panel, crease,
                        (fig_label){.text = "crease",
                                    .size = FIG_LETTERS_SMALL,
                                    .side = FIG_SIDE_NE});
}

/// Both triangles, at a time of the whole step above, and below the close-up.
static void draw_strips(fig_page *page, const pair_of_triangles *pair)
{
    double width = fig_page_width(page) / SHOWN;
    double height = fig_page_height(page) / 2 - text_room;
    for (int i = 0; i < SHOWN; i++) {
        fig_box above = {i * width + 3, 0, width - 6, height};
        fig_box below = above;
        below.y = fig_page_height(page) / 2;
        fig_page_fill_box(
            page, below,
            (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
        draw_time(page, pair, shown[i], above, camera);
        fig_panel *panel =
            draw_time(page, pair, closer[i], below, close_camera);
        if (i > 0)
            mark_crease(panel, pair, closer[i], i == 1);
    }
}

/// One time of a film: the whole, and the close-up beside it.
static void draw_moment(fig_page *page, const pair_of_triangles *pair, double t)
{
    double width = fig_page_width(page) / 2;
    double height = fig_page_height(page) - 2 * text_room;
    fig_box whole = {3, 0, width - 6, height};
    fig_box close = {width + 3, 40, width - 6, 170};
    fig_page_fill_box(page, close,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    draw_time(page, pair, t, whole, camera);
    fig_panel *panel = draw_time(page, pair, t, close, close_camera);
    if (t > 0 && t < 1)
        mark_crease(panel, pair, t, false);
    fig_film_clock(page, 4, fig_page_height(page) - 10,
                   fig_page_width(page) - 8, t, -1, NULL);
}

static void draw(fig_page *page, FILE *numbers)
{
    pair_of_triangles pair;
    move(&pair);
    double t = fig_film_time(page, numbers, shown[1], -1);
    if (fig_page_moves(page))
        draw_moment(page, &pair, t);
    else
        draw_strips(page, &pair);
    print_numbers(&pair, numbers);
}

const fig_figure fig_crease_crossing = {
    .name = "crease-crossing",
    .title = "Bent triangles that cross at creases without a contact",
    .width = FIG_PAGE_WIDTH,
    .height = 300,
    .moves = true,
    .draw = draw,
};

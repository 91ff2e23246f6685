// Two moving edges at five times, and how far apart the pieces of each of their
// four pairs of triangles are at all times.
#include "arithmetic/exact.h"
#include "intersect/cascade.h"
#include "kit/figures.h"
#include "kit/worlds.h"
#include "query/query.h"
#include "renderer/plot.h"

#include <math.h>

enum {
    EDGES = 2,
    TRIANGLES = 2, ///< in the sweep of an edge
    FRAMES = 5,
    STEPS = 400 ///< of a curve
};

// Chosen to meet at half time.
static const double start[EDGES][2][3] = {
    {{-2.625, -1, -1}, {1.375, 0.5, -2}},
    {{0.5, -1.375, 2.75}, {-0.5, 2.625, 1.5}}};
static const double end[EDGES][2][3] = {
    {{-2.875, -0.5, 0.5}, {1.375, -0.5, 2.75}},
    {{-0.25, -1.375, -2}, {0.75, 2.625, -1}}};

static const fig_role role[EDGES] = {FIG_ROLE_EDGE, FIG_ROLE_OTHER_EDGE};
static const char *const vertex_name[EDGES][2][2] = {
    {{"$a_0$", "$a_0'$"}, {"$a_1$", "$a_1'$"}},
    {{"$b_0$", "$b_0'$"}, {"$b_1$", "$b_1'$"}}};

/// The triangles, in the order of tf_sweep.
static const char *const triangle_name[EDGES][TRIANGLES] = {{"$S_1$", "$S_0$"},
                                                            {"$R_1$", "$R_0$"}};

static const fig_side name_side[EDGES][TRIANGLES] = {{FIG_SIDE_NE, FIG_SIDE_N},
                                                     {FIG_SIDE_NE, FIG_SIDE_S}};

/// The pieces that grow are paler.
static const double triangle_shade[TRIANGLES] = {0, -0.55};

static const fig_camera camera = {.azimuth = 57, .elevation = 18};
static const double frame_gap = 4, frame_top = 20, frame_height = 88;

typedef struct encounter {
    tf_worldline edge[EDGES][2];
    tf_simplex sweep[EDGES][TRIANGLES];
    tf_intersection meeting[TRIANGLES][TRIANGLES];
    double distance[TRIANGLES][TRIANGLES][STEPS + 1];
    tf_contact contact;
    tf_vector place; ///< of the contact
} encounter;

// Distances --------------------------------------------------------------

static double distance_to_point(fig_slice segment, tf_vector point)
{
    tf_vector way = fig_difference(segment.corner[1], segment.corner[0]);
    tf_vector from = fig_difference(point, segment.corner[0]);
    double square = tf_vector_dot(way, way);
    double share = square > 0 ? tf_vector_dot(from, way) / square : 0;
    share = fmin(fmax(share, 0), 1);
    return fig_length(fig_combination(from, -share, way));
}

/// The distance of the lines of two segments, if their nearest points are on
/// the segments, else infinity.
static double distance_inside(fig_slice a, fig_slice b)
{
    tf_vector u = fig_difference(a.corner[1], a.corner[0]);
    tf_vector v = fig_difference(b.corner[1], b.corner[0]);
    tf_vector gap = fig_difference(b.corner[0], a.corner[0]);
    tf_vector normal = fig_cross(u, v);
    double square = tf_vector_dot(normal, normal);
    if (square == 0)
        return INFINITY;
    double on_a = tf_vector_dot(fig_cross(gap, v), normal) / square;
    double on_b = tf_vector_dot(fig_cross(gap, u), normal) / square;
    bool inside = on_a >= 0 && on_a <= 1 && on_b >= 0 && on_b <= 1;
    return inside ? fabs(tf_vector_dot(gap, normal)) / sqrt(square) : INFINITY;
}

static double distance_between(fig_slice a, fig_slice b)
{
    double distance = distance_inside(a, b);
    for (int i = 0; i < 2; i++) {
        distance = fmin(distance, distance_to_point(a, b.corner[i]));
        distance = fmin(distance, distance_to_point(b, a.corner[i]));
    }
    return distance;
}

static void find_distances(encounter *e, int i, int j)
{
    for (int step = 0; step <= STEPS; step++) {
        double t = (double)step / STEPS;
        e->distance[i][j][step] =
            distance_between(fig_slice_of(&e->sweep[0][i], 3, t),
                             fig_slice_of(&e->sweep[1][j], 3, t));
    }
}

static double nearest(const encounter *e, int i, int j)
{
    double least = e->distance[i][j][0];
    for (int step = 1; step <= STEPS; step++)
        least = fmin(least, e->distance[i][j][step]);
    return least;
}

// The query --------------------------------------------------------------

/// The point of the first edge's triangle that has the meeting's coordinates.
static tf_vector place_of(const tf_pair *pair, const tf_intersection *meeting)
{
    tf_vector place = {{0}};
    for (int i = 0; i < pair->count; i++)
        if (pair->operand[i] > 0)
            place = fig_combination(place, meeting->barycentric[i],
                                    fig_vector_of(pair->event[i]->x));
    return place;
}

static bool hits(const encounter *e, int i, int j)
{
    return e->meeting[i][j].verdict == TF_HIT;
}

static void solve_pair(encounter *e, int i, int j)
{
    tf_pair pair = tf_pair_of(&e->sweep[0][i], &e->sweep[1][j], 3);
    e->meeting[i][j] = tf_intersect(&tf_exact, &pair, TF_WITH_POINT);
    if (hits(e, i, j))
        e->place = place_of(&pair, &e->meeting[i][j]);
    find_distances(e, i, j);
}

static void solve(encounter *e)
{
    for (int k = 0; k < EDGES; k++) {
        for (int i = 0; i < 2; i++)
            e->edge[k][i] = tf_worldline_between(3, start[k][i], end[k][i]);
        tf_sweep(2, e->edge[k], e->sweep[k]);
    }
    for (int i = 0; i < TRIANGLES; i++)
        for (int j = 0; j < TRIANGLES; j++)
            solve_pair(e, i, j);
    tf_query(&tf_exact, 3, 2, e->edge[0], 2, e->edge[1], &e->contact);
}

static void print_numbers(const encounter *e, FILE *numbers)
{
    double nearest_other = INFINITY;
    for (int i = 0; i < TRIANGLES; i++)
        for (int j = 0; j < TRIANGLES; j++) {
            char key[16];
            snprintf(key, sizeof key, "hit_%d%d", i, j);
            fig_number(numbers, key, hits(e, i, j));
            snprintf(key, sizeof key, "nearest_%d%d", i, j);
            fig_number(numbers, key, nearest(e, i, j));
            if (!hits(e, i, j))
                nearest_other = fmin(nearest_other, nearest(e, i, j));
        }
    fig_number(numbers, "nearest_other", nearest_other);
    fig_number(numbers, "toi", fig_toi(&e->contact));
    fig_number(numbers, "normal_velocity", e->contact.normal_velocity);
    fig_number(numbers, "barycentric_a1", e->contact.barycentric[0][1]);
    fig_number(numbers, "barycentric_b1", e->contact.barycentric[1][1]);
}

// The frames -------------------------------------------------------------

/// The piece of an edge that is a slice of one triangle.
static void add_piece(fig_panel *panel, const encounter *e, int edge,
                      int triangle, double t)
{
    fig_slice slice = fig_slice_of(&e->sweep[edge][triangle], 3, t);
    tf_vector way = fig_difference(slice.corner[1], slice.corner[0]);
    if (fig_length(way) == 0)
        return;
    fig_scene_tube(fig_panel_scene(panel), slice.corner[0], slice.corner[1],
                   FIG_WIDTH_TUBE,
                   (fig_paint){role[edge], 1, triangle_shade[triangle]});
    if (t == 0.5)
        fig_panel_label(panel, fig_lerp(slice.corner[0], slice.corner[1], 0.6),
                        (fig_label){.text = triangle_name[edge][triangle],
                                    .role = role[edge],
                                    .size = FIG_LETTERS_SMALL,
                                    .side = name_side[edge][triangle],
                                    .gap = 4});
}

/// The vertices on their ways, and at both ends their names.
static void add_vertices(fig_panel *panel, const encounter *e, int edge,
                         double t)
{
    fig_scene *scene = fig_panel_scene(panel);
    for (int i = 0; i < 2; i++) {
        const tf_worldline *vertex = &e->edge[edge][i];
        tf_vector here = fig_worldline_place(vertex, 3, t);
        fig_scene_dashes(scene, fig_vector_of(vertex->at[0].x),
                         fig_vector_of(vertex->at[1].x), FIG_WIDTH_HAIR, 2,
                         (fig_paint){.role = FIG_ROLE_NEUTRAL});
        fig_scene_ball(scene, here, 4.5, (fig_paint){.role = role[edge]});
        if (t == 0 || t == 1)
            fig_panel_label(panel, here,
                            (fig_label){.text = vertex_name[edge][i][t == 1],
                                        .role = role[edge],
                                        .size = FIG_LETTERS_SMALL,
                                        .gap = 4});
    }
}

static void draw_frame(fig_page *page, const encounter *e, double t,
                       fig_box box)
{
    fig_page_fill_box(page, box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, camera);
    fig_panel_margin(panel, 7);
    for (int k = 0; k < EDGES; k++) {
        add_vertices(panel, e, k, t);
        for (int i = 0; i < TRIANGLES; i++)
            add_piece(panel, e, k, i, t);
    }
    if (t == fig_toi(&e->contact))
        fig_scene_ball(fig_panel_scene(panel), e->place, 7,
                       (fig_paint){.role = FIG_ROLE_CONTACT});
}

static void draw_frames(fig_page *page, const encounter *e)
{
    static const char *const time[FRAMES] = {
        "$t = 0$", "$t = 0.25$", "$t = 0.5$", "$t = 0.75$", "$t = 1$"};
    double width = (fig_page_width(page) + frame_gap) / FRAMES - frame_gap;
    for (int i = 0; i < FRAMES; i++) {
        fig_box box = {i * (width + frame_gap), frame_top, width, frame_height};
        fig_page_title(page, box, time[i]);
        draw_frame(page, e, i / (FRAMES - 1.0), box);
    }
}

// The distances of the four pairs ----------------------------------------

static void draw_distance(fig_page *page, const encounter *e, int i, int j,
                          fig_plot plot)
{
    fig_role ink = hits(e, i, j) ? FIG_ROLE_CONTACT : FIG_ROLE_INK;
    fig_point curve[STEPS + 1];
    int least = 0;
    for (int step = 0; step <= STEPS; step++) {
        curve[step] =
            (fig_point){(double)step / STEPS, e->distance[i][j][step]};
        if (curve[step].y < curve[least].y)
            least = step;
    }
    fig_plot_frame(page, &plot);
    fig_plot_curve(page, &plot, STEPS + 1, curve,
                   (fig_stroke){.paint = {.role = ink}});
    fig_point at =
        fig_plot_dot(page, &plot, curve[least].x, curve[least].y, 5, ink);
    char text[32] = "hit";
    if (!hits(e, i, j))
        snprintf(text, sizeof text, "%.2f", curve[least].y);
    double above = hits(e, i, j) ? 30 : 8;
    fig_page_text(page, at.x, at.y - above, FIG_ALIGN_CENTER, text,
                  FIG_LETTERS_SMALL, ink);
    snprintf(text, sizeof text, "%s and %s", triangle_name[0][i],
             triangle_name[1][j]);
    fig_page_title(page, plot.box, text);
}

static void draw_distances(fig_page *page, const encounter *e, double top)
{
    double left = 34, gap = 12, count = TRIANGLES * TRIANGLES;
    double width = (fig_page_width(page) - left + gap) / count - gap - 1;
    for (int i = 0; i < TRIANGLES; i++)
        for (int j = 0; j < TRIANGLES; j++) {
            int place = TRIANGLES * i + j;
            fig_plot plot = {
                .box = {left + place * (width + gap), top, width, 66},
                .x = {0, 1},
                .y = {0, 5},
                .name_x = "$t$",
                .name_y = place == 0 ? "distance" : NULL,
                .ticks_x = 2,
                .ticks_y = place == 0 ? 5 : -1};
            draw_distance(page, e, i, j, plot);
        }
}

static void draw(fig_page *page, FILE *numbers)
{
    encounter e;
    solve(&e);
    draw_frames(page, &e);
    draw_distances(page, &e, frame_top + frame_height + 30);
    print_numbers(&e, numbers);
}

const fig_figure fig_edge_edge_distances = {
    .name = "edge-edge-distances",
    .title = "Two edges at five times, and the distances of their pieces",
    .width = FIG_PAGE_WIDTH,
    .height = 238,
    .draw = draw,
};

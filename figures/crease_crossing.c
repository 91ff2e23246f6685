// Two bent triangles cross at their creases in mid-step, and no point meets a
// triangle and no edge an edge.
#include "arithmetic/exact.h"
#include "figures.h"
#include "query/edge_edge.h"
#include "query/point_triangle.h"
#include "stage/vector.h"
#include "worlds.h"

#include <math.h>

enum {
    TRIANGLES = 2,
    CORNERS = 3,
    PANELS = 3,
    PARTS_MOST = CORNERS * CORNERS
};

static const double start[TRIANGLES][CORNERS][3] = {
    {{-3, -6, 6}, {6, -3, -1}, {6, 6, -4}},
    {{5, 5, -6}, {-3, -6, 3}, {-6, -2, -3}}};
static const double end[TRIANGLES][CORNERS][3] = {
    {{4, -5, 6}, {6, 3, -1}, {0, 6, -5}},
    {{-1, 3, -4}, {2, -6, 6}, {-5, 4, 1}}};

static const double shown[PANELS] = {0, 0.4375, 1};

static const double text_room = 18, border_width = 1.7;
static const tf_role role[TRIANGLES] = {TF_ROLE_TRIANGLE, TF_ROLE_OTHER_EDGE};
static const tf_camera camera = {.azimuth = -173, .elevation = 30};

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
            tf_point_triangle(&tf_exact, &pair->corner[k][i],
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
            tf_edge_edge(&tf_exact, first, second, &contact);
            hits += contact.verdict == TF_HIT;
        }
    return hits;
}

// The crossing -----------------------------------------------------------

/// A straight part of the crossing of two bent triangles.
typedef struct segment {
    double end[2][3];
} segment;

typedef struct crossing {
    segment part[PARTS_MOST];
    int count;
    double length;
} crossing;

/// How far `point` is from the plane of a slice, up to a factor.
static double height_over(const tf_slice *slice, const double normal[3],
                          const double point[3])
{
    double offset[3];
    tf_add(point, -1, slice->corner[0], offset);
    return tf_dot(normal, offset);
}

static void find_normal(const tf_slice *slice, double normal[3])
{
    // The diagonals of a parallelogram, or two sides of a triangle.
    double u[3], v[3];
    tf_add(slice->corner[2], -1, slice->corner[0], u);
    tf_add(slice->corner[slice->count - 1], -1, slice->corner[1], v);
    tf_cross(u, v, normal);
}

/// Cut the line point + s direction to a convex slice that it lies in the plane
/// of: narrow from <= s <= to.
static void cut_to_slice(const tf_slice *slice, const double normal[3],
                         const double point[3], const double direction[3],
                         double *from, double *to)
{
    for (int i = 0; i < slice->count; i++) {
        double side[3], inward[3], offset[3];
        tf_add(slice->corner[(i + 1) % slice->count], -1, slice->corner[i],
               side);
        tf_cross(normal, side, inward);
        tf_add(point, -1, slice->corner[i], offset);
        double depth = tf_dot(inward, offset);
        double rate = tf_dot(inward, direction);
        if (rate > 0)
            *from = fmax(*from, -depth / rate);
        else if (rate < 0)
            *to = fmin(*to, -depth / rate);
        else if (depth < 0)
            *to = -INFINITY;
    }
}

/// The line in which the planes of two slices meet.  False if they are
/// parallel or a slice has no area.
static bool cut_planes(const tf_slice *a, const double normal_a[3],
                       const tf_slice *b, const double normal_b[3],
                       double point[3], double direction[3])
{
    double along_a[3];
    tf_cross(normal_a, normal_b, direction);
    tf_cross(direction, normal_a, along_a);
    double square = tf_dot(direction, direction);
    if (square == 0)
        return false;
    // From a corner of `a` within its plane to the plane of `b`.
    double height = height_over(b, normal_b, a->corner[0]);
    tf_add(a->corner[0], -height / square, along_a, point);
    return true;
}

static void cross_slices(const tf_slice *a, const tf_slice *b,
                         crossing *crossed)
{
    double normal_a[3], normal_b[3], point[3], direction[3];
    double from = -INFINITY, to = INFINITY;
    find_normal(a, normal_a);
    find_normal(b, normal_b);
    if (!cut_planes(a, normal_a, b, normal_b, point, direction))
        return;
    cut_to_slice(a, normal_a, point, direction, &from, &to);
    cut_to_slice(b, normal_b, point, direction, &from, &to);
    if (from >= to)
        return;
    segment *part = &crossed->part[crossed->count++];
    tf_add(point, from, direction, part->end[0]);
    tf_add(point, to, direction, part->end[1]);
    crossed->length += (to - from) * sqrt(tf_dot(direction, direction));
}

static crossing cross(const pair_of_triangles *pair, double t)
{
    crossing crossed = {.count = 0};
    for (int i = 0; i < CORNERS; i++)
        for (int j = 0; j < CORNERS; j++) {
            tf_slice a = tf_slice_of(&pair->sweep[0][i], 3, t);
            tf_slice b = tf_slice_of(&pair->sweep[1][j], 3, t);
            cross_slices(&a, &b, &crossed);
        }
    return crossed;
}

static void print_numbers(const pair_of_triangles *pair, FILE *numbers)
{
    tf_figure_number(numbers, "point_triangle_hits",
                     count_point_triangle(pair));
    tf_figure_number(numbers, "edge_edge_hits", count_edge_edge(pair));
    tf_figure_number(numbers, "time", shown[1]);
    tf_figure_number(numbers, "length_start", cross(pair, shown[0]).length);
    tf_figure_number(numbers, "length", cross(pair, shown[1]).length);
    tf_figure_number(numbers, "length_end", cross(pair, shown[2]).length);
}

// Drawing ----------------------------------------------------------------

static void add_piece(tf_scene *scene, const tf_slice *slice, tf_role own)
{
    for (int i = 2; i < slice->count; i++) {
        double corner[3][3];
        tf_add(slice->corner[0], 0, slice->corner[0], corner[0]);
        tf_add(slice->corner[i - 1], 0, slice->corner[0], corner[1]);
        tf_add(slice->corner[i], 0, slice->corner[0], corner[2]);
        tf_scene_triangle(scene, (const double(*)[3])corner, 0,
                          (tf_paint){.role = own, .opacity = 0.5});
    }
}

/// A bent triangle at the time t: its border thick, its creases thin.
static void add_bent(tf_scene *scene, const tf_worldline corner[CORNERS],
                     double t, tf_role own)
{
    const tf_paint paint = {.role = own, .shade = 0.25};
    tf_simplex sweep[CORNERS];
    tf_slice slice[CORNERS];
    tf_sweep(CORNERS, corner, sweep);
    for (int i = 0; i < CORNERS; i++) {
        slice[i] = tf_slice_of(&sweep[i], 3, t);
        add_piece(scene, &slice[i], own);
    }

    // The outer pieces are triangles, and a crease is where each begins.
    const tf_slice *first = &slice[2], *last = &slice[0];
    double second[3];
    tf_worldline_place(&corner[1], 3, t, second);
    const double *const around[] = {
        first->corner[0], first->corner[1], second,          last->corner[1],
        last->corner[2],  last->corner[0],  first->corner[0]};
    for (int i = 0; i < 2 * CORNERS; i++)
        tf_scene_tube(scene, around[i], around[i + 1], border_width, paint);
    tf_scene_tube(scene, first->corner[1], first->corner[2], TF_WIDTH_THIN,
                  paint);
    tf_scene_tube(scene, last->corner[0], last->corner[1], TF_WIDTH_THIN,
                  paint);
}

static void write_state(tf_page *page, tf_box box, double t, bool crosses)
{
    char text[64];
    snprintf(text, sizeof text, "$t = %g$: %s", t,
             crosses ? "crossing" : "clear");
    tf_page_text(page, box.x + box.width / 2, box.y + box.height + 11,
                 TF_ALIGN_CENTER, text, TF_LETTERS,
                 crosses ? TF_ROLE_CONTACT : TF_ROLE_INK);
}

/// Both triangles and their crossing at one time.
static void draw_time(tf_page *page, const pair_of_triangles *pair, double t,
                      tf_box box)
{
    tf_panel *panel = tf_page_panel(page, box);
    tf_panel_look(panel, camera);
    tf_panel_margin(panel, 8);
    tf_scene *scene = tf_panel_scene(panel);
    for (int k = 0; k < TRIANGLES; k++)
        add_bent(scene, pair->corner[k], t, role[k]);
    crossing crossed = cross(pair, t);
    for (int i = 0; i < crossed.count; i++)
        tf_scene_tube(scene, crossed.part[i].end[0], crossed.part[i].end[1],
                      TF_WIDTH_TUBE, (tf_paint){.role = TF_ROLE_CONTACT});
    write_state(page, box, t, crossed.count > 0);
}

static void draw(tf_page *page, FILE *numbers)
{
    double height = tf_page_height(page), side = 124;
    const tf_box box[PANELS] = {
        {0, 0, side, height / 2 - text_room},
        {side, 0, tf_page_width(page) - side, height - text_room},
        {0, height / 2, side, height / 2 - text_room}};
    pair_of_triangles pair;
    move(&pair);
    for (int i = 0; i < PANELS; i++)
        draw_time(page, &pair, shown[i], box[i]);
    print_numbers(&pair, numbers);
}

const tf_figure tf_figure_crease_crossing = {
    .name = "crease-crossing",
    .title = "Bent triangles that cross at their creases without a contact",
    .width = TF_FIGURE_WIDTH,
    .height = 264,
    .draw = draw,
};

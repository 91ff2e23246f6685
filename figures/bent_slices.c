// A moving edge and a moving triangle as their sweeps have them, time by time.
#include "figures.h"

#include "spacetime/sweep.h"
#include "stage/vector.h"
#include "worlds.h"

enum {
    FRAMES = 5,
    ROWS = 2
};

static const double frame_width = 72, frame_gap = 4;
static const double row_top[ROWS] = {20, 116}, row_height[ROWS] = {80, 80};

/// A piece is coloured by the time at which all of the element lies as it does;
/// the middle one of a triangle lies as the element never does.
static const tf_role piece_role[TF_VERTICES + 1][TF_VERTICES] = {
    [2] = {TF_ROLE_START, TF_ROLE_END},
    [3] = {TF_ROLE_START, TF_ROLE_TRIANGLE, TF_ROLE_END}};

/// A moving element and how it is looked at.
typedef struct element {
    const char *key;
    int axes, vertices;
    tf_worldline vertex[TF_VERTICES];
    const char *name[2][TF_VERTICES]; ///< of the vertices at t = 0 and t = 1
    tf_side side[TF_VERTICES];        ///< where the names stand
    tf_role role;
    tf_camera camera;
} element;

static element make_edge(void)
{
    return (element){.key = "edge_bend",
                     .axes = 2,
                     .vertices = 2,
                     .vertex = {tf_worldline_between(2, (double[]){-0.6, 0.2},
                                                     (double[]){-0.3, -0.5}),
                                tf_worldline_between(2, (double[]){0.6, 0.05},
                                                     (double[]){0.4, 0.55})},
                     .name = {{"$e_0$", "$e_1$"}, {"$e_0'$", "$e_1'$"}},
                     .side = {TF_SIDE_N, TF_SIDE_S},
                     .role = TF_ROLE_EDGE,
                     .camera = {.elevation = 90}};
}

static element make_triangle(void)
{
    return (element){
        .key = "triangle_bend",
        .axes = 3,
        .vertices = 3,
        .vertex = {tf_worldline_between(3, (double[]){-0.6, -0.3, 0},
                                        (double[]){-0.5, -0.4, 0.8}),
                   tf_worldline_between(3, (double[]){0.6, -0.4, 0},
                                        (double[]){0.6, -0.3, 0.1}),
                   tf_worldline_between(3, (double[]){0, 0.6, 0},
                                        (double[]){0.1, 0.5, -0.3})},
        .name = {{"$a$", "$b$", "$c$"}, {"$a'$", "$b'$", "$c'$"}},
        .side = {TF_SIDE_E, TF_SIDE_N, TF_SIDE_E},
        .role = TF_ROLE_TRIANGLE,
        .camera = {.azimuth = 150, .elevation = 36}};
}

/// The direction of a segment, or the normal of a polygon; false if the piece
/// has no extent.
static bool find_direction(const tf_slice *piece, double direction[3])
{
    double u[3], v[3];
    tf_add(piece->corner[1], -1, piece->corner[0], u);
    tf_add(piece->corner[piece->count - 1], -1, piece->corner[0], v);
    if (piece->count == 2)
        tf_add(u, 0, u, direction);
    else
        tf_cross(u, v, direction);
    return tf_normalize(direction) > 0;
}

/// The angle in degrees by which the element is bent between two pieces.
static double bend_between(const tf_slice *a, const tf_slice *b)
{
    double u[3], v[3], turn[3];
    if (!find_direction(a, u) || !find_direction(b, v))
        return 0;
    tf_cross(u, v, turn);
    return atan2(sqrt(tf_dot(turn, turn)), tf_dot(u, v)) * 180 / acos(-1);
}

static tf_box frame_box(int row, int frame)
{
    double margin =
        (TF_FIGURE_WIDTH - FRAMES * frame_width - (FRAMES - 1) * frame_gap) / 2;
    return (tf_box){margin + frame * (frame_width + frame_gap), row_top[row],
                    frame_width, row_height[row]};
}

/// One flat piece with its border, if it has an extent.
static void draw_piece(tf_scene *scene, const tf_slice *piece, tf_role role)
{
    tf_paint paint = {.role = role, .shade = -0.3};
    double direction[3];
    if (!find_direction(piece, direction))
        return;
    if (piece->count == 2) {
        tf_scene_tube(scene, piece->corner[0], piece->corner[1], TF_WIDTH_TUBE,
                      paint);
        return;
    }
    for (int i = 2; i < piece->count; i++) {
        double corner[3][3];
        tf_add(piece->corner[0], 0, piece->corner[0], corner[0]);
        tf_add(piece->corner[i - 1], 0, piece->corner[i - 1], corner[1]);
        tf_add(piece->corner[i], 0, piece->corner[i], corner[2]);
        tf_scene_triangle(scene, (const double(*)[3])corner, 0, paint);
    }
    // The same for all pieces, because neighbours share a crease.
    tf_paint border = {.role = TF_ROLE_TRIANGLE, .shade = 0.3};
    for (int i = 0; i < piece->count; i++)
        tf_scene_tube(scene, piece->corner[i],
                      piece->corner[(i + 1) % piece->count], TF_WIDTH_THIN,
                      border);
}

/// The vertices, and the ways that they go; at both ends their names.
static void draw_vertices(tf_panel *panel, const element *e, double t)
{
    tf_scene *scene = tf_panel_scene(panel);
    for (int i = 0; i < e->vertices; i++) {
        double start[3], here[3], end[3];
        tf_worldline_place(&e->vertex[i], e->axes, 0, start);
        tf_worldline_place(&e->vertex[i], e->axes, t, here);
        tf_worldline_place(&e->vertex[i], e->axes, 1, end);
        tf_scene_dashes(scene, start, end, TF_WIDTH_HAIR, 2,
                        (tf_paint){.role = TF_ROLE_NEUTRAL});
        tf_scene_ball(scene, here, 4.5, (tf_paint){.role = e->role});
        if (t == 0 || t == 1)
            tf_panel_label(panel, here,
                           (tf_label){.text = e->name[t == 1][i],
                                      .size = TF_LETTERS_SMALL,
                                      .side = e->side[i],
                                      .gap = 4});
    }
}

/// The element at the time t.
static void draw_frame(tf_page *page, tf_box box, const element *e, double t,
                       const tf_slice piece[])
{
    tf_page_fill_box(page, box,
                     (tf_paint){.role = TF_ROLE_NEUTRAL, .opacity = 0.09});
    tf_panel *panel = tf_page_panel(page, box);
    tf_panel_look(panel, e->camera);
    tf_panel_margin(panel, 11);
    if (e->axes == 2)
        tf_panel_fix(panel);
    draw_vertices(panel, e, t);
    for (int i = 0; i < e->vertices; i++)
        draw_piece(tf_panel_scene(panel), &piece[i],
                   piece_role[e->vertices][i]);
}

/// Tell the angles between the pieces, below the frame and in numbers.
static void tell_bends(tf_page *page, tf_box box, const element *e, double t,
                       const tf_slice piece[], FILE *numbers)
{
    char text[32] = "";
    size_t length = 0;
    for (int i = 0; i + 1 < e->vertices; i++) {
        char key[32];
        double bend = bend_between(&piece[i], &piece[i + 1]);
        snprintf(key, sizeof key, "%s%s_%g", e->key, i > 0 ? "_second" : "", t);
        tf_figure_number(numbers, key, bend);
        length += (size_t)snprintf(text + length, sizeof text - length,
                                   "%s%.0f°", i > 0 ? ", " : "", bend);
    }
    tf_page_caption(page, box, text);
}

static void draw_row(tf_page *page, int row, const element *e, FILE *numbers)
{
    tf_simplex sweep[TF_VERTICES];
    tf_sweep(e->vertices, e->vertex, sweep);
    for (int frame = 0; frame < FRAMES; frame++) {
        double t = frame / (FRAMES - 1.0);
        tf_box box = frame_box(row, frame);
        tf_slice piece[TF_VERTICES];
        for (int i = 0; i < e->vertices; i++)
            piece[i] = tf_slice_of(&sweep[i], e->axes, t);
        draw_frame(page, box, e, t, piece);
        tell_bends(page, box, e, t, piece, numbers);
    }
}

static void draw(tf_page *page, FILE *numbers)
{
    static const char *const time[FRAMES] = {
        "$t = 0$", "$t = 1/4$", "$t = 1/2$", "$t = 3/4$", "$t = 1$"};
    element edge = make_edge(), triangle = make_triangle();
    for (int frame = 0; frame < FRAMES; frame++)
        tf_page_title(page, frame_box(0, frame), time[frame]);
    draw_row(page, 0, &edge, numbers);
    draw_row(page, 1, &triangle, numbers);
}

const tf_figure tf_figure_bent_slices = {
    .name = "bent-slices",
    .title = "A bent edge and a bent triangle, time by time",
    .width = TF_FIGURE_WIDTH,
    .height = 216,
    .draw = draw,
};

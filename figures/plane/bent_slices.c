// A moving edge and a moving triangle as their sweeps have them, time by time.
#include "kit/figures.h"

#include "geometry/sweep.h"
#include "kit/worlds.h"

enum {
    FRAMES = 5,
    ROWS = 2
};

static const double frame_width = 72, frame_gap = 4;
static const double row_top[ROWS] = {20, 90}, row_height[ROWS] = {52, 92};

/// A piece is colored by the time at which all of the element lies as it does;
/// the middle one of a triangle lies as the element never does.
static const fig_role piece_role[TF_VERTICES + 1][TF_VERTICES] = {
    [2] = {FIG_ROLE_START, FIG_ROLE_END},
    [3] = {FIG_ROLE_START, FIG_ROLE_TRIANGLE, FIG_ROLE_END}};

/// A moving element and how it is looked at.
typedef struct element {
    const char *key;
    int axes, vertices;
    tf_worldline vertex[TF_VERTICES];
    const char *name[2][TF_VERTICES]; ///< of the vertices at t = 0 and t = 1
    fig_side side[TF_VERTICES];       ///< where the names stand
    fig_role role;
    fig_camera camera;
} element;

static element make_edge(void)
{
    return (element){
        .key = "edge_bend",
        .axes = 2,
        .vertices = 2,
        .vertex = {tf_worldline_between(2, (double[]){0, 0}, (double[]){0, 1}),
                   tf_worldline_between(2, (double[]){4, 0}, (double[]){4, 2})},
        .name = {{"$e_0$", "$e_1$"}, {"$e_0'$", "$e_1'$"}},
        .side = {FIG_SIDE_S, FIG_SIDE_S},
        .role = FIG_ROLE_EDGE,
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
        .name = {{"$v_0$", "$v_1$", "$v_2$"}, {"$v_0'$", "$v_1'$", "$v_2'$"}},
        .side = {FIG_SIDE_E, FIG_SIDE_N, FIG_SIDE_E},
        .role = FIG_ROLE_TRIANGLE,
        .camera = {.azimuth = 150, .elevation = 36}};
}

/// The direction of a segment, or the normal of a polygon; zero if the piece
/// has no extent.
static tf_vector direction_of(const fig_slice *piece)
{
    tf_vector u = fig_difference(piece->corner[1], piece->corner[0]);
    tf_vector v =
        fig_difference(piece->corner[piece->count - 1], piece->corner[0]);
    return fig_normalized(piece->count == 2 ? u : fig_cross(u, v));
}

/// The angle in degrees by which the element is bent between two pieces.
static double bend_between(const fig_slice *a, const fig_slice *b)
{
    tf_vector u = direction_of(a), v = direction_of(b);
    return atan2(fig_length(fig_cross(u, v)), tf_vector_dot(u, v)) * 180 /
           acos(-1);
}

/// The name of a segment's simplex, beside it.
static void name_segment(fig_panel *panel, const fig_slice *piece,
                         const char *name, fig_role role)
{
    fig_panel_label(panel, fig_lerp(piece->corner[0], piece->corner[1], 0.5),
                    (fig_label){.text = name,
                                .role = role,
                                .size = FIG_LETTERS_SMALL,
                                .side = FIG_SIDE_N,
                                .gap = 3});
}

/// The name of a polygon's simplex, in its middle.  The colors of t = 0 and
/// t = 1 are light in both themes.
static void name_polygon(fig_page *page, fig_panel *panel,
                         const fig_slice *piece, const char *name,
                         fig_role role)
{
    tf_vector middle = {{0}};
    for (int i = 0; i < piece->count; i++)
        middle = fig_combination(middle, 1.0 / piece->count, piece->corner[i]);
    fig_point at = fig_panel_project(panel, middle);
    bool bright = fig_page_theme(page)->dark && role != FIG_ROLE_TRIANGLE;
    fig_page_text(page, at.x, at.y + 3, FIG_ALIGN_CENTER, name,
                  FIG_LETTERS_SMALL, bright ? FIG_ROLE_PAPER : FIG_ROLE_INK);
}

/// Name the pieces: those of an edge in the middle frame, and one of a triangle
/// in each frame between the ends, there where it is large.
static void name_pieces(fig_page *page, fig_panel *panel, const element *e,
                        double t, const tf_simplex sweep[],
                        const fig_slice piece[])
{
    for (int i = 0; i < e->vertices; i++) {
        fig_role role = piece_role[e->vertices][i];
        char name[16];
        snprintf(name, sizeof name, "$S_%d$", sweep[i].pivot);
        if (e->vertices == 2 && t == 0.5)
            name_segment(panel, &piece[i], name, role);
        if (e->vertices == 3 && t == (i + 1) / 4.0)
            name_polygon(page, panel, &piece[i], name, role);
    }
}

static fig_box frame_box(int row, int frame)
{
    double margin =
        (FIG_PAGE_WIDTH - FRAMES * frame_width - (FRAMES - 1) * frame_gap) / 2;
    return (fig_box){margin + frame * (frame_width + frame_gap), row_top[row],
                     frame_width, row_height[row]};
}

/// One flat piece with its border, if it has an extent.
static void draw_piece(fig_scene *scene, const fig_slice *piece, fig_role role)
{
    fig_paint paint = {.role = role, .shade = -0.3};
    if (fig_length(direction_of(piece)) == 0)
        return;
    if (piece->count == 2) {
        fig_scene_tube(scene, piece->corner[0], piece->corner[1],
                       FIG_WIDTH_TUBE, paint);
        return;
    }
    for (int i = 2; i < piece->count; i++) {
        tf_vector corner[3] = {piece->corner[0], piece->corner[i - 1],
                               piece->corner[i]};
        fig_scene_triangle(scene, corner, 0, paint);
    }
    // The same for all pieces, because neighbours share a crease.
    fig_paint border = {.role = FIG_ROLE_TRIANGLE, .shade = 0.3};
    for (int i = 0; i < piece->count; i++)
        fig_scene_tube(scene, piece->corner[i],
                       piece->corner[(i + 1) % piece->count], FIG_WIDTH_THIN,
                       border);
}

/// The vertices, and the ways that they go; at both ends their names.
static void draw_vertices(fig_panel *panel, const element *e, double t)
{
    fig_scene *scene = fig_panel_scene(panel);
    for (int i = 0; i < e->vertices; i++) {
        tf_vector start = fig_worldline_place(&e->vertex[i], e->axes, 0);
        tf_vector here = fig_worldline_place(&e->vertex[i], e->axes, t);
        tf_vector end = fig_worldline_place(&e->vertex[i], e->axes, 1);
        fig_scene_dashes(scene, start, end, FIG_WIDTH_HAIR, 2,
                         (fig_paint){.role = FIG_ROLE_NEUTRAL});
        fig_scene_ball(scene, here, 4.5, (fig_paint){.role = e->role});
        if (t == 0 || t == 1)
            fig_panel_label(panel, here,
                            (fig_label){.text = e->name[t == 1][i],
                                        .size = FIG_LETTERS_SMALL,
                                        .side = e->side[i],
                                        .gap = 4});
    }
}

/// The element at the time t.
static void draw_frame(fig_page *page, fig_box box, const element *e, double t,
                       const tf_simplex sweep[], const fig_slice piece[])
{
    fig_page_fill_box(page, box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, e->camera);
    fig_panel_margin(panel, 11);
    if (e->axes == 2)
        fig_panel_fix(panel);
    draw_vertices(panel, e, t);
    for (int i = 0; i < e->vertices; i++)
        draw_piece(fig_panel_scene(panel), &piece[i],
                   piece_role[e->vertices][i]);
    name_pieces(page, panel, e, t, sweep, piece);
}

/// Tell the angles between the pieces, below the frame and in numbers.
static void tell_bends(fig_page *page, fig_box box, const element *e, double t,
                       const fig_slice piece[], FILE *numbers)
{
    char text[32] = "";
    size_t length = 0;
    for (int i = 0; i + 1 < e->vertices; i++) {
        char key[32];
        double bend = bend_between(&piece[i], &piece[i + 1]);
        snprintf(key, sizeof key, "%s%s_%g", e->key, i > 0 ? "_second" : "", t);
        fig_number(numbers, key, bend);
        length += (size_t)snprintf(text + length, sizeof text - length,
                                   "%s%.0f°", i > 0 ? ", " : "", bend);
    }
    fig_page_caption(page, box, text);
}

static void draw_row(fig_page *page, int row, const element *e, FILE *numbers)
{
    tf_simplex sweep[TF_VERTICES];
    tf_sweep(e->vertices, e->vertex, sweep);
    for (int frame = 0; frame < FRAMES; frame++) {
        double t = frame / (FRAMES - 1.0);
        fig_box box = frame_box(row, frame);
        fig_slice piece[TF_VERTICES];
        for (int i = 0; i < e->vertices; i++)
            piece[i] = fig_slice_of(&sweep[i], e->axes, t);
        draw_frame(page, box, e, t, sweep, piece);
        tell_bends(page, box, e, t, piece, numbers);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    static const char *const time[FRAMES] = {
        "$t = 0$", "$t = 1/4$", "$t = 1/2$", "$t = 3/4$", "$t = 1$"};
    element edge = make_edge(), triangle = make_triangle();
    for (int frame = 0; frame < FRAMES; frame++)
        fig_page_title(page, frame_box(0, frame), time[frame]);
    draw_row(page, 0, &edge, numbers);
    draw_row(page, 1, &triangle, numbers);
}

const fig_figure fig_bent_slices = {
    .name = "bent-slices",
    .title = "A bent edge and a bent triangle, time by time",
    .width = FIG_PAGE_WIDTH,
    .height = 200,
    .draw = draw,
};

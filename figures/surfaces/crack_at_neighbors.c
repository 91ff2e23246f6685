// Two triangles with a common edge, each swept in the order in which its own
// corners are listed, and both in one order: a crack opens or does not.
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "kit/film.h"
#include "kit/worlds.h"
#include "query/query.h"

enum {
    FRAMES = 5,
    ROWS = 2,
    TRIANGLES = 2,
    VERTICES = 4
};

/// The vertices a, b, c and d of the triangles abc and bad, and a particle.
static const double start[VERTICES + 1][3] = {
    {0, 0, 0}, {4, 0, 0}, {2, 4, 0}, {2, -4, 0}, {2, 0.25, 1.5}};
static const double end[VERTICES + 1][3] = {
    {0, -1, 0}, {4, 1, 0}, {2, 4, 0}, {2, -4, 0}, {2, 0.25, -1.5}};

/// How the corners of each triangle are listed, and how by their indices.
static const int listed[ROWS][TRIANGLES][3] = {{{0, 1, 2}, {1, 0, 3}},
                                               {{0, 1, 2}, {0, 1, 3}}};
static const char *const title[ROWS] = {
    "each triangle in its own order: a crack",
    "both in the order of the indices: no crack"};
static const char *const short_title[ROWS] = {"each in its own order",
                                              "in the order of the indices"};
static const char *const key[ROWS] = {"private_hits", "shared_hits"};

static const fig_role role[TRIANGLES] = {FIG_ROLE_TRIANGLE,
                                         FIG_ROLE_OTHER_EDGE};
static const fig_camera camera = {.azimuth = -14, .elevation = 46};
static const double row_height = 118, title_room = 16;

static tf_worldline vertex_of(int v)
{
    return tf_worldline_between(3, start[v], end[v]);
}

static void find_corners(const int triangle[3], tf_worldline corner[3])
{
    for (int i = 0; i < 3; i++)
        corner[i] = vertex_of(triangle[i]);
}

/// The contact of the particle with a triangle.
static tf_contact meet(const int triangle[3])
{
    tf_worldline corner[3], particle = vertex_of(VERTICES);
    tf_contact contact = {.verdict = TF_APART};
    find_corners(triangle, corner);
    tf_query(&tf_exact, 3, 1, &particle, 3, corner, &contact);
    return contact;
}

/// How far apart the two bent edges are at half time: their creases, where the
/// first of the two vertices has left and the second has arrived.
static double crack_width(void)
{
    tf_vector crease[2];
    for (int i = 0; i < 2; i++)
        crease[i] =
            fig_lerp(fig_vector_of(start[i]), fig_vector_of(end[1 - i]), 0.5);
    return fig_length(fig_difference(crease[1], crease[0]));
}

static void name_vertices(fig_panel *panel, int row)
{
    static const char *const name[ROWS][VERTICES] = {
        {"$a$", "$b$", "$c$", "$d$"}, {"0", "1", "2", "3"}};
    static const fig_side side[VERTICES] = {FIG_SIDE_W, FIG_SIDE_E, FIG_SIDE_N,
                                            FIG_SIDE_S};
    for (int v = 0; v < VERTICES; v++)
        fig_panel_label(panel, fig_vector_of(start[v]),
                        (fig_label){.text = name[row][v],
                                    .size = FIG_LETTERS_SMALL,
                                    .side = side[v],
                                    .gap = 3});
}

/// Let all frames have one camera.
static void reach_all(fig_scene *scene)
{
    for (int v = 0; v <= VERTICES; v++) {
        fig_scene_reach(scene, fig_vector_of(start[v]));
        fig_scene_reach(scene, fig_vector_of(end[v]));
    }
}

/// The particle on its way, and the contact once it has been reached.
static void draw_particle(fig_scene *scene, double t, double toi)
{
    const fig_paint paint = {.role = FIG_ROLE_POINT};
    tf_worldline particle = vertex_of(VERTICES);
    tf_vector from = fig_worldline_place(&particle, 3, 0);
    tf_vector at = fig_worldline_place(&particle, 3, t);
    if (t > 0)
        fig_scene_tube(scene, from, at, FIG_WIDTH_THIN, paint);
    bool reached = toi >= 0 && t > toi - 1e-9;
    if (reached)
        fig_scene_ball(scene, fig_worldline_place(&particle, 3, toi),
                       FIG_WIDTH_MARK, (fig_paint){.role = FIG_ROLE_CONTACT});
    if (!reached || t > toi + 1e-9)
        fig_scene_ball(scene, at, FIG_WIDTH_BALL, paint);
}

static void draw_frame(fig_page *page, int row, double t, fig_box box,
                       double toi)
{
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, camera);
    fig_panel_margin(panel, 9);
    fig_scene *scene = fig_panel_scene(panel);
    reach_all(scene);
    for (int k = 0; k < TRIANGLES; k++) {
        tf_worldline corner[3];
        find_corners(listed[row][k], corner);
        fig_world_bent(scene, corner, t, role[k]);
    }
    draw_particle(scene, t, toi);
    if (t == 0 && !fig_page_moves(page))
        name_vertices(panel, row);
}

static void write_time(fig_page *page, fig_box box, double t)
{
    char text[32];
    snprintf(text, sizeof text, "$t = %g$", t);
    fig_page_caption(page, box, text);
}

/// How many of a row's triangles the particle meets, and when; -1 if none.
static int count_hits(int row, double *toi)
{
    int hits = 0;
    *toi = -1;
    for (int k = 0; k < TRIANGLES; k++) {
        tf_contact contact = meet(listed[row][k]);
        hits += contact.verdict == TF_HIT;
        if (contact.verdict == TF_HIT)
            *toi = fig_toi(&contact);
    }
    return hits;
}

static void draw_strip(fig_page *page, int row)
{
    double width = fig_page_width(page) / FRAMES;
    double top = row * (row_height + title_room), toi;
    count_hits(row, &toi);
    fig_page_text(page, fig_page_width(page) / 2, top + 11, FIG_ALIGN_CENTER,
                  title[row], FIG_LETTERS, FIG_ROLE_INK);
    for (int i = 0; i < FRAMES; i++) {
        fig_box box = {i * width, top + title_room, width, row_height};
        draw_frame(page, row, i / (FRAMES - 1.0), box, toi);
        if (row == ROWS - 1)
            write_time(page, box, i / (FRAMES - 1.0));
    }
}

/// One time of a film, both orders side by side.
static void draw_moment(fig_page *page, double t)
{
    double width = fig_page_width(page) / ROWS;
    double toi[ROWS];
    for (int row = 0; row < ROWS; row++) {
        count_hits(row, &toi[row]);
        fig_box box = {row * width, title_room, width,
                       fig_page_height(page) - 3 * title_room};
        fig_page_text(page, box.x + width / 2, 11, FIG_ALIGN_CENTER,
                      short_title[row], FIG_LETTERS, FIG_ROLE_INK);
        draw_frame(page, row, t, box, toi[row]);
    }
    fig_film_clock(page, 4, fig_page_height(page) - 10,
                   fig_page_width(page) - 8, t, toi[1], "contact on the right");
}

static void print_numbers(FILE *numbers)
{
    double toi[ROWS];
    for (int row = 0; row < ROWS; row++)
        fig_number(numbers, key[row], count_hits(row, &toi[row]));
    fig_number(numbers, "toi", toi[1]);
    fig_number(numbers, "width", crack_width());
    fig_number(numbers, "length",
               fig_length(fig_difference(fig_vector_of(start[1]),
                                         fig_vector_of(start[0]))));
}

static void draw(fig_page *page, FILE *numbers)
{
    double t = fig_film_time(page, numbers, 0.5, -1);
    if (fig_page_moves(page))
        draw_moment(page, t);
    else
        for (int row = 0; row < ROWS; row++)
            draw_strip(page, row);
    print_numbers(numbers);
}

const fig_figure fig_crack_at_neighbors = {
    .name = "crack-at-neighbors",
    .title = "The crack between neighbors swept in different orders",
    .width = FIG_PAGE_WIDTH,
    .height = 284,
    .moves = true,
    .draw = draw,
};

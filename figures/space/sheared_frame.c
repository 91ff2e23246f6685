// The frame in which the point stands still: is the origin of space in one of
// three tetrahedra?
#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "intersect/cascade.h"
#include "kit/figures.h"
#include "kit/worlds.h"
#include "query/query.h"

enum {
    CORNERS = 3,
    TETRAHEDRA = 3
};

static const char *const simplex_name[TETRAHEDRA] = {"$S_0$", "$S_1$", "$S_2$"};
static const char *const corner_name[CORNERS][2] = {
    {"$a$", "$a'$"}, {"$b$", "$b'$"}, {"$c$", "$c'$"}};

/// Where the names of the corners stand, at t = 0 and at t = 1.
static const fig_side corner_side[CORNERS][2] = {{FIG_SIDE_W, FIG_SIDE_W},
                                                 {FIG_SIDE_S, FIG_SIDE_N},
                                                 {FIG_SIDE_E, FIG_SIDE_NE}};

// Chosen for simple weights: a quarter each.
static const double point_start[] = {0.75, -1, 2.25},
                    point_end[] = {0, 0, 0.25};
static const double corner_start[CORNERS][3] = {
    {-2, -1.5, 0.5}, {2.5, -1.5, 0}, {0, 2.5, 0.25}};
static const double corner_end[CORNERS][3] = {
    {-2.5, -1, 1.5}, {1.5, -1.5, 2}, {-0.5, 2.5, 2.5}};

static const tf_vector origin = {{0, 0, 0}};
static const double explosion = 1.7;
static const double small_ball = 4.5;
static const double column = 17, line = 15; ///< of the table

/// A point, a triangle, and what the library finds.
typedef struct encounter {
    tf_worldline point, corner[CORNERS];
    tf_simplex path, sweep[TETRAHEDRA];
    tf_contact contact;
    int holder; ///< the tetrahedron that holds the origin
    tf_intersection meeting[TETRAHEDRA];
    tf_sign sign[TETRAHEDRA][TF_EVENTS]; ///< of the origin's weights
} encounter;

// The weight of a corner is, up to a common factor, the determinant of the
// others, with signs in turn.
static tf_sign coordinate_sign(const tf_pair *pair, const tf_event *corner,
                               int place)
{
    int without = 0;
    while (pair->event[without] != corner)
        without++;
    tf_differences others;
    tf_pair_differences(pair, without, &others);
    tf_sign sign = tf_exact.sign(&others);
    return place % 2 == 0 ? sign : (tf_sign)-sign;
}

static void solve(encounter *e)
{
    e->point = tf_worldline_between(3, point_start, point_end);
    for (int i = 0; i < CORNERS; i++)
        e->corner[i] = tf_worldline_between(3, corner_start[i], corner_end[i]);
    tf_sweep(1, &e->point, &e->path);
    tf_sweep(CORNERS, e->corner, e->sweep);
    tf_query(&tf_exact, 3, 1, &e->point, 3, e->corner, &e->contact);
    for (int j = 0; j < TETRAHEDRA; j++) {
        tf_pair pair = tf_pair_of(&e->path, &e->sweep[j], 3);
        e->meeting[j] = tf_intersect(&tf_exact, &pair, TF_WITH_POINT);
        if (e->meeting[j].verdict == TF_HIT)
            e->holder = j;
        for (int i = 0; i < TF_EVENTS; i++)
            e->sign[j][i] = coordinate_sign(&pair, e->sweep[j].event[i], i);
    }
}

static void print_numbers(const encounter *e, FILE *numbers)
{
    const tf_contact *contact = &e->contact;
    char key[32];
    fig_number(numbers, "toi", fig_toi(contact));
    for (int i = 0; i < CORNERS; i++) {
        snprintf(key, sizeof key, "barycentric_%c", 'a' + i);
        fig_number(numbers, key, contact->barycentric[1][i]);
    }
    for (int j = 0; j < TETRAHEDRA; j++)
        for (int i = 0; i < TF_EVENTS; i++) {
            snprintf(key, sizeof key, "sign_%d_%d", e->sweep[j].pivot, i);
            fig_number(numbers, key, e->sign[j][i]);
        }
}

// The frame of the point -------------------------------------------------

/// Which corner an event is of.
static int corner_of(const encounter *e, const tf_event *event)
{
    int corner = 0;
    while (event != &e->corner[corner].at[event->t])
        corner++;
    return corner;
}

static tf_vector seen_from_point(const encounter *e, const tf_event *event)
{
    return fig_difference(fig_vector_of(event->x),
                          fig_vector_of(e->point.at[event->t].x));
}

/// How far a tetrahedron is drawn from its place, away from the one that holds
/// the origin.
static tf_vector find_shift(const encounter *e, int tetrahedron)
{
    tf_vector shift = {{0}};
    for (int i = 0; i < TF_EVENTS; i++) {
        tf_vector own = seen_from_point(e, e->sweep[tetrahedron].event[i]);
        tf_vector held = seen_from_point(e, e->sweep[e->holder].event[i]);
        shift = fig_combination(shift, explosion / TF_EVENTS,
                                fig_difference(own, held));
    }
    return shift;
}

static void draw_tetrahedron(fig_panel *panel, const encounter *e,
                             int tetrahedron)
{
    const tf_simplex *simplex = &e->sweep[tetrahedron];
    bool holds = tetrahedron == e->holder;
    fig_scene *scene = fig_panel_scene(panel);
    tf_vector corner[TF_EVENTS];
    tf_vector shift = find_shift(e, tetrahedron);
    for (int i = 0; i < simplex->count; i++) {
        const tf_event *event = simplex->event[i];
        corner[i] = fig_sum(seen_from_point(e, event), shift);
        if (holds)
            fig_scene_dashes(scene, origin, corner[i], FIG_WIDTH_THIN, 2,
                             (fig_paint){.role = FIG_ROLE_POINT});
        fig_scene_ball(scene, corner[i], holds ? FIG_WIDTH_BALL : small_ball,
                       (fig_paint){.role = FIG_ROLE_TRIANGLE});
        fig_panel_label(
            panel, corner[i],
            (fig_label){.text = corner_name[corner_of(e, event)][event->t],
                        .side = corner_side[corner_of(e, event)][event->t],
                        .role = FIG_ROLE_TRIANGLE,
                        .size = holds ? FIG_LETTERS : FIG_LETTERS_SMALL});
    }
    tf_vector middle = {{0}};
    for (int i = 0; i < TF_EVENTS; i++)
        middle = fig_combination(middle, 1.0 / TF_EVENTS, corner[i]);
    fig_panel_label(panel, middle,
                    (fig_label){.text = simplex_name[simplex->pivot],
                                .gap = holds ? 18 : 2});
    fig_scene_tetrahedron(
        scene, corner, holds ? FIG_WIDTH_LINE : FIG_WIDTH_THIN,
        (fig_paint){.role = FIG_ROLE_TRIANGLE, .opacity = holds ? 0.22 : 0.14});
}

static void draw_frame(fig_page *page, const encounter *e, fig_box box)
{
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.azimuth = 72, .elevation = 14});
    for (int j = 0; j < TETRAHEDRA; j++)
        draw_tetrahedron(panel, e, j);
    fig_scene_ball(fig_panel_scene(panel), origin, FIG_WIDTH_MARK,
                   (fig_paint){.role = FIG_ROLE_POINT});
    fig_panel_label(panel, origin,
                    (fig_label){.text = "$0$",
                                .role = FIG_ROLE_POINT,
                                .side = FIG_SIDE_E,
                                .gap = 7});
}

// The motion as it is ----------------------------------------------------

static void add_vertex(fig_panel *panel, const tf_worldline *vertex,
                       const char *const name[2], const fig_side side[2],
                       fig_role role)
{
    fig_scene *scene = fig_panel_scene(panel);
    tf_vector start = fig_vector_of(vertex->at[0].x);
    tf_vector end = fig_vector_of(vertex->at[1].x);
    fig_scene_ball(scene, start, small_ball, (fig_paint){.role = role});
    fig_scene_arrow(scene, start, end, FIG_WIDTH_LINE,
                    (fig_paint){.role = role});
    fig_panel_label(
        panel, start,
        (fig_label){.text = name[0], .role = role, .side = side[0]});
    fig_panel_label(
        panel, end,
        (fig_label){.text = name[1], .role = role, .side = side[1]});
}

static void draw_motion(fig_page *page, const encounter *e, fig_box box)
{
    static const char *const point_name[2] = {"$p$", "$p'$"};
    static const fig_side point_side[2] = {FIG_SIDE_N, FIG_SIDE_E};
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.azimuth = 72, .elevation = 14});
    fig_scene *scene = fig_panel_scene(panel);
    for (int t = 0; t < 2; t++) {
        tf_vector corner[CORNERS];
        for (int i = 0; i < CORNERS; i++)
            corner[i] = fig_worldline_place(&e->corner[i], 3, t);
        fig_scene_triangle(
            scene, corner, FIG_WIDTH_THIN,
            (fig_paint){.role = FIG_ROLE_TRIANGLE, .opacity = 0.4});
    }
    for (int i = 0; i < CORNERS; i++)
        add_vertex(panel, &e->corner[i], corner_name[i], corner_side[i],
                   FIG_ROLE_TRIANGLE);
    add_vertex(panel, &e->point, point_name, point_side, FIG_ROLE_POINT);
}

// The table of signs -----------------------------------------------------

static void write_sign(fig_page *page, double x, double y, tf_sign sign)
{
    const char *text = sign > 0 ? "$+$" : sign < 0 ? "$-$" : "$0$";
    fig_role role = sign > 0   ? FIG_ROLE_POSITIVE
                    : sign < 0 ? FIG_ROLE_NEGATIVE
                               : FIG_ROLE_UNCERTAIN;
    fig_page_dot(page, x, y - 3.3, line - 4, (fig_paint){.role = role});
    fig_page_text(page, x, y, FIG_ALIGN_CENTER, text, FIG_LETTERS,
                  FIG_ROLE_INK);
}

/// A row of two lines: corners, and the signs of their weights.
static void write_row(fig_page *page, const encounter *e, int tetrahedron,
                      double x, double y)
{
    const tf_simplex *simplex = &e->sweep[tetrahedron];
    for (int i = 0; i < simplex->count; i++) {
        const tf_event *event = simplex->event[i];
        fig_page_text(page, x + column * i, y, FIG_ALIGN_CENTER,
                      corner_name[corner_of(e, event)][event->t], FIG_LETTERS,
                      FIG_ROLE_TRIANGLE);
        write_sign(page, x + column * i, y + line, e->sign[tetrahedron][i]);
    }
    fig_page_text(page, x - 26, y + line / 2, FIG_ALIGN_LEFT,
                  simplex_name[simplex->pivot], FIG_LETTERS, FIG_ROLE_INK);
    bool holds = tetrahedron == e->holder;
    fig_page_text(page, x + column * simplex->count, y + line / 2,
                  FIG_ALIGN_LEFT, holds ? "holds $0$" : "misses $0$",
                  FIG_LETTERS, holds ? FIG_ROLE_CONTACT : FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    encounter e;
    solve(&e);
    double height = fig_page_height(page), side = 236;
    draw_frame(page, &e, (fig_box){0, 10, side, height - 10});
    fig_page_text(page, side / 2, 14, FIG_ALIGN_CENTER, "seen from the point",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    fig_page_text(page, side + 68, 14, FIG_ALIGN_CENTER, "the motion as it is",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    draw_motion(page, &e, (fig_box){side, 14, 144, 124});
    fig_page_text(page, side + 68, 160, FIG_ALIGN_CENTER,
                  "signs of the coordinates of $0$", FIG_LETTERS_SMALL,
                  FIG_ROLE_INK);
    for (int j = 0; j < TETRAHEDRA; j++)
        write_row(page, &e, TETRAHEDRA - 1 - j, side + 29, 182 + 38 * j);
    print_numbers(&e, numbers);
}

const fig_figure fig_sheared_frame = {
    .name = "sheared-frame",
    .title = "Three tetrahedra around the point that stands still",
    .width = FIG_PAGE_WIDTH,
    .height = FIG_PAGE_HEIGHT,
    .draw = draw,
};

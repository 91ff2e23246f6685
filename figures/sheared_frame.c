// The frame in which the point stands still: is the origin of space in one of
// three tetrahedra?
#include "arithmetic/exact.h"
#include "figures.h"
#include "query/point_triangle.h"
#include "spacetime/meet.h"
#include "stage/vector.h"
#include "worlds.h"

enum {
    CORNERS = 3,
    TETRAHEDRA = 3
};

static const char *const corner_name[CORNERS][2] = {
    {"$a$", "$a'$"}, {"$b$", "$b'$"}, {"$c$", "$c'$"}};

// Chosen for simple weights: a quarter each.
static const double point_start[] = {0.75, -1, 2.25},
                    point_end[] = {0, 0, 0.25};
static const double corner_start[CORNERS][3] = {
    {-2, -1.5, 0.5}, {2.5, -1.5, 0}, {0, 2.5, 0.25}};
static const double corner_end[CORNERS][3] = {
    {-2.5, -1, 1.5}, {1.5, -1.5, 2}, {-0.5, 2.5, 2.5}};

static const double origin[3] = {0, 0, 0}, explosion = 0.75;
static const double small_ball = 4.5;
static const double column = 17, line = 15; ///< of the table

/// A point, a triangle, and what the library finds.
typedef struct encounter {
    tf_worldline point, corner[CORNERS];
    tf_simplex path, sweep[TETRAHEDRA];
    tf_contact contact;
    int holder; ///< the tetrahedron that holds the origin
    tf_meeting meeting[TETRAHEDRA];
    tf_sign sign[TETRAHEDRA][TF_EVENTS]; ///< of the origin's weights
} encounter;

// The weight of a corner is, up to a common factor, the determinant of the
// others, with signs in turn.
static tf_sign weight_sign(const tf_pair *pair, const tf_event *corner,
                           int place)
{
    int without = 0;
    while (pair->event[without] != corner)
        without++;
    tf_differences others = tf_pair_differences(pair, without);
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
    tf_point_triangle(&tf_exact, &e->point, e->corner, &e->contact);
    for (int j = 0; j < TETRAHEDRA; j++) {
        tf_pair pair = tf_pair_of(&e->path, &e->sweep[j], 3);
        e->meeting[j] = tf_meet(&tf_exact, &pair);
        if (e->meeting[j].verdict == TF_HIT)
            e->holder = j;
        for (int i = 0; i < TF_EVENTS; i++)
            e->sign[j][i] = weight_sign(&pair, e->sweep[j].event[i], i);
    }
}

static void print_numbers(const encounter *e, FILE *numbers)
{
    const tf_contact *contact = &e->contact;
    char key[32];
    tf_figure_number(numbers, "toi", (contact->toi_lo + contact->toi_hi) / 2);
    for (int i = 0; i < CORNERS; i++) {
        snprintf(key, sizeof key, "weight_%c", 'a' + i);
        tf_figure_number(numbers, key, contact->weight[1][i]);
    }
    for (int j = 0; j < TETRAHEDRA; j++)
        for (int i = 0; i < TF_EVENTS; i++) {
            snprintf(key, sizeof key, "sign_%d_%d", e->sweep[j].mover, i);
            tf_figure_number(numbers, key, e->sign[j][i]);
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

static void see_from_point(const encounter *e, const tf_event *event,
                           double seen[3])
{
    for (int k = 0; k < 3; k++)
        seen[k] = event->x[k] - e->point.at[event->t].x[k];
}

/// How far a tetrahedron is drawn from its place, away from the one that holds
/// the origin.
static void find_shift(const encounter *e, int tetrahedron, double shift[3])
{
    for (int k = 0; k < 3; k++)
        shift[k] = 0;
    for (int i = 0; i < TF_EVENTS; i++) {
        double own[3], held[3];
        see_from_point(e, e->sweep[tetrahedron].event[i], own);
        see_from_point(e, e->sweep[e->holder].event[i], held);
        for (int k = 0; k < 3; k++)
            shift[k] += explosion * (own[k] - held[k]) / TF_EVENTS;
    }
}

static void draw_tetrahedron(tf_panel *panel, const encounter *e,
                             int tetrahedron)
{
    const tf_simplex *simplex = &e->sweep[tetrahedron];
    bool holds = tetrahedron == e->holder;
    tf_scene *scene = tf_panel_scene(panel);
    double corner[TF_EVENTS][3], shift[3];
    find_shift(e, tetrahedron, shift);
    for (int i = 0; i < simplex->count; i++) {
        const tf_event *event = simplex->event[i];
        see_from_point(e, event, corner[i]);
        tf_add(corner[i], 1, shift, corner[i]);
        if (holds)
            tf_scene_dashes(scene, origin, corner[i], TF_WIDTH_THIN, 2,
                            (tf_paint){.role = TF_ROLE_POINT});
        tf_scene_ball(scene, corner[i], holds ? TF_WIDTH_BALL : small_ball,
                      (tf_paint){.role = TF_ROLE_TRIANGLE});
        tf_panel_label(
            panel, corner[i],
            (tf_label){.text = corner_name[corner_of(e, event)][event->t],
                       .role = TF_ROLE_TRIANGLE,
                       .size = holds ? TF_LETTERS : TF_LETTERS_SMALL});
    }
    tf_scene_tetrahedron(
        scene, (const double(*)[3])corner,
        holds ? TF_WIDTH_LINE : TF_WIDTH_THIN,
        (tf_paint){.role = TF_ROLE_TRIANGLE, .opacity = holds ? 0.22 : 0.14});
}

static void draw_frame(tf_page *page, const encounter *e, tf_box box)
{
    tf_panel *panel = tf_page_panel(page, box);
    tf_panel_look(panel, (tf_camera){.azimuth = 42, .elevation = 14});
    for (int j = 0; j < TETRAHEDRA; j++)
        draw_tetrahedron(panel, e, j);
    tf_scene_ball(tf_panel_scene(panel), origin, TF_WIDTH_MARK,
                  (tf_paint){.role = TF_ROLE_POINT});
    tf_panel_label(
        panel, origin,
        (tf_label){
            .text = "$0$", .role = TF_ROLE_POINT, .side = TF_SIDE_E, .gap = 7});
}

// The motion as it is ----------------------------------------------------

static void add_vertex(tf_panel *panel, const tf_worldline *vertex,
                       const char *const name[2], tf_role role)
{
    tf_scene *scene = tf_panel_scene(panel);
    const double *start = vertex->at[0].x, *end = vertex->at[1].x;
    tf_scene_ball(scene, start, small_ball, (tf_paint){.role = role});
    tf_scene_arrow(scene, start, end, TF_WIDTH_LINE, (tf_paint){.role = role});
    tf_panel_label(panel, start, (tf_label){.text = name[0], .role = role});
    tf_panel_label(panel, end, (tf_label){.text = name[1], .role = role});
}

static void draw_motion(tf_page *page, const encounter *e, tf_box box)
{
    static const char *const point_name[2] = {"$p$", "$p'$"};
    tf_panel *panel = tf_page_panel(page, box);
    tf_panel_look(panel, (tf_camera){.azimuth = 42, .elevation = 14});
    tf_scene *scene = tf_panel_scene(panel);
    for (int t = 0; t < 2; t++) {
        double corner[CORNERS][3];
        for (int i = 0; i < CORNERS; i++)
            tf_worldline_place(&e->corner[i], 3, t, corner[i]);
        tf_scene_triangle(scene, (const double(*)[3])corner, TF_WIDTH_THIN,
                          (tf_paint){.role = TF_ROLE_TRIANGLE, .opacity = 0.4});
    }
    for (int i = 0; i < CORNERS; i++)
        add_vertex(panel, &e->corner[i], corner_name[i], TF_ROLE_TRIANGLE);
    add_vertex(panel, &e->point, point_name, TF_ROLE_POINT);
}

// The table of signs -----------------------------------------------------

static void write_sign(tf_page *page, double x, double y, tf_sign sign)
{
    const char *text = sign > 0 ? "$+$" : sign < 0 ? "$-$" : "$0$";
    tf_role role = sign > 0   ? TF_ROLE_POSITIVE
                   : sign < 0 ? TF_ROLE_NEGATIVE
                              : TF_ROLE_UNCERTAIN;
    tf_page_dot(page, x, y - 3.3, line - 4, (tf_paint){.role = role});
    tf_page_text(page, x, y, TF_ALIGN_CENTER, text, TF_LETTERS, TF_ROLE_INK);
}

/// A row of two lines: corners, and the signs of their weights.
static void write_row(tf_page *page, const encounter *e, int tetrahedron,
                      double x, double y)
{
    const tf_simplex *simplex = &e->sweep[tetrahedron];
    for (int i = 0; i < simplex->count; i++) {
        const tf_event *event = simplex->event[i];
        tf_page_text(page, x + column * i, y, TF_ALIGN_CENTER,
                     corner_name[corner_of(e, event)][event->t], TF_LETTERS,
                     TF_ROLE_TRIANGLE);
        write_sign(page, x + column * i, y + line, e->sign[tetrahedron][i]);
    }
    bool holds = tetrahedron == e->holder;
    tf_page_text(page, x + column * simplex->count, y + line / 2, TF_ALIGN_LEFT,
                 holds ? "holds $0$" : "misses $0$", TF_LETTERS,
                 holds ? TF_ROLE_CONTACT : TF_ROLE_INK);
}

static void draw(tf_page *page, FILE *numbers)
{
    encounter e;
    solve(&e);
    double height = tf_page_height(page), side = 236;
    draw_frame(page, &e, (tf_box){0, 10, side, height - 10});
    tf_page_text(page, side / 2, 14, TF_ALIGN_CENTER, "seen from the point",
                 TF_LETTERS_SMALL, TF_ROLE_INK);
    tf_page_text(page, side + 68, 14, TF_ALIGN_CENTER, "the motion as it is",
                 TF_LETTERS_SMALL, TF_ROLE_INK);
    draw_motion(page, &e, (tf_box){side, 14, 144, 124});
    tf_page_text(page, side + 68, 160, TF_ALIGN_CENTER,
                 "signs of the weights of $0$", TF_LETTERS_SMALL, TF_ROLE_INK);
    for (int j = 0; j < TETRAHEDRA; j++)
        write_row(page, &e, TETRAHEDRA - 1 - j, side + 10, 182 + 38 * j);
    print_numbers(&e, numbers);
}

const tf_figure tf_figure_sheared_frame = {
    .name = "sheared-frame",
    .title = "Three tetrahedra around the point that stands still",
    .width = TF_FIGURE_WIDTH,
    .height = TF_FIGURE_HEIGHT,
    .draw = draw,
};

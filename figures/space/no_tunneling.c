// Without a contact what is inside stays inside, and what is linked stays
// linked: a curve and two points of the plane, and two loops in space, at the
// start, in the middle and at the end of a step.
#include "base/require.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "kit/worlds.h"
#include "query/query.h"

#include <math.h>
#include <stddef.h>

enum {
    COLUMNS = 3,
    POINTS = 2,
    CURVE = 8, ///< vertices
    LOOPS = 2,
    LOOP = 5 ///< vertices of each
};

static const double shown[COLUMNS] = {0, 0.5, 1};

static const double curve_at[2][CURVE][2] = {{{-0.5, -0.87},
                                              {0.34, -0.94},
                                              {0.82, -0.57},
                                              {1, 0},
                                              {0.82, 0.57},
                                              {0.34, 0.94},
                                              {-0.5, 0.87},
                                              {-1, 0}},
                                             {{-0.6, -1.05},
                                              {1.2, -1},
                                              {1.1, -0.5},
                                              {-0.5, 0.05},
                                              {1.1, 0.5},
                                              {1.2, 1},
                                              {-0.6, 1.05},
                                              {-1.3, 0}}};
static const double points_at[2][POINTS][2] = {{{0.1, 0.35}, {1.35, 0}},
                                               {{0.7, 0.72}, {0.4, 0.02}}};

static const double loops_at[2][LOOPS][LOOP][3] = {{{{-1.5, -0.7, 0.1},
                                                     {0.2, -1, -0.2},
                                                     {1, -0.1, 0.2},
                                                     {0.3, 0.9, 0},
                                                     {-1.3, 0.8, -0.1}},
                                                    {{0.1, 0, 0.2},
                                                     {0.7, 0.1, -0.9},
                                                     {1.9, 0, -0.7},
                                                     {2, 0.1, 0.7},
                                                     {0.9, -0.1, 1}}},
                                                   {{{-1.2, -0.9, -0.5},
                                                     {0.8, -0.8, 0.3},
                                                     {0.7, 0.3, 0.5},
                                                     {0.1, 0.9, -0.6},
                                                     {-1.4, 0.4, 0.5}},
                                                    {{-0.5, 0.1, 0.3},
                                                     {0.1, 0.2, -1},
                                                     {1.6, -0.4, -0.4},
                                                     {1.9, 0.5, 0.3},
                                                     {0.5, 0, 1.1}}}};

static const double row_top[2] = {20, 142}, row_height[2] = {106, 116};

/// Vertices around a closed thing, and the points of a bent one.
typedef struct loop {
    int count, axes;
    tf_worldline vertex[CURVE];
} loop;

typedef struct bent_loop {
    int count;
    tf_vector place[2 * CURVE];
} bent_loop;

typedef struct step {
    loop curve, linked[LOOPS];
    tf_worldline point[POINTS];
} step;

// The step --------------------------------------------------------------------

/// The i-th edge of a loop, in the order of its vertices' indices.
static void find_edge(const loop *l, int i, tf_worldline edge[2])
{
    bool closes = i == l->count - 1;
    edge[0] = l->vertex[closes ? 0 : i];
    edge[1] = l->vertex[closes ? i : i + 1];
}

static void move(step *s)
{
    s->curve = (loop){.count = CURVE, .axes = 2};
    for (int i = 0; i < CURVE; i++)
        s->curve.vertex[i] =
            tf_worldline_between(2, curve_at[0][i], curve_at[1][i]);
    for (int i = 0; i < POINTS; i++)
        s->point[i] = tf_worldline_between(2, points_at[0][i], points_at[1][i]);
    for (int k = 0; k < LOOPS; k++) {
        s->linked[k] = (loop){.count = LOOP, .axes = 3};
        for (int i = 0; i < LOOP; i++)
            s->linked[k].vertex[i] =
                tf_worldline_between(3, loops_at[0][k][i], loops_at[1][k][i]);
    }
}

static bool meet(int axes, int vertices, const tf_worldline first[],
                 const tf_worldline edge[2])
{
    tf_contact contact;
    tf_status status =
        tf_query(&tf_exact, axes, vertices, first, 2, edge, &contact);
    TF_REQUIRE(status == TF_OK);
    return contact.verdict == TF_HIT;
}

/// How many points meet edges of the curve, and edges those of the other loop.
static int count_contacts(const step *s)
{
    int contacts = 0;
    for (int i = 0; i < CURVE; i++) {
        tf_worldline edge[2];
        find_edge(&s->curve, i, edge);
        for (int k = 0; k < POINTS; k++)
            contacts += meet(2, 1, &s->point[k], edge);
    }
    for (int i = 0; i < LOOP; i++)
        for (int j = 0; j < LOOP; j++) {
            tf_worldline first[2], second[2];
            find_edge(&s->linked[0], i, first);
            find_edge(&s->linked[1], j, second);
            contacts += meet(3, 2, first, second);
        }
    return contacts;
}

// At one time -----------------------------------------------------------------

/// The vertices of a loop at the time t, and after each the crease of its edge.
static bent_loop bend(const loop *l, double t)
{
    bent_loop bent = {.count = 2 * l->count};
    for (int i = 0; i < l->count; i++) {
        tf_worldline edge[2];
        find_edge(l, i, edge);
        tf_worldline pair = {{edge[0].at[0], edge[1].at[1]}};
        bent.place[(ptrdiff_t)2 * i] =
            fig_worldline_place(&l->vertex[i], l->axes, t);
        bent.place[2 * i + 1] = fig_worldline_place(&pair, l->axes, t);
    }
    return bent;
}

/// How often a curve of the plane goes around a point.
static double winding_number(const bent_loop *curve, tf_vector point)
{
    double turns = 0;
    for (int i = 0; i < curve->count; i++) {
        tf_vector a = fig_difference(curve->place[i], point);
        tf_vector b =
            fig_difference(curve->place[(i + 1) % curve->count], point);
        turns += atan2(fig_cross(a, b).x[2], tf_vector_dot(a, b));
    }
    return round(turns / (2 * acos(-1))) + 0.0;
}

static double volume(tf_vector a, tf_vector b, tf_vector c)
{
    return tf_vector_dot(fig_cross(a, b), c);
}

/// How often two loops are linked: the crossings of the one above the other,
/// as seen along a direction in which no two corners are in line.
static double linking_number(const bent_loop *first, const bent_loop *second)
{
    static const tf_vector along = {{0.31, 0.17, 0.94}};
    double sum = 0;
    for (int i = 0; i < first->count; i++)
        for (int j = 0; j < second->count; j++) {
            tf_vector a = first->place[i], b = second->place[j];
            tf_vector a1 = first->place[(i + 1) % first->count];
            tf_vector b1 = second->place[(j + 1) % second->count];
            tf_vector u = fig_difference(a1, a), v = fig_difference(b1, b);
            bool parts = volume(along, v, fig_difference(a, b)) *
                             volume(along, v, fig_difference(a1, b)) <
                         0;
            bool parted = volume(along, u, fig_difference(b, a)) *
                              volume(along, u, fig_difference(b1, a)) <
                          0;
            double sense = volume(along, u, v);
            double height = volume(fig_difference(a, b), u, v) / sense;
            if (parts && parted && height > 0)
                sum += sense > 0 ? 1 : -1;
        }
    return sum + 0.0;
}

// Drawing ---------------------------------------------------------------------

static fig_box column_box(const fig_page *page, int row, int column)
{
    double width = fig_page_width(page) / COLUMNS;
    return (fig_box){width * column + 4, row_top[row], width - 8,
                     row_height[row]};
}

static fig_panel *begin_panel(fig_page *page, fig_box box, fig_camera camera)
{
    fig_page_fill_box(page, box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, camera);
    fig_panel_margin(panel, 12);
    return panel;
}

static void add_loop(fig_scene *scene, const loop *l, double t, fig_role role)
{
    for (int at = 0; at < 2; at++) {
        bent_loop end = bend(l, at);
        for (int i = 0; i < end.count; i++)
            fig_scene_reach(scene, end.place[i]);
    }
    bent_loop bent = bend(l, t);
    for (int i = 0; i < bent.count; i++) {
        fig_scene_tube(scene, bent.place[i], bent.place[(i + 1) % bent.count],
                       FIG_WIDTH_TUBE, (fig_paint){.role = role});
        if (i % 2 == 0)
            fig_scene_ball(scene, bent.place[i], 4, (fig_paint){.role = role});
    }
}

static void draw_curve(fig_page *page, fig_box box, const step *s, double t)
{
    fig_panel *panel = begin_panel(page, box, (fig_camera){.elevation = 90});
    fig_panel_fix(panel);
    fig_scene *drawn = fig_panel_scene(panel);
    bent_loop curve = bend(&s->curve, t);
    fig_panel_fill(panel, curve.count, curve.place,
                   (fig_paint){.role = FIG_ROLE_EDGE, .opacity = 0.13});
    add_loop(drawn, &s->curve, t, FIG_ROLE_EDGE);
    for (int k = 0; k < POINTS; k++) {
        fig_scene_reach(drawn, fig_worldline_place(&s->point[k], 2, 0));
        tf_vector at = fig_worldline_place(&s->point[k], 2, t);
        char text[16];
        snprintf(text, sizeof text, "$%g$", winding_number(&curve, at));
        fig_scene_ball(drawn, at, FIG_WIDTH_BALL,
                       (fig_paint){.role = FIG_ROLE_POINT});
        fig_panel_label(panel, at,
                        (fig_label){.text = text,
                                    .role = FIG_ROLE_POINT,
                                    .side = FIG_SIDE_E,
                                    .gap = 5});
    }
}

static void draw_loops(fig_page *page, fig_box box, const step *s, double t)
{
    static const fig_role role[LOOPS] = {FIG_ROLE_EDGE, FIG_ROLE_OTHER_EDGE};
    fig_panel *panel =
        begin_panel(page, box, (fig_camera){.azimuth = -20, .elevation = 35});
    for (int k = 0; k < LOOPS; k++)
        add_loop(fig_panel_scene(panel), &s->linked[k], t, role[k]);
    bent_loop first = bend(&s->linked[0], t), second = bend(&s->linked[1], t);
    char text[48];
    snprintf(text, sizeof text, "linking number %g",
             fabs(linking_number(&first, &second)));
    fig_page_caption(page, box, text);
}

static void print_numbers(const step *s, FILE *numbers)
{
    static const char *const when[COLUMNS] = {"start", "half", "end"};
    fig_number(numbers, "contacts", count_contacts(s));
    for (int i = 0; i < COLUMNS; i++) {
        bent_loop curve = bend(&s->curve, shown[i]);
        bent_loop first = bend(&s->linked[0], shown[i]);
        bent_loop second = bend(&s->linked[1], shown[i]);
        char key[32];
        for (int k = 0; k < POINTS; k++) {
            tf_vector at = fig_worldline_place(&s->point[k], 2, shown[i]);
            snprintf(key, sizeof key, "winding_%d_%s", k, when[i]);
            fig_number(numbers, key, winding_number(&curve, at));
        }
        snprintf(key, sizeof key, "linking_%s", when[i]);
        fig_number(numbers, key, linking_number(&first, &second));
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    step s;
    move(&s);
    for (int i = 0; i < COLUMNS; i++) {
        char text[32];
        snprintf(text, sizeof text, "$t = %g$", shown[i]);
        fig_page_title(page, column_box(page, 0, i), text);
        draw_curve(page, column_box(page, 0, i), &s, shown[i]);
        draw_loops(page, column_box(page, 1, i), &s, shown[i]);
    }
    print_numbers(&s, numbers);
}

const fig_figure fig_no_tunneling = {
    .name = "no-tunneling",
    .title = "Inside stays inside, and linked stays linked",
    .width = FIG_PAGE_WIDTH,
    .height = 278,
    .draw = draw,
};

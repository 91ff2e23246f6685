// Three points in a row, and where explicit numbers for the symbols take them:
// the turn that the points make then is the perturbed one.
#include "figures.h"

#include "arithmetic/perturbed.h"

#include <math.h>

enum {
    POINTS = 3,
    AXES = 2
};

/// The points and the numbers for their symbols, in the order of size.
static const struct row {
    double x[AXES], move[AXES];
    const char *name;
} row[POINTS] = {
    {{0, 0}, {0x1p-1, 0x1p-2}, "$a$"},
    {{1, 0}, {0x1p-5, 0x1p-6}, "$b$"},
    {{2, 0}, {0x1p-9, 0x1p-10}, "$c$"},
};

/// A map from the plane to the page: the middle of a lens shows `center`.
typedef struct lens {
    double center[AXES]; ///< of the plane
    double at[2];        ///< on the page
    double scale;        ///< points a unit
} lens;

static const double lens_radius = 27;

static void place(const lens *l, const double x[AXES], double page[2])
{
    page[0] = l->at[0] + l->scale * (x[0] - l->center[0]);
    page[1] = l->at[1] - l->scale * (x[1] - l->center[1]);
}

static void find_moved(int i, double x[AXES])
{
    for (int k = 0; k < AXES; k++)
        x[k] = row[i].x[k] + row[i].move[k];
}

static void draw_line(tf_page *page, const double from[2], const double to[2],
                      tf_stroke stroke)
{
    const double at[2][2] = {{from[0], from[1]}, {to[0], to[1]}};
    tf_page_line(page, 2, at, stroke);
}

/// The line on which the points stand.
static void draw_ground(tf_page *page, const lens *l, double from, double to)
{
    double at[2][2];
    place(l, (double[]){from, 0}, at[0]);
    place(l, (double[]){to, 0}, at[1]);
    draw_line(
        page, at[0], at[1],
        (tf_stroke){.paint.role = TF_ROLE_NEUTRAL, .width = TF_WIDTH_HAIR});
}

static void draw_point(tf_page *page, const lens *l, int i,
                       const double x[AXES], tf_role role)
{
    double at[2];
    place(l, x, at);
    tf_page_dot(page, at[0], at[1], TF_WIDTH_BALL, (tf_paint){.role = role});
    tf_page_label(page, at[0], at[1],
                  (tf_label){.text = row[i].name, .side = TF_SIDE_N});
}

/// A point's old place and the way from it to the new one.
static void draw_move(tf_page *page, const lens *l, int i)
{
    double x[AXES], from[2], to[2];
    find_moved(i, x);
    place(l, row[i].x, from);
    place(l, x, to);
    tf_page_dot(page, from[0], from[1], 4, (tf_paint){.role = TF_ROLE_NEUTRAL});

    // The head ends where the ball begins.
    double length = hypot(to[0] - from[0], to[1] - from[1]);
    double share = 1 - (TF_WIDTH_BALL / 2 + 1) / length;
    for (int k = 0; k < 2; k++)
        to[k] = from[k] + share * (to[k] - from[k]);
    draw_line(page, from, to,
              (tf_stroke){.paint.role = TF_ROLE_NEUTRAL,
                          .width = TF_WIDTH_LINE,
                          .arrow = true});
}

static void draw_stored(tf_page *page, const lens *l)
{
    draw_ground(page, l, -0.35, 2.35);
    for (int i = 0; i < POINTS; i++)
        draw_point(page, l, i, row[i].x, TF_ROLE_POINT);
}

/// The turn at b: from the way straight on to the way to c.
static void draw_turn(tf_page *page, const double at[POINTS][2])
{
    enum {
        CHORDS = 4
    };
    static const double straight_on = 56, radius = 42;
    double angle[2], arc[CHORDS + 1][2];
    for (int i = 0; i < 2; i++)
        angle[i] = atan2(at[i + 1][1] - at[i][1], at[i + 1][0] - at[i][0]);
    draw_line(page, at[1],
              (double[]){at[1][0] + straight_on * cos(angle[0]),
                         at[1][1] + straight_on * sin(angle[0])},
              (tf_stroke){.paint.role = TF_ROLE_NEUTRAL,
                          .width = TF_WIDTH_THIN,
                          .dash = 3});
    for (int i = 0; i <= CHORDS; i++) {
        double a = angle[0] + (angle[1] - angle[0]) * i / CHORDS;
        arc[i][0] = at[1][0] + radius * cos(a);
        arc[i][1] = at[1][1] + radius * sin(a);
    }
    tf_page_line(page, CHORDS + 1, (const double(*)[2])arc,
                 (tf_stroke){.paint.role = TF_ROLE_CONTACT, .arrow = true});
}

static void draw_moved(tf_page *page, const lens *l)
{
    double x[AXES], at[POINTS][2];
    draw_ground(page, l, -0.2, 2.25);
    for (int i = 0; i < POINTS; i++) {
        find_moved(i, x);
        place(l, x, at[i]);
    }
    tf_page_fill(page, POINTS, (const double(*)[2])at,
                 (tf_paint){.role = TF_ROLE_TRIANGLE, .opacity = 0.25});
    for (int i = 1; i < POINTS; i++)
        draw_line(
            page, at[i - 1], at[i],
            (tf_stroke){.paint.role = TF_ROLE_EDGE, .width = TF_WIDTH_LINE});
    draw_turn(page, (const double(*)[2])at);
    draw_move(page, l, 0);
    for (int i = 0; i < POINTS; i++) {
        find_moved(i, x);
        draw_point(page, l, i, x, TF_ROLE_POINT);
    }
}

/// A round window on a point, in which its move looks as large as that of a.
static void draw_lens(tf_page *page, const lens *l, int i)
{
    double x[AXES];
    tf_page_arc(
        page, l->at[0], l->at[1], lens_radius, 0, 360,
        (tf_stroke){.paint.role = TF_ROLE_NEUTRAL, .width = TF_WIDTH_THIN});
    double reach = lens_radius / l->scale;
    draw_ground(page, l, l->center[0] - 0.9 * reach,
                l->center[0] + 0.9 * reach);
    draw_move(page, l, i);
    find_moved(i, x);
    draw_point(page, l, i, x, TF_ROLE_POINT);
    char text[32];
    snprintf(text, sizeof text, "× %g", row[0].move[0] / row[i].move[0]);
    tf_page_text(page, l->at[0], l->at[1] + lens_radius + 12, TF_ALIGN_CENTER,
                 text, TF_LETTERS_SMALL, TF_ROLE_INK);
}

/// The perturbed sign of the turn of the points as they are.
static tf_sign find_turn(void)
{
    tf_event event[POINTS];
    for (int i = 0; i < POINTS; i++)
        event[i] = (tf_event){.x = {row[i].x[0], row[i].x[1]}, .vertex = i};
    return tf_perturbed.sign(&(tf_differences){.n = AXES,
                                               .to = {&event[1], &event[2]},
                                               .from = {&event[0], &event[0]},
                                               .axis = {0, 1}});
}

static void draw(tf_page *page, FILE *numbers)
{
    const lens stored = {{1, 0}, {56, 74}, 38};
    draw_stored(page, &stored);
    const lens moved = {{1, 0}, {202, 74}, 66};
    draw_moved(page, &moved);
    for (int i = 1; i < POINTS; i++) {
        const double *move = row[i].move;
        lens l = {{row[i].x[0] + move[0] / 2, row[i].x[1] + move[1] / 2},
                  {350, i == 1 ? 30 : 104},
                  moved.scale * row[0].move[0] / move[0]};
        draw_lens(page, &l, i);
    }
    tf_figure_number(numbers, "first", row[0].move[0]);
    tf_figure_number(numbers, "second", row[0].move[1]);
    tf_figure_number(numbers, "turn", find_turn());
}

const tf_figure tf_figure_moved_row = {
    .name = "moved-row",
    .title = "Three points in a row, moved by numbers for the symbols",
    .width = TF_FIGURE_WIDTH,
    .height = 148,
    .draw = draw,
};

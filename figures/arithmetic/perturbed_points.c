// Three points in a row, and where explicit numbers for the symbols take them:
// the turn that the points make then is the perturbed one.
#include "arithmetic/functions.h"
#include "kit/figures.h"

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
    fig_point center; ///< of the plane
    fig_point at;     ///< on the page
    double scale;     ///< points a unit
} lens;

static const double lens_radius = 27;

static fig_point place(const lens *l, fig_point x)
{
    return (fig_point){l->at.x + l->scale * (x.x - l->center.x),
                       l->at.y - l->scale * (x.y - l->center.y)};
}

static fig_point stored_place(int i)
{
    return (fig_point){row[i].x[0], row[i].x[1]};
}

static fig_point moved_place(int i)
{
    return (fig_point){row[i].x[0] + row[i].move[0],
                       row[i].x[1] + row[i].move[1]};
}

static void draw_line(fig_page *page, fig_point from, fig_point to,
                      fig_stroke stroke)
{
    fig_page_line(page, 2, (fig_point[]){from, to}, stroke);
}

/// The line on which the points stand.
static void draw_ground(fig_page *page, const lens *l, double from, double to)
{
    draw_line(
        page, place(l, (fig_point){from, 0}), place(l, (fig_point){to, 0}),
        (fig_stroke){.paint.role = FIG_ROLE_NEUTRAL, .width = FIG_WIDTH_HAIR});
}

static void draw_point(fig_page *page, const lens *l, int i, fig_point x,
                       fig_role role)
{
    fig_point at = place(l, x);
    fig_page_dot(page, at.x, at.y, FIG_WIDTH_BALL, (fig_paint){.role = role});
    fig_page_label(page, at.x, at.y,
                   (fig_label){.text = row[i].name, .side = FIG_SIDE_N});
}

/// A point's old place and the way from it to the new one.
static void draw_move(fig_page *page, const lens *l, int i)
{
    fig_point from = place(l, stored_place(i)), to = place(l, moved_place(i));
    fig_page_dot(page, from.x, from.y, 4,
                 (fig_paint){.role = FIG_ROLE_NEUTRAL});

    // The head ends where the ball begins.
    double dx = to.x - from.x, dy = to.y - from.y;
    double share = 1 - (FIG_WIDTH_BALL / 2 + 1) / hypot(dx, dy);
    draw_line(page, from, (fig_point){from.x + share * dx, from.y + share * dy},
              (fig_stroke){.paint.role = FIG_ROLE_NEUTRAL,
                           .width = FIG_WIDTH_LINE,
                           .arrow = true});
}

static void draw_stored(fig_page *page, const lens *l)
{
    draw_ground(page, l, -0.35, 2.35);
    for (int i = 0; i < POINTS; i++)
        draw_point(page, l, i, stored_place(i), FIG_ROLE_POINT);
}

/// The turn at b: from the way straight on to the way to c.
static void draw_turn(fig_page *page, const fig_point at[POINTS])
{
    enum {
        CHORDS = 4
    };
    static const double straight_on = 56, radius = 42;
    double angle[2];
    fig_point arc[CHORDS + 1];
    for (int i = 0; i < 2; i++)
        angle[i] = atan2(at[i + 1].y - at[i].y, at[i + 1].x - at[i].x);
    draw_line(page, at[1],
              (fig_point){at[1].x + straight_on * cos(angle[0]),
                          at[1].y + straight_on * sin(angle[0])},
              (fig_stroke){.paint.role = FIG_ROLE_NEUTRAL,
                           .width = FIG_WIDTH_THIN,
                           .dash = 3});
    for (int i = 0; i <= CHORDS; i++) {
        double a = angle[0] + (angle[1] - angle[0]) * i / CHORDS;
        arc[i] =
            (fig_point){at[1].x + radius * cos(a), at[1].y + radius * sin(a)};
    }
    fig_page_line(page, CHORDS + 1, arc, (fig_stroke){.arrow = true});
}

static void draw_moved(fig_page *page, const lens *l)
{
    fig_point at[POINTS];
    draw_ground(page, l, -0.2, 2.25);
    for (int i = 0; i < POINTS; i++)
        at[i] = place(l, moved_place(i));
    fig_page_fill(page, POINTS, at,
                  (fig_paint){.role = FIG_ROLE_TRIANGLE, .opacity = 0.25});
    for (int i = 1; i < POINTS; i++)
        draw_line(
            page, at[i - 1], at[i],
            (fig_stroke){.paint.role = FIG_ROLE_EDGE, .width = FIG_WIDTH_LINE});
    draw_turn(page, at);
    draw_move(page, l, 0);
    for (int i = 0; i < POINTS; i++)
        draw_point(page, l, i, moved_place(i), FIG_ROLE_POINT);
}

/// A round window on a point, in which its move looks as large as that of a.
static void draw_lens(fig_page *page, const lens *l, int i)
{
    fig_page_arc(
        page, l->at.x, l->at.y, lens_radius, 0, 360,
        (fig_stroke){.paint.role = FIG_ROLE_NEUTRAL, .width = FIG_WIDTH_THIN});
    double reach = lens_radius / l->scale;
    draw_ground(page, l, l->center.x - 0.9 * reach, l->center.x + 0.9 * reach);
    draw_move(page, l, i);
    draw_point(page, l, i, moved_place(i), FIG_ROLE_POINT);
    char text[32];
    snprintf(text, sizeof text, "× %g", row[0].move[0] / row[i].move[0]);
    fig_page_text(page, l->at.x, l->at.y + lens_radius + 12, FIG_ALIGN_CENTER,
                  text, FIG_LETTERS_SMALL, FIG_ROLE_INK);
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

static void draw(fig_page *page, FILE *numbers)
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
    fig_number(numbers, "first", row[0].move[0]);
    fig_number(numbers, "second", row[0].move[1]);
    fig_number(numbers, "turn", find_turn());
}

const fig_figure fig_perturbed_points = {
    .name = "perturbed-points",
    .title = "Three points in a row, moved by numbers for the symbols",
    .width = FIG_PAGE_WIDTH,
    .height = 148,
    .draw = draw,
};

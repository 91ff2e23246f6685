// Two rows of one pair that are nearly parallel: the nearest displacement that
// satisfies both, and the iterates of conjugate residuals.
#include "kit/figures.h"

#include "kit/plane_rows.h"

#include <math.h>

static const double angle = 7 * 0.017453292519943295;
static const double bound[2] = {0.3, 0.42};
static const double proposal[2] = {-0.35, -0.25};

static const fig_box shown = {-0.75, -0.42, 2.3, 1.27};
static const fig_box box = {8, 6, 368, 203};

static fig_point place(double x, double y)
{
    double scale = box.width / shown.width;
    return (fig_point){box.x + (x - shown.x) * scale,
                       box.y + box.height - (y - shown.y) * scale};
}

/// The line on which a row holds as an equation, between two places along it.
static void draw_line(fig_page *page, const tf_constraint *row, double from,
                      double to)
{
    const double *n = row->normal, u = row->bound;
    fig_point at[] = {place(u * n[0] + n[1] * from, u * n[1] - n[0] * from),
                      place(u * n[0] + n[1] * to, u * n[1] - n[0] * to)};
    fig_page_line(page, 2, at,
                  (fig_stroke){.paint = {.role = FIG_ROLE_EDGE}, .width = 1.6});
}

/// What both rows allow: to the left of their crossing above the second line,
/// to the right of it above the first.
static void draw_allowed(fig_page *page, const double crossing[2])
{
    double left = shown.x, right = shown.x + shown.width;
    double top = shown.y + shown.height, lean = tan(angle);
    fig_point corner[] = {
        place(left, crossing[1] + lean * (crossing[0] - left)),
        place(crossing[0], crossing[1]), place(right, crossing[1]),
        place(right, top), place(left, top)};
    fig_page_fill(page, 5, corner,
                  (fig_paint){.role = FIG_ROLE_POSITIVE, .opacity = 0.18});
}

static double draw_step(fig_page *page, const double from[2],
                        const double to[2], fig_role role)
{
    fig_point at[] = {place(from[0], from[1]), place(to[0], to[1])};
    fig_page_line(page, 2, at,
                  (fig_stroke){.paint = {.role = role},
                               .width = FIG_WIDTH_LINE,
                               .arrow = true});
    return hypot(to[0] - from[0], to[1] - from[1]);
}

static void draw_place(fig_page *page, const double at[2], fig_role role,
                       fig_side side, const char *text)
{
    fig_point on = place(at[0], at[1]);
    fig_page_dot(page, on.x, on.y, FIG_WIDTH_BALL, (fig_paint){.role = role});
    fig_page_label(page, on.x, on.y,
                   (fig_label){.text = text, .role = role, .side = side});
}

static void draw(fig_page *page, FILE *numbers)
{
    const double normal[2][2] = {{0, 1}, {sin(angle), cos(angle)}};
    fig_plane_rows rows = {.count = 2};
    for (int i = 0; i < 2; i++)
        rows.row[i] = fig_plane_row(normal[i], bound[i]);
    double nearest[2], iterate[2][2], impulse[FIG_PLANE_ROWS];
    fig_plane_sweeps(&rows, proposal, 1000, nearest, impulse);
    for (int i = 0; i < 2; i++)
        fig_plane_residuals(&rows, proposal, i + 1, iterate[i], impulse);

    draw_allowed(page, iterate[1]);
    draw_line(page, &rows.row[0], -1.2, 1.6);
    draw_line(page, &rows.row[1], -1.2, 1.6);
    fig_number(numbers, "angle", angle / 0.017453292519943295);
    fig_number(numbers, "nearest",
               draw_step(page, proposal, nearest, FIG_ROLE_POINT));
    fig_number(numbers, "first",
               hypot(iterate[0][0] - proposal[0], iterate[0][1] - proposal[1]));
    fig_number(numbers, "second",
               hypot(iterate[1][0] - proposal[0], iterate[1][1] - proposal[1]));
    draw_step(page, iterate[0], iterate[1], FIG_ROLE_CONTACT);
    draw_place(page, proposal, FIG_ROLE_INK, FIG_SIDE_SE, "proposal");
    draw_place(page, nearest, FIG_ROLE_POINT, FIG_SIDE_NW, "inequalities");
    draw_place(page, iterate[0], FIG_ROLE_CONTACT, FIG_SIDE_SE,
               "one iteration");
    draw_place(page, iterate[1], FIG_ROLE_CONTACT, FIG_SIDE_S,
               "two iterations");
}

const fig_figure fig_nearly_parallel_rows = {
    .name = "nearly-parallel-rows",
    .title = "Two nearly parallel rows, as equations and as inequalities",
    .width = FIG_PAGE_WIDTH,
    .height = 215,
    .draw = draw,
};

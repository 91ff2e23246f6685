// The displacements of a bead in a corner: what two constraints allow, where
// they hold as equations, and the nearest point that satisfies them as
// inequalities.
#include "kit/figures.h"

#include "kit/plane_rows.h"

static const double normal[2][2] = {{0, 1}, {0.8660254037844386, 0.5}};
static const double proposal[2] = {-1, -0.1};

/// What the page shows of the plane.
static const fig_box shown = {-1.5, -0.75, 2.9, 1.75};
static const fig_box box = {8, 8, 368, 222};

static fig_point place(double x, double y)
{
    double scale = box.width / shown.width;
    return (fig_point){box.x + (x - shown.x) * scale,
                       box.y + box.height - (y - shown.y) * scale};
}

/// What both constraints allow, as far as it is shown.
static void draw_allowed(fig_page *page)
{
    double top = shown.y + shown.height, right = shown.x + shown.width;
    fig_point wedge[] = {place(0, 0), place(right, 0), place(right, top),
                         place(-top * normal[1][1] / normal[1][0], top)};
    fig_page_fill(page, 4, wedge,
                  (fig_paint){.role = FIG_ROLE_POSITIVE, .opacity = 0.18});
}

/// The border of what a constraint allows.
static void draw_wall(fig_page *page, const double n[2], double from, double to)
{
    fig_point at[] = {place(-n[1] * from, n[0] * from),
                      place(-n[1] * to, n[0] * to)};
    fig_page_line(page, 2, at,
                  (fig_stroke){.paint = {.role = FIG_ROLE_EDGE}, .width = 1.6});
}

static void draw_step(fig_page *page, const double from[2], const double to[2],
                      fig_role role)
{
    fig_point at[] = {place(from[0], from[1]), place(to[0], to[1])};
    fig_page_line(page, 2, at,
                  (fig_stroke){.paint = {.role = role},
                               .width = FIG_WIDTH_LINE,
                               .arrow = true});
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
    fig_plane_rows rows = {.count = 2};
    for (int i = 0; i < 2; i++)
        rows.row[i] = fig_plane_row(normal[i], 0);
    double glued[2], nearest[2], first[2];
    double by_equations[2], by_signs[2], by_first[2];
    fig_plane_residuals(&rows, proposal, 2, glued, by_equations);
    fig_plane_sweeps(&rows, proposal, 2, nearest, by_signs);
    rows.count = 1; // the first visit of the first sweep
    fig_plane_sweeps(&rows, proposal, 1, first, by_first);

    draw_allowed(page);
    draw_wall(page, normal[0], 1.5, -1.4);
    draw_wall(page, normal[1], 1.15, -0.8);
    draw_step(page, proposal, glued, FIG_ROLE_CONTACT);
    draw_step(page, proposal, nearest, FIG_ROLE_POINT);
    draw_place(page, proposal, FIG_ROLE_INK, FIG_SIDE_W, "proposal");
    draw_place(page, glued, FIG_ROLE_CONTACT, FIG_SIDE_SE, "equations");
    draw_place(page, nearest, FIG_ROLE_POINT, FIG_SIDE_NE, "inequalities");
    fig_point flat = place(1.02, 0), steep = place(-0.5, 0.866);
    fig_page_text(page, flat.x, flat.y + 14, FIG_ALIGN_CENTER, "flat wall",
                  FIG_LETTERS_SMALL, FIG_ROLE_EDGE);
    fig_page_text(page, steep.x - 8, steep.y, FIG_ALIGN_RIGHT, "steep wall",
                  FIG_LETTERS_SMALL, FIG_ROLE_EDGE);
    fig_point allowed = place(0.7, 0.62);
    fig_page_text(page, allowed.x, allowed.y, FIG_ALIGN_CENTER,
                  "what both constraints allow", FIG_LETTERS_SMALL,
                  FIG_ROLE_INK);
    for (int i = 0; i < 2; i++) {
        fig_number(numbers, i ? "glued_1" : "glued_0", by_equations[i]);
        fig_number(numbers, i ? "nearest_1" : "nearest_0", by_signs[i]);
    }
    fig_number(numbers, "first_push", by_first[0]);
}

const fig_figure fig_bead_in_corner = {
    .name = "bead-in-corner",
    .title = "The displacements of a bead that runs into a corner",
    .width = FIG_PAGE_WIDTH,
    .height = 238,
    .draw = draw,
};

// A ray that runs through corners and along an edge of a polygon, and one that
// starts a little above.
#include "kit/figures.h"

enum {
    CORNERS = 8,
    STATES = 2
};

static const double polygon[CORNERS][2] = {{0, 0}, {10, 0}, {10, 2}, {8, 2},
                                           {7, 4}, {5, 2},  {4, 4},  {0, 4}};
static const double start[] = {2, 2};

/// How far above the ray is drawn, and how far it reaches.
static const double above = 0.5, end = 11.2;

static tf_vector in_plane(double x, double y)
{
    return (tf_vector){{x, y, 0}};
}

/// Whether the ray that starts a little above crosses an edge: 1 upwards, -1
/// downwards, else 0.
static int crossing(const double a[2], const double b[2])
{
    bool low_a = a[1] <= start[1], low_b = b[1] <= start[1];
    if (low_a == low_b)
        return 0;
    const double *low = low_a ? a : b, *high = low_a ? b : a;
    double turn = (high[0] - low[0]) * (start[1] - low[1]) -
                  (high[1] - low[1]) * (start[0] - low[0]);
    return turn > 0 ? low_a - low_b : 0;
}

static fig_panel *draw_polygon(fig_page *page, int state)
{
    double width = fig_page_width(page) / STATES;
    fig_panel *panel = fig_page_panel(
        page, (fig_box){width * state, 0, width, fig_page_height(page)});
    fig_panel_look(panel, (fig_camera){.elevation = 90});
    fig_panel_fix(panel);
    fig_panel_margin(panel, 12);
    fig_scene *scene = fig_panel_scene(panel);
    tf_vector corner[CORNERS];
    for (int i = 0; i < CORNERS; i++) {
        corner[i] = in_plane(polygon[i][0], polygon[i][1]);
        fig_scene_reach(scene, corner[i]);
    }
    fig_scene_reach(scene, in_plane(end, 0));
    fig_panel_fill(panel, CORNERS, corner,
                   (fig_paint){.role = FIG_ROLE_TRIANGLE, .opacity = 0.2});
    fig_panel_line(
        panel, CORNERS, corner,
        (fig_stroke){.paint = {.role = FIG_ROLE_TRIANGLE}, .closed = true});
    return panel;
}

/// A dot over all lines, where a ball would be under them.
static void draw_dot(fig_page *page, const fig_panel *panel, double x, double y,
                     fig_role role)
{
    fig_point at = fig_panel_project(panel, in_plane(x, y));
    fig_page_dot(page, at.x, at.y, FIG_WIDTH_BALL, (fig_paint){.role = role});
}

static void draw_ray(fig_page *page, fig_panel *panel, double height)
{
    const tf_vector at[] = {in_plane(start[0], start[1] + height),
                            in_plane(end, start[1] + height)};
    fig_panel_line(
        panel, 2, at,
        (fig_stroke){.paint = {.role = FIG_ROLE_POINT}, .arrow = true});
    draw_dot(page, panel, start[0], start[1], FIG_ROLE_POINT);
}

static void draw_ties(fig_page *page, fig_panel *panel)
{
    const tf_vector along[] = {in_plane(8, start[1]), in_plane(10, start[1])};
    fig_panel_line(panel, 2, along,
                   (fig_stroke){.paint = {.role = FIG_ROLE_CONTACT},
                                .width = FIG_WIDTH_TUBE});
    for (int i = 0; i < CORNERS; i++)
        if (polygon[i][1] == start[1])
            draw_dot(page, panel, polygon[i][0], polygon[i][1],
                     FIG_ROLE_CONTACT);
}

/// Returns how many edges the ray crosses; their sum is set.
static int draw_crossings(fig_page *page, fig_panel *panel, int *sum)
{
    int count = 0;
    *sum = 0;
    for (int i = 0; i < CORNERS; i++) {
        const double *a = polygon[i], *b = polygon[(i + 1) % CORNERS];
        int sign = crossing(a, b);
        if (sign == 0)
            continue;
        double y = start[1] + above, part = (y - a[1]) / (b[1] - a[1]);
        double x = a[0] + part * (b[0] - a[0]);
        draw_dot(page, panel, x, y,
                 sign > 0 ? FIG_ROLE_EDGE : FIG_ROLE_OTHER_EDGE);
        fig_panel_label(panel, in_plane(x, y),
                        (fig_label){.text = sign > 0 ? "$+1$" : "$-1$",
                                    .size = FIG_LETTERS_SMALL,
                                    .side = sign > 0 ? FIG_SIDE_N : FIG_SIDE_S,
                                    .gap = 7});
        *sum += sign;
        count++;
    }
    return count;
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_panel *panel = draw_polygon(page, 0);
    draw_ray(page, panel, 0);
    draw_ties(page, panel);
    panel = draw_polygon(page, 1);
    draw_ray(page, panel, above);
    int sum, count = draw_crossings(page, panel, &sum);
    fig_number(numbers, "crossings", count);
    fig_number(numbers, "sum", sum);
}

const fig_figure fig_perturbed_ray = {
    .name = "perturbed-ray",
    .title = "A ray that starts a little above its point",
    .width = FIG_PAGE_WIDTH,
    .height = 100,
    .draw = draw,
};

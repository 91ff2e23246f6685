// A short edge of a polygon that collapses into its middle, and into the place
// that keeps the area.
#include "kit/figures.h"

#include <math.h>

enum {
    CORNERS = 7,
    STATES = 3,
    FROM = 1, ///< the ends of the short edge
    TO = 2
};

static const double before[CORNERS][2] = {
    {1, 0.15},    {0.28, 0.95}, {-0.22, 1},  {-0.95, 0.3},
    {-0.7, -0.5}, {0, -0.8},    {0.75, -0.5}};

/// The corners when the short edge has collapsed to a place.
static int collapse_to(const double place[2], double after[CORNERS][2])
{
    int count = 0;
    for (int i = 0; i < CORNERS; i++)
        if (i != TO) {
            const double *from = i == FROM ? place : before[i];
            after[count][0] = from[0];
            after[count++][1] = from[1];
        }
    return count;
}

static double area_of(int count, const double at[][2])
{
    double sum = 0;
    for (int i = 0; i < count; i++) {
        const double *a = at[i], *b = at[(i + 1) % count];
        sum += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
    return sum;
}

static tf_vector in_plane(const double at[2])
{
    return (tf_vector){{at[0], at[1], 0}};
}

static void draw_polygon(fig_panel *panel, int count, const double at[][2],
                         fig_paint fill, fig_stroke stroke)
{
    tf_vector corner[CORNERS];
    for (int i = 0; i < count; i++)
        corner[i] = in_plane(at[i]);
    if (fill.opacity > 0)
        fig_panel_fill(panel, count, corner, fill);
    stroke.closed = true;
    fig_panel_line(panel, count, corner, stroke);
}

static void draw_dot(fig_panel *panel, const double at[2], const char *name)
{
    fig_scene_ball(fig_panel_scene(panel), in_plane(at), 5,
                   (fig_paint){.role = FIG_ROLE_POINT});
    fig_panel_label(panel, in_plane(at),
                    (fig_label){.text = name,
                                .size = FIG_LETTERS_SMALL,
                                .side = FIG_SIDE_N,
                                .gap = 4});
}

static fig_panel *panel_of(fig_page *page, int i)
{
    double width = fig_page_width(page) / STATES;
    fig_panel *panel = fig_page_panel(
        page, (fig_box){width * i, 0, width, fig_page_height(page)});
    fig_panel_look(panel, (fig_camera){.elevation = 90});
    fig_panel_fix(panel);
    fig_panel_margin(panel, 14);
    for (int j = 0; j < CORNERS; j++)
        fig_scene_reach(fig_panel_scene(panel), in_plane(before[j]));
    fig_scene_reach(fig_panel_scene(panel), (tf_vector){{0, 1.12, 0}});
    return panel;
}

static fig_panel *draw_state(fig_page *page, int i, int count,
                             const double at[][2], const double *place,
                             const char *name)
{
    fig_panel *panel = panel_of(page, i);
    fig_paint paint = {.role = FIG_ROLE_TRIANGLE, .opacity = 0.25};
    draw_polygon(panel, count, at, paint,
                 (fig_stroke){.paint = {.role = FIG_ROLE_TRIANGLE}});
    if (place) {
        draw_polygon(
            panel, CORNERS, before, (fig_paint){0},
            (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL}, .dash = 3});
        draw_dot(panel, place, name);
    } else {
        draw_dot(panel, before[FROM], "$s$");
        draw_dot(panel, before[TO], "$d$");
    }
    return panel;
}

static void draw(fig_page *page, FILE *numbers)
{
    double middle[2], after[CORNERS][2], kept[2];
    for (int k = 0; k < 2; k++)
        middle[k] = (before[FROM][k] + before[TO][k]) / 2;
    double area = area_of(CORNERS, before);
    int count = collapse_to(middle, after);
    double lost = area - area_of(count, (const double(*)[2])after);
    draw_state(page, 0, CORNERS, before, NULL, NULL);
    draw_state(page, 1, count, (const double(*)[2])after, middle, "$p_0$");
    // The normal of the chord between the neighbors, as long as that is.
    const double *right = before[FROM - 1], *left = before[TO + 1];
    double normal[] = {left[1] - right[1], right[0] - left[0]};
    double square = normal[0] * normal[0] + normal[1] * normal[1];
    for (int k = 0; k < 2; k++)
        kept[k] = middle[k] + 2 * lost * normal[k] / square;
    collapse_to(kept, after);
    fig_panel *last = draw_state(page, 2, count, (const double(*)[2])after,
                                 kept, "$p_0 + h$");
    fig_scene_arrow(fig_panel_scene(last), in_plane(middle), in_plane(kept),
                    FIG_WIDTH_LINE, (fig_paint){.role = FIG_ROLE_POINT});
    fig_number(numbers, "lost", 100 * lost / area);
    fig_number(numbers, "error",
               area_of(count, (const double(*)[2])after) / area - 1);
}

const fig_figure fig_area_keeping_collapse = {
    .name = "area-keeping-collapse",
    .title = "A collapse that keeps the area",
    .width = FIG_PAGE_WIDTH,
    .height = 128,
    .draw = draw,
};

// A corner of a polygon on its level, below it, and on one farther out.
#include "kit/figures.h"

enum {
    CORNERS = 7,
    STATES = 3,
    APEX = 1 ///< the corner that moves
};

static const double polygon[CORNERS][2] = {
    {1, 0.15},    {0.35, 0.9},  {-0.65, 0.75}, {-0.95, 0.1},
    {-0.6, -0.6}, {0.1, -0.75}, {0.75, -0.45}};

/// How far the corner goes: along the chord between its neighbors, in chords,
/// and across it, in heights above it.
static const struct {
    double along, across;
    const char *name;
} states[STATES] = {
    {-0.22, 0, "*on the level*"},
    {0, -0.5, "*below it*"},
    {0, 0.35, "*above it*"},
};

static tf_vector in_plane(const double at[2])
{
    return (tf_vector){{at[0], at[1], 0}};
}

/// The neighbors of the corner, and what is between them.
typedef struct chord {
    tf_vector from, to, along;
    tf_vector height; ///< from the chord to the corner, across
} chord;

static chord chord_of(void)
{
    chord c = {.from = in_plane(polygon[APEX - 1]),
               .to = in_plane(polygon[APEX + 1])};
    c.along = fig_difference(c.to, c.from);
    tf_vector up = fig_difference(in_plane(polygon[APEX]), c.from);
    double part = tf_vector_dot(up, c.along) / tf_vector_dot(c.along, c.along);
    c.height = fig_combination(up, -part, c.along);
    return c;
}

static tf_vector place_in(const chord *c, int state)
{
    tf_vector at =
        fig_combination(in_plane(polygon[APEX]), states[state].along, c->along);
    return fig_combination(at, states[state].across, c->height);
}

static double area_of(const tf_vector at[CORNERS])
{
    double sum = 0;
    for (int i = 0; i < CORNERS; i++) {
        const double *a = at[i].x, *b = at[(i + 1) % CORNERS].x;
        sum += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
    return sum;
}

static void copy_polygon(tf_vector at[CORNERS])
{
    for (int i = 0; i < CORNERS; i++)
        at[i] = in_plane(polygon[i]);
}

static fig_panel *panel_of(fig_page *page, int state)
{
    double width = fig_page_width(page) / STATES;
    fig_box box = {width * state, 0, width, fig_page_height(page) - 16};
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.elevation = 90});
    fig_panel_fix(panel);
    fig_panel_margin(panel, 10);
    for (int i = 0; i < CORNERS; i++)
        fig_scene_reach(fig_panel_scene(panel), in_plane(polygon[i]));
    fig_scene_reach(fig_panel_scene(panel), (tf_vector){{0.6, 1.35, 0}});
    fig_page_caption(page, box, states[state].name);
    return panel;
}

/// The line through a place that is parallel to the chord.
static void draw_level(fig_panel *panel, const chord *c, tf_vector through)
{
    tf_vector line[2] = {fig_combination(through, -0.45, c->along),
                         fig_combination(through, 0.45, c->along)};
    fig_panel_line(panel, 2, line,
                   (fig_stroke){.paint = {.role = FIG_ROLE_EDGE}, .dash = 4});
}

static void draw_state(fig_page *page, const chord *c, int state,
                       const tf_vector after[CORNERS])
{
    fig_panel *panel = panel_of(page, state);
    tf_vector before[CORNERS];
    copy_polygon(before);
    fig_panel_fill(panel, CORNERS, after,
                   (fig_paint){.role = FIG_ROLE_TRIANGLE, .opacity = 0.25});
    fig_panel_line(
        panel, CORNERS, after,
        (fig_stroke){.paint = {.role = FIG_ROLE_TRIANGLE}, .closed = true});
    fig_panel_line(
        panel, 3, before,
        (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL}, .dash = 3});
    fig_panel_line(panel, 2, (tf_vector[]){c->from, c->to},
                   (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                                .width = FIG_WIDTH_THIN});
    draw_level(panel, c, state == 2 ? after[APEX] : before[APEX]);
    fig_point at = fig_panel_project(panel, after[APEX]);
    fig_page_dot(page, at.x, at.y, FIG_WIDTH_BALL,
                 (fig_paint){.role = FIG_ROLE_POINT});
}

static void draw(fig_page *page, FILE *numbers)
{
    static const char *const keys[STATES] = {"kept", "lost", "gained"};
    chord c = chord_of();
    for (int i = 0; i < STATES; i++) {
        tf_vector before[CORNERS], after[CORNERS];
        copy_polygon(before);
        copy_polygon(after);
        after[APEX] = place_in(&c, i);
        draw_state(page, &c, i, after);
        double change = area_of(after) / area_of(before) - 1;
        fig_number(numbers, keys[i], (i == 1 ? -100 : 100) * change);
    }
}

const fig_figure fig_equal_area_line = {
    .name = "equal-area-line",
    .title = "Moves of a polygon's corner that keep, lose and gain area",
    .width = FIG_PAGE_WIDTH,
    .height = 142,
    .draw = draw,
};

// How two moving triangles could overlap: sharing only the moving vertex, or an
// edge, with one outline edge leading into the other triangle or along the
// other's.
#include "kit/figures.h"

#include "surgery/touch.h"

enum {
    CASES = 3,
    CORNERS = 6
};

/// A place with its name.
typedef struct named {
    double at[2];
    const char *name;
    fig_side side;
} named;

/// Two triangles, a line of each outline, and what is red.
typedef struct fan {
    int places;
    named place[CORNERS];
    int triangle[2][3], red[2];
    double cut[2][2]; ///< the part of the red edge in the other triangle
} fan;

static const fan fans[CASES] = {
    {.places = 5,
     .place = {{{0, 1.1}, "$v_t$", FIG_SIDE_N},
               {{-0.9, 0.2}, "$x$", FIG_SIDE_W},
               {{0.55, 0.35}, "$y$", FIG_SIDE_E},
               {{-0.35, -0.3}, "$z$", FIG_SIDE_S},
               {{0.95, -0.1}, "$w$", FIG_SIDE_S}},
     .triangle = {{0, 1, 2}, {0, 3, 4}},
     .red = {1, 2},
     .cut = {{-0.2045, 0.2719}, {0.55, 0.35}}},
    {.places = 4,
     .place = {{{-0.7, 1}, "$v_t$", FIG_SIDE_N},
               {{-0.7, -0.3}, "$x$", FIG_SIDE_S},
               {{0.15, 0.65}, "$y$", FIG_SIDE_N},
               {{0.95, -0.1}, "$w$", FIG_SIDE_S}},
     .triangle = {{0, 1, 2}, {0, 1, 3}},
     .red = {1, 2},
     .cut = {{-0.7, -0.3}, {-0.0294, 0.4471}}},
    {.places = 4,
     .place = {{{-0.7, 1}, "$v_t$", FIG_SIDE_N},
               {{-0.7, -0.3}, "$x$", FIG_SIDE_S},
               {{0.05, -0.02}, "$y$", FIG_SIDE_S},
               {{0.95, 0.316}, "$w$", FIG_SIDE_S}},
     .triangle = {{0, 1, 2}, {0, 1, 3}},
     .red = {1, 2},
     .cut = {{-0.7, -0.3}, {0.05, -0.02}}},
};

static tf_vector place_of(const double at[2])
{
    return (tf_vector){{at[0], at[1], 0}};
}

static void draw_triangle(fig_panel *panel, const fan *f, int i, fig_role role)
{
    tf_vector corner[3];
    for (int j = 0; j < 3; j++)
        corner[j] = place_of(f->place[f->triangle[i][j]].at);
    fig_panel_fill(panel, 3, corner, (fig_paint){.role = role, .opacity = 0.3});
    fig_panel_line(panel, 3, corner,
                   (fig_stroke){.paint = {.role = role}, .closed = true});
}

static void draw_fan(fig_page *page, fig_box box, const fan *f)
{
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.elevation = 90});
    fig_panel_fix(panel);
    fig_panel_margin(panel, 18);
    for (int i = 0; i < f->places; i++)
        fig_scene_reach(fig_panel_scene(panel), place_of(f->place[i].at));
    draw_triangle(panel, f, 0, FIG_ROLE_EDGE);
    draw_triangle(panel, f, 1, FIG_ROLE_TRIANGLE);
    tf_vector cut[2] = {place_of(f->cut[0]), place_of(f->cut[1])};
    fig_panel_line(panel, 2, cut,
                   (fig_stroke){.paint = {.role = FIG_ROLE_CONTACT},
                                .width = FIG_WIDTH_TUBE});
    for (int i = 0; i < f->places; i++) {
        tf_vector at = place_of(f->place[i].at);
        fig_scene_ball(
            fig_panel_scene(panel), at, i == 0 ? FIG_WIDTH_BALL : 4,
            (fig_paint){.role = i == 0 ? FIG_ROLE_POINT : FIG_ROLE_INK});
        fig_panel_label(panel, at,
                        (fig_label){.text = f->place[i].name,
                                    .size = FIG_LETTERS_SMALL,
                                    .side = f->place[i].side,
                                    .gap = 4});
    }
}

static bool is_overlap(const fan *f)
{
    double place[CORNERS][3] = {{0}};
    tf_facet facet[2];
    for (int i = 0; i < f->places; i++)
        for (int k = 0; k < 2; k++)
            place[i][k] = f->place[i].at[k];
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 3; j++) {
            facet[i].vertex[j] = f->triangle[i][j];
            facet[i].corner[j] = place[f->triangle[i][j]];
        }
    return tf_facets_overlap(&facet[0], &facet[1]);
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = fig_page_width(page) / CASES;
    int overlaps = 0;
    for (int i = 0; i < CASES; i++) {
        draw_fan(page, (fig_box){width * i, 0, width, fig_page_height(page)},
                 &fans[i]);
        overlaps += is_overlap(&fans[i]);
    }
    fig_number(numbers, "overlaps", overlaps);
}

const fig_figure fig_overlapping_fans = {
    .name = "overlapping-fans",
    .title = "How two moving triangles could overlap",
    .width = FIG_PAGE_WIDTH,
    .height = 118,
    .draw = draw,
};

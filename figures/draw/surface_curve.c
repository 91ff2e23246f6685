// A curve of the plane as it is drawn: lines and dots.
#include "draw/surface_parts.h"

/// Of vertices, in points, and how long an edge must be for them to be drawn.
static const double dot_diameter = 3, least_length = 7;

static const double line_width = 1.5, touching_width = 2.4, zone_width = 6;

/// A curve at a time on its way to a page.
typedef struct stage {
    fig_page *page;
    fig_view view;
    const fig_shown_surface *shown;
    const fig_shape *shape;
    double t;
} stage;

static fig_point project(const stage *s, tf_vector at)
{
    return fig_view_project(&s->view, at);
}

static void draw_edge(const stage *s, int edge, double width, fig_paint paint)
{
    tf_vector line[3];
    fig_point at[3];
    int count = fig_shape_line(s->shape, edge, s->shown->motion, s->t, line);
    for (int i = 0; i < count; i++)
        at[i] = project(s, line[i]);
    fig_page_line(
        s->page, count, at,
        (fig_stroke){.paint = paint, .width = width, .under_labels = true});
}

static bool touches(const stage *s, int edge)
{
    return s->shown->marked && !s->shown->crosses &&
           fig_is_marked(s->page, s->shown->marks.edge[edge], s->t);
}

/// Wide and pale, below the edges that are in zones.
static void draw_zones(const stage *s)
{
    for (int i = 0; i < s->shape->edges; i++)
        if (fig_is_in_zone(s->shown, i))
            draw_edge(
                s, i, zone_width,
                fig_facet_paint(s->shown, i, s->shape->edge[2 * (size_t)i]));
}

static void draw_edges(const stage *s)
{
    draw_zones(s);
    for (int i = 0; i < s->shape->edges; i++) {
        int part = s->shape->part[s->shape->edge[2 * (size_t)i]];
        draw_edge(s, i, line_width, fig_part_paint(s->shown, part));
    }
    for (int i = 0; i < s->shape->edges; i++)
        if (touches(s, i))
            draw_edge(s, i, touching_width,
                      fig_touching_paint(s->shown->marks.edge[i], s->t));
}

static void draw_dot(const stage *s, tf_vector place, double diameter,
                     fig_paint paint)
{
    fig_point at = project(s, place);
    fig_page_dot(s->page, at.x, at.y, diameter, paint);
}

/// The vertices, if they can be told apart; those of no edge always.
static void draw_vertices(const stage *s)
{
    bool all = s->shape->edge_length * s->shown->scale >= least_length;
    for (int i = 0; i < s->shape->vertices; i++) {
        int part = s->shape->part[i];
        if (part >= 0 && !all)
            continue;
        fig_paint paint = {.role = FIG_ROLE_INK};
        if (part >= 0)
            paint = fig_part_paint(s->shown, part);
        paint.shade = fmax(paint.shade, 0) + 0.3;
        draw_dot(s, fig_shape_place(s->shape, i, s->t), dot_diameter, paint);
    }
}

static void draw_spots(const stage *s)
{
    const fig_marks *marks = &s->shown->marks;
    for (int i = 0; i < marks->count; i++) {
        const fig_spot *spot = &marks->spot[i];
        double width = fig_spot_width(s->page, s->shown, i, s->t);
        if (width > 0)
            draw_dot(s,
                     fig_shape_point(s->shape, spot->vertices, spot->vertex,
                                     spot->weight, s->shown->motion, s->t),
                     width, fig_spot_paint);
    }
}

void fig_show_curve(fig_page *page, fig_box box, const fig_shown_surface *shown,
                    double t)
{
    stage s = {.page = page,
               .view = fig_view_of(&shown->camera, box),
               .shown = shown,
               .shape = &shown->shape,
               .t = t};
    draw_edges(&s);
    draw_vertices(&s);
    if (shown->marked)
        draw_spots(&s);
}

// A surface of space as it is drawn.
#include "draw/surface_parts.h"
#include "kit/surface_normals.h"

#include <limits.h>
#include <math.h>

/// The most edges that are drawn as lines, and the most as lines in contact.
enum {
    LINES = 60000,
    LINES_IN_CONTACT = 5000
};

/// Of particles, in points.
static const double particle_diameter = 1.6;

/// Of the curves along which a surface intersects itself, and of balls where it
/// only touches itself, in points.
static const double curve_width = 2, touch_diameter = 4.5;

/// Of edges in contact: narrower than what stands off.
static const double touching_width = 1.3;

/// A surface at a time on its way into a scene.
typedef struct stage {
    const fig_page *page;
    fig_scene *scene;
    const fig_shown_surface *shown;
    const fig_shape *shape;
    double t;
    fig_normals normals;
} stage;

// Facets -----------------------------------------------------------------

static fig_paint triangle_paint(const stage *s, int triangle)
{
    const fig_marks *marks = &s->shown->marks;
    if (s->shown->marked && !s->shown->crosses &&
        fig_is_marked(s->page, marks->triangle[triangle], s->t))
        return fig_touching_paint(marks->triangle[triangle], s->t);
    return fig_facet_paint(s->shown, triangle,
                           s->shape->triangle[3 * (size_t)triangle]);
}

static void set_corner(fig_facet *facet, int corner, tf_vector at,
                       tf_vector normal)
{
    for (int k = 0; k < 3; k++) {
        facet->at[corner][k] = (float)at.x[k];
        facet->normal[corner][k] = (float)normal.x[k];
    }
}

static fig_facet flat_facet(const tf_vector at[3], fig_paint paint)
{
    fig_facet facet = {.role = paint.role, .shade = (float)paint.shade};
    tf_vector normal = fig_normalized(
        fig_cross(fig_difference(at[1], at[0]), fig_difference(at[2], at[0])));
    for (int c = 0; c < 3; c++)
        set_corner(&facet, c, at[c], normal);
    return facet;
}

static void light_facet(const stage *s, int triangle, fig_facet *facet)
{
    for (size_t c = 0; c < 3; c++)
        for (size_t k = 0; k < 3; k++)
            facet->normal[c][k] =
                s->normals.corner[3 * (size_t)triangle + c][k];
}

static void add_triangles(const stage *s)
{
    bool bends = fig_motion_bends(s->shown->motion, s->t);
    int pieces = bends ? FIG_BENT_PIECES : 1;
    if (s->shape->triangles > INT_MAX / pieces)
        return;
    fig_facet *facet = fig_scene_facets(s->scene, pieces * s->shape->triangles);
    for (int i = 0; facet && i < s->shape->triangles; i++) {
        tf_vector piece[FIG_BENT_PIECES][3];
        fig_paint paint = triangle_paint(s, i);
        fig_shape_pieces(s->shape, i, s->shown->motion, s->t, piece);
        for (int k = 0; k < pieces; k++)
            facet[k] = flat_facet(piece[k], paint);
        if (!bends)
            light_facet(s, i, facet);
        facet += pieces;
    }
}

/// A particle as an octahedron, lit as a ball.
static void add_particle(const stage *s, int vertex)
{
    double radius = particle_diameter / 2 / s->shown->scale;
    tf_vector middle = fig_shape_place(s->shape, vertex, s->t);
    fig_facet *facet = fig_scene_facets(s->scene, 8);
    for (int i = 0; facet && i < 8; i++) {
        facet[i] = (fig_facet){.role = FIG_ROLE_INK, .shade = -0.25F};
        for (int k = 0; k < 3; k++) {
            tf_vector out = {{0}};
            out.x[k] = i >> k & 1 ? 1 : -1;
            set_corner(&facet[i], k, fig_combination(middle, radius, out), out);
        }
    }
}

static void add_particles(const stage *s)
{
    for (int i = 0; i < s->shape->vertices; i++)
        if (s->shape->part[i] < 0)
            add_particle(s, i);
}

// Lines ------------------------------------------------------------------

static void add_line(const stage *s, int edge, double width, fig_paint paint)
{
    tf_vector line[3];
    int count = fig_shape_line(s->shape, edge, s->shown->motion, s->t, line);
    fig_scene_path(s->scene, count, line, width, paint);
}

/// The width of the line along an edge, in points; 0 for none.
static double line_width(const stage *s, int edge, bool all)
{
    if (s->shape->degree[edge] == 0)
        return FIG_WIDTH_LINE;
    if (s->normals.crease[edge])
        return FIG_WIDTH_THIN;
    return all ? FIG_WIDTH_HAIR : 0;
}

static int count_lines(const stage *s, bool all)
{
    int count = 0;
    for (int i = 0; i < s->shape->edges; i++)
        count += line_width(s, i, all) > 0;
    return count;
}

static fig_paint line_paint(const stage *s, int edge)
{
    int part = s->shape->part[s->shape->edge[2 * (size_t)edge]];
    fig_paint paint = fig_part_paint(s->shown, part);
    if (s->shape->degree[edge] > 0)
        paint.shade = fmax(paint.shade, 0) + 0.35;
    return paint;
}

/// Lines along the edges of no triangle, along borders and creases, and along
/// all edges if they can be read.
static void add_lines(const stage *s)
{
    bool all = fig_shows_edges(s->shown);
    bool few = count_lines(s, all) <= LINES;
    for (int i = 0; i < s->shape->edges; i++) {
        double width = line_width(s, i, all);
        if (width > 0 && (few || s->shape->degree[i] == 0))
            add_line(s, i, width, line_paint(s, i));
    }
}

static void add_touching_lines(const stage *s)
{
    const float *toi = s->shown->marks.edge;
    int count = 0;
    for (int i = 0; i < s->shape->edges; i++)
        count += toi[i] < FIG_NEVER;
    for (int i = 0; i < s->shape->edges; i++)
        if (fig_is_marked(s->page, toi[i], s->t))
            add_line(s, i,
                     toi[i] <= s->t && count <= LINES_IN_CONTACT
                         ? touching_width
                         : FIG_WIDTH_THIN,
                     fig_touching_paint(toi[i], s->t));
}

static void add_spot(const stage *s, int i, double diameter, fig_paint paint)
{
    const fig_spot *spot = &s->shown->marks.spot[i];
    fig_scene_ball(s->scene,
                   fig_shape_point(s->shape, spot->vertices, spot->vertex,
                                   spot->weight, s->shown->motion, s->t),
                   diameter, paint);
}

static void add_spots(const stage *s)
{
    for (int i = 0; i < s->shown->marks.count; i++) {
        double width = fig_spot_width(s->page, s->shown, i, s->t);
        if (width > 0)
            add_spot(s, i, width, fig_spot_paint);
    }
}

/// Curves as lines, and as balls what only touches.
static void add_crossings(const stage *s)
{
    const fig_tangled *tangled = &s->shown->tangled;
    fig_curve_pieces_draw(s->scene, &tangled->curves, curve_width);
    for (int i = 0; i < s->shown->marks.count; i++)
        if (tangled->touches[i])
            add_spot(s, i, touch_diameter,
                     (fig_paint){.role = FIG_ROLE_CONTACT});
}

// The surface ------------------------------------------------------------

static void add_surface(stage *s)
{
    if (!fig_normals_find(&s->normals, s->shape, s->t, NULL)) {
        fig_scene_fail(s->scene);
        return;
    }
    add_triangles(s);
    add_particles(s);
    add_lines(s);
    if (s->shown->crosses) {
        add_crossings(s);
    } else if (s->shown->marked) {
        add_touching_lines(s);
        add_spots(s);
    }
}

void fig_show_surface(fig_page *page, fig_box box,
                      const fig_shown_surface *shown, double t)
{
    fig_panel *panel = fig_page_panel(page, box);
    fig_camera camera = shown->camera;
    camera.height = 0;
    fig_panel_look(panel, camera);
    fig_panel_margin(panel, FIG_SURFACE_MARGIN);
    stage s = {.page = page,
               .scene = fig_panel_scene(panel),
               .shown = shown,
               .shape = &shown->shape,
               .t = t};
    for (int i = 0; i < shown->outline_count; i++)
        fig_scene_reach(s.scene, shown->outline[i]);
    add_surface(&s);
    fig_normals_free(&s.normals);
}

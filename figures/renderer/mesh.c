#include "renderer/mesh.h"

#include "renderer/list.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

enum {
    SIDES_MOST = 32
}; ///< of a round thing

static const double tau = 6.283185307179586;

/// An arrow head's length and width, by the width of its tube.
static const double head_length = 3.6, head_width = 2.9;

/// From how many points on a solid thing stands off what is behind it.
static const double stands_off = 1.4;

/// How near to a plane, in points, a face lies in it.
static const double flat = 1e-3;

/// The points x for which dot(normal, x) = level, from the view's center.
typedef struct plane {
    tf_vector normal;
    double level;
} plane;

/// What is being built, and what all its vertices share.
typedef struct builder {
    fig_mesh mesh;
    const fig_view *view;
    const fig_theme *theme;
    fig_vertex like; ///< the color of the part at work
    plane *planes;   ///< of the flat translucent faces so far
    int plane_count, plane_room;
} builder;

/// Coordinates along three orthonormal axes from an origin.
typedef struct frame {
    tf_vector origin, axis[3];
} frame;

static void add_vertex(builder *b, tf_vector at, tf_vector normal)
{
    if (!fig_list_room(&b->mesh.vertices, b->mesh.count, 1, &b->mesh.room,
                       sizeof *b->mesh.vertices)) {
        b->mesh.out_of_memory = true;
        return;
    }
    fig_vertex *vertex = &b->mesh.vertices[b->mesh.count++];
    *vertex = b->like;
    for (int k = 0; k < 3; k++) {
        vertex->at[k] = (float)(at.x[k] - b->view->center.x[k]);
        vertex->normal[k] = (float)normal.x[k];
    }
}

/// Set the color of a part that is `width` points wide.
static void set_paint(builder *b, fig_paint paint, double width)
{
    fig_rgb color = fig_paint_color(b->theme, paint);
    double opacity = fig_paint_opacity(paint);
    if (opacity < 1)
        opacity = pow(opacity, b->theme->opacity_power);
    else if (width < stands_off)
        opacity = 0.5;
    b->like.color[0] = (float)fig_rgb_to_linear(color.r);
    b->like.color[1] = (float)fig_rgb_to_linear(color.g);
    b->like.color[2] = (float)fig_rgb_to_linear(color.b);
    b->like.color[3] = (float)opacity;
}

// Round things -----------------------------------------------------------

/// A ring of a round thing: where along the third axis, how wide, and the
/// slope of its normal along that axis.
typedef struct ring {
    double along, radius;
    double normal_along, normal_out;
} ring;

static void add_ring_vertex(builder *b, const frame *f, const ring *r,
                            double turn)
{
    tf_vector out =
        fig_combination(tf_vector_scaled(cos(turn * tau), f->axis[0]),
                        sin(turn * tau), f->axis[1]);
    tf_vector middle = fig_combination(f->origin, r->along, f->axis[2]);
    tf_vector slope = tf_vector_scaled(r->normal_along, f->axis[2]);
    add_vertex(b, fig_combination(middle, r->radius, out),
               fig_combination(slope, r->normal_out, out));
}

/// The band between two rings, in `sides` quadrangles.
static void add_band(builder *b, const frame *f, const ring *lower,
                     const ring *upper, int sides)
{
    for (int i = 0; i < sides; i++) {
        double here = (double)i / sides, next = (double)(i + 1) / sides;
        add_ring_vertex(b, f, lower, here);
        add_ring_vertex(b, f, lower, next);
        add_ring_vertex(b, f, upper, next);
        add_ring_vertex(b, f, lower, here);
        add_ring_vertex(b, f, upper, next);
        add_ring_vertex(b, f, upper, here);
    }
}

/// A frame whose third axis points along `axis`, of length 1.
static frame frame_along(tf_vector origin, tf_vector axis)
{
    int k = fabs(axis.x[0]) < fabs(axis.x[1]) ? 0 : 1;
    k = fabs(axis.x[2]) < fabs(axis.x[k]) ? 2 : k;
    tf_vector least = {{k == 0, k == 1, k == 2}};
    tf_vector first = fig_normalized(fig_cross(axis, least));
    return (frame){origin, {first, fig_cross(axis, first), axis}};
}

/// As many sides as a round thing of a diameter in points needs.
static int sides_for(double diameter)
{
    int sides = 6 + (int)(5 * diameter);
    return sides < SIDES_MOST ? sides : SIDES_MOST;
}

static void add_ball(builder *b, tf_vector at, double radius, int sides)
{
    frame f = frame_along(at, (tf_vector){{0, 0, 1}});
    ring below = {-radius, 0, -1, 0};
    int bands = sides / 2;
    for (int i = 1; i <= bands; i++) {
        double angle = tau / 2 * i / bands;
        ring above = {-radius * cos(angle), radius * sin(angle), -cos(angle),
                      sin(angle)};
        add_band(b, &f, &below, &above, sides);
        below = above;
    }
}

static void add_cylinder(builder *b, const frame *f, double from, double to,
                         double radius, int sides)
{
    ring lower = {from, radius, 0, 1}, upper = {to, radius, 0, 1};
    add_band(b, f, &lower, &upper, sides);
}

static void add_cone(builder *b, const frame *f, double base, double tip,
                     double radius, int sides)
{
    double length = hypot(tip - base, radius);
    double along = radius / length, out = (tip - base) / length;
    ring middle = {base, 0, -1, 0}, rim = {base, radius, -1, 0};
    ring foot = {base, radius, along, out}, top = {tip, 0, along, out};
    add_band(b, f, &middle, &rim, sides);
    add_band(b, f, &foot, &top, sides);
}

static void add_dashes(builder *b, const frame *f, double length, double dash,
                       double radius, int sides)
{
    int count = (int)(length / dash / 2);
    count = count < 1 ? 1 : count > 1000 ? 1000 : count;
    // An odd number of equal parts begins and ends with a dash.
    double part = length / (2 * count + 1);
    for (int i = 0; i <= count; i++)
        add_cylinder(b, f, 2 * i * part, (2 * i + 1) * part, radius, sides);
}

static void add_tube(builder *b, const fig_tube *tube)
{
    tf_vector along = fig_difference(tube->to, tube->from);
    double length = fig_length(along);
    if (length == 0)
        return;
    double unit = 1 / b->view->points_per_unit;
    double radius = tube->width / 2 * unit;
    int sides = sides_for(tube->width);
    frame f = frame_along(tube->from, fig_normalized(along));
    set_paint(b, tube->paint, tube->width);
    if (tube->dash > 0) {
        add_dashes(b, &f, length, tube->dash * unit, radius, sides);
        return;
    }

    // Draw the head and the tube up to it
    double end = length;
    if (tube->head > 0) {
        double tip = tube->head * length;
        double size = fmin(head_length * tube->width * unit, tip);
        add_cone(b, &f, tip - size, tip, size * head_width / head_length / 2,
                 sides_for(head_width * tube->width));
        end = tube->head < 1 ? length : tip - size;
    }
    add_cylinder(b, &f, 0, end, radius, sides);

    // Round the ends of what is wide enough for them to be seen
    if (tube->width > FIG_WIDTH_THIN && fig_paint_opacity(tube->paint) >= 1) {
        add_ball(b, tube->from, radius, sides);
        if (tube->head != 1)
            add_ball(b, tube->to, radius, sides);
    }
}

// Faces ------------------------------------------------------------------

static int compare_vectors(tf_vector a, tf_vector b)
{
    for (int k = 0; k < 3; k++)
        if (a.x[k] != b.x[k])
            return a.x[k] < b.x[k] ? -1 : 1;
    return 0;
}

/// Corners in a fixed order: then faces that coincide have the same depth at
/// each pixel, to the last bit, and one of them is seen, not a mixture.
static void order_corners(const fig_face *face, int order[3])
{
    for (int i = 0; i < 3; i++) {
        int j = i;
        for (; j > 0 &&
               compare_vectors(face->corner[i], face->corner[order[j - 1]]) < 0;
             j--)
            order[j] = order[j - 1];
        order[j] = i;
    }
}

static double level_of(const builder *b, tf_vector normal, tf_vector at)
{
    return tf_vector_dot(normal, fig_difference(at, b->view->center));
}

static bool lies_in(const builder *b, const plane *p, const fig_face *face)
{
    for (int i = 0; i < 3; i++)
        if (fabs(level_of(b, p->normal, face->corner[i]) - p->level) *
                b->view->points_per_unit >
            flat)
            return false;
    return true;
}

/// The plane of a flat face: one that other faces have, or a new one.  NULL if
/// there is no memory.
static const plane *plane_of(builder *b, const fig_face *face)
{
    for (int i = 0; i < b->plane_count; i++)
        if (lies_in(b, &b->planes[i], face))
            return &b->planes[i];
    if (!fig_list_room(&b->planes, b->plane_count, 1, &b->plane_room,
                       sizeof *b->planes)) {
        b->mesh.out_of_memory = true;
        return NULL;
    }
    tf_vector normal = face->normal[0];
    b->planes[b->plane_count] =
        (plane){normal, level_of(b, normal, face->corner[0])};
    return &b->planes[b->plane_count++];
}

static bool is_flat(const fig_face *face)
{
    const tf_vector *normal = face->normal;
    return compare_vectors(normal[0], normal[1]) == 0 &&
           compare_vectors(normal[0], normal[2]) == 0;
}

/// Flat translucent faces have the depth of their plane, so that where some of
/// one plane overlap, one of them is seen too.
static void add_face(builder *b, const fig_face *face)
{
    int order[3];
    order_corners(face, order);
    set_paint(b, face->paint, 0);
    const plane *own = NULL;
    if (fig_paint_opacity(face->paint) < 1 && is_flat(face))
        own = plane_of(b, face);
    b->like.level = own ? (float)own->level : FIG_NO_LEVEL;
    for (int i = 0; i < 3; i++)
        add_vertex(b, face->corner[order[i]],
                   own ? own->normal : face->normal[order[i]]);
    b->like.level = FIG_NO_LEVEL;
}

/// How bright a facet is in the light from the reader's left, on top of how
/// solids are shaded: large surfaces need more relief.
static float relief_of(const builder *b, const float normal[3])
{
    static const double shadow = 0.68, lamp = 0.46;
    tf_vector n = {{normal[0], normal[1], normal[2]}};
    tf_vector from = fig_combination(b->view->back, -0.9, b->view->right);
    from = fig_normalized(fig_combination(from, 0.8, b->view->up));
    double facing = tf_vector_dot(n, b->view->back) < 0 ? -1 : 1;
    return (float)(shadow + lamp * fmax(0, facing * tf_vector_dot(n, from)));
}

static void add_facet_corner(builder *b, const fig_facet *facet, int corner)
{
    const float *at = facet->at[corner], *normal = facet->normal[corner];
    fig_vertex plain = b->like;
    float relief = relief_of(b, normal);
    for (int k = 0; k < 3; k++)
        b->like.color[k] *= relief;
    add_vertex(b, (tf_vector){{at[0], at[1], at[2]}},
               (tf_vector){{normal[0], normal[1], normal[2]}});
    b->like = plain;
}

/// Room for three vertices each of `count` triangles, and no more.
static bool make_room(builder *b, int count)
{
    // Three vertices each must still be an int.
    if (count <= INT_MAX / 3 &&
        fig_list_more(&b->mesh.vertices, b->mesh.count, 3 * count,
                      &b->mesh.room, sizeof *b->mesh.vertices))
        return true;
    b->mesh.out_of_memory = true;
    return false;
}

/// The triangles of large surfaces, in no more memory than they need.
static void add_facets(builder *b, const fig_scene *scene)
{
    if (!make_room(b, scene->facet_count))
        return;
    fig_paint last = {.role = FIG_ROLES};
    for (int i = 0; i < scene->facet_count; i++) {
        const fig_facet *facet = &scene->facets[i];
        fig_paint paint = {.role = facet->role, .shade = facet->shade};
        if (paint.role != last.role || paint.shade != last.shade)
            set_paint(b, paint, 0);
        last = paint;
        for (int c = 0; c < 3; c++)
            add_facet_corner(b, facet, c);
    }
}

/// Triangles that are lit already; none stands off what is behind it.
static void add_painted(builder *b, const fig_scene *scene)
{
    if (!make_room(b, scene->painted_count))
        return;
    b->like.color[3] = 0.5F;
    for (int i = 0; i < scene->painted_count; i++)
        for (int c = 0; c < 3; c++) {
            const float *at = scene->painted[i].at[c];
            memcpy(b->like.color, scene->painted[i].color[c],
                   sizeof scene->painted[i].color[c]);
            add_vertex(b, (tf_vector){{at[0], at[1], at[2]}},
                       (tf_vector){{0, 0, 0}});
        }
}

// The scene --------------------------------------------------------------

static bool is_opaque(fig_paint paint)
{
    return fig_paint_opacity(paint) >= 1;
}

static void add_parts(builder *b, const fig_scene *scene, bool opaque)
{
    for (int i = 0; i < scene->face_count; i++)
        if (is_opaque(scene->faces[i].paint) == opaque)
            add_face(b, &scene->faces[i]);
    for (int i = 0; i < scene->tube_count; i++)
        if (is_opaque(scene->tubes[i].paint) == opaque)
            add_tube(b, &scene->tubes[i]);
    for (int i = 0; i < scene->ball_count; i++)
        if (is_opaque(scene->balls[i].paint) == opaque) {
            const fig_ball *ball = &scene->balls[i];
            set_paint(b, ball->paint, ball->diameter);
            add_ball(b, ball->at, ball->diameter / 2 / b->view->points_per_unit,
                     sides_for(ball->diameter));
        }
}

fig_mesh fig_mesh_of(const fig_scene *scene, const fig_view *view,
                     const fig_theme *theme)
{
    builder b = {.view = view, .theme = theme, .like.level = FIG_NO_LEVEL};
    add_parts(&b, scene, true);
    add_facets(&b, scene);
    add_painted(&b, scene);
    b.mesh.opaque = b.mesh.count;
    add_parts(&b, scene, false);
    free(b.planes);
    return b.mesh;
}

#include "stage/mesh.h"

#include "stage/list.h"
#include "stage/vector.h"

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

/// What is being built, and what all its vertices share.
typedef struct builder {
    tf_mesh mesh;
    const tf_view *view;
    const tf_theme *theme;
    tf_vertex like; ///< the colour of the part at work
} builder;

/// Coordinates along three orthonormal axes from an origin.
typedef struct frame {
    double origin[3], axis[3][3];
} frame;

static void add_vertex(builder *b, const double at[3], const double normal[3])
{
    if (!tf_list_room(&b->mesh.vertices, b->mesh.count, 1, &b->mesh.room,
                      sizeof *b->mesh.vertices)) {
        b->mesh.out_of_memory = true;
        return;
    }
    tf_vertex *vertex = &b->mesh.vertices[b->mesh.count++];
    *vertex = b->like;
    for (int k = 0; k < 3; k++) {
        vertex->at[k] = (float)(at[k] - b->view->center[k]);
        vertex->normal[k] = (float)normal[k];
    }
}

/// Set the colour of a part that is `width` points wide.
static void set_paint(builder *b, tf_paint paint, double width)
{
    tf_rgb color = tf_paint_color(b->theme, paint);
    double opacity = tf_paint_opacity(paint);
    if (opacity < 1)
        opacity = pow(opacity, b->theme->opacity_power);
    else if (width < stands_off)
        opacity = 0.5;
    b->like.color[0] = (float)tf_rgb_to_linear(color.r);
    b->like.color[1] = (float)tf_rgb_to_linear(color.g);
    b->like.color[2] = (float)tf_rgb_to_linear(color.b);
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
    double out[3] = {0}, at[3], normal[3] = {0};
    tf_add(out, cos(turn * tau), f->axis[0], out);
    tf_add(out, sin(turn * tau), f->axis[1], out);
    tf_add(f->origin, r->along, f->axis[2], at);
    tf_add(at, r->radius, out, at);
    tf_add(normal, r->normal_along, f->axis[2], normal);
    tf_add(normal, r->normal_out, out, normal);
    add_vertex(b, at, normal);
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
static frame frame_along(const double origin[3], const double axis[3])
{
    frame f = {.origin = {0}};
    int k = fabs(axis[0]) < fabs(axis[1]) ? 0 : 1;
    k = fabs(axis[2]) < fabs(axis[k]) ? 2 : k;
    const double least[3] = {k == 0, k == 1, k == 2};
    tf_add(origin, 0, origin, f.origin);
    tf_add(axis, 0, axis, f.axis[2]);
    tf_cross(axis, least, f.axis[0]);
    tf_normalize(f.axis[0]);
    tf_cross(f.axis[2], f.axis[0], f.axis[1]);
    return f;
}

/// As many sides as a round thing of a diameter in points needs.
static int sides_for(double diameter)
{
    int sides = 6 + (int)(5 * diameter);
    return sides < SIDES_MOST ? sides : SIDES_MOST;
}

static void add_ball(builder *b, const double at[3], double radius, int sides)
{
    frame f = frame_along(at, (double[]){0, 0, 1});
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

static void add_tube(builder *b, const tf_tube *tube)
{
    double along[3], unit = 1 / b->view->points_per_unit;
    tf_add(tube->to, -1, tube->from, along);
    double length = tf_normalize(along);
    if (length == 0)
        return;
    double radius = tube->width / 2 * unit;
    int sides = sides_for(tube->width);
    frame f = frame_along(tube->from, along);
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
    if (tube->width > TF_WIDTH_THIN && tf_paint_opacity(tube->paint) >= 1) {
        add_ball(b, tube->from, radius, sides);
        if (tube->head != 1)
            add_ball(b, tube->to, radius, sides);
    }
}

// Faces ------------------------------------------------------------------

static int compare_corners(const double a[3], const double b[3])
{
    for (int k = 0; k < 3; k++)
        if (a[k] != b[k])
            return a[k] < b[k] ? -1 : 1;
    return 0;
}

/// Corners in a fixed order: then faces that coincide have the same depth at
/// each pixel, to the last bit, and one of them is seen, not a mixture.
static void order_corners(const tf_face *face, int order[3])
{
    for (int i = 0; i < 3; i++) {
        int j = i;
        for (; j > 0 &&
               compare_corners(face->corner[i], face->corner[order[j - 1]]) < 0;
             j--)
            order[j] = order[j - 1];
        order[j] = i;
    }
}

static void add_face(builder *b, const tf_face *face)
{
    int order[3];
    order_corners(face, order);
    set_paint(b, face->paint, 0);
    for (int i = 0; i < 3; i++)
        add_vertex(b, face->corner[order[i]], face->normal[order[i]]);
}

// The scene --------------------------------------------------------------

static bool is_opaque(tf_paint paint)
{
    return tf_paint_opacity(paint) >= 1;
}

static void add_parts(builder *b, const tf_scene *scene, bool opaque)
{
    for (int i = 0; i < scene->face_count; i++)
        if (is_opaque(scene->faces[i].paint) == opaque)
            add_face(b, &scene->faces[i]);
    for (int i = 0; i < scene->tube_count; i++)
        if (is_opaque(scene->tubes[i].paint) == opaque)
            add_tube(b, &scene->tubes[i]);
    for (int i = 0; i < scene->ball_count; i++)
        if (is_opaque(scene->balls[i].paint) == opaque) {
            const tf_ball *ball = &scene->balls[i];
            set_paint(b, ball->paint, ball->diameter);
            add_ball(b, ball->at, ball->diameter / 2 / b->view->points_per_unit,
                     sides_for(ball->diameter));
        }
}

tf_mesh tf_mesh_of(const tf_scene *scene, const tf_view *view,
                   const tf_theme *theme)
{
    builder b = {.view = view, .theme = theme};
    add_parts(&b, scene, true);
    b.mesh.opaque = b.mesh.count;
    add_parts(&b, scene, false);
    return b.mesh;
}

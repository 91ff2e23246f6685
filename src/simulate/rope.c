//: Include what ropes need
#include "simulate/rope.h"

#include "simulate/solid.h"

#include <math.h>
#include <stdlib.h>

static const double pi = 3.141592653589793;

//: Follow the trefoil knot
/// It winds twice about the vertical axis, and at the same time three times
/// about a circle of radius 2.
static tf_vector trefoil(double t)
{
    double out = 2 + cos(3 * t);
    return (tf_vector){{out * cos(2 * t), out * sin(2 * t), sin(3 * t)}};
}

/// Where the first of its three lobes is cut off.
static const double cut = 0.42;

enum {
    FINE = 2000 // steps along the knot, and along each end
};

/// Follows an end away from where the knot is cut: the one before the first
/// point of the knot with the side 1, to earlier points, and the one after the
/// last with -1, to later ones.
static void follow_end(int side, double tail, tf_vector *point)
{
    double at_cut = side > 0 ? cut : 2 * pi - cut, small = 1e-6;
    tf_vector at = trefoil(at_cut), away = {{0, side, 0}};
    tf_vector along = tf_vector_unit(
        tf_vector_difference(trefoil(at_cut - side * small), at));
    tf_vector swerve = tf_vector_difference(away, along);
    for (int i = 0; i < FINE; i++, point -= side) {
        double part = fmin(tail * i / FINE / 2, 1);
        tf_vector ahead = tf_vector_unit(tf_vector_sum(along, part, swerve));
        at = tf_vector_sum(at, tail / FINE, ahead);
        *point = at;
    }
}

//: Place points at equal distances
/// Walks along a line of many points, and puts a point wherever another spacing
/// has been covered.
static void space_out(tf_line *line, double scale, double spacing, int count,
                      const tf_vector fine[])
{
    double covered = 0;
    for (int i = 0; i + 1 < count; i++) {
        covered += scale *
                   tf_vector_length(tf_vector_difference(fine[i + 1], fine[i]));
        if (covered < line->points * spacing)
            continue;
        for (int k = 0; k < 3; k++)
            line->x[3 * line->points + k] = scale * fine[i + 1].x[k];
        line->points++;
    }
}

//: Make the line of a knot
tf_line tf_knot_line(double scale, double tail, double spacing)
{
    enum {
        ALL = 3 * FINE
    };
    tf_line line = {0};
    tf_vector *fine = malloc(sizeof *fine * ALL);
    line.x = malloc(sizeof(double) * 3 * ALL);
    if (fine && line.x) {
        follow_end(1, tail, fine + FINE - 1);
        for (int i = 0; i < FINE; i++)
            fine[FINE + i] = trefoil(cut + 2 * (pi - cut) * i / (FINE - 1));
        follow_end(-1, tail, fine + (ptrdiff_t)2 * FINE);
        space_out(&line, scale, spacing, ALL, fine);
    }
    free(fine);
    return line;
}

void tf_line_free(tf_line *line)
{
    free(line->x);
    *line = (tf_line){0};
}

//: Place circles along a line
static tf_vector direction_at(const tf_line *line, int i)
{
    int before = i > 0 ? i - 1 : i;
    int after = i + 1 < line->points ? i + 1 : i;
    return tf_vector_unit(tf_vector_difference(tf_vector_at(line->x, after),
                                               tf_vector_at(line->x, before)));
}

/// Each circle is turned as little as possible from the one before it.
static void add_circles(tf_body *body, const tf_line *line, double radius,
                        int sides)
{
    tf_vector across = {{0, 0, 1}};
    for (int i = 0; i < line->points; i++) {
        tf_vector along = direction_at(line, i);
        double slope = tf_vector_dot(across, along);
        across = tf_vector_unit(tf_vector_sum(across, -slope, along));
        tf_vector beside = tf_vector_cross(along, across);
        tf_circle_add(body, tf_vector_at(line->x, i),
                      tf_vector_scaled(radius, across),
                      tf_vector_scaled(radius, beside), sides);
    }
}

//: Join the circles of a rope
static void add_tube(tf_body *body, int first, int circles, int sides)
{
    for (int i = 0; i + 1 < circles; i++)
        for (int s = 0; s < sides; s++) {
            int v = first + i * sides + s;
            int next = first + i * sides + (s + 1) % sides;
            tf_body_add_triangle(body, v, next, v + sides);
            tf_body_add_triangle(body, next, next + sides, v + sides);
        }
}

/// Across each circle, and from each to the next one.
static void add_struts(tf_body *body, int first, int sides, double stiffness)
{
    for (int circle = first; circle < body->vertices; circle += sides)
        for (int s = 0; s < sides; s++) {
            int v = circle + s, across = circle + (s + sides / 2) % sides;
            if (v < across)
                tf_body_add_spring(body, v, across, stiffness);
            if (across + sides < body->vertices)
                tf_body_add_spring(body, v, across + sides, stiffness);
        }
}

//: Add a rope
void tf_rope_add(tf_body *body, const tf_line *line, double radius, int sides,
                 const tf_material *material)
{
    int first = body->vertices, triangle = body->triangles;
    if (!line->x) {
        body->failed = true;
        return;
    }
    add_circles(body, line, radius, sides);
    add_tube(body, first, line->points, sides);
    tf_cloth_stiffen(body, triangle, material);
    add_struts(body, first, sides, material->stretch);
}

//: Include what ropes need
#include "simulate/rope.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.141592653589793;

//: Calculate with vectors
typedef struct vector {
    double x[3];
} vector;

static vector sum(vector a, double factor, vector b)
{
    for (int k = 0; k < 3; k++)
        a.x[k] += factor * b.x[k];
    return a;
}

static double dot(vector a, vector b)
{
    return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}

static vector unit(vector a)
{
    double length = sqrt(dot(a, a));
    return (vector){{a.x[0] / length, a.x[1] / length, a.x[2] / length}};
}

static vector cross(vector a, vector b)
{
    return (vector){{a.x[1] * b.x[2] - a.x[2] * b.x[1],
                     a.x[2] * b.x[0] - a.x[0] * b.x[2],
                     a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}

//: Follow the trefoil knot
/// It winds twice about the vertical axis, and at the same time three times
/// about a circle of radius 2.
static vector trefoil(double t)
{
    double out = 2 + cos(3 * t);
    return (vector){{out * cos(2 * t), out * sin(2 * t), sin(3 * t)}};
}

/// Where the first of its three lobes is cut off.
static const double cut = 0.42;

enum {
    FINE = 2000 // steps along the knot, and along each end
};

/// Follows an end from where the knot is cut; `side` is 1 for the one at the
/// first point of the knot, and -1 for that at the last.
static void follow_end(double side, double tail, vector point[FINE])
{
    double h = 1e-6, begin = side > 0 ? cut : 2 * pi - cut;
    vector at = trefoil(begin);
    vector along = unit(sum(trefoil(begin - side * h), -1, at));
    vector away = {{0, side, 0}};
    for (int i = 0; i < FINE; i++) {
        double turned = fmin(tail * i / FINE / 2, 1);
        vector ahead = sum(along, turned, sum(away, -1, along));
        at = sum(at, tail / FINE, unit(ahead));
        point[i] = at;
    }
}

//: Place points at equal distances
/// Walks along a line of many points, and puts a point wherever another spacing
/// has been covered.
static void space_out(tf_line *line, double scale, double spacing, int count,
                      const vector fine[])
{
    double covered = 0;
    for (int i = 0; i + 1 < count; i++) {
        vector to_next = sum(fine[i + 1], -1, fine[i]);
        covered += scale * sqrt(dot(to_next, to_next));
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
    vector *fine = malloc(sizeof *fine * ALL);
    line.x = malloc(sizeof(double) * 3 * ALL);
    if (fine && line.x) {
        follow_end(1, tail, fine);
        for (int i = 0; i < FINE / 2; i++) {
            vector swapped = fine[i];
            fine[i] = fine[FINE - 1 - i];
            fine[FINE - 1 - i] = swapped;
        }
        for (int i = 0; i < FINE; i++)
            fine[FINE + i] = trefoil(cut + 2 * (pi - cut) * i / (FINE - 1));
        follow_end(-1, tail, fine + 2 * FINE);
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
static vector point_of(const tf_line *line, int i)
{
    vector point;
    memcpy(point.x, line->x + 3 * i, sizeof point.x);
    return point;
}

static vector direction_at(const tf_line *line, int i)
{
    int before = i > 0 ? i - 1 : i;
    int after = i + 1 < line->points ? i + 1 : i;
    return unit(sum(point_of(line, after), -1, point_of(line, before)));
}

/// Each circle is turned as little as possible from the one before it.
static void add_circles(tf_body *body, const tf_line *line, double radius,
                        int sides)
{
    vector across = {{0, 0, 1}};
    for (int i = 0; i < line->points; i++) {
        vector along = direction_at(line, i);
        across = unit(sum(across, -dot(across, along), along));
        vector beside = cross(along, across);
        for (int s = 0; s < sides; s++) {
            double around = 2 * pi * s / sides;
            vector x = sum(point_of(line, i), radius * cos(around), across);
            x = sum(x, radius * sin(around), beside);
            tf_body_add_vertex(body, x.x);
        }
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
    body->failed |= !line->x;
    add_circles(body, line, radius, sides);
    add_tube(body, first, line->points, sides);
    tf_cloth_stiffen(body, triangle, material);
    add_struts(body, first, sides, material->stretch);
}

//: Include what solids need
#include "simulate/solid.h"

#include <math.h>

static const double pi = 3.141592653589793;

//: Add a circle of vertices
void tf_circle_add(tf_body *body, tf_vector center, tf_vector across,
                   tf_vector beside, int vertices)
{
    for (int i = 0; i < vertices; i++) {
        double around = 2 * pi * i / vertices;
        tf_vector x = tf_vector_sum(center, cos(around), across);
        x = tf_vector_sum(x, sin(around), beside);
        tf_body_add_vertex(body, x.x);
    }
}

/// A level circle, some way up from a center.
static void add_level(tf_body *body, const double center[3], double up,
                      double radius, int sectors)
{
    tf_vector middle = {{center[0], center[1], center[2] + up}};
    tf_circle_add(body, middle, (tf_vector){{radius}}, (tf_vector){{0, radius}},
                  sectors);
}

//: Add triangles between circles
/// @param above, below the first vertex of each
static void add_belt(tf_body *body, int above, int below, int sectors)
{
    for (int s = 0; s < sectors; s++) {
        int next = (s + 1) % sectors;
        tf_body_add_triangle(body, above + s, below + s, above + next);
        tf_body_add_triangle(body, above + next, below + s, below + next);
    }
}

/// Circles that follow each other among the vertices.
static void add_belts(tf_body *body, int first, int circles, int sectors)
{
    for (int i = 0; i + 1 < circles; i++)
        add_belt(body, first + i * sectors, first + (i + 1) * sectors, sectors);
}

/// Closes two circles by two new vertices.
static void add_ends(tf_body *body, const double center[3], double top,
                     double bottom, const int circle[2], int sectors)
{
    int first = body->vertices;
    add_level(body, center, top, 0, 1);
    add_level(body, center, bottom, 0, 1);
    for (int s = 0; s < sectors; s++) {
        int next = (s + 1) % sectors;
        tf_body_add_triangle(body, first, circle[0] + s, circle[0] + next);
        tf_body_add_triangle(body, first + 1, circle[1] + next, circle[1] + s);
    }
}

//: Add a ball
void tf_ball_add(tf_body *body, const double center[3], double radius,
                 int sectors)
{
    int first = body->vertices, circles = sectors / 2;
    for (int i = 1; i <= circles; i++) {
        double down = pi * i / (circles + 1);
        add_level(body, center, radius * cos(down), radius * sin(down),
                  sectors);
    }
    add_belts(body, first, circles, sectors);
    const int outer[] = {first, first + (circles - 1) * sectors};
    add_ends(body, center, radius, -radius, outer, sectors);
}

//: Add a column
void tf_column_add(tf_body *body, const double foot[3], double radius,
                   double height, int sectors, int rows)
{
    int first = body->vertices;
    for (int i = rows; i >= 0; i--)
        add_level(body, foot, height * i / rows, radius, sectors);
    add_belts(body, first, rows + 1, sectors);
    const int outer[] = {first, first + rows * sectors};
    add_ends(body, foot, height, 0, outer, sectors);
}

//: Add a ring
void tf_ring_add(tf_body *body, const double center[3], const double radius[2],
                 int sectors, int sides)
{
    int first = body->vertices;
    for (int i = 0; i < sides; i++) {
        double around = 2 * pi * i / sides;
        add_level(body, center, radius[1] * cos(around),
                  radius[0] + radius[1] * sin(around), sectors);
    }
    add_belts(body, first, sides, sectors);
    add_belt(body, first + (sides - 1) * sectors, first, sectors);
}

//: Add a floor
void tf_floor_add(tf_body *body, double height, double side)
{
    int first = body->vertices;
    for (int i = 0; i < 4; i++) {
        double x = i % 2 ? side / 2 : -side / 2;
        double y = i > 1 ? side / 2 : -side / 2;
        tf_body_add_vertex(body, (const double[]){x, y, height});
    }
    tf_body_add_triangle(body, first, first + 1, first + 3);
    tf_body_add_triangle(body, first, first + 3, first + 2);
}

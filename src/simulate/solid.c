//: Include what solids need
#include "simulate/solid.h"

#include <math.h>

static const double pi = 3.141592653589793;

//: Add a ball
static void add_ball_vertices(tf_body *body, const double center[3],
                              double radius, int sectors)
{
    int rings = sectors / 2 + 1;
    for (int r = 1; r < rings; r++)
        for (int s = 0; s < sectors; s++) {
            double down = pi * r / rings, around = 2 * pi * s / sectors;
            tf_body_add_vertex(
                body, (const double[]){
                          center[0] + radius * sin(down) * cos(around),
                          center[1] + radius * sin(down) * sin(around),
                          center[2] + radius * cos(down)});
        }
    for (int end = 1; end >= -1; end -= 2)
        tf_body_add_vertex(body, (const double[]){center[0], center[1],
                                                  center[2] + end * radius});
}

void tf_ball_add(tf_body *body, const double center[3], double radius,
                 int sectors)
{
    int first = body->vertices, rings = sectors / 2 + 1;
    int top = first + (rings - 1) * sectors;
    add_ball_vertices(body, center, radius, sectors);
    for (int s = 0; s < sectors; s++) {
        int next = (s + 1) % sectors;
        for (int r = 0; r < rings - 2; r++) {
            int row = first + r * sectors, below = row + sectors;
            tf_body_add_triangle(body, row + s, below + s, row + next);
            tf_body_add_triangle(body, row + next, below + s, below + next);
        }
        int last = top - sectors;
        tf_body_add_triangle(body, top, first + s, first + next);
        tf_body_add_triangle(body, top + 1, last + next, last + s);
    }
}

//: Add a floor
void tf_floor_add(tf_body *body, double height, double side)
{
    int first = body->vertices;
    for (int i = 0; i < 4; i++)
        tf_body_add_vertex(body,
                           (const double[]){(i % 2 - 0.5) * side,
                                            (i / 2 - 0.5) * side, height});
    tf_body_add_triangle(body, first, first + 1, first + 3);
    tf_body_add_triangle(body, first, first + 3, first + 2);
}

//: Include what falls
#include "simulate/falling.h"

#include "simulate/cloth.h"
#include "simulate/solid.h"

#include <math.h>

static const tf_material cotton = {
    .density = 0.15, .stretch = 400, .bend = 2e-5};

//: Lay out a sheet
/// A horizontal square above the origin, turned about the vertical.
static void add_square(tf_body *body, int cells, double side, double height,
                       double turn)
{
    double cell = side / cells, c = cell * cos(turn), s = cell * sin(turn);
    double half = cells / 2.0;
    tf_sheet sheet = {.across = cells,
                      .along = cells,
                      .corner = {half * (s - c), -half * (s + c), height},
                      .across_step = {c, s, 0},
                      .along_step = {-s, c, 0}};
    tf_sheet_add(body, &sheet, &cotton);
}

//: Build the scene sphere
void tf_build_sphere(tf_stage *stage, int size)
{
    const double radius = 0.25, center[] = {0, 0, 0.35};
    tf_body *body = &stage->body;
    add_square(body, size, 1, center[2] + radius + 0.02, 0.3);
    int first = body->vertices;
    tf_ball_add(body, center, radius, size + 3);
    stage->handles = 1;
    stage->handle[0] = (tf_handle){.first = first,
                                   .count = body->vertices - first,
                                   .begin = 1.5,
                                   .end = 3.5,
                                   .center = {0, 0, center[2]},
                                   .axis = {0, 0, 1},
                                   .turn = 6};
    tf_floor_add(body, 0, 4);
}

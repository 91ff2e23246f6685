//: Include what falls
#include "simulate/falling.h"

#include "simulate/cloth.h"
#include "simulate/solid.h"

#include <math.h>

static const tf_material cotton = {
    .density = 0.15, .stretch = 100, .bend = 1.5e-4};

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

//: Build the scene stack
void tf_build_stack(tf_stage *stage, int size)
{
    enum {
        SHEETS = 5
    };
    const double foot[] = {0, 0, -0.3}, side = 0.6, gap = 0.06;
    for (int i = 0; i < SHEETS; i++)
        add_square(&stage->body, size, side, gap * (i + 1), 0.3 * i);
    tf_column_add(&stage->body, foot, 0.15, 0.3, size + 4, size / 2 + 1);
    tf_floor_add(&stage->body, -0.31, 4);
}

//: Lay out a chain
/// Rows that rise a little, each joined to the next one above it.
static void add_joints(tf_body *body, int links, double length)
{
    const double width = 0.5;
    int row = (int)(width / length) + 1;
    double x = -width / 2, y = 0.3, along = length;
    for (int i = 0; i <= links; i++) {
        tf_body_add_vertex(body, (const double[]){x, y});
        bool turns = i % row == row - 1;
        along = turns ? -along : along;
        x += turns ? 0 : along;
        y += turns ? 0.04 : 0.1 * length;
    }
}

/// It resists being stretched a lot, and being bent a little.
static void add_links(tf_body *body, int links, double length)
{
    const double density = 0.1, stretch = 50, bend = 2e-3;
    for (int v = 0; v < links && !body->failed; v++) {
        tf_body_add_edge(body, v, v + 1);
        tf_body_add_spring(body, v, v + 1, stretch / length);
        body->mass[v] += density * length / 2;
        body->mass[v + 1] += density * length / 2;
    }
    for (int v = 0; v + 1 < links; v++)
        tf_body_add_elastic(body,
                            &(tf_elastic){.count = 3,
                                          .vertex = {v, v + 1, v + 2},
                                          .weight = {1, -2, 1},
                                          .stiffness = bend / pow(length, 3)});
}

//: Build the scene plane-chain
static void add_box(tf_body *body)
{
    static const double corner[][2] = {
        {-0.35, 0.5}, {-0.3, 0}, {0.3, -0.02}, {0.35, 0.5}};
    int first = body->vertices;
    for (int i = 0; i < 4; i++) {
        tf_body_add_vertex(body, corner[i]);
        if (i > 0)
            tf_body_add_edge(body, first + i - 1, first + i);
    }
}

void tf_build_chain(tf_stage *stage, int size)
{
    double length = 5.0 / size;
    add_joints(&stage->body, size, length);
    add_links(&stage->body, size, length);
    add_box(&stage->body);
}

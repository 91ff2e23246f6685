//: Include what scenes of cloth need
#include "simulate/cloth_scenes.h"

#include "simulate/cloth.h"
#include "simulate/cloth_simulation.h"
#include "simulate/rope.h"
#include "simulate/solid.h"

#include <math.h>

// Kilograms per square meter, and what stretching and folds are resisted by.
#define COTTON                                                                 \
    {                                                                          \
        0.15, 300, 1.5e-4                                                      \
    }
#define RIBBON                                                                 \
    {                                                                          \
        1, 200, 1.5e-4                                                         \
    }
#define HEMP                                                                   \
    {                                                                          \
        10, 500, 0                                                             \
    }
#define SILK                                                                   \
    {                                                                          \
        0.3, 60, 1.5e-4                                                        \
    }
#define BUNTING                                                                \
    {                                                                          \
        0.2, 400, 1.5e-4                                                       \
    }

// The same of a chain, per meter.
#define STEEL                                                                  \
    {                                                                          \
        0.1, 50, 2e-3                                                          \
    }

//: Lay out a sheet
/// A horizontal square above the origin, turned about the vertical.
static void add_square(tf_scene_setup *setup, int cells, double side,
                       double height, double turn)
{
    double cell = side / cells, c = cell * cos(turn), s = cell * sin(turn);
    double half = cells / 2.0;
    tf_sheet sheet = {cells, cells,
                      .corner = {half * (s - c), -half * (s + c), height},
                      .across_step = {c, s, 0}, .along_step = {-s, c, 0}};
    tf_sheet_add(&setup->body, &sheet, &setup->scene->material);
}

//: Build the scene sphere
static void build_sphere(tf_scene_setup *setup, double cells)
{
    const double radius = 0.25, center[] = {0, 0, 0.35};
    tf_body *body = &setup->body;
    add_square(setup, (int)cells, 1, center[2] + radius + 0.02, 0.3);
    int first = body->vertices;
    tf_ball_add(body, center, radius, (int)cells + 3);
    tf_scene_setup_add_script(setup, (tf_script){first, body->vertices - first,
                                                 .begin = 1.5, .end = 3.5,
                                                 .center = {0, 0, center[2]},
                                                 .axis = {0, 0, 1}, .turn = 6});
    tf_floor_add(body, 0, 4);
}

//: Build the scene stack
static void build_stack(tf_scene_setup *setup, double cells)
{
    enum {
        SHEETS = 5
    };
    const double foot[] = {0, 0, -0.3}, side = 0.6, gap = 0.06;
    int size = (int)cells;
    for (int i = 0; i < SHEETS; i++)
        add_square(setup, size, side, gap * (i + 1), 0.3 * i);
    tf_column_add(&setup->body, foot, 0.15, 0.3, size + 4, size / 2 + 1);
    tf_floor_add(&setup->body, -0.31, 4);
}

//: Build the scene twist
static void build_twist(tf_scene_setup *setup, double cells)
{
    const double width = 0.2, cell = width / cells;
    int across = (int)cells, along = 6 * across, row = across + 1;
    tf_sheet strip = {across, along,
                      .corner = {-cell * along / 2, -width / 2, 0},
                      .across_step = {0, cell, 0}, .along_step = {cell, 0, 0}};
    tf_sheet_add(&setup->body, &strip, &setup->scene->material);
    for (int end = -1; end <= 1; end += 2)
        tf_scene_setup_add_script(
            setup, (tf_script){end < 0 ? 0 : along * row, row, .end = 3.5,
                               .axis = {1, 0, 0}, .turn = 18 * end,
                               .shift = {-0.3 * end, 0, 0}});
}

//: Build the scene knot
static void build_knot(tf_scene_setup *setup, double pairs)
{
    const double scale = 0.045, radius = 0.018;
    int sides = 2 * (int)pairs;
    tf_line line = tf_knot_line(scale, 6, 7 * radius / sides);
    tf_rope_add(&setup->body, &line, radius, sides, &setup->scene->material);
    int circles = line.points, grip = 2 * sides;
    tf_line_free(&line);
    for (int end = 0; end < 2; end++)
        tf_scene_setup_add_script(
            setup, (tf_script){end * (circles * sides - grip), grip, .end = 2.5,
                               .shift = {0, end == 0 ? 0.26 : -0.26, 0}});
}

//: Build the scene curtain
/// The cell that is pulled lies above the middle of the ring.
static void build_curtain(tf_scene_setup *setup, double cells)
{
    const double side = 1, center[] = {0, 0, -0.06};
    const double radius[] = {0.22, 0.04};
    int size = (int)cells, row = size + 1, middle = (size - 1) / 2;
    double cell = side / size, before = cell * (middle + 0.5);
    tf_sheet sheet = {size, size, .corner = {-before, -before, 0},
                      .across_step = {cell, 0, 0}, .along_step = {0, cell, 0}};
    tf_sheet_add(&setup->body, &sheet, &setup->scene->material);
    for (int i = 0; i < 2; i++)
        tf_scene_setup_add_script(
            setup, (tf_script){(middle + i) * row + middle, 2, .begin = 0.1,
                               .end = 2.8, .shift = {0, 0, -0.9}});
    tf_ring_add(&setup->body, center, radius, size + 4, size / 3 + 4);
}

//: Build the scene flag
static void build_flag(tf_scene_setup *setup, double cells)
{
    const double height = 0.6, foot[] = {0, 0, -0.3}, cell = height / cells;
    int size = (int)cells;
    tf_body *body = &setup->body;
    tf_sheet sheet = {size, 3 * size / 2, .corner = {0.03, 0, 0},
                      .across_step = {0, 0, cell}, .along_step = {cell, 0, 0}};
    tf_sheet_add(body, &sheet, &setup->scene->material);
    for (int v = 0; v <= size && !body->failed; v++)
        body->mass[v] = 0;
    tf_column_add(body, foot, 0.02, 0.95, 12, size);
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
static void add_links(tf_body *body, int links, double length,
                      const tf_material *material)
{
    for (int v = 0; v < links && !body->failed; v++) {
        tf_body_add_edge(body, v, v + 1);
        tf_body_add_spring(body, v, v + 1, material->stretch / length);
        body->mass[v] += material->density * length / 2;
        body->mass[v + 1] += material->density * length / 2;
    }
    for (int v = 0; v + 1 < links; v++)
        tf_body_add_elastic(
            body,
            &(tf_elastic){3, .vertex = {v, v + 1, v + 2}, .weight = {1, -2, 1},
                          .stiffness = material->bend / pow(length, 3)});
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

static void build_chain(tf_scene_setup *setup, double links)
{
    double length = 5 / links;
    add_joints(&setup->body, (int)links, length);
    add_links(&setup->body, (int)links, length, &setup->scene->material);
    add_box(&setup->body);
}

//: List the scenes of cloth
enum {
    MOST = 2000 // cells, and the like
};

const tf_scene tf_cloth_scenes[] = {
    {&tf_cloth_kind, .name = "sphere", .build = build_sphere,
     .material = COTTON, .shows = "cloth falls on a ball, which then turns",
     .resolution = {35, 4, MOST, "cells along a side of the cloth"},
     .steps = 400, .step = 0.01, .gravity = 9.81, .air = {.drag = 0.3},
     .friction = 0.4},
    {&tf_cloth_kind, .name = "stack", .build = build_stack, .material = COTTON,
     .shows = "sheets fall on a column, one upon the other",
     .resolution = {20, 4, MOST, "cells along a side of a sheet"}, .steps = 250,
     .step = 0.01, .gravity = 9.81, .air = {.drag = 0.3}, .friction = 0.3},
    {&tf_cloth_kind, .name = "twist", .build = build_twist, .material = RIBBON,
     .shows = "a strip whose ends are turned buckles, and winds about itself",
     .resolution = {12, 2, MOST, "cells across the strip"}, .steps = 750,
     .step = 0.005, .air = {.drag = 0.3}, .friction = 0.2},
    {&tf_cloth_kind, .name = "knot", .build = build_knot, .material = HEMP,
     .shows = "a rope with a knot is pulled tight",
     .resolution = {5, 2, MOST, "pairs of sides of the rope"}, .steps = 550,
     .step = 0.005, .air = {.drag = 0.3}, .friction = 0.2},
    {&tf_cloth_kind, .name = "curtain", .build = build_curtain,
     .material = SILK, .shows = "a sheet is drawn through a ring by its middle",
     .resolution = {35, 10, MOST, "cells along a side of the sheet"},
     .steps = 1200, .step = 0.0025, .gravity = 9.81, .air = {.drag = 0.3}},
    {&tf_cloth_kind, .name = "flag", .build = build_flag, .material = BUNTING,
     .shows = "a flag is blown about its pole, and flaps",
     .resolution = {20, 4, MOST, "cells along the pole"}, .steps = 800,
     .step = 0.005, .gravity = 9.81,
     .air = {.drag = 0.8, .wind = {5, 0, 0}, .veer = 1, .gust = 1.5},
     .friction = 0.2},
    {&tf_cloth_kind, .name = "plane-chain", .build = build_chain,
     .material = STEEL, .shows = "in the plane, a chain falls into a box",
     .resolution = {200, 40, MOST, "links of the chain"}, .steps = 400,
     .step = 0.005, .plane = true, .gravity = 9.81, .friction = 0.3},
    {0},
};

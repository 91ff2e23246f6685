//: Include what is pulled
#include "simulate/pulled.h"

#include "simulate/cloth.h"
#include "simulate/rope.h"
#include "simulate/solid.h"

//: Take hold of vertices
/// Makes vertices scripted; the handle moves them.
static void take(tf_stage *stage, tf_handle handle)
{
    for (int i = 0; i < handle.count && !stage->body.failed; i++)
        stage->body.mass[handle.first + i] = 0;
    stage->handle[stage->handles++] = handle;
}

//: Build the scene twist
void tf_build_twist(tf_stage *stage, int size)
{
    static const tf_material ribbon = {
        .density = 1, .stretch = 40, .bend = 1.5e-4};
    const double width = 0.2;
    int along = 6 * size, row = size + 1;
    double cell = width / size;
    tf_sheet strip = {.across = size,
                      .along = along,
                      .corner = {-cell * along / 2, -width / 2, 0},
                      .across_step = {0, cell, 0},
                      .along_step = {cell, 0, 0}};
    tf_sheet_add(&stage->body, &strip, &ribbon);
    for (int end = -1; end <= 1; end += 2)
        take(stage, (tf_handle){.first = end < 0 ? 0 : along * row,
                                .count = row,
                                .begin = 0,
                                .end = 3.5,
                                .axis = {1, 0, 0},
                                .turn = 18 * end,
                                .shift = {-0.3 * end, 0, 0}});
}

//: Build the scene knot
void tf_build_knot(tf_stage *stage, int size)
{
    static const tf_material hemp = {.density = 10, .stretch = 100};
    const double scale = 0.045, radius = 0.018;
    int sides = 2 * size;
    tf_line line = tf_knot_line(scale, 6, 7 * radius / sides);
    tf_rope_add(&stage->body, &line, radius, sides, &hemp);
    int circles = line.points, grip = 2 * sides;
    tf_line_free(&line);
    for (int end = 0; end < 2; end++)
        take(stage, (tf_handle){.first = end * (circles * sides - grip),
                                .count = grip,
                                .begin = 0,
                                .end = 2.5,
                                .axis = {0, 0, 1},
                                .shift = {0, end == 0 ? 0.38 : -0.38, 0}});
}

//: Build the scene curtain
/// The cell that is pulled lies above the middle of the ring.
void tf_build_curtain(tf_stage *stage, int size)
{
    static const tf_material silk = {
        .density = 0.3, .stretch = 60, .bend = 1.5e-4};
    const double side = 1, center[] = {0, 0, -0.06};
    const double radius[] = {0.22, 0.04};
    int row = size + 1, middle = (size - 1) / 2;
    double cell = side / size, before = cell * (middle + 0.5);
    tf_sheet sheet = {.across = size,
                      .along = size,
                      .corner = {-before, -before, 0},
                      .across_step = {cell, 0, 0},
                      .along_step = {0, cell, 0}};
    tf_sheet_add(&stage->body, &sheet, &silk);
    for (int i = 0; i < 2; i++)
        take(stage, (tf_handle){.first = (middle + i) * row + middle,
                                .count = 2,
                                .begin = 0.1,
                                .end = 2.8,
                                .axis = {0, 0, 1},
                                .shift = {0, 0, -0.9}});
    tf_ring_add(&stage->body, center, radius, size + 4, size / 3 + 4);
}

//: Include what the flag needs
#include "simulate/flag.h"

#include "simulate/cloth.h"
#include "simulate/solid.h"

//: Build the scene flag
void tf_build_flag(tf_stage *stage, int size)
{
    static const tf_material bunting = {
        .density = 0.2, .stretch = 60, .bend = 1.5e-4};
    const double height = 0.6, foot[] = {0, 0, -0.3};
    double cell = height / size;
    tf_sheet sheet = {.across = size,
                      .along = 3 * size / 2,
                      .corner = {0.03, 0, 0},
                      .across_step = {0, 0, cell},
                      .along_step = {cell, 0, 0}};
    tf_body *body = &stage->body;
    tf_sheet_add(body, &sheet, &bunting);
    for (int v = 0; v <= size && !body->failed; v++)
        body->mass[v] = 0;
    tf_column_add(body, foot, 0.02, 0.95, 12, size);
}

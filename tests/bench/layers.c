#include "bench/layers.h"

#include "support/generator.h"
#include "support/memory.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

enum {
    LAYERS = 10
};

/// Turns a point so that no axis is special.
static void turn(const double from[3], double scale, double to[3])
{
    static const double rotation[3][3] = {
        {2.0 / 3, -1.0 / 3, 2.0 / 3},
        {2.0 / 3, 2.0 / 3, -1.0 / 3},
        {-1.0 / 3, 2.0 / 3, 2.0 / 3},
    };
    for (int k = 0; k < 3; k++)
        to[k] = scale * (rotation[k][0] * from[0] + rotation[k][1] * from[1] +
                         rotation[k][2] * from[2]);
}

/// The vertex (i, j) of a layer, and where it goes, in edge lengths.
static void place(generator *random, int layer, int i, int j, double gap,
                  double reach, double start[3], double end[3])
{
    double wave = 6.283185307179586 / 30;
    start[0] = i + uniform(random, -0.15, 0.15);
    start[1] = j + uniform(random, -0.15, 0.15);
    start[2] = layer * gap + 4 * sin(wave * start[0] + 0.15 * layer) +
               4 * cos(wave * start[1] - 0.1 * layer) +
               uniform(random, -0.05, 0.05);
    double wind[] = {0.5 + 0.5 * sin(0.05 * start[1] + layer),
                     0.3 + 0.5 * cos(0.07 * start[0] + 2 * layer),
                     (layer % 2 ? 0.6 : -0.6) +
                         0.3 * sin(0.06 * (start[0] + start[1]))};
    for (int k = 0; k < 3; k++)
        end[k] = start[k] + reach * (wind[k] + uniform(random, -0.1, 0.1));
}

static void place_all(int n, double gap, double reach, double *start,
                      double *end)
{
    generator random = generator_new(1);
    for (int layer = 0; layer < LAYERS; layer++)
        for (int j = 0; j < n; j++)
            for (int i = 0; i < n; i++, start += 3, end += 3) {
                double from[3], to[3];
                place(&random, layer, i, j, gap, reach, from, to);
                turn(from, 1.0 / n, start);
                turn(to, 1.0 / n, end);
            }
}

/// Two triangles for each square of the grid.
static void join(int n, int *triangle)
{
    for (int layer = 0; layer < LAYERS; layer++)
        for (int j = 0; j + 1 < n; j++)
            for (int i = 0; i + 1 < n; i++, triangle += 6) {
                int v = (layer * n + j) * n + i;
                int corners[] = {v, v + 1, v + n + 1, v, v + n + 1, v + n};
                for (int c = 0; c < 6; c++)
                    triangle[c] = corners[c];
            }
}

layers layers_new(int n, double gap, double reach)
{
    int vertices = LAYERS * n * n, triangles = LAYERS * 2 * (n - 1) * (n - 1);
    double *start = allocate(3 * (size_t)vertices, sizeof *start);
    double *end = allocate(3 * (size_t)vertices, sizeof *end);
    int *triangle = allocate(3 * (size_t)triangles, sizeof *triangle);
    place_all(n, gap, reach, start, end);
    join(n, triangle);
    return (layers){.mesh = {.axes = 3,
                             .vertices = vertices,
                             .triangles = triangles,
                             .triangle = triangle},
                    .motion = {3, vertices, start, end}};
}

void layers_free(layers *cloth)
{
    free((double *)cloth->motion.start);
    free((double *)cloth->motion.end);
    free((int *)cloth->mesh.triangle);
}

// Cloth to time: ten wavy layers, one above the other, that move.
#ifndef BENCH_LAYERS_H
#define BENCH_LAYERS_H

#include "query/motion.h"
#include "surface/surface.h"

/// A mesh and a step of it.
typedef struct layers {
    tf_mesh mesh;
    tf_motion motion;
} layers;

/// Ten layers of n x n vertices, turned askew, with all that is in them at
/// random the same in every run.
/// @param gap between layers, in edge lengths
/// @param reach how far vertices move, in edge lengths
layers layers_new(int n, double gap, double reach);

void layers_free(layers *cloth);

#endif

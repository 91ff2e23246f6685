// Small meshes to make adaptive surfaces of, and the states of those surfaces.
#ifndef FUZZ_CALLS_SHAPES_H
#define FUZZ_CALLS_SHAPES_H

#include "arguments.h"

enum {
    SHAPE_VERTICES = 16,
    SHAPE_TRIANGLES = 24
};

/// A mesh and its positions.
typedef struct shape {
    tf_mesh mesh;
    int triangle[3 * SHAPE_TRIANGLES];
    double position[3 * SHAPE_VERTICES];
    bool embedded; ///< whether it is certainly an adaptive surface
    double unit;   ///< about the length of its edges
} shape;

/// Draws one: a tetrahedron, two of them that face each other, a tube with a
/// narrow waist, a sheet, or any triangles.
void shape_draw(generator *random, shape *drawn);

/// What a surface is.
typedef struct state {
    tf_mesh mesh;
    int *triangle;
    double *position;
} state;

state state_of(const tf_adaptive_surface *surface);
void state_free(state *of);

/// Whether two states are the same bits.
bool state_equals(const state *a, const state *b);

/// Makes a surface of those triangles of a state that there are.
tf_status state_copy(const state *of, tf_adaptive_surface **made);

#endif

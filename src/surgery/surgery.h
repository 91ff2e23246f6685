//: Declare surgery
#pragma once

#include "surface/buffer.h"
#include "surgery/aabb.h"
#include "surgery/adaptive.h"
#include "surgery/outcome.h"
#include "surgery/tetrahedron.h"

/// A triangle to be added.
typedef struct tf_added_triangle {
    tf_facet facet;
    tf_aabb box;
} tf_added_triangle;

/// A tetrahedron to be swept over.
typedef struct tf_swept {
    tf_tetrahedron body;
    tf_aabb box;
} tf_swept;

enum {
    TF_MOST_PLACED = 3 ///< vertices that a surgery may place
};

/// A patch of the surface that is replaced by another one, and what the surface
/// sweeps over meanwhile.
typedef struct tf_surgery {
    int removals, grafts, sweeps, rims;
    int placed;        ///< vertices, with the numbers after the last
    int settled;       ///< the first grafts, which earlier stages have added
    tf_buffer removed; ///< numbers of triangles
    tf_buffer graft;   ///< tf_added_triangle each
    tf_buffer sweep;   ///< tf_swept each
    tf_buffer rim;     ///< edges of the surface's boundary that both patches
                       ///< have: two vertices each
    int axis[2];       ///< a vertex that moves, before and after, or TF_NONE
} tf_surgery;

//: Declare how a surgery is described
/// Begins to describe a surgery, none of whose lists gets longer than `most`,
/// and makes room for it.  False if there is no memory.
bool tf_surgery_begin(tf_adaptive_surface *surface, int most);

/// Places a vertex that the surface gets if the surgery is done; returns its
/// number.
int tf_surgery_place(tf_adaptive_surface *surface, const double place[3]);

/// Removes a triangle.
void tf_surgery_remove(tf_adaptive_surface *surface, int triangle);

/// Adds a triangle.
void tf_surgery_add(tf_adaptive_surface *surface, int a, int b, int c);

/// Sweeps over a tetrahedron.
void tf_surgery_sweep(tf_adaptive_surface *surface, int a, int b, int c, int d);

/// Keeps the edge from this corner to the next.
void tf_surgery_keep(tf_adaptive_surface *surface, int corner);

/// Moves a vertex to the place of another one.
void tf_surgery_move(tf_adaptive_surface *surface, int from, int to);

void tf_surgery_free(tf_surgery *surgery);

//: Declare how a surgery is tried and done
/// Tries the surgery: what the first test to refuse it says, or TF_COMMITTED if
/// none does.  Changes nothing.
tf_outcome tf_surgery_try(tf_adaptive_surface *surface);

/// Keeps the vertices that were placed.
void tf_surgery_accept(tf_adaptive_surface *surface);

/// Replaces the one patch by the other.
void tf_surgery_commit(tf_adaptive_surface *surface);

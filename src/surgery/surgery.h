//: Declare how a surgery is described
#pragma once

#include "surgery/adaptive_surface.h"

/// Begins to describe a surgery, none of whose lists gets longer than `most`,
/// and makes room for it.  False if there is no memory.
bool tf_surgery_begin(tf_adaptive_surface *surface, int most);

/// Places a vertex that the surface gets if the surgery is done; returns its
/// number.
int tf_surgery_place(tf_adaptive_surface *surface, const double position[3]);

/// Removes a triangle.
void tf_surgery_remove(tf_adaptive_surface *surface, int triangle);

/// Adds a triangle.
void tf_surgery_add(tf_adaptive_surface *surface, int a, int b, int c);

/// Sweeps over a tetrahedron.
void tf_surgery_sweep(tf_adaptive_surface *surface, int a, int b, int c, int d);

/// Keeps the edge from this corner to the next.
void tf_surgery_keep(tf_adaptive_surface *surface, int corner);

/// Moves a vertex to where another one is.
void tf_surgery_move(tf_adaptive_surface *surface, int from, int to);

//: Declare how a surgery is done
/// Keeps the vertices that were placed.
void tf_surgery_accept(tf_adaptive_surface *surface);

/// Replaces the one patch by the other.
void tf_surgery_commit(tf_adaptive_surface *surface);

void tf_surgery_free(tf_surgery *surgery);

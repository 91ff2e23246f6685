//: Declare the stars of vertices
#pragma once

#include "surgery/adaptive_surface.h"

/// The corner at `from` of the triangle that has the edge from `from` to `to`,
/// in this direction; TF_NONE if there is none.
int tf_find_edge(const tf_adaptive_surface *surface, int from, int to);

/// Whether the edge from this corner to the next has no other triangle.
bool tf_is_boundary_edge(const tf_adaptive_surface *surface, int corner);

/// Whether all three edges of a triangle are on the boundary.
bool tf_is_isolated(const tf_adaptive_surface *surface, int triangle);

/// How many triangles a vertex has.
int tf_star_size(const tf_adaptive_surface *surface, int vertex);

/// Whether a vertex is on the boundary.
bool tf_is_boundary_vertex(const tf_adaptive_surface *surface, int vertex);

/// How many neighbors two vertices have in common.
int tf_common_neighbors(const tf_adaptive_surface *surface, int a, int b);

//: Declare how triangles come and go
/// Makes room for so many vertices and triangles, for what a surgery places,
/// and for `more` triangles more.  False if there is no memory.
bool tf_adaptive_reserve(tf_adaptive_surface *surface, int vertices,
                         int triangles, int more);

/// Links all triangles to their vertices and puts them into the tree; `box` has
/// room for one for each.  There must be no gaps.  False if the caller cancels.
bool tf_stars_build(tf_adaptive_surface *surface, tf_aabb box[]);

/// Adds a triangle, for which there is room; returns its number.
int tf_triangle_add(tf_adaptive_surface *surface, const int vertex[3]);
void tf_triangle_remove(tf_adaptive_surface *surface, int triangle);

/// Puts a vertex elsewhere, untested.
void tf_vertex_put(tf_adaptive_surface *surface, int vertex,
                   const double position[3]);

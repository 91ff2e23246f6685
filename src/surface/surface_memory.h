//: Declare what a surface holds
#pragma once

#include "base/error.h"
#include "base/watch.h"
#include "surface/box.h"
#include "surface/elements.h"
#include "surface/mesh.h"
#include "surface/pair_filter.h"
#include "surface/tree.h"
#include "surface/workers.h"

typedef struct tf_surface {
    int axes, vertices;
    tf_elements edges, triangles;
    tf_pair_filter filter; ///< with a copy of the groups, in `groups`
    tf_buffer groups;
    const double *inverse_mass; ///< of the vertices: pairs whose vertices all
        ///< have 0 are left out, too; NULL: no such pair
    const int *zone[3]; ///< of the vertices, edges and triangles: pairs of two
        ///< elements in one are left out, too; below 0: in none;
        ///< NULL: no such pair
    tf_buffer zones; ///< of the vertices and edges
    tf_frame frame;  ///< of the paths
    tf_buffer paths; ///< of the vertices
    tf_tree vertex_tree, edge_tree, triangle_tree;
    tf_tree_workspace tree_workspace;
    tf_sort_workspace sort_workspace; ///< of the elements
    tf_workers workers; ///< with the watch over the call that they work for
    tf_buffer task_rows, task_places; ///< of the tasks that list candidates
    tf_buffer enlarged; ///< positions around those of a search of near pairs
    tf_buffer found;    ///< what was found last, lent to the caller
    tf_buffer sorting;  ///< of these rows
} tf_surface;

/// Gives a surface another mesh, which is good, in memory that is kept; nothing
/// of the last mesh is left.  False if there is no memory: then the surface
/// needs another mesh before it is used.
bool tf_surface_refill(tf_surface *surface, const tf_mesh *mesh);

//: Declare how a surface moves
/// Builds the trees for one step.  They are swept (tf_tree_elements) where the
/// caller says so, or where most of what moves is calm: then that costs less.
/// Sets the error to what it returns: TF_OK;
/// TF_BAD_ENVIRONMENT; TF_BAD_AXES or TF_BAD_COUNT if the motion has other axes,
/// or another number of vertices; TF_NOT_FINITE about a vertex;
/// TF_OUT_OF_MEMORY; or TF_CANCELLED.
tf_status tf_surface_move(tf_surface *surface, const tf_motion *motion,
                          bool swept, const tf_parallel *parallel,
                          tf_error *error);

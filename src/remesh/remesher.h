//: Hold a remeshing
#pragma once

#include "remesh/measure.h"
#include "remesh/original.h"
#include "remesh/remesh.h"

/// An edge to look at.
typedef struct tf_edge_row {
    double length;
    int a, b;
} tf_edge_row;

/// A surface that is being remeshed.
typedef struct tf_remesher {
    tf_adaptive_surface *surface;
    tf_original original;
    double edge; ///< the length that is wanted
    const tf_remesh_options *options;
    tf_remesh_report *report;
    tf_buffer row; ///< tf_edge_row each
    int rows;
} tf_remesher;

//: Declare the passes
/// Each goes once through the surface, and returns TF_OK or what went wrong.
tf_status tf_split_pass(tf_remesher *remesher);
tf_status tf_collapse_pass(tf_remesher *remesher);
tf_status tf_flip_pass(tf_remesher *remesher);
tf_status tf_smooth_pass(tf_remesher *remesher);

//: Declare what the passes have in common
/// Lists the edges whose length is at least `low` and at most `high`, the
/// shortest first.  False if there is no memory.
bool tf_remesher_list(tf_remesher *remesher, double low, double high);

/// Counts what became of an operation, and shows progress.
void tf_remesher_count(tf_remesher *remesher, tf_operation operation,
                       tf_outcome outcome);

/// The nearest point of the original if it is nearer than the wanted length, or
/// else the point itself.
tf_vector tf_remesher_project(tf_remesher *remesher, tf_vector point);

/// Whether the triangles at a vertex, but for those at `other` too, would be
/// good if it were at `place`: not turned over, and no worse than the worst that
/// there is now or a fair triangle.
bool tf_star_stays_good(const tf_remesher *remesher, int vertex, int other,
                        tf_vector place);

//: Declare what is wanted of operations
/// Whether no edge would be longer than `most` that leads from a vertex to
/// another one than `other`, if it were at `place`.
bool tf_edges_stay_short(const tf_adaptive_surface *surface, int vertex,
                         int other, tf_vector place, double most);

/// The triangles on an edge, and those on the other diagonal.
typedef struct tf_diagonals {
    tf_shape own[2], other[2];
} tf_diagonals;

/// Those on the edge of two corners, forth and back.
tf_diagonals tf_diagonals_of(const tf_adaptive_surface *surface, int forth,
                             int back);

/// Whether a flip bends the surface little.
bool tf_diagonals_agree(const tf_diagonals *diagonals);

/// The mean of the middles of the triangles at a vertex, weighted by their
/// areas.
tf_vector tf_star_middle(const tf_adaptive_surface *surface, int vertex);

/// Whether a place is far enough from a vertex to be worth a move.
bool tf_is_worth_a_move(const tf_remesher *remesher, int vertex,
                        tf_vector place);

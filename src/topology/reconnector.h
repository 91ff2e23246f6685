//: Hold a reconnection
#pragma once

#include "remesh/measure.h"
#include "surgery/state.h"
#include "topology/reconnect.h"

/// Two edges that face each other.
typedef struct tf_facing_edges {
    double distance;
    int first[2], second[2]; ///< their ends
} tf_facing_edges;

/// A surface that is being reconnected.  What follows the report begins empty.
typedef struct tf_reconnector {
    tf_adaptive_surface *surface;
    tf_reconnect_options options; ///< all lengths as they are, and the volume
    tf_reconnect_report *report;
    tf_buffer row; ///< what there is to do
    int rows;
    tf_buffer normal; ///< tf_vector each: of the edge from each corner on
    tf_buffer piece;  ///< of each vertex: another one of its piece, or TF_NONE
} tf_reconnector;

void tf_reconnector_free(tf_reconnector *reconnector);

//: Declare the passes of a reconnection
/// Each goes once through the surface, and returns TF_OK or what went wrong.
tf_status tf_merge_pass(tf_reconnector *reconnector);
tf_status tf_pinch_pass(tf_reconnector *reconnector);
tf_status tf_drop_pass(tf_reconnector *reconnector);

//: Declare what reconnections have in common
/// Counts what became of an operation, and what volume it gained.
void tf_reconnector_count(tf_reconnector *reconnector, tf_reconnection what,
                          tf_outcome outcome, double gained);

/// The volume between the triangles at some vertices and the place of the first
/// one; for the change when these triangles change.
double tf_volume_at(const tf_adaptive_surface *surface, int count,
                    const int vertex[]);

/// The volume between a triangle and a point.
double tf_volume_below(const tf_adaptive_surface *surface, int triangle,
                       tf_vector point);

//: Declare contacts
/// Lists the pairs of edges that face each other at less than a distance, the
/// nearest first: their normals are more than 120 degrees apart, and each is on
/// the outer side of the other.  False if there is no memory.
bool tf_list_facing(tf_reconnector *reconnector, double distance);

/// Divides the vertices near the listed edges, up to their neighbors, into
/// pieces that are connected on the surface.  False if there is no memory.
bool tf_find_pieces(tf_reconnector *reconnector);

/// The vertex that stands for the piece of another one.
int tf_piece_of(tf_reconnector *reconnector, int vertex);

/// Makes one piece of two.
void tf_unite_pieces(tf_reconnector *reconnector, int a, int b);

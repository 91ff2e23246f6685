//: Hold a reconnection
#pragma once

#include "base/status.h"
#include "geometry/vector.h"
#include "surface/sort.h"
#include "topology/component.h"
#include "topology/options.h"

/// How to reconnect, in the surface's own unit; what is never done has 0.
typedef struct tf_reconnect_lengths {
    double merge, patch, pinch;
    double apart; ///< how far a pinch moves its two sides apart
    double drop;  ///< a volume
} tf_reconnect_lengths;

/// A surface that is being reconnected.  What follows the report begins empty.
typedef struct tf_reconnector {
    tf_adaptive_surface *surface; ///< with the watch over the call
    tf_reconnect_lengths lengths;
    tf_reconnect_report report;
    tf_buffer candidate; ///< for a merge, tf_facing_edges each, or for a pinch
    int candidates;
    tf_buffer normal; ///< tf_vector each: of the edge from each corner on
    tf_buffer piece;  ///< of each vertex: another one of its piece, or TF_NONE
    tf_components components; ///< for drops
    tf_sort_memory sorting;   ///< of the candidates
} tf_reconnector;

void tf_reconnector_free(tf_reconnector *reconnector);
size_t tf_reconnector_memory(const tf_reconnector *reconnector);

//: Declare what reconnections have in common
/// Counts what became of an operation, and what volume it gained.
void tf_reconnector_count(tf_reconnector *reconnector, tf_reconnection what,
                          tf_outcome outcome, double gained);

/// Sorts the candidates, of that size.  Returns TF_OK, TF_OUT_OF_MEMORY or
/// TF_CANCELLED.
tf_status tf_reconnector_sort(tf_reconnector *reconnector, size_t size,
                              tf_precedes *precedes);

/// The volume between the triangles at some vertices and the position of the
/// first one; for the change when these triangles change.
double tf_volume_at(const tf_adaptive_surface *surface, int count,
                    const int vertex[]);

/// The volume between a triangle and a point.
double tf_volume_below(const tf_adaptive_surface *surface, int triangle,
                       tf_vector point);

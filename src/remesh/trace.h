//: Declare traces to the original
#pragma once

#include "remesh/original.h"
#include "remesh/origins.h"
#include "remesh/sharp_edges.h"

/// Where the vertices of a surface come from on its original, and the memory for
/// finding that.
typedef struct tf_trace {
    const tf_original *original; ///< NULL: nobody wants to know
    const tf_sharp_edges *sharp; ///< of the original
    tf_buffer origin;            ///< tf_origin of each vertex
    tf_buffer visited; ///< of each vertex of the original, and then of each
                       ///< triangle: the last search that has visited it
    tf_buffer reached; ///< vertices of the original: those of a search
    int search;        ///< its number
} tf_trace;

/// Begins with a copy of the original.  False if there is no memory; free the
/// trace in any case.
bool tf_trace_begin(tf_trace *trace, const tf_original *original,
                    const tf_sharp_edges *sharp);
void tf_trace_free(tf_trace *trace);

/// Whether it has begun.
static inline bool tf_trace_goes(const tf_trace *trace)
{
    return trace->original;
}

//: Declare how a vertex is traced
/// A vertex that has been placed, or moved.
typedef struct tf_placement {
    int vertex;
    int from[2]; ///< vertices near which it was on the same sheet: the ends of
                 ///< an edge, or twice the vertex itself
    bool sharp;  ///< whether it was placed on a sharp edge, or on the boundary
    const tf_projection
        *projection; ///< the last one; that of the vertex, if it
                     ///< is where the vertex is
} tf_placement;

/// Moves a point between two vertices on sharp edges to the nearest point of the
/// original's.  False if there is none near, and then the point stays.
bool tf_trace_sharp_point(tf_trace *trace, const tf_adaptive_surface *surface,
                          const int between[2], tf_vector *point);

/// Finds out where a vertex comes from.  False if there is no memory.
bool tf_trace_place(tf_trace *trace, const tf_adaptive_surface *surface,
                    const tf_placement *placed);

/// Closes the gaps between so many vertices: vertex v becomes map[v], or is gone.
void tf_trace_compact(tf_trace *trace, int vertices, const int map[]);

//: Declare what remeshing does
#pragma once

#include "base/api.h"
#include "base/progress.h"
#include "surgery/outcome.h"

#include <stddef.h>

/// @addtogroup adaptive
/// @{

/// The operations of which remeshing is made.
typedef enum tf_operation {
    TF_SPLIT = 0,     ///< of long edges
    TF_COLLAPSE,      ///< of short edges
    TF_FLIP,          ///< to better triangles
    TF_SMOOTH,        ///< a move along the surface
    TF_OPERATIONS = 8 ///< room for those of later versions
} tf_operation;

/// What remeshing has done.  Lengths are as those of the positions.  Lent; later
/// versions may add to its end.
typedef struct tf_remesh_report {
    int rounds; ///< how many there were
    /// How often an operation was tried, by its outcome; those that would make
    /// poor triangles are not even tried.
    size_t tried[TF_OPERATIONS][TF_OUTCOMES];
    /// The least quality of a triangle before, from 0, which is collinear, to
    /// 1, which is equilateral; 1 if there are no triangles.
    double least_before;
    double least_after; ///< the same of the new surface
    double mean_before; ///< the mean quality of the triangles before
    double mean_after;  ///< the same of the new surface
    double distance;    ///< the greatest that was found from a point of the new
                        ///< surface to the old one, or from the old to the new
    double most_distance; ///< no point of either surface is farther from the
                          ///< other one, up to rounding
} tf_remesh_report;

//: Declare how to remesh
/// How to remesh.
typedef struct tf_remesh_options {
    size_t size; ///< sizeof(tf_remesh_options); 0: that of version 1.0
    double edge; ///< the length that edges should have, above 0; with `lengths`
                 ///< or `error` the greatest, and 0: as long as they allow
    int rounds;  ///< how often to go through all operations; 0: 5; negative:
                 ///< not at all
    tf_progress *progress; ///< NULL: nothing is told
    void *context;         ///< passed on to `progress`
    double crease; ///< an edge is sharp if the normals of its two triangles are
                   ///< further apart than this, in degrees; 0: 25; at most 180,
                   ///< and then only boundaries and kept edges are
    int keeps;     ///< how many kept edges there are, 0 or more
    const int *keep; ///< of each kept edge its two vertices: it is sharp, too;
                     ///< twice the same vertex: that is a corner
    const double *lengths; ///< of each vertex, above 0: the length that edges
                           ///< near it should have, or less where this changes
                           ///< by more than half of the distance; NULL: `edge`
    double error; ///< how far the new surface may be from the old one, or the
                  ///< old from the new, at most; triangles are as large as
                  ///< that allows; at least 2^-36 of the diagonal of the box
                  ///< around the surface; 0: as their edges say
} tf_remesh_options;

/// @}

//: Declare how changes of positions are gathered
#pragma once

#include "untangle/tangle.h"

/// By how much vertices are to move: of each a weighted mean of what is proposed.
typedef struct tf_change {
    tf_vector *move;  ///< of each vertex; first a sum, then a mean
    double *weight;   ///< of each vertex; 0: nothing is proposed
    tf_vector *other; ///< room for as many moves
    tf_buffer storage, marks;
} tf_change;

/// Begins with no proposals; false if there is no memory.
bool tf_change_begin(tf_change *change, const tf_tangle *tangle);

void tf_change_free(tf_change *change);

/// Proposes a move of a vertex, unless it is fixed: `length` along `direction`.
void tf_change_add(tf_change *change, const tf_tangle *tangle, int vertex,
                   tf_vector direction, double length, double weight);

/// Takes the means, none longer than half of the edges at its vertex, and lets
/// them spread over the surface.  False if the caller cancels.
bool tf_change_finish(tf_change *change, const tf_tangle *tangle);

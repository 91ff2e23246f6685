//: Declare sizes that vary
#pragma once

#include "remesh/remesher.h"

/// The target lengths at the vertices of the original.
typedef struct tf_sizes {
    tf_buffer target; ///< double each
    tf_buffer error;  ///< double of each triangle, of one surface or the other
    tf_buffer worst;  ///< double of each vertex
} tf_sizes;

void tf_sizes_free(tf_sizes *sizes);

/// Begins with given lengths, in the user's unit, which become shorter where
/// they would change too fast: between two vertices by more than half of their
/// distance.  False if there is no memory, or if the caller cancels.
bool tf_sizes_begin(tf_sizes *sizes, tf_remesher *remesher,
                    const double edge[]);

/// Begins with lengths for which triangles on curved parts are about that far
/// from the original.  False if there is no memory, or if the caller cancels.
bool tf_sizes_begin_for(tf_sizes *sizes, tf_remesher *remesher, double error);

/// Makes lengths shorter where the surfaces are further apart than `error`, and
/// unless `shrink` longer where they are nearer.  Sets how far they are apart at
/// most.  Returns TF_OK, TF_OUT_OF_MEMORY or TF_CANCELLED.
tf_status tf_sizes_adapt(tf_sizes *sizes, tf_remesher *remesher, double error,
                         bool shrink, double *most);

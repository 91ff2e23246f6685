// A surface that is being remeshed.
#ifndef SUPPORT_REMESHING_H
#define SUPPORT_REMESHING_H

#include "remesh/policy.h"

/// Begins to remesh a surface, which it then owns, to edges of that length.
tf_remesher *remeshing_begin(tf_adaptive_surface *surface,
                             const tf_remesh_policy *policy, double edge);
void remeshing_end(tf_remesher *remesher);

/// How often an operation was done, and refused.
int done(const tf_remesher *remesher, tf_operation operation);
int refused(const tf_remesher *remesher, tf_operation operation);

/// The lengths of the shortest and the longest edge.
double shortest_edge(const tf_adaptive_surface *surface);
double longest_edge(const tf_adaptive_surface *surface);

#endif

// A surface that is being remeshed.
#ifndef SUPPORT_REMESHERS_H
#define SUPPORT_REMESHERS_H

#include "remesh/policy.h"

/// Begins to remesh a surface, which it then owns, to edges of that length.
tf_remesher *remesher_begin(tf_adaptive_surface *surface,
                            const tf_remesh_policy *policy, double edge);
void remesher_end(tf_remesher *remesher);

/// How often an operation was done, and refused.
int done(const tf_remesher *remesher, tf_operation operation);
int refused(const tf_remesher *remesher, tf_operation operation);

/// The lengths of the shortest and the longest edge.
double shortest_edge(const tf_adaptive_surface *surface);
double longest_edge(const tf_adaptive_surface *surface);

#endif

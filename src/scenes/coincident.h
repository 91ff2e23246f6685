//: Declare how coincident vertices are found
#pragma once

#include <stdbool.h>

/// Finds for each vertex, in their order, the one that it coincides with: the
/// nearest of the vertices before it that coincide with none, if that is not
/// farther than `within`, the first of several; or itself.  So of any two
/// vertices that are left one is farther than that from the other, and no vertex
/// moves farther if it is replaced.  The time grows with the number of vertices.
/// @param position three finite coordinates each
/// @param within 0: only at exactly the same position (-0 and 0 are the same);
///     else at least tf_least_within
/// @param[out] first of each vertex; itself, if it coincides with none
/// @return false: there is no memory
bool tf_find_coincident(int vertices, const double position[], double within,
                        int first[]);

/// The least distance above 0 for positions: 2^-50 of their greatest coordinate.
double tf_least_within(int vertices, const double position[]);

/// The distance of two positions, without overflow on the way.
double tf_distance_between(const double x[3], const double y[3]);

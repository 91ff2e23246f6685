//: Declare the edges that face each other
#pragma once

#include "topology/reconnector.h"

/// Two edges that face each other.
typedef struct tf_facing_edges {
    double distance;
    int first[2], second[2]; ///< their ends
} tf_facing_edges;

/// Lists the pairs of edges that face each other at less than a distance, the
/// nearest first: their normals are more than 120 degrees apart, and each is on
/// the outer side of the other.  Returns TF_OK, TF_OUT_OF_MEMORY or
/// TF_CANCELLED.
tf_status tf_list_facing(tf_reconnector *reconnector, double distance);

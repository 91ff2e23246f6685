//: Declare the features of two elements
#pragma once

#include "arithmetic/wide.h"
#include "geometry/vector.h"
#include "query/kind.h"

#include <stdbool.h>

/// What may hold the nearest points of two elements.
typedef enum tf_feature_kind {
    TF_TWO_VERTICES,
    TF_VERTEX_AND_EDGE,
    TF_VERTEX_AND_TRIANGLE,
    TF_TWO_EDGES,
} tf_feature_kind;

/// A vertex, an edge or a triangle of each of two elements, by the places of its
/// vertices in the list of both elements' vertices, the first element's first.
typedef struct tf_features {
    tf_feature_kind kind;
    int place[4];
} tf_features;

/// The features that may hold the nearest points of two elements of a kind;
/// returns how many there are.
int tf_features_of(tf_kind kind, const tf_features **features);

//: Declare exact vertices
/// The vertices of two elements, in units of 2^unit.
typedef struct tf_exact_vertices {
    int unit;
    tf_wide x[4][TF_AXES];
} tf_exact_vertices;

/// Sets the vertices of two elements in the greatest unit that divides all of
/// their coordinates and also a length.
void tf_exact_vertices_set(tf_kind kind, const double *const x[], double length,
                           tf_exact_vertices *exact);

//: Declare the distance of two features
/// The square of a distance is square / scale, in squares of the unit.
typedef struct tf_feature_distance {
    tf_wide square, scale;
    double
        weight[4]; ///< of the vertices in the nearest points, by their places
                   ///< in the elements
} tf_feature_distance;

/// Finds the distance of the points, lines or planes that two features lie in.
/// False if their nearest points are not inside both features, or are not
/// unique: then other features hold the nearest points of the elements.
bool tf_feature_distance_find(const tf_exact_vertices *exact,
                              const tf_features *features,
                              tf_feature_distance *found);

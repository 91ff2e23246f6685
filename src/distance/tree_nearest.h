//: Declare a tree of facets
#pragma once

#include "geometry/vector.h"
#include "surface/buffer.h"

/// Facets, triangles or in the plane edges, chosen among those of a surface.
/// All arrays are borrowed.  Coordinates are of a size of about 1: squares of
/// them neither overflow nor vanish.
typedef struct tf_chosen_facets {
    int axes;          ///< 2 or 3
    int count;         ///< how many are chosen
    const int *chosen; ///< the numbers of these; NULL: the first ones
    const int *corner; ///< of each facet of the surface: `axes` vertices
    const double *x;   ///< `axes` coordinates of each vertex
} tf_chosen_facets;

/// A box with sides along the axes.
typedef struct tf_tree_box {
    double low[TF_AXES], high[TF_AXES];
} tf_tree_box;

/// A binary tree of boxes around facets in Morton order.  Node i is around the
/// nodes 2 i and 2 i + 1; the root is 1, and the leaves are the last half of
/// all nodes.
typedef struct tf_nearest_tree {
    tf_chosen_facets facets;
    int leaves;       ///< a power of two
    int *place;       ///< in Morton order: a place in the list of the chosen
    tf_tree_box *box; ///< of each node
    double slack;     ///< more than what rounding adds to a distance
    tf_buffer keys, sorted, counts, places, boxes;
} tf_nearest_tree;

//: Declare where a point is nearest to facets
/// The point of a facet that is nearest to some point.
typedef struct tf_landing {
    int place;        ///< the facet's in the list of the chosen; -1: none
    int facet;        ///< its number
    double weight[3]; ///< barycentric coordinates
    tf_vector out;    ///< the vector from there to the point
    double distance;  ///< the length of that
} tf_landing;

/// Builds the tree anew, in memory that is kept.  False if there is not enough.
bool tf_nearest_tree_build(tf_nearest_tree *tree,
                           const tf_chosen_facets *facets);

/// Frees the memory that only building takes.
void tf_nearest_tree_trim(tf_nearest_tree *tree);

void tf_nearest_tree_free(tf_nearest_tree *tree);

/// The facets of a leaf: those at place[begin] to place[end - 1].
void tf_nearest_tree_leaf(const tf_nearest_tree *tree, int leaf, int *begin,
                          int *end);

/// Finds where a point is nearest to a facet that does not have the vertex
/// `without`, which may be -1; of several facets at the same distance, as it is
/// computed, the first of the list.
tf_landing tf_nearest_landing(const tf_nearest_tree *tree, tf_vector point,
                              int without);

/// Where a point is nearest to the facet at a place of the list.
tf_landing tf_land(const tf_chosen_facets *facets, tf_vector point, int place);

// Queries as scenes: flat lists of coordinates, and indices.
#ifndef SUPPORT_SCENES_H
#define SUPPORT_SCENES_H

#include "query/motion.h"
#include "support/queries.h"

enum {
    SCENE_VERTICES = 6
};

/// The vertices of a query among those of a scene; the others rest at the
/// origin.
typedef struct scene {
    int axes;
    int index[QUERY_VERTICES]; ///< of the query's vertices, in its order
    double start[SCENE_VERTICES * TF_AXES], end[SCENE_VERTICES * TF_AXES];
} scene;

/// The i-th vertex of the query gets the index[i], below SCENE_VERTICES.
scene scene_of(const query *q, const int index[]);

/// Refers to the scene.
tf_motion scene_motion(const scene *s);

/// A query whose coordinates are integers, with a generic contact at t = 1/2.
query scene_hit(query_kind kind);

#endif

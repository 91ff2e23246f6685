// The judge of a surface at rest: where do its elements intersect or touch?
// Exactly, and sharing nothing with src/ but the declaration of a mesh.
#ifndef SUPPORT_TANGLE_H
#define SUPPORT_TANGLE_H

#include "surface/mesh.h"

#include <stdbool.h>

/// How two elements at rest meet.
typedef enum tangle_kind {
    EDGE_PIERCES_TRIANGLE, ///< in space: inside meets inside, across the plane
    POINT_IN_TRIANGLE,     ///< in space: on the triangle or its border
    EDGES_MEET,            ///< in one point or more
    POINT_IN_EDGE,         ///< in the plane
} tangle_kind;

/// Two elements that share no vertex, and meet.
typedef struct tangle {
    tangle_kind kind;
    int vertex[5]; ///< as those of a tf_crossing; -1 where there is none
} tangle;

/// What to judge, and room for what is found.
typedef struct tangle_judge tangle_judge;

/// Copies the mesh.
tangle_judge *tangle_judge_new(const tf_mesh *mesh);
void tangle_judge_free(tangle_judge *judge);

/// Has the judge leave out what nothing can be done about: pairs of a step whose
/// vertices all have an inverse mass of 0, and pairs at rest of a vertex more if
/// without one of their vertices all others have.  The masses are borrowed.
void tangle_judge_script(tangle_judge *judge, const double inverse_mass[]);

/// Judges the pairs of elements whose boxes overlap, which are found by a sweep
/// along one axis; returns how many tangles there are.
int tangle_count(tangle_judge *judge, const double position[]);

/// The same by trying every pair.
int tangle_count_all(tangle_judge *judge, const double position[]);

/// Counts the pairs of a vertex and a triangle and of two edges, in the plane of
/// a vertex and an edge, that meet during a step, by the oracle: slow.
int tangle_count_in_step(tangle_judge *judge, const double start[],
                         const double end[]);

/// What the last count has found, sorted by kind, then by vertices.
const tangle *tangles(const tangle_judge *judge);

/// The tangle in words.  Static storage.
const char *tangle_text(const tangle *found);

#endif

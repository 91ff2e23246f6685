// Small scenes of position-based dynamics that know nothing of collisions: what
// a simulation proposes, step by step.  Lengths are in edges of the cloth.
#ifndef SUPPORT_CLOTH_H
#define SUPPORT_CLOTH_H

#include "surface/mesh.h"

typedef enum cloth_scene {
    CHAIN,         ///< in the plane: falls end first, and piles up
    SPHERE,        ///< falls on a ball, and folds on the floor below
    STACK_ALIGNED, ///< six sheets fall on a ball, vertex above vertex
    STACK_TURNED,  ///< each of the sheets turned a little more
    TWIST,         ///< a strip, turned at both ends
    NARROW_TWIST   ///< a narrow strip, which jams
} cloth_scene;

enum {
    CLOTH_SCENES = NARROW_TWIST + 1
};

/// What each scene is called.
extern const char *const cloth_names[CLOTH_SCENES];

typedef struct spring {
    int vertex[2];
    double length, stiffness; ///< the part of what is amiss that a visit mends
} spring;

typedef struct cloth_model {
    tf_mesh mesh;         ///< lent, as are the arrays below
    double *position;     ///< of the vertices
    double *velocity;     ///< the last step's displacements, damped
    double *inverse_mass; ///< 0: the vertex is scripted, or at rest
    int springs;
    spring *spring;
    double turn; ///< of scripted vertices about the first axis, by a step, in
                 ///< one sense where it is positive, else in the other
} cloth_model;

/// The scene at its start.
/// @param n edges of the cloth: along a side, along the chain, across a strip
///     TWIST
cloth_model *cloth_new(cloth_scene scene, int n);
void cloth_free(cloth_model *cloth);

/// Where the vertices should be after a step, if nothing were in their way.
void cloth_propose(const cloth_model *cloth, double end[]);

/// Goes on from where the vertices are after all, with the velocities of where
/// they would be without pushes.
void cloth_accept(cloth_model *cloth, const double unpushed[],
                  const double end[]);

#endif

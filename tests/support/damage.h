// Scenes that are damaged, and what meets in them.
#ifndef SUPPORT_DAMAGE_H
#define SUPPORT_DAMAGE_H

#include "support/adaptive_scenes.h"
#include "support/tangle.h"

/// Damages a scene: another triangle on an edge, or one there twice; a vertex on
/// another one, or made the same; a triangle divided on one side only, or turned
/// over.
void damage(generator *random, adaptive_scene *scene);

/// Lists what meets in a surface, by the judge, but for vertices of no triangle;
/// returns how many, at most `most`.
int tangles_of(const tf_adaptive_surface *surface, int most, tangle found[]);

#endif

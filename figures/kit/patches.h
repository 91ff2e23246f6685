// Patches of surfaces in space, and what lies between them.
#ifndef FIG_PATCHES_H
#define FIG_PATCHES_H

#include "renderer/scene.h"

/// Draws some triangles, three places each.
void fig_patch_triangles(fig_scene *scene, const tf_vector at[], int count,
                         const int triangle[][3], fig_paint paint);

/// Draws a closed polygon as a tube.
void fig_patch_outline(fig_scene *scene, const tf_vector at[], int count,
                       const int corner[], fig_paint paint);

/// Draws the faces of a tetrahedron.
void fig_patch_body(fig_scene *scene, const tf_vector at[], const int corner[4],
                    fig_paint paint);

/// Draws a swept tetrahedron, faintly.
void fig_patch_swept(fig_scene *scene, const tf_vector at[],
                     const int corner[4]);

#endif

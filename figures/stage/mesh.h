// Triangles for the graphics card, made from the parts of a scene.
#ifndef TF_STAGE_MESH_H
#define TF_STAGE_MESH_H

#include "stage/camera.h"
#include "stage/scene_parts.h"
#include "stage/theme.h"

/// A corner of a triangle.
typedef struct tf_vertex {
    float at[3];     ///< world units from the view's center
    float normal[3]; ///< of length 1, to either side
    float color[4];  ///< in linear light, and opacity; the opacity of a solid
                     ///< thing that is wide enough to stand off what it passes
                     ///< in front of is 1, of another 1/2
} tf_vertex;

typedef struct tf_mesh {
    tf_vertex *vertices; ///< three a triangle; the opaque triangles first
    int count, room;
    int opaque; ///< how many vertices are of opaque triangles
    bool out_of_memory;
} tf_mesh;

/// Make the triangles of a scene as `view` sees it.  The caller frees
/// `vertices`.
tf_mesh tf_mesh_of(const tf_scene *scene, const tf_view *view,
                   const tf_theme *theme);

#endif

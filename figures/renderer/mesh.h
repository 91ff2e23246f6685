// Triangles for the graphics card, made from the parts of a scene.
#ifndef FIG_RENDERER_MESH_H
#define FIG_RENDERER_MESH_H

#include "renderer/camera.h"
#include "renderer/scene_parts.h"
#include "renderer/theme.h"

/// A corner of a triangle.
typedef struct fig_vertex {
    float at[3];     ///< world units from the view's center
    float normal[3]; ///< of length 1, to either side; zero: lit already
    float color[4];  ///< in linear light, and opacity; the opacity of a solid
                     ///< thing that is wide enough to stand off what it passes
                     ///< in front of is 1, of another 1/2
    float level;     ///< dot(normal, at) on the plane of a flat translucent
                     ///< triangle, the same for all that lie in one plane;
                     ///< FIG_NO_LEVEL: there is no such plane
} fig_vertex;

#define FIG_NO_LEVEL 1e30F

typedef struct fig_mesh {
    fig_vertex *vertices; ///< three a triangle; the opaque triangles first
    int count, room;
    int opaque; ///< how many vertices are of opaque triangles
    bool out_of_memory;
} fig_mesh;

/// Make the triangles of a scene as `view` sees it.  The caller frees
/// `vertices`.
fig_mesh fig_mesh_of(const fig_scene *scene, const fig_view *view,
                     const fig_theme *theme);

#endif

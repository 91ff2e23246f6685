//: Include what the memory of surfaces needs
#include "surface/surface_memory.h"

#include "base/environment.h"
#include "base/require.h"
#include "surface/derive.h"

//: Refill a surface
bool tf_surface_refill(tf_surface *surface, const tf_mesh *mesh)
{
    tf_sort_workspace *workspace = &surface->sort_workspace;
    surface->axes = mesh->axes;
    surface->vertices = mesh->vertices;
    return tf_mesh_triangles(mesh, &surface->triangles, workspace) &&
           tf_mesh_edges(mesh, &surface->triangles, &surface->edges, workspace);
}

//: Build the tree of one kind of element
static bool build_tree(tf_surface *surface, tf_tree *tree,
                       tf_tree_elements *elements, int count, int corners,
                       const int *corner, const tf_parallel *parallel)
{
    elements->count = count;
    elements->corners = corners;
    elements->corner = corner;
    return tf_tree_build(tree, elements, &surface->tree_workspace, parallel);
}

//: Build all trees
static tf_status build_trees(tf_surface *surface, const tf_parallel *parallel)
{
    const tf_box *box = surface->boxes.data;
    tf_tree_elements elements = {.vertex = box, .whole = &surface->frame.whole};
    const tf_elements *edges = &surface->edges;
    const tf_elements *triangles = &surface->triangles;
    bool good = build_tree(surface, &surface->vertex_tree, &elements,
                           surface->vertices, 1, NULL, parallel) &&
                build_tree(surface, &surface->edge_tree, &elements,
                           edges->count, 2, edges->corner, parallel) &&
                build_tree(surface, &surface->triangle_tree, &elements,
                           triangles->count, 3, triangles->corner, parallel);
    return good ? TF_OK : TF_OUT_OF_MEMORY;
}

//: Move a surface
tf_status tf_surface_move(tf_surface *surface, const tf_motion *motion,
                          const tf_parallel *parallel, tf_flaw *flaw)
{
    TF_REQUIRE(motion && motion->start && motion->end);
    *flaw = (tf_flaw){.element = TF_NO_ELEMENT};
    if (!tf_environment_is_ieee())
        return TF_BAD_ENVIRONMENT;
    if (motion->vertices != surface->vertices)
        return TF_BAD_COUNT;
    int bad = 0;
    tf_status status =
        tf_frame_of(surface->axes, motion, parallel, &surface->frame, &bad);
    if (status != TF_OK) {
        *flaw = (tf_flaw){TF_VERTEX, bad, bad};
        return status;
    }
    if (!tf_buffer_reserve(&surface->boxes, (size_t)surface->vertices,
                           sizeof(tf_box)))
        return TF_OUT_OF_MEMORY;
    tf_vertex_boxes(&surface->frame, motion, parallel, surface->boxes.data);
    return build_trees(surface, parallel);
}

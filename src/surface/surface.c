//: Include what surfaces need
#include "surface/state.h"

#include "base/environment.h"
#include "base/require.h"
#include "surface/derive.h"

#include <stdlib.h>

//: Create a surface
bool tf_surface_refill(tf_surface *surface, const tf_mesh *mesh)
{
    tf_sort_workspace *workspace = &surface->sort_workspace;
    surface->axes = mesh->axes;
    surface->vertices = mesh->vertices;
    return tf_mesh_triangles(mesh, &surface->triangles, workspace) &&
           tf_mesh_edges(mesh, &surface->triangles, &surface->edges, workspace);
}

tf_status tf_surface_create(const tf_mesh *mesh, tf_surface **surface,
                            tf_flaw *flaw)
{
    TF_REQUIRE(mesh && surface);
    tf_flaw unused;
    tf_status status = tf_mesh_check(mesh, flaw ? flaw : &unused);
    if (status != TF_OK)
        return status;
    tf_surface *made = calloc(1, sizeof *made);
    if (!made || !tf_surface_refill(made, mesh)) {
        tf_surface_free(made);
        return TF_OUT_OF_MEMORY;
    }
    // Most surfaces keep their mesh.
    tf_sort_workspace_free(&made->sort_workspace);
    *surface = made;
    return TF_OK;
}

//: Free a surface
void tf_surface_free(tf_surface *surface)
{
    if (!surface)
        return;
    tf_buffer_free(&surface->edges.storage);
    tf_buffer_free(&surface->triangles.storage);
    tf_buffer_free(&surface->boxes);
    tf_tree_free(&surface->vertex_tree);
    tf_tree_free(&surface->edge_tree);
    tf_tree_free(&surface->triangle_tree);
    tf_tree_workspace_free(&surface->tree_workspace);
    tf_sort_workspace_free(&surface->sort_workspace);
    tf_workers_free(&surface->workers);
    tf_buffer_free(&surface->task_rows);
    tf_buffer_free(&surface->task_places);
    tf_buffer_free(&surface->found);
    tf_buffer_free(&surface->sorting);
    tf_buffer_free(&surface->moved);
    free(surface);
}

//: Lend the elements
const int *tf_surface_edges(const tf_surface *surface, int *count)
{
    TF_REQUIRE(surface && count);
    *count = surface->edges.count;
    return surface->edges.corner;
}

const int *tf_surface_triangles(const tf_surface *surface, int *count)
{
    TF_REQUIRE(surface && count);
    *count = surface->triangles.count;
    return surface->triangles.corner;
}

//: Count the memory
static size_t tree_bytes(const tf_tree *tree)
{
    return tree->pack_storage.bytes + tree->element_storage.bytes +
           tree->corner_storage.bytes;
}

size_t tf_surface_memory(const tf_surface *surface)
{
    TF_REQUIRE(surface);
    const tf_tree_workspace *workspace = &surface->tree_workspace;
    return sizeof *surface + surface->edges.storage.bytes +
           surface->triangles.storage.bytes + surface->boxes.bytes +
           tree_bytes(&surface->vertex_tree) + tree_bytes(&surface->edge_tree) +
           tree_bytes(&surface->triangle_tree) + workspace->keys.bytes +
           workspace->sorted.bytes + workspace->counts.bytes +
           surface->sort_workspace.other.bytes +
           surface->sort_workspace.place.bytes +
           tf_workers_memory(&surface->workers) + surface->task_rows.bytes +
           surface->task_places.bytes + surface->found.bytes +
           surface->sorting.bytes + surface->moved.bytes;
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
    tf_tree_elements of = {.vertex = box, .whole = &surface->frame.whole};
    const tf_elements *edges = &surface->edges;
    const tf_elements *triangles = &surface->triangles;
    bool good = build_tree(surface, &surface->vertex_tree, &of,
                           surface->vertices, 1, NULL, parallel) &&
                build_tree(surface, &surface->edge_tree, &of, edges->count, 2,
                           edges->corner, parallel) &&
                build_tree(surface, &surface->triangle_tree, &of,
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

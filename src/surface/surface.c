//: Include what surfaces need
#include "surface/surface.h"

#include "base/fail.h"
#include "base/memory.h"
#include "base/require.h"
#include "base/sized.h"
#include "surface/derive.h"
#include "surface/surface_memory.h"

#include <stddef.h>
#include <string.h>

//: Create a surface
tf_status tf_surface_create(const tf_mesh *mesh, tf_surface **surface,
                            tf_error *error)
{
    TF_REQUIRE(mesh && surface);
    tf_status status = tf_mesh_check(mesh, error);
    if (status != TF_OK)
        return status;
    tf_surface *made = tf_allocate_zeroed(sizeof *made);
    if (!made || !tf_surface_refill(made, mesh)) {
        tf_surface_free(made);
        return tf_fail(error, TF_OUT_OF_MEMORY);
    }
    // Most surfaces keep their mesh.
    tf_sort_workspace_free(&made->sort_workspace);
    *surface = made;
    return tf_fail(error, TF_OK);
}

//: Free a surface
void tf_surface_free(tf_surface *surface)
{
    if (!surface)
        return;
    tf_buffer_free(&surface->edges.storage);
    tf_buffer_free(&surface->triangles.storage);
    tf_buffer_free(&surface->groups);
    tf_buffer_free(&surface->zones);
    tf_buffer_free(&surface->paths);
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
    tf_buffer_free(&surface->enlarged);
    tf_release(surface, sizeof *surface);
}

//: Tell the size of a surface
int tf_surface_axes(const tf_surface *surface)
{
    TF_REQUIRE(surface);
    return surface->axes;
}

int tf_surface_vertices(const tf_surface *surface)
{
    TF_REQUIRE(surface);
    return surface->vertices;
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

//: Filter the pairs of a surface
tf_status tf_surface_set_filter(tf_surface *surface,
                                const tf_pair_filter *filter, tf_error *error)
{
    TF_REQUIRE(surface);
    tf_pair_filter own;
    size_t first = offsetof(tf_pair_filter, context) + sizeof own.context;
    tf_status status = tf_options_read(&own, sizeof own, filter, first, error);
    if (status != TF_OK)
        return status;
    if (own.vertices != (own.group ? surface->vertices : 0))
        return tf_fail(error, TF_BAD_COUNT);
    if (own.group) {
        size_t count = (size_t)own.vertices;
        if (!tf_buffer_reserve(&surface->groups, count, sizeof(int)))
            return tf_fail(error, TF_OUT_OF_MEMORY);
        own.group =
            memcpy(surface->groups.data, own.group, sizeof(int) * count);
    }
    surface->filter = own;
    return tf_fail(error, TF_OK);
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
           surface->triangles.storage.bytes + surface->groups.bytes +
           surface->zones.bytes + surface->paths.bytes +
           tree_bytes(&surface->vertex_tree) + tree_bytes(&surface->edge_tree) +
           tree_bytes(&surface->triangle_tree) + workspace->keys.bytes +
           workspace->sorted.bytes + workspace->counts.bytes +
           surface->sort_workspace.other.bytes +
           surface->sort_workspace.place.bytes +
           tf_workers_memory(&surface->workers) + surface->task_rows.bytes +
           surface->task_places.bytes + surface->found.bytes +
           surface->sorting.bytes + surface->enlarged.bytes;
}

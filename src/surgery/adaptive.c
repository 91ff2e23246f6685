//: Include what adaptive surfaces need
#include "surgery/adaptive.h"

#include "base/environment.h"
#include "base/memory.h"
#include "base/require.h"
#include "surgery/conditions.h"
#include "surgery/star.h"
#include "surgery/surgery.h"

#include <string.h>

//: Fill an adaptive surface
static tf_status fill_surface(const tf_mesh *mesh, const double position[],
                              tf_adaptive_surface *surface)
{
    if (!tf_adaptive_reserve(surface, mesh->vertices, mesh->triangles, 0) ||
        !tf_buffer_extend(&surface->box, (size_t)mesh->triangles,
                          sizeof(tf_aabb)))
        return TF_OUT_OF_MEMORY;
    surface->vertices = mesh->vertices;
    surface->triangles = mesh->triangles;
    memcpy(surface->position.data, position,
           3 * sizeof *position * (size_t)mesh->vertices);
    memcpy(surface->vertex.data, mesh->triangle,
           3 * sizeof *mesh->triangle * (size_t)mesh->triangles);
    tf_stars_build(surface, surface->box.data);
    return TF_OK;
}

//: Check an adaptive surface
static tf_status make_surface(const tf_mesh *mesh, const double position[],
                              tf_adaptive_surface *surface, tf_defect *defect)
{
    tf_status status = fill_surface(mesh, position, surface);
    if (status == TF_OK)
        status = tf_check_manifold(surface, defect);
    return status == TF_OK ? tf_check_embedding(surface, mesh, position, defect)
                           : status;
}

//: Create an adaptive surface
tf_status tf_adaptive_create(const tf_mesh *mesh, const double position[],
                             tf_adaptive_surface **surface, tf_defect *defect)
{
    TF_REQUIRE(mesh && mesh->axes == 3 && position && surface);
    tf_defect unused = {0}, *first = defect ? defect : &unused;
    *first = (tf_defect){TF_NONE, {TF_NONE, TF_NONE}, {.kind = TF_NO_CROSSING}};
    if (!tf_environment_is_ieee())
        return TF_BAD_ENVIRONMENT;
    tf_status status = tf_check_mesh(mesh, position, first);
    if (status != TF_OK)
        return status;
    tf_adaptive_surface *made = tf_allocate_zeroed(sizeof *made);
    status =
        made ? make_surface(mesh, position, made, first) : TF_OUT_OF_MEMORY;
    if (status == TF_OK)
        *surface = made;
    else
        tf_adaptive_free(made);
    return status;
}

//: Free an adaptive surface
void tf_adaptive_free(tf_adaptive_surface *surface)
{
    if (!surface)
        return;
    tf_buffer_free(&surface->position);
    tf_buffer_free(&surface->vertex);
    tf_buffer_free(&surface->first);
    tf_buffer_free(&surface->next);
    tf_buffer_free(&surface->found);
    tf_buffer_free(&surface->box);
    tf_dynamic_tree_free(&surface->tree);
    tf_surgery_free(&surface->surgery);
    tf_release(surface, sizeof *surface);
}

//: Count the memory of an adaptive surface
size_t tf_adaptive_memory(const tf_adaptive_surface *surface)
{
    TF_REQUIRE(surface);
    const tf_surgery *surgery = &surface->surgery;
    const tf_dynamic_tree *boxes = &surface->tree;
    return sizeof *surface + surface->position.bytes + surface->vertex.bytes +
           surface->first.bytes + surface->next.bytes + surface->found.bytes +
           surface->box.bytes + boxes->branch.bytes + boxes->parent.bytes +
           boxes->stack.bytes + surgery->removed.bytes + surgery->added.bytes +
           surgery->swept.bytes + surgery->boundary.bytes;
}

//: Lend an adaptive surface
tf_mesh tf_adaptive_mesh(const tf_adaptive_surface *surface)
{
    TF_REQUIRE(surface);
    return (tf_mesh){.axes = 3,
                     .vertices = surface->vertices,
                     .triangles = surface->triangles,
                     .triangle = surface->vertex.data};
}

const double *tf_adaptive_positions(const tf_adaptive_surface *surface)
{
    TF_REQUIRE(surface);
    return surface->position.data;
}

//: Close the gaps
/// Moves the vertices that have triangles to the front; their new numbers, or
/// TF_NONE, replace their first corners.
static void move_vertices(tf_adaptive_surface *surface)
{
    int kept = 0, *number = surface->first.data;
    double *position = surface->position.data;
    for (int v = 0; v < surface->vertices; v++) {
        if (number[v] == TF_NONE)
            continue;
        memmove(position + 3 * (ptrdiff_t)kept, position + 3 * (ptrdiff_t)v,
                3 * sizeof *position);
        number[v] = kept++;
    }
    surface->vertices = kept;
}

static void move_triangles(tf_adaptive_surface *surface)
{
    int kept = 0, *vertex = surface->vertex.data;
    const int *number = surface->first.data;
    for (int t = 0; t < surface->triangles; t++) {
        if (!tf_is_triangle(surface, t))
            continue;
        for (int i = 0; i < 3; i++)
            vertex[3 * kept + i] = number[vertex[3 * t + i]];
        kept++;
    }
    surface->triangles = kept;
}

//: Compact an adaptive surface
tf_status tf_adaptive_compact(tf_adaptive_surface *surface, int map[])
{
    TF_REQUIRE(surface);
    if (!tf_buffer_extend(&surface->box, (size_t)surface->triangles,
                          sizeof(tf_aabb)))
        return TF_OUT_OF_MEMORY;
    int before = surface->vertices;
    move_vertices(surface);
    move_triangles(surface);
    if (map && before > 0)
        memcpy(map, surface->first.data, sizeof *map * (size_t)before);
    tf_stars_build(surface, surface->box.data);
    return TF_OK;
}

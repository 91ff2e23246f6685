//: Include what adaptive surfaces need
#include "surgery/adaptive.h"

#include "base/environment.h"
#include "base/fail.h"
#include "base/memory.h"
#include "base/require.h"
#include "surgery/conditions.h"
#include "surgery/draft.h"
#include "surgery/frozen.h"
#include "surgery/star.h"

#include <string.h>

//: Fill an adaptive surface
static tf_status fill_surface(const tf_mesh *mesh, const double position[],
                              tf_adaptive_surface *surface)
{
    if (!tf_buffer_extend(&surface->lent.mesh, 1, sizeof *mesh) ||
        !tf_adaptive_reserve(surface, mesh->vertices, mesh->triangles, 0) ||
        !tf_buffer_extend(&surface->box, (size_t)mesh->triangles,
                          sizeof(tf_aabb)))
        return TF_OUT_OF_MEMORY;
    surface->vertices = mesh->vertices;
    surface->triangles = mesh->triangles;
    memcpy(surface->position.data, position,
           3 * sizeof *position * (size_t)mesh->vertices);
    memcpy(surface->vertex.data, mesh->triangle,
           3 * sizeof *mesh->triangle * (size_t)mesh->triangles);
    return tf_stars_build(surface, surface->box.data) ? TF_OK : TF_CANCELLED;
}

//: Make an adaptive surface
/// Fills a surface that is empty, and then checks it.
static tf_status make_surface(const tf_mesh *mesh, const double position[],
                              bool strict, tf_adaptive_surface *surface,
                              tf_error *error)
{
    tf_status status = tf_fail(error, fill_surface(mesh, position, surface));
    if (status != TF_OK)
        return status;
    return strict ? tf_check_surface(surface, mesh, error)
                  : tf_leave_defects(surface, mesh, error);
}

static tf_status create_surface(const tf_mesh *mesh, const double position[],
                                bool strict, tf_adaptive_surface **surface,
                                tf_error *error)
{
    TF_REQUIRE(mesh && position && surface);
    if (!tf_environment_is_ieee())
        return tf_fail(error, TF_BAD_ENVIRONMENT);
    tf_status status = tf_check_mesh(mesh, position, error);
    if (status != TF_OK)
        return status;
    tf_adaptive_surface *made = tf_allocate_zeroed(sizeof *made);
    if (!made)
        return tf_fail(error, TF_OUT_OF_MEMORY);
    made->scale = 1;
    status = make_surface(mesh, position, strict, made, error);
    if (status == TF_OK)
        *surface = made;
    else
        tf_adaptive_free(made);
    return status;
}

//: Create an adaptive surface
tf_status tf_adaptive_create(const tf_mesh *mesh, const double position[],
                             tf_adaptive_surface **surface, tf_error *error)
{
    return create_surface(mesh, position, true, surface, error);
}

tf_status tf_adaptive_create_around(const tf_mesh *mesh,
                                    const double position[],
                                    tf_adaptive_surface **surface,
                                    const tf_defects **defects, tf_error *error)
{
    tf_status status = create_surface(mesh, position, false, surface, error);
    if (status == TF_OK && defects)
        *defects = (*surface)->lent.defects.data;
    return status;
}

//: Free an adaptive surface
void tf_adaptive_free(tf_adaptive_surface *surface)
{
    if (!surface)
        return;
    tf_draft_free(surface);
    tf_release(surface, sizeof *surface);
}

//: Count the memory of an adaptive surface
size_t tf_adaptive_memory(const tf_adaptive_surface *surface)
{
    TF_REQUIRE(surface);
    const tf_surgery *surgery = &surface->surgery;
    const tf_dynamic_tree *boxes = &surface->tree;
    const tf_adaptive_lent *lent = &surface->lent;
    return sizeof *surface + surface->position.bytes + surface->vertex.bytes +
           surface->first.bytes + surface->next.bytes + surface->frozen.bytes +
           surface->found.bytes + surface->box.bytes + boxes->branch.bytes +
           boxes->parent.bytes + boxes->stack.bytes + surgery->removed.bytes +
           surgery->added.bytes + surgery->swept.bytes +
           surgery->boundary.bytes + lent->mesh.bytes +
           lent->remesh_report.bytes + lent->reconnect_report.bytes +
           lent->origin.bytes + lent->corner_origin.bytes +
           lent->defects.bytes + lent->defect.bytes;
}

//: Lend an adaptive surface
const tf_mesh *tf_adaptive_mesh(const tf_adaptive_surface *surface)
{
    TF_REQUIRE(surface);
    tf_mesh *mesh = surface->lent.mesh.data;
    *mesh = tf_mesh_of(surface);
    return mesh;
}

const double *tf_adaptive_positions(const tf_adaptive_surface *surface)
{
    TF_REQUIRE(surface);
    return surface->position.data;
}

//: Close the gaps
/// Moves the marks of the vertices that have triangles to the front.
static void move_marks(tf_adaptive_surface *surface)
{
    bool *frozen = surface->frozen.data;
    int kept = 0;
    for (int v = 0; v < surface->marked; v++)
        if (tf_first_corner(surface, v) != TF_NONE)
            frozen[kept++] = frozen[v];
    surface->marked = kept;
}

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
    move_marks(surface);
    move_vertices(surface);
    move_triangles(surface);
    if (!tf_watch_done(surface->watch, 0))
        return TF_CANCELLED;
    if (map && before > 0)
        memcpy(map, surface->first.data, sizeof *map * (size_t)before);
    return tf_stars_build(surface, surface->box.data) ? TF_OK : TF_CANCELLED;
}

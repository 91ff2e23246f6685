//: Include what the memory of surfaces needs
#include "surface/surface_memory.h"

#include "base/environment.h"
#include "base/fail.h"
#include "query/query.h"
#include "surface/derive.h"

#include <math.h>
#include <stddef.h>

//: Refill a surface
bool tf_surface_refill(tf_surface *surface, const tf_mesh *mesh)
{
    tf_sort_workspace *workspace = &surface->sort_workspace;
    surface->axes = mesh->axes;
    surface->vertices = mesh->vertices;
    surface->filter = (tf_pair_filter){0};
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
    tf_watch *watch = surface->workers.watch;
    const tf_box *box = surface->boxes.data;
    tf_tree_elements elements = {.vertex = box, .whole = &surface->frame.whole};
    const tf_elements *edges = &surface->edges;
    const tf_elements *triangles = &surface->triangles;
    bool good = build_tree(surface, &surface->vertex_tree, &elements,
                           surface->vertices, 1, NULL, parallel) &&
                tf_watch_done(watch, 1) &&
                build_tree(surface, &surface->edge_tree, &elements,
                           edges->count, 2, edges->corner, parallel) &&
                tf_watch_done(watch, 1) &&
                build_tree(surface, &surface->triangle_tree, &elements,
                           triangles->count, 3, triangles->corner, parallel) &&
                tf_watch_done(watch, 1);
    return good ? TF_OK : tf_watch_failure(watch);
}

//: Check a motion of a surface
/// Which end of the step is not finite at a vertex.
static int time_of(const tf_motion *motion, int vertex)
{
    const double *start = motion->start + (ptrdiff_t)motion->axes * vertex;
    bool finite = true;
    for (int k = 0; k < motion->axes; k++)
        finite = finite && isfinite(start[k]);
    return finite;
}

static tf_status check_motion(const tf_surface *surface,
                              const tf_motion *motion, tf_error *error)
{
    tf_fail(error, TF_OK);
    if (!tf_environment_is_ieee())
        return tf_fail(error, TF_BAD_ENVIRONMENT);
    tf_status status = tf_motion_check(motion, surface->axes);
    if (status == TF_OK && motion->vertices != surface->vertices)
        status = TF_BAD_COUNT;
    return tf_fail(error, status);
}

//: Move a surface
tf_status tf_surface_move(tf_surface *surface, const tf_motion *motion,
                          const tf_parallel *parallel, tf_error *error)
{
    tf_watch_stage(surface->workers.watch, "trees", 3);
    tf_status status = check_motion(surface, motion, error);
    if (status != TF_OK)
        return status;
    int bad = 0;
    status =
        tf_frame_of(surface->axes, motion, parallel, &surface->frame, &bad);
    if (status != TF_OK)
        return tf_fail_vertex(error, status, bad, time_of(motion, bad));
    if (!tf_buffer_reserve(&surface->boxes, (size_t)surface->vertices,
                           sizeof(tf_box)))
        return tf_fail(error, TF_OUT_OF_MEMORY);
    tf_vertex_boxes(&surface->frame, motion, parallel, surface->boxes.data);
    return tf_fail(error, build_trees(surface, parallel));
}

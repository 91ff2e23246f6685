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
static tf_status build_trees(tf_surface *surface, bool swept,
                             const tf_parallel *parallel)
{
    tf_watch *watch = surface->workers.watch;
    tf_tree_elements elements = {.vertex = surface->paths.data,
                                 .whole = &surface->frame.whole,
                                 .swept = swept};
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

//: Measure a swept edge
/// The squares of the sizes of an edge, along an axis: at the start, and of all
/// that it sweeps.
typedef struct edge_sizes {
    double start, swept;
} edge_sizes;

/// @param moved how far the center of all moves along the axis
static edge_sizes edge_sizes_of(const tf_path *a, const tf_path *b, int k,
                                double moved)
{
    double x[] = {a->at[k], b->at[k], a->at[TF_AXES + k] + moved,
                  b->at[TF_AXES + k] + moved};
    double start = x[0] - x[1], low = x[0], high = x[0];
    for (int i = 1; i < 4; i++) {
        low = x[i] < low ? x[i] : low;
        high = x[i] > high ? x[i] : high;
    }
    double swept = high - low;
    return (edge_sizes){start * start, swept * swept};
}

//: Test whether a motion is calm
enum {
    LEAST_SAMPLE = 64, // edges
    MOST_SAMPLE = 1024,
    SAMPLE_PART = 16
};

/// How far apart the edges of the sample are in a list: it has every sixteenth
/// edge, but not too few of a small mesh, nor too many of a large one.
static int sample_step(int edges)
{
    int size = edges / SAMPLE_PART;
    size = size < LEAST_SAMPLE  ? LEAST_SAMPLE
           : size > MOST_SAMPLE ? MOST_SAMPLE
                                : size;
    return 1 + edges / size;
}

/// Whether the boxes around what edges sweep are not much larger than the edges:
/// whether the squares of their sizes are at most twice as large, in sum, over a
/// sample of all edges.
static bool is_calm(const tf_surface *surface, const tf_motion *motion)
{
    const tf_elements *edges = &surface->edges;
    const tf_frame *frame = &surface->frame;
    edge_sizes all = {0};
    for (int i = 0; i < edges->count; i += sample_step(edges->count)) {
        const int *corner = edges->corner + 2 * (ptrdiff_t)i;
        tf_path a = tf_vertex_path(frame, motion, corner[0]),
                b = tf_vertex_path(frame, motion, corner[1]);
        for (int k = 0; k < surface->axes; k++) {
            double moved = frame->center[TF_AXES + k] - frame->center[k];
            edge_sizes own = edge_sizes_of(&a, &b, k, moved * frame->scale);
            all.start += own.start;
            all.swept += own.swept;
        }
    }
    return all.swept <= 2 * all.start;
}

//: Find the frame of a surface
/// Finds the frame; `*swept` becomes true if the motion is calm.
static tf_status find_frame(tf_surface *surface, const tf_motion *motion,
                            bool *swept, const tf_parallel *parallel,
                            tf_error *error)
{
    tf_frame *frame = &surface->frame;
    int bad = 0;
    tf_status status =
        tf_frame_of(surface->axes, motion, parallel, frame, &bad);
    if (status != TF_OK)
        return tf_fail_vertex(error, status, bad, time_of(motion, bad));
    *swept = *swept || is_calm(surface, motion);
    if (*swept)
        tf_frame_sweep(frame);
    return TF_OK;
}

//: Move a surface
tf_status tf_surface_move(tf_surface *surface, const tf_motion *motion,
                          bool swept, const tf_parallel *parallel,
                          tf_error *error)
{
    tf_watch_stage(surface->workers.watch, "trees", 3);
    tf_status status = check_motion(surface, motion, error);
    if (status != TF_OK)
        return status;
    status = find_frame(surface, motion, &swept, parallel, error);
    if (status != TF_OK)
        return status;
    if (!tf_buffer_reserve(&surface->paths, (size_t)surface->vertices,
                           sizeof(tf_path)))
        return tf_fail(error, TF_OUT_OF_MEMORY);
    tf_vertex_paths(&surface->frame, motion, parallel, surface->paths.data);
    return tf_fail(error, build_trees(surface, swept, parallel));
}

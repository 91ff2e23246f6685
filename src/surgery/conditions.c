//: Include what the conditions need
#include "surgery/conditions.h"

#include "base/fail.h"
#include "surface/crossing_error.h"
#include "surface/derive.h"
#include "surface/surface.h"
#include "surgery/side.h"
#include "surgery/star.h"

#include <math.h>
#include <stddef.h>

//: Check the mesh
static tf_status fail_edge(tf_error *error, tf_subject subject, int index,
                           int from, int to)
{
    tf_fail_element(error, TF_EDGE_NOT_MANIFOLD, subject, (size_t)index, from);
    if (error)
        error->vertex[1] = to;
    return TF_EDGE_NOT_MANIFOLD;
}

static tf_status check_places(const tf_mesh *mesh, const double position[],
                              tf_error *error)
{
    for (int i = 0; i < 3 * mesh->vertices; i++)
        if (!isfinite(position[i]))
            return tf_fail_vertex(error, TF_NOT_FINITE, i / 3, -1);
    return tf_fail(error, TF_OK);
}

tf_status tf_check_mesh(const tf_mesh *mesh, const double position[],
                        tf_error *error)
{
    tf_status status = tf_mesh_check(mesh, error);
    if (status == TF_OK && mesh->axes != 3)
        return tf_fail(error, TF_BAD_AXES);
    if (status == TF_OK && mesh->edges > 0)
        return fail_edge(error, TF_EDGE, 0, mesh->edge[0], mesh->edge[1]);
    return status == TF_OK ? check_places(mesh, position, error) : status;
}

//: Find bad edges
/// Whether another triangle has the edge of a corner in the same direction.
static bool is_repeated(const tf_adaptive_surface *surface, int corner)
{
    int from = tf_vertex_at(surface, corner);
    int to = tf_vertex_at(surface, tf_corner_after(corner));
    for (int c = tf_first_corner(surface, from); c != TF_NONE;
         c = tf_next_corner(surface, c))
        if (c != corner && tf_vertex_at(surface, tf_corner_after(c)) == to)
            return true;
    return false;
}

/// Whether the edge of a corner, which is repeated, is so at a lower corner.
static bool is_told(const tf_adaptive_surface *surface, int corner)
{
    int from = tf_vertex_at(surface, corner);
    int to = tf_vertex_at(surface, tf_corner_after(corner)), c;
    for (c = tf_first_corner(surface, from); c != TF_NONE;
         c = tf_next_corner(surface, c))
        if (c < corner && tf_vertex_at(surface, tf_corner_after(c)) == to)
            return true;
    for (c = tf_first_corner(surface, to); c != TF_NONE;
         c = tf_next_corner(surface, c))
        if (c < corner && tf_vertex_at(surface, tf_corner_after(c)) == from &&
            is_repeated(surface, c))
            return true;
    return false;
}

static tf_status find_bad_edges(const tf_adaptive_surface *surface,
                                tf_defect_sink *sink)
{
    tf_error defect;
    tf_status status = TF_OK;
    for (int c = 0; c < 3 * surface->triangles && status == TF_OK; c++) {
        if (!is_repeated(surface, c) || is_told(surface, c))
            continue;
        fail_edge(&defect, TF_TRIANGLE, c / 3, tf_vertex_at(surface, c),
                  tf_vertex_at(surface, tf_corner_after(c)));
        status = sink->take(sink, &defect);
    }
    return status;
}

//: Go around a vertex
/// The corner where a fan at a vertex begins, if there is one; else any.
static int first_of_fan(const tf_adaptive_surface *surface, int vertex)
{
    int c = tf_first_corner(surface, vertex);
    while (c != TF_NONE && !tf_is_boundary_edge(surface, c))
        c = tf_next_corner(surface, c);
    return c == TF_NONE ? tf_first_corner(surface, vertex) : c;
}

/// How many triangles follow each other around a vertex.
static int fan_size(const tf_adaptive_surface *surface, int vertex)
{
    int count = 0, begin = first_of_fan(surface, vertex), c = begin;
    do {
        int before = tf_vertex_at(surface, tf_corner_before(c));
        c = tf_find_edge(surface, vertex, before);
        count++;
    } while (c != TF_NONE && c != begin);
    return count;
}

//: Find bad vertices
/// Besides those that are frozen: of an edge that is repeated no end can be gone
/// around.
static tf_status find_bad_vertices(const tf_adaptive_surface *surface,
                                   tf_defect_sink *sink)
{
    tf_error defect;
    tf_status status = TF_OK;
    for (int v = 0; v < surface->vertices && status == TF_OK; v++) {
        if (tf_first_corner(surface, v) == TF_NONE ||
            tf_is_frozen(surface, v) ||
            fan_size(surface, v) == tf_star_size(surface, v))
            continue;
        tf_fail_vertex(&defect, TF_VERTEX_NOT_MANIFOLD, v, -1);
        status = sink->take(sink, &defect);
    }
    return status;
}

//: Find collinear triangles
static tf_status find_collinear(const tf_adaptive_surface *surface,
                                tf_defect_sink *sink)
{
    tf_error defect;
    tf_status status = TF_OK;
    for (int t = 0; t < surface->triangles && status == TF_OK; t++) {
        const double *const *x =
            tf_facet_of(surface, tf_triangle(surface, t)).corner;
        if (!tf_are_collinear(x[0], x[1], x[2]))
            continue;
        tf_fail_element(&defect, TF_COLLINEAR, TF_TRIANGLE, (size_t)t, -1);
        status = sink->take(sink, &defect);
    }
    return status;
}

//: Find intersections
/// Vertices without triangles may be anywhere.
static tf_status take_crossings(const tf_adaptive_surface *surface,
                                const tf_crossings *found, tf_defect_sink *sink)
{
    tf_error defect;
    tf_status status = TF_OK;
    for (size_t i = 0; i < found->count && status == TF_OK; i++) {
        const tf_crossing *row = &found->crossing[i];
        if (row->kind == TF_POINT_ON_TRIANGLE &&
            tf_first_corner(surface, row->vertex[0]) == TF_NONE)
            continue;
        tf_fail_crossing(&defect, TF_NOT_EMBEDDED, row, -1);
        status = sink->take(sink, &defect);
    }
    return status;
}

static tf_status find_crossings(const tf_adaptive_surface *surface,
                                const tf_mesh *mesh, tf_defect_sink *sink,
                                tf_error *error)
{
    tf_surface *detection = NULL;
    tf_crossings found;
    tf_status status = tf_surface_create(mesh, &detection, error);
    if (status == TF_OK)
        status = tf_surface_check(detection, surface->vertices,
                                  surface->position.data, NULL, &found, error);
    if (status == TF_OK)
        status = take_crossings(surface, &found, sink);
    tf_surface_free(detection);
    return status;
}

//: Find all defects of a surface
tf_status tf_find_defects(const tf_adaptive_surface *surface,
                          const tf_mesh *mesh, tf_defect_sink *sink,
                          tf_error *error)
{
    tf_fail(error, TF_OK);
    tf_status status = find_bad_edges(surface, sink);
    if (status == TF_OK)
        status = find_bad_vertices(surface, sink);
    if (status == TF_OK)
        status = find_collinear(surface, sink);
    return status == TF_OK ? find_crossings(surface, mesh, sink, error)
                           : status;
}

//: Refuse the first defect
typedef struct refusal {
    tf_defect_sink sink;
    tf_error *error; ///< that is to be set, or NULL
} refusal;

static tf_status refuse(tf_defect_sink *sink, const tf_error *defect)
{
    tf_error *error = ((refusal *)sink)->error;
    if (error)
        *error = *defect;
    return defect->status;
}

tf_status tf_check_surface(const tf_adaptive_surface *surface,
                           const tf_mesh *mesh, tf_error *error)
{
    refusal all = {{refuse}, error};
    return tf_find_defects(surface, mesh, &all.sink, error);
}

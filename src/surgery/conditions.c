//: Include what the conditions need
#include "surgery/conditions.h"

#include "surface/derive.h"
#include "surface/surface.h"
#include "surgery/side.h"
#include "surgery/star.h"

#include <math.h>
#include <stddef.h>

//: Check the mesh
static tf_status check_places(const tf_mesh *mesh, const double position[],
                              tf_defect *defect)
{
    for (int i = 0; i < 3 * mesh->vertices; i++)
        if (!isfinite(position[i])) {
            defect->vertex[0] = i / 3;
            return TF_NOT_FINITE;
        }
    return TF_OK;
}

tf_status tf_check_mesh(const tf_mesh *mesh, const double position[],
                        tf_defect *defect)
{
    tf_error error;
    tf_status status = tf_mesh_check(mesh, &error);
    if (status == TF_BAD_INDEX && error.subject == TF_TRIANGLE) {
        defect->triangle = (int)error.index;
        defect->vertex[0] = error.vertex[0];
    } else if (status != TF_NO_ELEMENTS && mesh->edges > 0) {
        defect->vertex[0] = mesh->edge[0];
        defect->vertex[1] = mesh->edge[1];
        return TF_EDGE_NOT_MANIFOLD;
    }
    return status == TF_OK ? check_places(mesh, position, defect) : status;
}

//: Check the edges of a surface
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

static tf_status check_edges(const tf_adaptive_surface *surface,
                             tf_defect *defect)
{
    for (int c = 0; c < 3 * surface->triangles; c++) {
        if (!is_repeated(surface, c))
            continue;
        defect->triangle = c / 3;
        defect->vertex[0] = tf_vertex_at(surface, c);
        defect->vertex[1] = tf_vertex_at(surface, tf_corner_after(c));
        return TF_EDGE_NOT_MANIFOLD;
    }
    return TF_OK;
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

//: Check the vertices of a surface
static tf_status check_vertices(const tf_adaptive_surface *surface,
                                tf_defect *defect)
{
    for (int v = 0; v < surface->vertices; v++) {
        if (tf_first_corner(surface, v) == TF_NONE ||
            fan_size(surface, v) == tf_star_size(surface, v))
            continue;
        defect->vertex[0] = v;
        return TF_VERTEX_NOT_MANIFOLD;
    }
    return TF_OK;
}

tf_status tf_check_manifold(const tf_adaptive_surface *surface,
                            tf_defect *defect)
{
    tf_status status = check_edges(surface, defect);
    return status == TF_OK ? check_vertices(surface, defect) : status;
}

//: Check the triangles of a surface
static tf_status check_triangles(const tf_adaptive_surface *surface,
                                 tf_defect *defect)
{
    for (int t = 0; t < surface->triangles; t++) {
        const double *const *x =
            tf_facet_of(surface, tf_triangle(surface, t)).corner;
        if (!tf_are_collinear(x[0], x[1], x[2]))
            continue;
        defect->triangle = t;
        return TF_COLLINEAR;
    }
    return TF_OK;
}

//: Check for intersections
/// Vertices without triangles may be anywhere.
static tf_status first_crossing(const tf_adaptive_surface *surface,
                                const tf_crossings *found, tf_defect *defect)
{
    for (size_t i = 0; i < found->count; i++) {
        const tf_crossing *row = &found->crossing[i];
        if (row->kind == TF_POINT_ON_TRIANGLE &&
            tf_first_corner(surface, row->vertex[0]) == TF_NONE)
            continue;
        defect->crossing = *row;
        return TF_NOT_EMBEDDED;
    }
    return TF_OK;
}

static tf_status check_crossings(const tf_adaptive_surface *surface,
                                 tf_surface *detection, const double position[],
                                 tf_defect *defect)
{
    tf_crossings found;
    tf_status status = tf_surface_check(detection, surface->vertices, position,
                                        NULL, &found, NULL);
    return status == TF_OK ? first_crossing(surface, &found, defect) : status;
}

//: Check the embedding
tf_status tf_check_embedding(const tf_adaptive_surface *surface,
                             const tf_mesh *mesh, const double position[],
                             tf_defect *defect)
{
    tf_status status = check_triangles(surface, defect);
    tf_surface *detection = NULL;
    if (status == TF_OK)
        status = tf_surface_create(mesh, &detection, NULL);
    if (status == TF_OK)
        status = check_crossings(surface, detection, position, defect);
    tf_surface_free(detection);
    return status;
}

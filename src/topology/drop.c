//: Include what dropping a component needs
#include "topology/drop.h"

#include "surgery/request.h"
#include "surgery/star.h"
#include "topology/component.h"
#include "topology/winding.h"

/// Whether the call whose draft the surface is, if it is one, has not been
/// cancelled, after so many triangles of a component.
static bool goes_on(const tf_adaptive_surface *surface, int triangles)
{
    return triangles % 256 != 255 || tf_watch_done(surface->watch, 0);
}

//: Recognize a closed component
/// Whether a component has no boundary, and no vertex that is frozen.
static bool is_closed(const tf_adaptive_surface *surface, int count,
                      const int triangle[])
{
    for (int i = 0; i < 3 * count && goes_on(surface, i); i++)
        if (tf_is_frozen(surface,
                         tf_triangle(surface, triangle[i / 3])[i % 3]) ||
            tf_is_boundary_edge(surface, 3 * triangle[i / 3] + i % 3))
            return false;
    return true;
}

//: Find what is inside of a component
static tf_aabb box_of_component(const tf_adaptive_surface *surface, int count,
                                const int triangle[])
{
    tf_aabb box = tf_aabb_empty();
    for (int i = 0; i < count; i++) {
        tf_aabb own = tf_aabb_of(surface, 3, tf_triangle(surface, triangle[i]));
        box = tf_aabb_union(box, &own);
    }
    return box;
}

/// How often a component goes around a vertex.
static int winding_of_component(const tf_adaptive_surface *surface, int count,
                                const int triangle[], int vertex)
{
    int sum = 0;
    for (int i = 0; i < count && goes_on(surface, i); i++) {
        tf_facet side = tf_facet_of(surface, tf_triangle(surface, triangle[i]));
        sum += tf_winding_part(side.corner,
                               tf_vertex_coordinates(surface, vertex));
    }
    return sum;
}

//: Find out whether a component is hollow
/// Whether no other component is inside of the first in the list.  As none
/// crosses another, one vertex of each decides.
static bool holds_nothing(tf_adaptive_surface *surface,
                          tf_components *components, int count)
{
    const int *own = tf_components_list(components);
    tf_aabb box = box_of_component(surface, count, own);
    int *found = surface->found.data;
    int near = tf_dynamic_tree_find(&surface->tree, &box, found);
    for (int i = 0; i < near && goes_on(surface, i); i++) {
        if (tf_is_listed(components, found[i]))
            continue;
        int vertex = *tf_triangle(surface, found[i]);
        if (winding_of_component(surface, count, own, vertex) != 0)
            return false;
        tf_components_add(components, surface, found[i]);
    }
    return true;
}

//: Drop a component as far as it is possible
static tf_outcome try_drop(tf_adaptive_surface *surface,
                           tf_components *components, int count)
{
    const int *triangle = tf_components_list(components);
    if (!is_closed(surface, count, triangle))
        return TF_IMPOSSIBLE;
    if (!holds_nothing(surface, components, count))
        return TF_PASSED_VERTEX;
    for (int i = 0; i < count && goes_on(surface, i); i++)
        tf_triangle_remove(surface, triangle[i]);
    return TF_COMMITTED;
}

//: Drop a component
tf_status tf_adaptive_drop(tf_adaptive_surface *surface, int vertex,
                           tf_outcome *outcome)
{
    tf_status status = tf_request_check(surface, vertex, vertex, NULL, outcome);
    if (status != TF_OK)
        return status;
    tf_components components = {0};
    int corner = tf_first_corner(surface, vertex);
    if (corner == TF_NONE)
        *outcome = TF_IMPOSSIBLE;
    else if (!tf_components_begin(&components, surface))
        status = TF_OUT_OF_MEMORY;
    else
        *outcome =
            try_drop(surface, &components,
                     tf_components_add(&components, surface, corner / 3));
    tf_components_free(&components);
    return status;
}

//: Find what is inside of a part
#include "topology/topology.h"

#include "surgery/request.h"
#include "surgery/star.h"
#include "topology/component.h"
#include "topology/winding.h"

/// Whether a part of the surface, the first in the list, has no boundary.
static bool is_closed(const tf_adaptive_surface *surface, const tf_parts *parts,
                      int count)
{
    const int *list = tf_parts_list(parts);
    for (int i = 0; i < 3 * count; i++)
        if (tf_is_boundary_edge(surface, 3 * list[i / 3] + i % 3))
            return false;
    return true;
}

static tf_aabb box_of_part(const tf_adaptive_surface *surface,
                           const tf_parts *parts, int count)
{
    tf_aabb box = tf_aabb_empty();
    for (int i = 0; i < count; i++) {
        tf_aabb own = tf_aabb_of(surface, 3,
                                 tf_triangle(surface, tf_parts_list(parts)[i]));
        box = tf_aabb_union(box, &own);
    }
    return box;
}

/// How often the first part in the list goes around a vertex.
static int winding_of_part(const tf_adaptive_surface *surface,
                           const tf_parts *parts, int count, int vertex)
{
    int sum = 0;
    for (int i = 0; i < count; i++) {
        tf_facet side =
            tf_facet_of(surface, tf_triangle(surface, tf_parts_list(parts)[i]));
        sum += tf_winding_part(side.corner, tf_place(surface, vertex));
    }
    return sum;
}

//: Find out whether a part is hollow
/// Whether no other part is inside of the first in the list.  As none crosses
/// another, one vertex of each decides.
static bool holds_nothing(tf_adaptive_surface *surface, tf_parts *parts,
                          int count)
{
    tf_aabb box = box_of_part(surface, parts, count);
    int *found = surface->found.data;
    int near = tf_dynamic_tree_find(&surface->boxes, &box, found);
    for (int i = 0; i < near; i++) {
        if (tf_is_listed(parts, found[i]))
            continue;
        if (winding_of_part(surface, parts, count,
                            *tf_triangle(surface, found[i])))
            return false;
        tf_parts_add(parts, surface, found[i]);
    }
    return true;
}

//: Drop a part as far as it is possible
static tf_outcome try_drop(tf_adaptive_surface *surface, tf_parts *parts,
                           int count)
{
    if (!is_closed(surface, parts, count))
        return TF_IMPOSSIBLE;
    if (!holds_nothing(surface, parts, count))
        return TF_PASSED_VERTEX;
    for (int i = 0; i < count; i++)
        tf_triangle_remove(surface, tf_parts_list(parts)[i]);
    return TF_COMMITTED;
}

//: Drop a part
tf_status tf_adaptive_drop(tf_adaptive_surface *surface, int vertex,
                           tf_outcome *outcome)
{
    tf_status status = tf_request_check(surface, vertex, vertex, NULL, outcome);
    if (status != TF_OK)
        return status;
    tf_parts parts = {0};
    int corner = tf_first_corner(surface, vertex);
    if (corner == TF_NONE)
        *outcome = TF_IMPOSSIBLE;
    else if (!tf_parts_begin(&parts, surface))
        status = TF_OUT_OF_MEMORY;
    else
        *outcome = try_drop(surface, &parts,
                            tf_parts_add(&parts, surface, corner / 3));
    tf_parts_free(&parts);
    return status;
}

//: Put up a wall
#include "topology/walls.h"

#include "surgery/trial.h"
#include "topology/winding.h"

void tf_walls_add(tf_walls *walls, const tf_adaptive_surface *surface, int a,
                  int b, int c)
{
    const int vertex[] = {a, b, c};
    walls->wall[walls->count++] = (tf_added_triangle){
        tf_facet_of(surface, vertex), tf_aabb_of(surface, 3, vertex)};
}

//: Test S: what is new overlaps no wall
/// The triangles that the surgery, or its last stage, has added.
static const tf_added_triangle *added_to(const tf_adaptive_surface *surface,
                                         int *count)
{
    const tf_surgery *surgery = &surface->surgery;
    *count = surgery->additions - surgery->earlier;
    return (const tf_added_triangle *)surgery->added.data + surgery->earlier;
}

static bool overlaps_wall(const tf_walls *walls,
                          const tf_adaptive_surface *surface)
{
    int count;
    const tf_added_triangle *added = added_to(surface, &count);
    for (int i = 0; i < walls->count * count; i++)
        if (tf_facets_overlap(&walls->wall[i / count].facet,
                              &added[i % count].facet))
            return true;
    return false;
}

//: Find out whether a ball holds a vertex
/// Its own corners are on its boundary.
static bool is_corner_of(const tf_walls *walls, int vertex)
{
    for (int i = 0; i < 3 * walls->count; i++)
        if (walls->wall[i / 3].facet.vertex[i % 3] == vertex)
            return true;
    return false;
}

/// The walls face the other way than what is new.
static bool is_in_ball(const tf_walls *walls,
                       const tf_adaptive_surface *surface, int vertex)
{
    int count, sum = 0;
    const tf_added_triangle *added = added_to(surface, &count);
    const double *x = tf_vertex_coordinates(surface, vertex);
    for (int i = 0; i < count; i++)
        sum += tf_winding_part(added[i].facet.corner, x);
    for (int i = 0; i < walls->count; i++)
        sum -= tf_winding_part(walls->wall[i].facet.corner, x);
    return sum != 0;
}

//: Test V: a ball holds no vertex
static tf_aabb box_of_ball(const tf_walls *walls,
                           const tf_adaptive_surface *surface)
{
    int count;
    const tf_added_triangle *added = added_to(surface, &count);
    tf_aabb box = tf_aabb_empty();
    for (int i = 0; i < walls->count; i++)
        box = tf_aabb_union(box, &walls->wall[i].box);
    for (int i = 0; i < count; i++)
        box = tf_aabb_union(box, &added[i].box);
    return box;
}

static bool holds_vertex(const tf_walls *walls, tf_adaptive_surface *surface)
{
    tf_aabb box = box_of_ball(walls, surface);
    int *found = surface->found.data;
    int count = tf_dynamic_tree_find(&surface->tree, &box, found);
    for (int i = 0; i < 3 * count; i++) {
        int vertex = tf_triangle(surface, found[i / 3])[i % 3];
        tf_aabb point = tf_aabb_of(surface, 1, &vertex);
        if (tf_aabbs_overlap(&box, &point) && !is_corner_of(walls, vertex) &&
            is_in_ball(walls, surface, vertex))
            return true;
    }
    return false;
}

//: Try surgery on a ball
tf_outcome tf_walls_try(const tf_walls *walls, tf_adaptive_surface *surface)
{
    tf_outcome outcome = tf_surgery_try(surface);
    if (outcome != TF_COMMITTED)
        return outcome;
    if (overlaps_wall(walls, surface))
        return TF_OVERLAPPED;
    return holds_vertex(walls, surface) ? TF_PASSED_VERTEX : TF_COMMITTED;
}

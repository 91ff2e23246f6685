//: Put up a wall
#include "topology/walls.h"

#include "topology/winding.h"

void tf_walls_add(tf_walls *walls, const tf_adaptive *of, int a, int b, int c)
{
    const int vertex[] = {a, b, c};
    walls->wall[walls->count++] =
        (tf_graft){tf_facet_of(of, vertex), tf_cuboid_of(of, 3, vertex)};
}

//: Test S: what is new overlaps no wall
/// The triangles that the surgery, or its last stage, has added.
static const tf_graft *grafts_of(const tf_adaptive *of, int *count)
{
    const tf_surgery *surgery = &of->surgery;
    *count = surgery->grafts - surgery->settled;
    return (const tf_graft *)surgery->graft.data + surgery->settled;
}

static bool overlaps_wall(const tf_walls *walls, const tf_adaptive *of)
{
    int count;
    const tf_graft *graft = grafts_of(of, &count);
    for (int i = 0; i < walls->count * count; i++)
        if (tf_facets_overlap(&walls->wall[i / count].facet,
                              &graft[i % count].facet))
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
static bool is_in_ball(const tf_walls *walls, const tf_adaptive *of, int vertex)
{
    int count, sum = 0;
    const tf_graft *graft = grafts_of(of, &count);
    const double *x = tf_place(of, vertex);
    for (int i = 0; i < count; i++)
        sum += tf_winding_part(graft[i].facet.corner, x);
    for (int i = 0; i < walls->count; i++)
        sum -= tf_winding_part(walls->wall[i].facet.corner, x);
    return sum != 0;
}

//: Test V: a ball holds no vertex
static tf_cuboid box_of_ball(const tf_walls *walls, const tf_adaptive *of)
{
    int count;
    const tf_graft *graft = grafts_of(of, &count);
    tf_cuboid box = tf_cuboid_empty();
    for (int i = 0; i < walls->count; i++)
        box = tf_cuboid_union(box, &walls->wall[i].box);
    for (int i = 0; i < count; i++)
        box = tf_cuboid_union(box, &graft[i].box);
    return box;
}

static bool holds_vertex(const tf_walls *walls, tf_adaptive *of)
{
    tf_cuboid box = box_of_ball(walls, of);
    int *found = of->found.data;
    int count = tf_hierarchy_find(&of->boxes, &box, found);
    for (int i = 0; i < 3 * count; i++) {
        int vertex = tf_triangle(of, found[i / 3])[i % 3];
        tf_cuboid point = tf_cuboid_of(of, 1, &vertex);
        if (tf_cuboids_overlap(&box, &point) && !is_corner_of(walls, vertex) &&
            is_in_ball(walls, of, vertex))
            return true;
    }
    return false;
}

//: Try surgery on a ball
static bool tests_ball(const tf_adaptive *of, tf_outcome refusal)
{
    return (of->left_out >> refusal & 1) == 0;
}

tf_outcome tf_walls_try(const tf_walls *walls, tf_adaptive *of)
{
    tf_outcome outcome = tf_surgery_try(of);
    if (outcome != TF_COMMITTED)
        return outcome;
    if (tests_ball(of, TF_OVERLAPPED) && overlaps_wall(walls, of))
        return TF_OVERLAPPED;
    if (tests_ball(of, TF_PASSED_VERTEX) && holds_vertex(walls, of))
        return TF_PASSED_VERTEX;
    return TF_COMMITTED;
}

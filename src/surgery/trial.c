//: Hold a trial
#include "surgery/trial.h"

typedef struct trial {
    tf_adaptive_surface *surface;
    int removals, additions, sweeps;
    const int *removed;
    const tf_added_triangle *added; ///< by this stage
    const tf_swept_tetrahedron *swept;
} trial;

static trial trial_of(tf_adaptive_surface *surface)
{
    const tf_surgery *s = &surface->surgery;
    const tf_added_triangle *added = s->added.data;
    return (trial){.surface = surface,
                   .removals = s->removals,
                   .additions = s->additions - s->earlier,
                   .sweeps = s->sweeps,
                   .removed = s->removed.data,
                   .added = added + s->earlier,
                   .swept = s->swept.data};
}

//: Test D: no new triangle is collinear
static bool some_triangle_is_collinear(const trial *t)
{
    for (int i = 0; i < t->additions; i++) {
        const double *const *x = t->added[i].facet.corner;
        if (tf_are_collinear(x[0], x[1], x[2]))
            return true;
    }
    return false;
}

//: Test S: new triangles overlap no other
/// Whether the call whose draft the surface is, if it is one, goes on after an
/// item of a loop: a vertex may have thousands of triangles.
static bool trial_goes_on(const trial *t, int item)
{
    return item % 64 != 63 || tf_watch_done(t->surface->watch, 0);
}

static bool added_overlap(const trial *t)
{
    for (int i = 0; i < t->additions; i++) {
        if (!trial_goes_on(t, i))
            return true;
        for (int j = 0; j < i; j++)
            if (tf_facets_overlap(&t->added[i].facet, &t->added[j].facet))
                return true;
    }
    return false;
}

static bool overlaps_added(const trial *t, const tf_added_triangle *kept)
{
    for (int i = 0; i < t->additions; i++)
        if (tf_aabbs_overlap(&t->added[i].box, &kept->box) &&
            tf_facets_overlap(&t->added[i].facet, &kept->facet))
            return true;
    return false;
}

//: Test E: no edge is swept over
static bool sweeps_edge(const tf_tetrahedron *body, int count,
                        const tf_facet *kept, const unsigned outside[], int i)
{
    int j = (i + 1) % count;
    tf_located_edge edge = {{kept->vertex[i], kept->vertex[j]},
                            {kept->corner[i], kept->corner[j]},
                            {outside[i], outside[j]}};
    return tf_tetrahedron_meets(body, &edge);
}

//: Sweep over a kept element
/// Test V, no vertex is swept over, and test E, for a triangle that is kept or an
/// edge: `count` is 3 or 2.
static tf_outcome try_sweep(const tf_tetrahedron *body, int count,
                            const tf_facet *kept)
{
    unsigned outside[3] = {0};
    for (int i = 0; i < count; i++) {
        if (tf_tetrahedron_corner(body, kept->vertex[i]) >= 0)
            continue;
        outside[i] = tf_tetrahedron_outside(body, kept->corner[i]);
        if (tf_tetrahedron_holds(body, kept->corner[i], outside[i]))
            return TF_PASSED_VERTEX;
    }
    for (int i = 0; i < 2 * count - 3; i++)
        if (sweeps_edge(body, count, kept, outside, i))
            return TF_PASSED_EDGE;
    return TF_COMMITTED;
}

static tf_outcome try_sweeps(const trial *t, int count,
                             const tf_added_triangle *kept)
{
    for (int i = 0; i < t->sweeps; i++) {
        const tf_tetrahedron *body = &t->swept[i].body;
        if (!tf_aabbs_overlap(&t->swept[i].box, &kept->box) ||
            tf_tetrahedron_is_apart(body, count, &kept->facet))
            continue;
        tf_outcome outcome = try_sweep(body, count, &kept->facet);
        if (outcome != TF_COMMITTED)
            return outcome;
    }
    return TF_COMMITTED;
}

//: Test X: the vertex that moves passes through no triangle
static bool path_touches(const trial *t, const tf_added_triangle *kept)
{
    const int *path = t->surface->surgery.path;
    if (path[0] == TF_NONE)
        return false;
    tf_aabb box = tf_aabb_of(t->surface, 2, path);
    return tf_aabbs_overlap(&box, &kept->box) &&
           tf_edge_touches_triangle(tf_vertex_coordinates(t->surface, path[0]),
                                    tf_vertex_coordinates(t->surface, path[1]),
                                    kept->facet.corner);
}

//: Try a triangle that is kept
static bool is_removed(const trial *t, int triangle)
{
    for (int i = 0; i < t->removals; i++)
        if (t->removed[i] == triangle)
            return true;
    return false;
}

static tf_outcome try_kept(const trial *t, const tf_added_triangle *kept)
{
    if (overlaps_added(t, kept))
        return TF_OVERLAPPED;
    if (path_touches(t, kept))
        return TF_PASSED_TRIANGLE;
    return try_sweeps(t, 3, kept);
}

static tf_outcome try_triangle(const trial *t, int triangle)
{
    if (is_removed(t, triangle))
        return TF_COMMITTED;
    const int *vertex = tf_triangle(t->surface, triangle);
    tf_added_triangle kept = {tf_facet_of(t->surface, vertex),
                              tf_aabb_of(t->surface, 3, vertex)};
    return try_kept(t, &kept);
}

/// The triangles that earlier stages of the surgery have added are kept.
static tf_outcome try_earlier(const trial *t)
{
    const tf_surgery *s = &t->surface->surgery;
    const tf_added_triangle *kept = s->added.data;
    tf_outcome outcome = TF_COMMITTED;
    for (int i = 0; i < s->earlier && outcome == TF_COMMITTED; i++)
        outcome = try_kept(t, &kept[i]);
    return outcome;
}

//: Try all triangles nearby
static tf_aabb box_of(const trial *t)
{
    tf_aabb box = tf_aabb_empty();
    for (int i = 0; i < t->additions; i++)
        box = tf_aabb_union(box, &t->added[i].box);
    for (int i = 0; i < t->sweeps; i++)
        box = tf_aabb_union(box, &t->swept[i].box);
    return box;
}

static tf_outcome try_triangles(const trial *t)
{
    tf_aabb box = box_of(t);
    int *found = t->surface->found.data;
    int count = tf_dynamic_tree_find(&t->surface->tree, &box, found);
    tf_outcome outcome = TF_COMMITTED;
    for (int i = 0; i < count && outcome == TF_COMMITTED; i++)
        outcome =
            trial_goes_on(t, i) ? try_triangle(t, found[i]) : TF_IMPOSSIBLE;
    return outcome;
}

//: Try the boundary of the patch
/// An edge of the boundary that the two patches share belongs to no triangle
/// that is kept.
static tf_outcome try_boundary_edge(const trial *t, const int edge[2])
{
    tf_added_triangle kept = {.box = tf_aabb_of(t->surface, 2, edge)};
    for (int i = 0; i < 2; i++) {
        kept.facet.vertex[i] = edge[i];
        kept.facet.corner[i] = tf_vertex_coordinates(t->surface, edge[i]);
    }
    return try_sweeps(t, 2, &kept);
}

static tf_outcome try_boundary(const trial *t)
{
    const tf_surgery *s = &t->surface->surgery;
    const int *edge = s->boundary.data;
    tf_outcome outcome = TF_COMMITTED;
    for (int i = 0; i < s->boundary_edges && outcome == TF_COMMITTED; i++)
        outcome = try_boundary_edge(t, edge + 2 * (size_t)i);
    return outcome;
}

//: Try a surgery
tf_outcome tf_surgery_try(tf_adaptive_surface *surface)
{
    trial t = trial_of(surface);
    if (some_triangle_is_collinear(&t))
        return TF_FLATTENED;
    if (added_overlap(&t))
        return TF_OVERLAPPED;
    tf_outcome outcome = try_earlier(&t);
    if (outcome == TF_COMMITTED)
        outcome = try_boundary(&t);
    return outcome == TF_COMMITTED ? try_triangles(&t) : outcome;
}

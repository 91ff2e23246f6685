//: Include what a tangle needs
#include "untangle/tangle.h"

#include <string.h>

//: Begin and end to untangle a surface
bool tf_tangle_begin(tf_tangle *tangle)
{
    if (!tf_neighbors_find(&tangle->near, tangle->surface) ||
        !tf_buffer_reserve(&tangle->lengths, (size_t)tangle->near.vertices,
                           sizeof(double)))
        return false;
    tangle->edge_at = tangle->lengths.data;
    tangle->edge = tf_mean_edge(&tangle->near, tangle->in, tangle->edge_at);
    return true;
}

void tf_tangle_end(tf_tangle *tangle)
{
    tf_neighbors_free(&tangle->near);
    tf_buffer_free(&tangle->lengths);
    tf_buffer_free(&tangle->moves);
    tf_buffer_free(&tangle->listed);
    tf_buffer_free(&tangle->merged);
    tf_pair_cache_free(&tangle->pairs);
    tf_near_patch_free(&tangle->patch);
}

//: Check a tangle
/// Lists crossings, which a surface has lent, in the tangle's memory.
static bool keep(tf_tangle *tangle, tf_crossings found)
{
    size_t size = sizeof *found.crossing;
    if (!tf_buffer_reserve(&tangle->listed, found.count + 1, size))
        return false;
    if (found.count > 0)
        memcpy(tangle->listed.data, found.crossing, found.count * size);
    tangle->crossings = (tf_crossings){found.count, tangle->listed.data};
    return true;
}

static tf_status check(const tf_tangle *tangle, tf_surface *surface,
                       int vertices, const double x[], tf_crossings *found)
{
    tf_check_options options = {.size = sizeof options,
                                .parallel = tangle->parallel};
    return tf_surface_check(surface, vertices, x, &options, found, NULL);
}

tf_status tf_tangle_check(tf_tangle *tangle, const double x[])
{
    tf_crossings found;
    tf_status status =
        check(tangle, tangle->surface, tangle->near.vertices, x, &found);
    if (status != TF_OK)
        return status;
    return keep(tangle, found) ? TF_OK : TF_OUT_OF_MEMORY;
}

//: Check only what has moved
static bool has_moved(const tf_neighbors *near, const double from[],
                      const double x[], const tf_crossing *crossing)
{
    for (int i = 0; i < tf_crossing_corners(crossing); i++)
        if (!tf_vector_equals(tf_place(near, from, crossing->vertex[i]),
                              tf_place(near, x, crossing->vertex[i])))
            return true;
    return false;
}

static bool precedes(const tf_crossing *a, const tf_crossing *b)
{
    if (a->kind != b->kind)
        return a->kind < b->kind;
    for (int i = 0; i < 5; i++)
        if (a->vertex[i] != b->vertex[i])
            return a->vertex[i] < b->vertex[i];
    return false;
}

/// Merges the crossings at `from` of what has not moved with those at x, in the
/// patch, of what has.  Both are sorted, since the numbers in a patch increase
/// with those in the surface.
static size_t merge(const tf_tangle *tangle, const double from[],
                    const double x[], const tf_crossings *found,
                    tf_crossing *to)
{
    const tf_crossings *last = &tangle->crossings;
    size_t count = 0, old = 0;
    for (size_t i = 0; i < found->count; i++) {
        tf_crossing own = found->crossing[i];
        tf_near_patch_name(&tangle->patch, 5, own.vertex);
        if (!has_moved(&tangle->near, from, x, &own))
            continue;
        for (; old < last->count && precedes(&last->crossing[old], &own); old++)
            if (!has_moved(&tangle->near, from, x, &last->crossing[old]))
                to[count++] = last->crossing[old];
        to[count++] = own;
    }
    for (; old < last->count; old++)
        if (!has_moved(&tangle->near, from, x, &last->crossing[old]))
            to[count++] = last->crossing[old];
    return count;
}

tf_status tf_tangle_follow(tf_tangle *tangle, const double from[],
                           const double x[])
{
    tf_near_patch *patch = &tangle->patch;
    if (!patch->is_used)
        return tf_tangle_check(tangle, x);
    tf_crossings found;
    tf_near_patch_gather(patch, &tangle->near, x, patch->end);
    tf_status status =
        check(tangle, patch->surface, patch->vertices, patch->end, &found);
    if (status != TF_OK)
        return status;
    if (!tf_buffer_reserve(&tangle->merged,
                           found.count + tangle->crossings.count + 1,
                           sizeof(tf_crossing)))
        return TF_OUT_OF_MEMORY;
    tf_crossing *to = tangle->merged.data;
    size_t count = merge(tangle, from, x, &found, to);
    return keep(tangle, (tf_crossings){count, to}) ? TF_OK : TF_OUT_OF_MEMORY;
}

//: Count crossings that nothing can end
int tf_crossing_corners(const tf_crossing *crossing)
{
    int corners = 0;
    while (corners < 5 && crossing->vertex[corners] >= 0)
        corners++;
    return corners;
}

bool tf_are_fixed(const tf_tangle *tangle, int corners, const int corner[])
{
    for (int i = 0; i < corners; i++)
        if (!tangle->fixed[corner[i]])
            return false;
    return true;
}

size_t tf_tangle_beyond(const tf_tangle *tangle)
{
    size_t beyond = 0;
    for (size_t i = 0; i < tangle->crossings.count; i++) {
        const tf_crossing *own = &tangle->crossings.crossing[i];
        beyond += tf_are_fixed(tangle, tf_crossing_corners(own), own->vertex);
    }
    return beyond;
}

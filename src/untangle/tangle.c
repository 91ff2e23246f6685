//: Include what a tangle needs
#include "untangle/tangle.h"

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
}

//: Check a tangle
tf_status tf_tangle_check(tf_tangle *tangle, const double x[])
{
    tf_check_options options = {.size = sizeof options,
                                .parallel = tangle->parallel};
    return tf_surface_check(tangle->surface, tangle->near.vertices, x, &options,
                            &tangle->crossings, NULL);
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

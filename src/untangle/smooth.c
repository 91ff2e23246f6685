//: Include what smoothing needs
#include "untangle/smooth.h"

#include "untangle/scope.h"

//: Find the mean of neighbors
typedef struct smoothing {
    tf_vector sum;     ///< of the ways to neighbors
    int count;         ///< of these
    tf_vector rim_sum; ///< of the ways to neighbors along the boundary
    int rims;
} smoothing;

static smoothing look_around(const tf_neighbors *all, const double x[],
                             int vertex)
{
    smoothing own = {.count = 0};
    tf_vector place = tf_place(all, x, vertex);
    for (int i = all->around.start[vertex]; i < all->around.start[vertex + 1];
         i++) {
        tf_vector way =
            tf_vector_difference(tf_place(all, x, all->around.item[i]), place);
        own.sum = tf_vector_sum(own.sum, 1, way);
        own.count++;
        if (!tf_is_boundary(all, all->edges_at.item[i]))
            continue;
        own.rim_sum = tf_vector_sum(own.rim_sum, 1, way);
        own.rims++;
    }
    return own;
}

//: Smooth
bool tf_smooth(tf_change *change, const tf_tangle *tangle, const double x[],
               int rings)
{
    const tf_neighbors *all = &tangle->near;
    const int *mark = tf_mark_rings(&change->marks, tangle, NULL, rings);
    if (!mark)
        return false;
    for (int v = 0; v < all->vertices; v++) {
        if (!mark[v] || tangle->fixed[v])
            continue;
        smoothing own = look_around(all, x, v);
        if (own.rims > 0)
            change->move[v] = tf_vector_scaled(0.25, own.rim_sum);
        else if (own.count > 0)
            change->move[v] = tf_vector_scaled(0.5 / own.count, own.sum);
    }
    return tf_watch_work(tangle->watch, (size_t)all->vertices);
}

//: Include what changes need
#include "untangle/change.h"

#include <string.h>

//: Begin a change
bool tf_change_begin(tf_change *change, const tf_tangle *tangle)
{
    size_t v = (size_t)tangle->near.vertices;
    size_t bytes = v * (2 * sizeof(tf_vector) + sizeof(double));
    if (!tf_buffer_reserve(&change->storage, bytes, 1))
        return false;
    change->move = change->storage.data;
    change->other = change->move + v;
    change->weight = (double *)(change->other + v);
    memset(change->move, 0, bytes);
    return true;
}

void tf_change_free(tf_change *change)
{
    tf_buffer_free(&change->storage);
    tf_buffer_free(&change->marks);
}

//: Propose a move
void tf_change_add(tf_change *change, const tf_tangle *tangle, int vertex,
                   tf_vector direction, double length, double weight)
{
    if (tangle->fixed[vertex] || weight <= 0)
        return;
    change->move[vertex] =
        tf_vector_sum(change->move[vertex], weight * length, direction);
    change->weight[vertex] += weight;
}

//: Take the means of what is proposed
static void take_means(tf_change *change, const tf_tangle *tangle)
{
    for (int v = 0; v < tangle->near.vertices; v++) {
        if (change->weight[v] <= 0)
            continue;
        tf_vector mean =
            tf_vector_scaled(1 / change->weight[v], change->move[v]);
        double length = tf_vector_length(mean), most = tangle->edge_at[v] / 2;
        change->move[v] =
            length > most ? tf_vector_scaled(most / length, mean) : mean;
    }
}

//: Let moves spread
enum {
    TIMES = 12
};

/// The mean of the moves of a vertex's neighbors.
static tf_vector mean_around(const tf_neighbors *all, const tf_vector move[],
                             int vertex)
{
    tf_vector sum = {{0, 0, 0}};
    int begin = all->around.start[vertex], end = all->around.start[vertex + 1];
    for (int i = begin; i < end; i++)
        sum = tf_vector_sum(sum, 1, move[all->around.item[i]]);
    return tf_vector_scaled(1.0 / (end - begin), sum);
}

/// Where nothing is proposed, vertices nearly follow their neighbors; where
/// something is, they mostly do that.
static void spread(tf_change *change, const tf_tangle *tangle)
{
    const tf_neighbors *all = &tangle->near;
    for (int v = 0; v < all->vertices; v++) {
        if (tangle->fixed[v] || tf_list_length(&all->around, v) == 0)
            continue;
        tf_vector mean = mean_around(all, change->other, v);
        change->move[v] =
            change->weight[v] > 0
                ? tf_vector_sum(tf_vector_scaled(0.7, change->other[v]), 0.3,
                                mean)
                : tf_vector_scaled(0.95, mean);
    }
}

//: Drop the least moves
/// What has spread so far that next to nothing is left stays where it is; so a
/// round moves only what is near a crossing.
static void drop_least(tf_change *change, const tf_tangle *tangle)
{
    for (int v = 0; v < tangle->near.vertices; v++)
        if (tf_vector_length(change->move[v]) < 0x1p-16 * tangle->edge_at[v])
            change->move[v] = (tf_vector){{0, 0, 0}};
}

//: Finish a change
bool tf_change_finish(tf_change *change, const tf_tangle *tangle)
{
    size_t vertices = (size_t)tangle->near.vertices;
    take_means(change, tangle);
    for (int i = 0; i < TIMES; i++) {
        memcpy(change->other, change->move, vertices * sizeof(tf_vector));
        spread(change, tangle);
        if (!tf_watch_work(tangle->watch, vertices))
            return false;
    }
    drop_least(change, tangle);
    return true;
}

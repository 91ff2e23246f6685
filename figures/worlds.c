#include "worlds.h"

#include "stage/vector.h"

void tf_world_of_event(const tf_event *event, double world[3])
{
    world[0] = event->x[0];
    world[1] = event->x[1];
    world[2] = event->t;
}

void tf_world_of_simplex(const tf_simplex *simplex, double world[][3])
{
    for (int i = 0; i < simplex->count; i++)
        tf_world_of_event(simplex->event[i], world[i]);
}

void tf_world_floors(tf_scene *scene, double width, double depth, double cell)
{
    static const tf_role role[2] = {TF_ROLE_START, TF_ROLE_END};
    for (int t = 0; t < 2; t++)
        tf_scene_grid(scene, (double[]){0, 0, t}, (double[]){width, 0, 0},
                      (double[]){0, depth, 0}, (int)lround(width / cell),
                      (int)lround(depth / cell), role[t]);
}

/// The place at the time t on the way from one event to another.
static void place_between(const tf_event *start, const tf_event *end, int axes,
                          double t, double place[3])
{
    for (int k = 0; k < 3; k++)
        place[k] = k < axes ? (1 - t) * start->x[k] + t * end->x[k] : 0;
}

void tf_worldline_place(const tf_worldline *worldline, int axes, double t,
                        double place[3])
{
    place_between(&worldline->at[0], &worldline->at[1], axes, t, place);
}

tf_slice tf_slice_of(const tf_simplex *simplex, int axes, double t)
{
    // The corners lie on the ways from events at t = 0 to events at t = 1.
    // Every other time backwards, they come in order around.
    int early = simplex->mover + 1;
    tf_slice slice = {0};
    for (int end = early; end < simplex->count; end++)
        for (int i = 0; i < early; i++) {
            int start = (end - early) % 2 == 0 ? i : early - 1 - i;
            place_between(simplex->event[start], simplex->event[end], axes, t,
                          slice.corner[slice.count++]);
        }
    return slice;
}

void tf_world_of_edge(const tf_worldline edge[2], double t, double world[3][3])
{
    static const double up[3] = {0, 0, 1};
    tf_simplex sweep[2];
    tf_sweep(2, edge, sweep);
    // Each triangle is cut in a segment; they share the crease.
    tf_slice second = tf_slice_of(&sweep[0], 2, t);
    tf_slice first = tf_slice_of(&sweep[1], 2, t);
    tf_add(first.corner[0], t, up, world[0]);
    tf_add(first.corner[1], t, up, world[1]);
    tf_add(second.corner[1], t, up, world[2]);
}

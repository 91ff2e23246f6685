#include "kit/worlds.h"

tf_vector fig_world_of_event(const tf_event *event)
{
    return (tf_vector){{event->x[0], event->x[1], event->t}};
}

void fig_world_of_simplex(const tf_simplex *simplex, tf_vector world[])
{
    for (int i = 0; i < simplex->count; i++)
        world[i] = fig_world_of_event(simplex->event[i]);
}

double fig_toi(const tf_contact *contact)
{
    return contact->verdict == TF_HIT ? (contact->toi_lo + contact->toi_hi) / 2
                                      : -1;
}

void fig_world_floors(fig_scene *scene, double width, double depth, double cell)
{
    static const fig_role role[2] = {FIG_ROLE_START, FIG_ROLE_END};
    for (int t = 0; t < 2; t++)
        fig_scene_grid(scene, (tf_vector){{0, 0, t}},
                       (tf_vector){{width, 0, 0}}, (tf_vector){{0, depth, 0}},
                       (int)lround(width / cell), (int)lround(depth / cell),
                       role[t]);
}

void fig_world_ends(fig_scene *scene, const tf_worldline edge[2])
{
    for (int t = 0; t < 2; t++)
        fig_scene_tube(scene, fig_world_of_event(&edge[0].at[t]),
                       fig_world_of_event(&edge[1].at[t]), FIG_WIDTH_TUBE,
                       (fig_paint){.role = FIG_ROLE_EDGE});
}

/// The place at the time t on the way from one event to another.
static tf_vector place_between(const tf_event *start, const tf_event *end,
                               int axes, double t)
{
    tf_vector place =
        fig_lerp(fig_vector_of(start->x), fig_vector_of(end->x), t);
    for (int k = axes; k < 3; k++)
        place.x[k] = 0;
    return place;
}

tf_vector fig_worldline_place(const tf_worldline *worldline, int axes, double t)
{
    return place_between(&worldline->at[0], &worldline->at[1], axes, t);
}

fig_slice fig_slice_of(const tf_simplex *simplex, int axes, double t)
{
    // The corners lie on the ways from events at t = 0 to events at t = 1.
    // Every other time backwards, they come in order around.
    int early = simplex->pivot + 1;
    fig_slice slice = {0};
    for (int end = early; end < simplex->count; end++)
        for (int i = 0; i < early; i++) {
            int start = (end - early) % 2 == 0 ? i : early - 1 - i;
            slice.corner[slice.count++] = place_between(
                simplex->event[start], simplex->event[end], axes, t);
        }
    return slice;
}

void fig_world_of_edge(const tf_worldline edge[2], double t, tf_vector world[3])
{
    const tf_vector up = {{0, 0, t}};
    tf_simplex sweep[2];
    tf_sweep(2, edge, sweep);
    // Each triangle is cut in a segment; they share the crease.
    fig_slice second = fig_slice_of(&sweep[0], 2, t);
    fig_slice first = fig_slice_of(&sweep[1], 2, t);
    world[0] = fig_sum(first.corner[0], up);
    world[1] = fig_sum(first.corner[1], up);
    world[2] = fig_sum(second.corner[1], up);
}

static void add_piece(fig_scene *scene, const fig_slice *slice, fig_role role)
{
    for (int i = 2; i < slice->count; i++) {
        tf_vector corner[3] = {slice->corner[0], slice->corner[i - 1],
                               slice->corner[i]};
        fig_scene_triangle(scene, corner, 0,
                           (fig_paint){.role = role, .shade = -0.15});
    }
}

void fig_world_bent(fig_scene *scene, const tf_worldline corner[3], double t,
                    fig_role role)
{
    enum {
        AROUND = 7
    };
    static const double border_width = 1.7;
    const fig_paint paint = {.role = role, .shade = 0.25};
    tf_simplex sweep[3];
    fig_slice slice[3];
    tf_sweep(3, corner, sweep);
    for (int i = 0; i < 3; i++) {
        slice[i] = fig_slice_of(&sweep[i], 3, t);
        add_piece(scene, &slice[i], role);
    }

    // The outer pieces are triangles, and a crease is where each begins.
    const fig_slice *first = &slice[2], *last = &slice[0];
    tf_vector second = fig_worldline_place(&corner[1], 3, t);
    const tf_vector around[AROUND] = {
        first->corner[0], first->corner[1], second,          last->corner[1],
        last->corner[2],  last->corner[0],  first->corner[0]};
    fig_scene_path(scene, AROUND, around, border_width, paint);
    fig_scene_tube(scene, first->corner[1], first->corner[2], FIG_WIDTH_THIN,
                   paint);
    fig_scene_tube(scene, last->corner[0], last->corner[1], FIG_WIDTH_THIN,
                   paint);
}

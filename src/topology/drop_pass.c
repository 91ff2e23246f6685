//: Measure a component
#include "topology/drop_pass.h"

#include "remesh/measure.h"
#include "topology/drop.h"

static double volume_of_component(const tf_adaptive_surface *surface, int count,
                                  const int triangle[])
{
    tf_vector point =
        tf_position_of(surface, *tf_triangle(surface, triangle[0]));
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += tf_volume_below(surface, triangle[i], point);
    return sum;
}

//: Drop a component if it is small
static tf_status drop_component(tf_reconnector *reconnector, int count,
                                const int triangle[])
{
    double volume = volume_of_component(reconnector->surface, count, triangle);
    if (!(fabs(volume) < reconnector->lengths.drop))
        return TF_OK;
    tf_outcome outcome;
    tf_status status = tf_adaptive_drop(
        reconnector->surface, *tf_triangle(reconnector->surface, *triangle),
        &outcome);
    if (status == TF_OK)
        tf_reconnector_count(reconnector, TF_DROP, outcome, -volume);
    return status;
}

//: Drop all small components
enum {
    WATCHED = 256 ///< triangles between two looks at the watch
};

tf_status tf_drop_pass(tf_reconnector *reconnector)
{
    const tf_adaptive_surface *surface = reconnector->surface;
    tf_components *components = &reconnector->components;
    if (!tf_components_begin(components, surface))
        return TF_OUT_OF_MEMORY;
    tf_status status = TF_OK;
    tf_watch_stage(surface->watch, "dropping", (size_t)surface->triangles);
    for (int t = 0; t < surface->triangles && status == TF_OK; t++) {
        if (t % WATCHED == 0 && !tf_watch_done(surface->watch, WATCHED))
            return TF_CANCELLED;
        if (!tf_is_triangle(surface, t) || tf_is_listed(components, t))
            continue;
        int before = components->count,
            count = tf_components_add(components, surface, t);
        status = drop_component(reconnector, count,
                                tf_components_list(components) + before);
    }
    return status == TF_OK && tf_watch_cancelled(surface->watch) ? TF_CANCELLED
                                                                 : status;
}

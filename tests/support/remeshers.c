#include "support/remeshers.h"

#include "remesh/keep_shape.h"
#include "remesh/measure.h"
#include "surgery/adaptive.h"
#include "surgery/draft.h"

#include <stdlib.h>

static tf_adaptive_surface original;

tf_remesher *remesher_begin(tf_adaptive_surface *surface,
                            const tf_remesh_policy *policy, double edge)
{
    static tf_remesher made;
    const tf_sharpness creases = {.cosine = 0.906, .depth = INFINITY};
    const tf_sharpness *sharpness =
        policy == &tf_keep_shape ? &creases : &tf_sharp_boundary;
    original = (tf_adaptive_surface){0};
    made = (tf_remesher){.surface = surface, .policy = policy, .edge = edge};
    if (tf_draft_begin(&original, surface, NULL) != TF_OK ||
        tf_original_begin(&made.original, &original, NULL) != TF_OK ||
        tf_sharp_edges_find(&made.sharp_before, &original, sharpness, NULL) ||
        !tf_sharp_edges_copy(&made.sharp, &made.sharp_before))
        abort();
    return &made;
}

void remesher_end(tf_remesher *remesher)
{
    tf_adaptive_free(remesher->surface);
    tf_remesher_free(remesher);
    tf_draft_free(&original);
}

int done(const tf_remesher *remesher, tf_operation operation)
{
    return (int)remesher->report.tried[operation][TF_COMMITTED];
}

int refused(const tf_remesher *remesher, tf_operation operation)
{
    int sum = 0;
    for (int i = TF_IMPOSSIBLE; i < TF_OUTCOMES; i++)
        sum += (int)remesher->report.tried[operation][i];
    return sum;
}

static double extreme_edge(const tf_adaptive_surface *surface, double sign)
{
    double extreme = -INFINITY;
    tf_mesh mesh = *tf_adaptive_mesh(surface);
    for (int i = 0; i < 3 * mesh.triangles; i++) {
        const int *t = mesh.triangle + i / 3 * 3;
        if (*t >= 0)
            extreme = fmax(extreme, sign * tf_length_of(surface, t[i % 3],
                                                        t[(i + 1) % 3]));
    }
    return sign * extreme;
}

double shortest_edge(const tf_adaptive_surface *surface)
{
    return extreme_edge(surface, -1);
}

double longest_edge(const tf_adaptive_surface *surface)
{
    return extreme_edge(surface, 1);
}

#include "kit/falling.h"

#include "base/require.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

int fig_falling_vertex(fig_falling *falling, const double at[], bool stays)
{
    TF_REQUIRE(falling->vertices < FIG_FALLING_MOST);
    size_t axes = (size_t)falling->axes;
    memcpy(falling->position + axes * (size_t)falling->vertices, at,
           axes * sizeof *at);
    falling->inverse_mass[falling->vertices] = stays ? 0 : 1;
    return falling->vertices++;
}

void fig_falling_begin(fig_falling *falling)
{
    const tf_mesh mesh = {.axes = falling->axes,
                          .vertices = falling->vertices,
                          .triangles = falling->triangles,
                          .triangle = falling->triangle,
                          .edges = falling->edges,
                          .edge = falling->edge};
    falling->options.size = sizeof falling->options;
    TF_REQUIRE(tf_surface_create(&mesh, &falling->surface, NULL) == TF_OK);
    TF_REQUIRE(tf_resolver_create(falling->surface, &falling->resolver) ==
               TF_OK);
}

void fig_falling_finish(fig_falling *falling)
{
    tf_resolver_free(falling->resolver);
    tf_surface_free(falling->surface);
}

static void propose(const fig_falling *falling, double end[])
{
    for (int i = 0; i < falling->axes * falling->vertices; i++) {
        bool up = i % falling->axes == falling->axes - 1;
        bool falls = falling->inverse_mass[i / falling->axes] > 0;
        end[i] = falling->position[i] + falling->step * falling->velocity[i];
        if (up && falls)
            end[i] -= FIG_GRAVITY * falling->step * falling->step;
    }
}

/// Moves what lies on the floor z = 0 up by a quarter of what is missing.
static void hop(const fig_falling *falling, double end[])
{
    for (int v = 0; v < falling->vertices; v++) {
        double *up = end + (ptrdiff_t)falling->axes * (v + 1) - 1;
        if (falling->inverse_mass[v] > 0)
            *up += 0.25 * fmax(0, falling->options.separation - *up);
    }
}

void fig_falling_step(fig_falling *falling)
{
    double end[3 * FIG_FALLING_MOST];
    const tf_response_report *report;
    tf_response_options options = falling->options;
    if (falling->hops)
        options.separation = -1;
    propose(falling, end);
    TF_REQUIRE(tf_step_resolve(falling->resolver, falling->vertices,
                               falling->position, end, falling->inverse_mass,
                               &options, &report, NULL) == TF_OK);
    if (falling->hops && report->contacts > 0)
        hop(falling, end);
    const double *to =
        falling->hops ? end : tf_resolver_unpushed(falling->resolver);
    for (int i = 0; i < falling->axes * falling->vertices; i++) {
        falling->velocity[i] = (to[i] - falling->position[i]) / falling->step;
        falling->position[i] = end[i];
    }
}

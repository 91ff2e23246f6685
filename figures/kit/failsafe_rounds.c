#include "kit/failsafe_rounds.h"

#include "base/require.h"
#include "fast/detect.h"

#include <stdlib.h>
#include <string.h>

static int go_through_rounds(tf_surface *surface, tf_step *step,
                             void (*show)(void *context, const fig_round *now),
                             void *context)
{
    tf_motion motion = {step->axes, step->vertices, step->start, step->end};
    tf_failsafe failsafe = {0};
    TF_REQUIRE(tf_failsafe_begin(&failsafe, step));
    for (int round = 0;; round++) {
        tf_contacts found;
        TF_REQUIRE(tf_surface_detect(surface, &motion, NULL, &found, NULL) ==
                   TF_OK);
        show(context, &(fig_round){round, step->end, &failsafe.groups, &found});
        if (!found.any) {
            tf_failsafe_free(&failsafe);
            return round;
        }
        tf_failsafe_round(&failsafe, step, &found);
    }
}

int fig_failsafe_rounds(const tf_mesh *mesh, const double start[],
                        const double proposed[],
                        void (*show)(void *context, const fig_round *now),
                        void *context)
{
    size_t vertices = (size_t)mesh->vertices;
    double *end = malloc(2 * vertices * sizeof *end);
    double *inverse_mass = malloc(vertices * sizeof *inverse_mass);
    tf_surface *surface;
    TF_REQUIRE(end && inverse_mass &&
               tf_surface_create(mesh, &surface, NULL) == TF_OK);
    memcpy(end, proposed, 2 * vertices * sizeof *end);
    for (size_t v = 0; v < vertices; v++)
        inverse_mass[v] = 1;
    tf_step step = {.axes = 2,
                    .vertices = mesh->vertices,
                    .start = start,
                    .proposed = proposed,
                    .inverse_mass = inverse_mass,
                    .end = end,
                    .unpushed = end}; // nothing is pushed apart
    int rounds = go_through_rounds(surface, &step, show, context);
    tf_surface_free(surface);
    free(end);
    free(inverse_mass);
    return rounds;
}

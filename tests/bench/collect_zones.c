// Prints zones that come up while cloth is twisted and stacked, as text, for
// tests/bench/zones.txt: of those that have from 24 to 200 constraints, every
// so many.
#include "response/gauss_seidel.h"
#include "response/resolve.h"
#include "support/cloth.h"
#include "support/zone_files.h"

#include <stdlib.h>

enum {
    LEAST = 24,
    MOST = 200
};

/// Every how many zones of a scene one is written, and how many came up.
static long every, came;

static size_t workspace(int axes, int vertices, int constraints)
{
    return tf_gauss_seidel.workspace(axes, vertices, constraints);
}

static int solve(tf_zone *zone)
{
    if (zone->constraints >= LEAST && zone->constraints <= MOST &&
        came++ % every == 0)
        zone_write(stdout, zone);
    return tf_gauss_seidel.solve(zone);
}

static void require(bool good)
{
    if (!good)
        abort();
}

static void run(cloth_scene scene, int edges, int steps, long part)
{
    static const tf_zone_solver writing = {"writing", workspace, solve};
    const tf_response_options options = {.solver = &writing};
    cloth_model *cloth = cloth_new(scene, edges);
    tf_surface *surface = NULL;
    tf_resolver *resolver = NULL;
    double *end = malloc(sizeof *end * 3 * (size_t)cloth->mesh.vertices);
    require(end && tf_surface_create(&cloth->mesh, &surface, NULL) == TF_OK &&
            tf_resolver_create(surface, &resolver) == TF_OK);
    every = part;
    came = 0;
    for (int i = 0; i < steps; i++) {
        cloth_propose(cloth, end);
        require(tf_step_resolve(resolver, cloth->mesh.vertices, cloth->position,
                                end, cloth->inverse_mass, &options, NULL,
                                NULL) == TF_OK);
        cloth_accept(cloth, tf_resolver_unpushed(resolver), end);
    }
    fprintf(stderr, "%s: %ld zones, every %ld\n", cloth_names[scene], came,
            every);
    free(end);
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    cloth_free(cloth);
}

int main(void)
{
    run(TWIST, 8, 160, 4);
    run(STACK_ALIGNED, 8, 60, 4);
    run(STACK_TURNED, 8, 60, 4);
    return EXIT_SUCCESS;
}

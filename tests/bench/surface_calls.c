#include "bench/long_calls.h"

#include "bench/layers.h"
#include "bench/measuring.h"
#include "fast/detect.h"
#include "response/conjugate_residuals.h"
#include "response/limit.h"
#include "response/minres.h"
#include "response/normal_residuals.h"
#include "response/resolve.h"
#include "support/generator.h"
#include "support/memory.h"
#include "surface/candidates.h"
#include "surface/check.h"

#include <stdlib.h>
#include <string.h>

// Surfaces --------------------------------------------------------------------

enum {
    SIDE = 72 // vertices; 100,820 triangles
};

/// What the layers do in a step.
typedef enum layers_step {
    PASS,    // slowly, past each other
    CROWD,   // into each other
    SCATTER, // each vertex on its own, by up to 3 edges along each axis
    TANGLE,  // the same, and at rest where that leads
    FLATTEN, // all layers, to one plane, where they are at rest
} layers_step;

typedef struct scene {
    layers cloth;
    tf_surface *surface;
    tf_resolver *resolver;
    double *end; ///< for those who change it
} scene;

static size_t numbers_of(const scene *s)
{
    return 3 * (size_t)s->cloth.mesh.vertices;
}

static void scatter(const scene *s, double *end)
{
    generator random = generator_new(2);
    for (size_t i = 0; i < numbers_of(s); i++)
        end[i] = s->cloth.motion.start[i] + uniform(&random, -3.0, 3.0) / SIDE;
}

static void flatten(const scene *s, double *end)
{
    for (size_t i = 0; i < numbers_of(s); i++)
        end[i] = i % 3 == 2 ? 0 : s->cloth.motion.start[i];
}

static void *make(int step)
{
    scene *s = allocate(1, sizeof *s);
    s->cloth = layers_new(SIDE, step == CROWD ? 2 : 3, step == CROWD ? 4 : 1);
    s->end = allocate(numbers_of(s), sizeof *s->end);
    double *end = (double *)s->cloth.motion.end;
    if (step == SCATTER || step == TANGLE)
        scatter(s, end);
    if (step == FLATTEN)
        flatten(s, end);
    if (step == TANGLE || step == FLATTEN)
        memcpy((double *)s->cloth.motion.start, end,
               numbers_of(s) * sizeof *end);
    require(tf_surface_create(&s->cloth.mesh, &s->surface, NULL));
    require(tf_resolver_create(s->surface, &s->resolver));
    return s;
}

static void release(void *made)
{
    scene *s = made;
    tf_resolver_free(s->resolver);
    tf_surface_free(s->surface);
    layers_free(&s->cloth);
    free(s->end);
    free(s);
}

// Calls -----------------------------------------------------------------------

static tf_status check(void *made, int step, const watched *how)
{
    const scene *s = made;
    const tf_check_options options = {.parallel = how->parallel,
                                      .progress = how->progress,
                                      .context = how->context};
    tf_crossings found;
    (void)step;
    return tf_surface_check(s->surface, s->cloth.mesh.vertices,
                            s->cloth.motion.start, &options, &found, NULL);
}

static tf_status detect(void *made, int step, const watched *how)
{
    const scene *s = made;
    const tf_detect_options options = {.parallel = how->parallel,
                                       .progress = how->progress,
                                       .context = how->context};
    tf_contacts found;
    (void)step;
    return tf_surface_detect(s->surface, &s->cloth.motion, &options, &found,
                             NULL);
}

static tf_status list(void *made, int step, const watched *how)
{
    const scene *s = made;
    const tf_detect_options options = {.parallel = how->parallel,
                                       .progress = how->progress,
                                       .context = how->context};
    tf_candidates found;
    (void)step;
    return tf_surface_candidates(s->surface, &s->cloth.motion, &options, &found,
                                 NULL);
}

static tf_status respond(const scene *s, tf_response_options options,
                         const watched *how)
{
    options.parallel = how->parallel;
    options.progress = how->progress;
    options.context = how->context;
    memcpy(s->end, s->cloth.motion.end, numbers_of(s) * sizeof *s->end);
    return tf_step_resolve(s->resolver, s->cloth.mesh.vertices,
                           s->cloth.motion.start, s->end, NULL, &options, NULL,
                           NULL);
}

static tf_status resolve(void *made, int step, const watched *how)
{
    (void)step;
    return respond(made, (tf_response_options){.check_start = true}, how);
}

static tf_status rub(void *made, int step, const watched *how)
{
    (void)step;
    return respond(made, (tf_response_options){.friction = 0.5}, how);
}

static tf_status push(void *made, int step, const watched *how)
{
    const tf_response_options options = {.impulse_rounds = 100,
                                         .zone_rounds = -1};
    (void)step;
    return respond(made, options, how);
}

static tf_status turn(void *made, int step, const watched *how)
{
    const tf_response_options options = {.zone_rounds = -1, .rigid = true};
    (void)step;
    return respond(made, options, how);
}

static tf_status rescue(void *made, int step, const watched *how)
{
    (void)step;
    return respond(made, (tf_response_options){.zone_rounds = -1}, how);
}

static tf_status solve_by_residuals(void *made, int step, const watched *how)
{
    (void)step;
    return respond(
        made, (tf_response_options){.solver = &tf_conjugate_residuals}, how);
}

static tf_status solve_by_minres(void *made, int step, const watched *how)
{
    (void)step;
    return respond(made, (tf_response_options){.solver = &tf_minres}, how);
}

static tf_status solve_by_normal_residuals(void *made, int step,
                                           const watched *how)
{
    (void)step;
    return respond(made, (tf_response_options){.solver = &tf_normal_residuals},
                   how);
}

static tf_status limit(void *made, int step, const watched *how)
{
    const scene *s = made;
    const tf_response_options options = {.parallel = how->parallel,
                                         .progress = how->progress,
                                         .context = how->context};
    int halvings;
    (void)step;
    memcpy(s->end, s->cloth.motion.end, numbers_of(s) * sizeof *s->end);
    return tf_step_limit(s->resolver, s->cloth.mesh.vertices,
                         s->cloth.motion.start, s->end, &options, &halvings,
                         NULL);
}

const long_call surface_calls[] = {
    {"check, apart", PASS, make, release, check},
    {"check, tangled", TANGLE, make, release, check},
    {"check, flat", FLATTEN, make, release, check},
    {"detect, passing", PASS, make, release, detect},
    {"detect, crowding", CROWD, make, release, detect},
    {"detect, scattering", SCATTER, make, release, detect},
    {"detect, flat", FLATTEN, make, release, detect},
    {"candidates, scattering", SCATTER, make, release, list},
    {"resolve, passing", PASS, make, release, resolve},
    {"resolve, crowding", CROWD, make, release, resolve},
    {"resolve, scattering", SCATTER, make, release, resolve},
    {"resolve, friction", SCATTER, make, release, rub},
    {"resolve, impulses", SCATTER, make, release, push},
    {"resolve, rigid", SCATTER, make, release, turn},
    {"resolve, failsafe", SCATTER, make, release, rescue},
    {"resolve, residuals", SCATTER, make, release, solve_by_residuals},
    {"resolve, minres", SCATTER, make, release, solve_by_minres},
    {"resolve, normal residuals", SCATTER, make, release,
     solve_by_normal_residuals},
    {"limit, crowding", CROWD, make, release, limit},
    {"limit, scattering", SCATTER, make, release, limit},
    {0},
};

#include "kit/cloth_run.h"

#include "base/require.h"
#include "simulate/cloth_scenes.h"

#include <stdlib.h>
#include <string.h>

// Running ----------------------------------------------------------------

/// A step that isn't resolved, or not as the scene would have it.
static tf_response_report make_simple_step(const fig_cloth_plan *plan,
                                           tf_cloth_simulation *s)
{
    tf_response_options options = {.friction = s->base.scene->friction};
    if (plan->chosen)
        options = (tf_response_options){.friction = plan->friction,
                                        .separation = plan->separation};
    tf_response_report report = {0};
    TF_REQUIRE(tf_cloth_propose(s) == TF_OK);
    if (!plan->unresolved) {
        const tf_response_report *lent;
        TF_REQUIRE(tf_step_resolve(s->resolver, s->base.setup.body.vertices,
                                   s->position, s->end, s->inverse_mass,
                                   &options, &lent, NULL) == TF_OK);
        report = *lent;
    }
    const double *unpushed =
        plan->unresolved ? s->end : tf_resolver_unpushed(s->resolver);
    tf_cloth_accept(s, unpushed, report.held);
    return report;
}

static tf_response_report make_step(const fig_cloth_plan *plan,
                                    tf_cloth_simulation *s)
{
    const tf_step_options options = {.check = s->base.step == 0};
    if (plan->unresolved || plan->chosen)
        return make_simple_step(plan, s);
    TF_REQUIRE(tf_cloth_kind.step(&s->base, &options) == TF_OK);
    return s->report.response;
}

static int count_crossings(const tf_cloth_simulation *s)
{
    tf_crossings found;
    TF_REQUIRE(tf_surface_check(s->surface, s->base.setup.body.vertices,
                                s->position, NULL, &found, NULL) == TF_OK);
    return (int)found.count;
}

static void note(fig_cloth_run *run, const fig_cloth_plan *plan, int i)
{
    const tf_cloth_simulation *s = run->simulation;
    fig_cloth_step *step = &run->step[i];
    size_t numbers = (size_t)run->axes * (size_t)run->vertices;
    memcpy(run->x + numbers * (size_t)i, s->position, sizeof(double) * numbers);
    step->crossings =
        plan->check > 0 && i % plan->check == 0 ? count_crossings(s) : 0;
    step->stretch = tf_body_stretch(&s->base.setup.body, s->position);
    step->kinetic = tf_body_kinetic_energy(&s->base.setup.body, s->velocity);
    step->elastic = tf_body_elastic_energy(&s->base.setup.body, s->position);
}

static void begin(fig_cloth_run *run, const fig_cloth_plan *plan)
{
    const tf_scene *scene = tf_scene_named(tf_cloth_scenes, plan->scene);
    tf_simulation *made;
    TF_REQUIRE(scene &&
               tf_simulation_create(scene, plan->size, &made) == TF_OK);
    run->simulation = (tf_cloth_simulation *)made;
    size_t frames = (size_t)plan->steps + 1;
    run->steps = plan->steps;
    run->axes = run->simulation->base.setup.body.axes;
    run->vertices = run->simulation->base.setup.body.vertices;
    run->x =
        malloc(sizeof(double) * (size_t)(run->axes * run->vertices) * frames);
    run->step = calloc(frames, sizeof *run->step);
    TF_REQUIRE(run->x && run->step);
}

// Keeping ----------------------------------------------------------------

typedef struct kept {
    fig_cloth_plan plan;
    fig_cloth_run run;
    struct kept *next;
} kept;

static bool same_plan(const fig_cloth_plan *a, const fig_cloth_plan *b)
{
    return strcmp(a->scene, b->scene) == 0 && a->size == b->size &&
           a->steps == b->steps && a->unresolved == b->unresolved &&
           a->check == b->check && a->chosen == b->chosen &&
           a->friction == b->friction && a->separation == b->separation;
}

const fig_cloth_run *fig_cloth_run_of(const fig_cloth_plan *plan)
{
    static kept *all;
    for (const kept *one = all; one; one = one->next)
        if (same_plan(&one->plan, plan))
            return &one->run;
    kept *one = calloc(1, sizeof *one);
    TF_REQUIRE(one);
    begin(&one->run, plan);
    note(&one->run, plan, 0);
    for (int i = 1; i <= plan->steps; i++) {
        one->run.step[i].report = make_step(plan, one->run.simulation);
        note(&one->run, plan, i);
    }
    one->plan = *plan;
    one->next = all;
    return &(all = one)->run;
}

// Looking at what was run ------------------------------------------------

const double *fig_cloth_run_at(const fig_cloth_run *run, int step)
{
    return run->x + (size_t)(run->axes * run->vertices) * (size_t)step;
}

int fig_cloth_run_count(const fig_cloth_run *run, tf_response_level level)
{
    int count = 0;
    for (int i = 1; i <= run->steps; i++)
        count += run->step[i].report.rounds[level] > 0;
    return count;
}

fig_cloth *fig_cloth_run_film(const fig_cloth_run *run, int first, int every)
{
    fig_cloth *cloth = fig_cloth_new(run->simulation->surface, run->axes);
    TF_REQUIRE(cloth);
    for (int i = first; i <= run->steps; i += every)
        TF_REQUIRE(
            fig_cloth_add(cloth, run->vertices, fig_cloth_run_at(run, i)));
    TF_REQUIRE(fig_cloth_end(cloth));
    return cloth;
}

// Run each scene of cloth at its usual size, by the response alone and by the
// coupling, on one thread, and print how stiff its springs are, what edges are
// stretched to, and what a step takes by its parts: lines of a CSV file.
#include "simulate/coupling.h"

#include "bench/measuring.h"
#include "simulate/cloth_scenes.h"
#include "simulate/cloth_simulation.h"

#include <math.h>
#include <stdio.h>

typedef struct costs {
    double stiffness, stretch, dynamics, response;
    tf_coupling_times times;
} costs;

static tf_status resolve(tf_cloth_simulation *c, bool coupled,
                         const tf_coupling_energy *energy,
                         tf_response_report *report)
{
    tf_response_options options = {.friction = c->base.scene->friction};
    const tf_response_report *lent;
    if (coupled)
        return tf_cloth_resolve(c, energy, &options, report);
    tf_status status =
        tf_step_resolve(c->resolver, c->base.setup.body.vertices, c->position,
                        c->end, c->inverse_mass, &options, &lent, NULL);
    if (status == TF_OK)
        *report = *lent;
    return status;
}

static void step(tf_cloth_simulation *c, bool coupled, costs *to)
{
    tf_response_report report;
    tf_coupling_energy energy = tf_cloth_energy(c);
    double begin = processor_seconds();
    require(tf_cloth_propose(c));
    double proposed = processor_seconds();
    require(resolve(c, coupled, &energy, &report));
    to->dynamics += proposed - begin;
    to->response += processor_seconds() - proposed;
    tf_cloth_accept(c, tf_resolver_unpushed(c->resolver), report.held);
    to->stretch =
        fmax(to->stretch, tf_body_stretch(&c->base.setup.body, c->position));
}

/// h^2 k / m, the mean over all free ends of springs.
static double stiffness_of(const tf_body *body, double step)
{
    double sum = 0;
    int ends = 0;
    for (int i = 0; i < body->elastics; i++) {
        const tf_elastic *e = &body->elastic[i];
        for (int k = 0; e->rest > 0 && k < e->count; k++) {
            double mass = body->mass[e->vertex[k]];
            ends += mass > 0;
            sum += mass > 0 ? step * step * e->stiffness / mass : 0;
        }
    }
    return sum / ends;
}

static costs run(const tf_scene *scene, bool coupled)
{
    tf_simulation *made;
    require(tf_simulation_create(scene, scene->resolution.usual, &made));
    tf_cloth_simulation *c = (tf_cloth_simulation *)made;
    costs sum = {.stiffness = stiffness_of(&c->base.setup.body, scene->step)};
    tf_coupling_watch(c->coupling, processor_seconds);
    for (int i = 0; i < scene->steps; i++)
        step(c, coupled, &sum);
    sum.times = tf_coupling_took(c->coupling);
    tf_simulation_free(made);
    return sum;
}

static void print(const tf_scene *scene, const char *what, double seconds)
{
    printf("%s %s,%.3f,ms\n", scene->name, what, 1000 * seconds / scene->steps);
}

int main(void)
{
    for (const tf_scene *scene = tf_cloth_scenes; scene->name; scene++) {
        costs alone = run(scene, false), coupled = run(scene, true);
        printf("%s stiffness,%.1f,\n", scene->name, alone.stiffness);
        printf("%s alone stretch,%.2f,\n", scene->name, alone.stretch);
        print(scene, "alone step", alone.dynamics + alone.response);
        print(scene, "coupled step", coupled.dynamics + coupled.response);
        print(scene, "coupled dynamics", coupled.dynamics);
        print(scene, "coupled draft", coupled.times.draft);
        print(scene, "coupled relaxation", coupled.times.relaxation);
        print(scene, "coupled answers", coupled.times.answers);
    }
    return 0;
}

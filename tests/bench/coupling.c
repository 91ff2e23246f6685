// Run each scene of cloth at its usual size, by the response alone and by the
// coupling, on one thread, and print what edges are stretched to, and what a step
// takes by its parts: lines of a CSV file.
#include "simulate/coupling.h"

#include "bench/measuring.h"
#include "simulate/cloth_scenes.h"
#include "simulate/cloth_simulation.h"

#include <math.h>
#include <stdio.h>

typedef struct costs {
    double stretch, dynamics, response;
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

static costs run(const tf_scene *scene, bool coupled)
{
    tf_simulation *made;
    require(tf_simulation_create(scene, scene->resolution.usual, &made));
    tf_cloth_simulation *c = (tf_cloth_simulation *)made;
    costs sum = {0};
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

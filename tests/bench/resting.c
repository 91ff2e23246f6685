// Whether a pile of cloth comes to rest: the scene "stack" in two sizes, for 600
// steps, in three ways.  Prints for each a line "name,value,unit" for the mean
// kinetic energy of every 20 steps, and for all steps together.
//
//     pushed    the response alone; velocities are made of the steps' ends, so the
//               pushes that make room are in them
//     unpushed  the response alone; velocities are without the pushes
//     relaxed   as the simulator does it
#include "bench/measuring.h"
#include "simulate/cloth_scenes.h"
#include "simulate/cloth_simulation.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    STEPS = 600,
    WINDOW = 20,
    LATE = 200 // from here on it should be at rest
};

static const char *const ways[] = {"pushed", "unpushed", "relaxed"};

/// Whether the failsafe had a hand in where the step ends.
static bool make_step(tf_cloth_simulation *s, int way)
{
    const tf_step_options usual = {.check = false};
    const tf_response_options options = {.friction = s->base.scene->friction};
    const tf_response_report *report;
    if (way == 2) {
        require(tf_cloth_kind.step(&s->base, &usual));
        return s->report.response.grouped > 0;
    }
    require(tf_cloth_propose(s));
    require(tf_step_resolve(s->resolver, s->base.setup.body.vertices,
                            s->position, s->end, s->inverse_mass, &options,
                            &report, NULL));
    int groups = report->grouped;
    tf_cloth_accept(s, way == 0 ? s->end : tf_resolver_unpushed(s->resolver),
                    report->held);
    return groups > 0;
}

static double kinetic_of(const tf_cloth_simulation *s)
{
    return tf_body_kinetic_energy(&s->base.setup.body, s->velocity);
}

static double energy_of(const tf_cloth_simulation *s)
{
    return kinetic_of(s) + tf_body_potential_energy(&s->base.setup.body,
                                                    s->base.scene->gravity,
                                                    s->position);
}

static void run(int size, int way)
{
    tf_simulation *made;
    const tf_scene *scene = tf_scene_named(tf_cloth_scenes, "stack");
    require(tf_simulation_create(scene, size, &made));
    tf_cloth_simulation *s = (tf_cloth_simulation *)made;
    double sum = 0, late = 0, least = energy_of(s), gain = 0;
    int failsafe = 0;
    for (int step = 1; step <= STEPS; step++) {
        failsafe += make_step(s, way);
        double kinetic = kinetic_of(s), energy = energy_of(s);
        sum += kinetic;
        late += step > LATE ? kinetic : 0;
        gain = fmax(gain, energy - least);
        least = fmin(least, energy);
        if (step % WINDOW == 0) {
            printf("%d %s kinetic %d,%.9f,J\n", size, ways[way], step,
                   sum / WINDOW);
            sum = 0;
        }
    }
    printf("%d %s late,%.9f,J\n", size, ways[way], late / (STEPS - LATE));
    printf("%d %s gain,%.6f,J\n", size, ways[way], gain);
    printf("%d %s failsafe,%d,\n", size, ways[way], failsafe);
    tf_simulation_free(made);
}

int main(void)
{
    printf("steps,%d,\nwindow,%d,\nlate,%d,\n", STEPS, WINDOW, LATE);
    for (int size = 10; size <= 20; size += 10)
        for (int way = 0; way < 3; way++)
            run(size, way);
    return EXIT_SUCCESS;
}

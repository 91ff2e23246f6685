// Whether a pile of cloth comes to rest, and what steps gain energy; prints lines
// "name,value,unit".  First comes the scene "stack" in two sizes, with the mean
// kinetic energy of every 20 steps, in three ways:
//
//     pushed    the response alone; velocities are made of the steps' ends, so the
//               pushes that make room are in them
//     unpushed  the response alone; velocities are without the pushes
//     relaxed   as the simulator does it
//
// Then come the scenes in which something falls, at their usual sizes, and what
// their steps gain, added up, `unpushed`, `careless` and `relaxed`:
//
//     careless  with a relaxation that doesn't look at energy
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

typedef enum method {
    PUSHED,
    UNPUSHED,
    CARELESS,
    RELAXED,
    METHODS
} method;

static const char *const names[METHODS] = {"pushed", "unpushed", "careless",
                                           "relaxed"};

/// A step by the response alone, or by the coupling without an eye to energy.
static tf_response_report make_simple_step(tf_cloth_simulation *s, method by)
{
    const tf_response_options options = {.friction = s->base.scene->friction};
    const tf_response_report *lent;
    tf_response_report report;
    require(tf_cloth_propose(s));
    if (by == CARELESS) {
        require(tf_coupling_resolve(s->coupling, s->position, s->end,
                                    s->inverse_mass, &options, NULL, &report));
    } else {
        require(tf_step_resolve(s->resolver, s->base.setup.body.vertices,
                                s->position, s->end, s->inverse_mass, &options,
                                &lent, NULL));
        report = *lent;
    }
    tf_cloth_accept(s,
                    by == PUSHED ? s->end : tf_resolver_unpushed(s->resolver),
                    report.held);
    return report;
}

/// Returns whether the failsafe had a hand in where the step ends.
static bool make_step(tf_cloth_simulation *s, method by)
{
    const tf_step_options usual = {.check = false};
    if (by != RELAXED)
        return make_simple_step(s, by).grouped > 0;
    require(tf_cloth_kind.step(&s->base, &usual));
    return s->report.response.grouped > 0;
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

static tf_cloth_simulation *begin(const char *scene, int size)
{
    tf_simulation *made;
    require(tf_simulation_create(tf_scene_named(tf_cloth_scenes, scene), size,
                                 &made));
    return (tf_cloth_simulation *)made;
}

static void rest(int size, method by)
{
    tf_cloth_simulation *s = begin("stack", size);
    double sum = 0, late = 0;
    int failsafe = 0;
    for (int step = 1; step <= STEPS; step++) {
        failsafe += make_step(s, by);
        sum += kinetic_of(s);
        late += step > LATE ? kinetic_of(s) : 0;
        if (step % WINDOW == 0) {
            printf("%d %s kinetic %d,%.9f,J\n", size, names[by], step,
                   sum / WINDOW);
            sum = 0;
        }
    }
    printf("%d %s late,%.9f,J\n", size, names[by], late / (STEPS - LATE));
    printf("%d %s failsafe,%d,\n", size, names[by], failsafe);
    tf_simulation_free(&s->base);
}

// As long as no script moves.
static const struct {
    const char *scene;
    int size, steps;
} falls[] = {
    {"sphere", 35, 149}, {"stack", 20, 250}, {"plane-chain", 200, 400}};

static void fall(int i, method by)
{
    tf_cloth_simulation *s = begin(falls[i].scene, falls[i].size);
    double first = energy_of(s), last = first, gain = 0;
    for (int step = 1; step <= falls[i].steps; step++) {
        make_step(s, by);
        double energy = energy_of(s);
        gain += fmax(0, energy - last);
        last = energy;
    }
    printf("%s %s gained,%.6f,J\n", falls[i].scene, names[by], gain);
    printf("%s %s lost,%.6f,J\n", falls[i].scene, names[by], first - last);
    tf_simulation_free(&s->base);
}

int main(void)
{
    printf("steps,%d,\nwindow,%d,\nlate,%d,\n", STEPS, WINDOW, LATE);
    for (int size = 10; size <= 20; size += 10)
        for (int by = 0; by < METHODS; by++)
            if (by != CARELESS)
                rest(size, (method)by);
    for (int i = 0; i < 3; i++)
        for (int by = UNPUSHED; by < METHODS; by++)
            fall(i, (method)by);
    return EXIT_SUCCESS;
}

// What it costs to resolve the steps of cloth, scene by scene:
//
//     response [PERCENT [SCENE]]
//
// of the usual number of steps; of one scene, from 0, or of all.  Prints a line
// a scene: vertices; steps without contacts, resolved by zones, and by the
// failsafe; rounds a step, mean and most; contacts; seconds of processor time
// for the first detection of all steps alone, and for resolving them, which
// includes that; what resolving costs in units of detection, over all steps, in
// the worst step, and in steps without contacts; vertices held back; how often
// a resolver took more memory once half of the steps were done; and how many
// pairs resolving decides, in units of those that detection does.

#include "bench/measuring.h"
#include "fast/detect.h"
#include "fast/vectorized.h"
#include "response/resolve.h"
#include "support/cloth.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

// A scene ---------------------------------------------------------------------

typedef struct scene {
    cloth_model *cloth;
    tf_surface *surface;
    tf_resolver *resolver;
    double *end;
} scene;

static scene scene_new(cloth_scene which, int edges)
{
    scene s = {.cloth = cloth_new(which, edges)};
    size_t numbers = (size_t)(s.cloth->mesh.axes * s.cloth->mesh.vertices);
    s.end = malloc(sizeof *s.end * numbers);
    require(s.end ? TF_OK : TF_OUT_OF_MEMORY);
    require(tf_surface_create(&s.cloth->mesh, &s.surface, NULL));
    require(tf_resolver_create(s.surface, &s.resolver));
    return s;
}

static void scene_free(scene *s)
{
    free(s->end);
    tf_resolver_free(s->resolver);
    tf_surface_free(s->surface);
    cloth_free(s->cloth);
}

static double time_detection(scene *s, size_t *pairs)
{
    const tf_detect_options all = {.narrow_phase = &tf_vectorized};
    tf_motion motion = {s->cloth->mesh.axes, s->cloth->mesh.vertices,
                        s->cloth->position, s->end};
    tf_contacts found;
    double begin = processor_seconds();
    require(tf_surface_detect(s->surface, &motion, &all, &found, NULL));
    double seconds = processor_seconds() - begin;
    *pairs += found.statistics.candidates;
    return seconds;
}

static double time_response(scene *s, tf_response_report *report)
{
    const tf_response_report *lent;
    double begin = processor_seconds();
    require(tf_step_resolve(s->resolver, s->cloth->mesh.vertices,
                            s->cloth->position, s->end, s->cloth->inverse_mass,
                            NULL, &lent, NULL));
    double seconds = processor_seconds() - begin;
    *report = *lent;
    return seconds;
}

// Sums ------------------------------------------------------------------------

typedef struct costs {
    int steps, clear, rescued, rounds, most_rounds, grown;
    long held;
    size_t contacts, detected_pairs, resolved_pairs;
    double detection, response, worst;
    double clear_detection, clear_response;
} costs;

static void account(const tf_response_report *report, double detection,
                    double response, costs *sum)
{
    int rounds = 0;
    for (int level = 0; level < TF_LEVELS; level++)
        rounds += report->rounds[level];
    sum->steps++;
    sum->rescued += report->rounds[TF_FAILSAFE] > 0;
    sum->rounds += rounds;
    sum->most_rounds = rounds > sum->most_rounds ? rounds : sum->most_rounds;
    sum->contacts += report->contacts;
    sum->resolved_pairs += report->statistics.candidates;
    sum->held += report->held;
    sum->detection += detection;
    sum->response += response;
    sum->worst = fmax(sum->worst, response / detection);
    if (report->first_contacts == 0) {
        sum->clear++;
        sum->clear_detection += detection;
        sum->clear_response += response;
    }
}

static costs measure(scene *s, int steps)
{
    costs sum = {0};
    size_t bytes = 0;
    for (int i = 0; i < steps; i++) {
        tf_response_report report;
        cloth_propose(s->cloth, s->end);
        double detection = time_detection(s, &sum.detected_pairs);
        double response = time_response(s, &report);
        account(&report, detection, response, &sum);
        size_t taken = tf_resolver_memory(s->resolver);
        sum.grown += 2 * i > steps && taken > bytes;
        bytes = taken;
        cloth_accept(s->cloth, tf_resolver_unpushed(s->resolver), s->end);
    }
    return sum;
}

static void show(cloth_scene which, int edges, int steps)
{
    scene s = scene_new(which, edges);
    costs sum = measure(&s, steps);
    printf("%-14s %5d %4d/%3d/%3d %5.1f %3d %8zu %7.2f %7.2f %6.2f %6.2f "
           "%6.2f %6ld %3d %5.2f\n",
           cloth_names[which], s.cloth->mesh.vertices, sum.clear,
           sum.steps - sum.clear - sum.rescued, sum.rescued,
           (double)sum.rounds / sum.steps, sum.most_rounds, sum.contacts,
           sum.detection, sum.response, sum.response / sum.detection, sum.worst,
           sum.clear ? sum.clear_response / sum.clear_detection : 0, sum.held,
           sum.grown, (double)sum.resolved_pairs / (double)sum.detected_pairs);
    fflush(stdout);
    scene_free(&s);
}

int main(int argc, char *argv[])
{
    static const int edges[CLOTH_SCENES] = {1000, 50, 19, 19, 21, 6};
    static const int steps[CLOTH_SCENES] = {200, 180, 120, 120, 300, 240};
    double percent = argc > 1 ? atof(argv[1]) : 100;
    printf("%-14s %5s %12s %9s %8s %7s %7s %6s %6s %6s %6s %3s %5s\n", "scene",
           "verts", "none/zon/fs", "rounds", "contacts", "det s", "res s",
           "ratio", "worst", "clear", "held", "mem", "pairs");
    int first = argc > 2 ? atoi(argv[2]) : 0;
    int last = argc > 2 ? first : CLOTH_SCENES - 1;
    for (int i = first; i <= last && i < CLOTH_SCENES; i++)
        show((cloth_scene)i, edges[i], (int)(steps[i] * percent / 100));
    return EXIT_SUCCESS;
}

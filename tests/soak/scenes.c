// Scenes of the simulator, whose every step is judged:
//
//     scenes                      all scenes, as large and as long as usual
//     scenes SCENE SIZE STEPS     one of them
//
// Each is simulated twice, with response and without, and prints how many
// vertices and triangles it has, after how many of its steps the judge found
// elements that meet, the largest stretch, how many steps needed the failsafe,
// and what it put into groups and held back at most.
#include "simulate/cloth_scenes.h"
#include "simulate/cloth_simulation.h"
#include "support/tangle.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

static tf_status succeed(tf_status status)
{
    if (status == TF_OK)
        return status;
    fprintf(stderr, "scenes: %s\n", tf_status_message(status));
    exit(EXIT_FAILURE);
}

typedef struct course {
    int vertices, triangles, steps, tangled, tangles, failsafes, grouped, held;
    double stretch;
} course;

static void step_with_response(course *c, tf_cloth_simulation *s)
{
    tf_step_options options = {.check = s->base.step == 0};
    succeed(tf_cloth_kind.step(&s->base, &options));
    const tf_response_report *report = &s->report.response;
    c->failsafes += report->rounds[TF_FAILSAFE] > 0;
    c->held += report->held;
    if (report->grouped > c->grouped)
        c->grouped = report->grouped;
}

static void step_without(tf_cloth_simulation *s)
{
    succeed(tf_cloth_propose(s));
    tf_cloth_accept(s, s->end, 0);
}

static void add_judgment(course *c, tangle_judge *judge,
                         const tf_cloth_simulation *s)
{
    int found = tangle_count(judge, s->position);
    double stretch = tf_body_stretch(&s->base.setup.body, s->position);
    c->steps++;
    c->tangled += found > 0;
    c->tangles += found;
    if (stretch > c->stretch)
        c->stretch = stretch;
}

static course follow(const tf_scene *scene, int size, int steps, bool response)
{
    course c = {0};
    tf_simulation *made;
    succeed(tf_simulation_create(scene, size, &made));
    tf_cloth_simulation *s = (tf_cloth_simulation *)made;
    tf_mesh mesh = tf_body_mesh(&s->base.setup.body);
    tangle_judge *judge = tangle_judge_new(&mesh);
    c.vertices = mesh.vertices;
    c.triangles = mesh.triangles;
    while (c.steps < steps) {
        if (response)
            step_with_response(&c, s);
        else
            step_without(s);
        add_judgment(&c, judge, s);
    }
    tangle_judge_free(judge);
    tf_simulation_free(made);
    return c;
}

/// Returns whether it is as it should be: free of tangles with response only.
static bool judge_scene(const tf_scene *scene, int size, int steps)
{
    course c = follow(scene, size, steps, true);
    printf("%s, size %d: %d vertices, %d triangles, %d steps: tangled after "
           "%d, %d with failsafe, grouped at most %.2f%%, held %d, stretched "
           "to %.2f; ",
           scene->name, size, c.vertices, c.triangles, c.steps, c.tangled,
           c.failsafes, 100.0 * c.grouped / c.vertices, c.held, c.stretch);
    fflush(stdout);
    course without = follow(scene, size, steps, false);
    printf("without response: tangled after %d, %d tangles\n", without.tangled,
           without.tangles);
    fflush(stdout);
    return c.tangled == 0 && without.tangled > 0;
}

int main(int argc, char *argv[])
{
    bool good = true;
    if (argc == 4) {
        const tf_scene *scene = tf_scene_named(tf_cloth_scenes, argv[1]);
        int size = atoi(argv[2]), steps = atoi(argv[3]);
        if (!scene || size < scene->resolution.least || steps < 1) {
            fprintf(stderr,
                    "scenes: no such scene, or SIZE or STEPS too low\n");
            return EXIT_FAILURE;
        }
        good = judge_scene(scene, size, steps);
    } else {
        for (const tf_scene *s = tf_cloth_scenes; s->name; s++)
            good = judge_scene(s, (int)s->resolution.usual, s->steps) && good;
    }
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}

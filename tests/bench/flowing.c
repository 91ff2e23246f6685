// What becomes of surfaces that flow: prints lines "name,value,unit".
//
// Enright's test comes first, for balls of 20 n^2 triangles, by their number:
// the length of edges, the most triangles, those in the end, by how many percent
// the volume has changed, the root of the mean square of the distances of the
// vertices from the sphere and the largest of them, in thousandths, and seconds
// of processor time.  Then the same ball with operations that do not keep the
// volume.  Then the scenes at their usual sizes; balls that meet at random; and
// what a step costs by the number of triangles.  Surfaces of some steps are
// judged.  An argument, `balls`, `careless`, a scene, `offsets` or `costs`,
// chooses one of these.

#include "bench/measuring.h"
#include "geometry/vector.h"
#include "simulate/flow_fields.h"
#include "simulate/flow_scenes.h"
#include "simulate/flow_simulation.h"
#include "simulate/geodesic.h"
#include "support/careless.h"
#include "support/generator.h"
#include "support/tangle.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    STEPS = 300,
    JUDGED = 10 ///< one of so many steps
};

static double read_clock(void *context)
{
    (void)context;
    return processor_seconds();
}

// A run -----------------------------------------------------------------------

/// What has been done in some steps, and what was measured before and after.
typedef struct run {
    tf_adaptive_surface *surface;
    tf_flow *flow;
    unsigned careless; ///< operations that do not keep the volume
    tf_flow_measures first, last;
    int most; ///< triangles
    size_t done[TF_RECONNECTIONS];
    size_t contacts, refused, failsafes;
    int judged, tangles;
    double reconnected; ///< the volume that was gained by it
    double seconds[TF_FLOW_PARTS];
} run;

static tf_flow_measures measure(const tf_adaptive_surface *surface)
{
    tf_flow_measures found;
    require(tf_flow_measure(surface, &found) ? TF_OK : TF_OUT_OF_MEMORY);
    return found;
}

static run run_new(tf_body *body)
{
    run r = {0};
    tf_mesh mesh = tf_body_mesh(body);
    require(body->failed ? TF_OUT_OF_MEMORY : TF_OK);
    require(tf_adaptive_create(&mesh, body->position, &r.surface, NULL));
    require(tf_flow_create(r.surface, &r.flow));
    tf_body_free(body);
    r.first = measure(r.surface);
    r.most = r.first.triangles;
    return r;
}

static void run_free(run *r)
{
    tf_flow_free(r->flow);
    tf_adaptive_free(r->surface);
}

static void add_outcomes(run *r, const tf_flow_report *report)
{
    for (int i = 0; i < TF_OPERATIONS; i++)
        for (int o = TF_COMMITTED + 1; o < TF_OUTCOMES; o++)
            r->refused += report->tried[i][o];
    for (int i = 0; i < TF_RECONNECTIONS; i++) {
        r->done[i] += report->reconnected->tried[i][TF_COMMITTED];
        r->reconnected += report->reconnected->gained[i];
    }
    for (int i = 0; i < TF_FLOW_PARTS; i++)
        r->seconds[i] += report->seconds[i];
    r->contacts += report->response->contacts;
    r->failsafes += report->response->rounds[TF_FAILSAFE] > 0;
}

static void judge(run *r)
{
    tf_mesh mesh = *tf_adaptive_mesh(r->surface);
    tangle_judge *judge = tangle_judge_new(&mesh);
    r->tangles += tangle_count(judge, tf_adaptive_positions(r->surface));
    r->judged++;
    tangle_judge_free(judge);
}

static void make_steps(run *r, const tf_flow_options *options, double length,
                       int steps)
{
    for (int i = 0; i < steps; i++) {
        const tf_flow_report *report;
        require(r->careless ? careless_step(r->flow, r->careless, i * length,
                                            length, options, &report)
                            : tf_flow_step(r->flow, i * length, length, options,
                                           &report, NULL));
        add_outcomes(r, report);
        int triangles = tf_adaptive_mesh(r->surface)->triangles;
        r->most = triangles > r->most ? triangles : r->most;
        if ((i + 1) % JUDGED == 0)
            judge(r);
    }
    r->last = measure(r->surface);
}

/// By how many percent the volume has changed.
static double change(const run *r)
{
    return 100 * (r->last.volume / r->first.volume - 1);
}

static void print_parts(const char *name, const run *r)
{
    static const char *const parts[] = {"improve", "reconnect", "advance"};
    for (int i = 0; i < 3; i++)
        printf("%s %s,%.1f,s\n", name, parts[i], r->seconds[i]);
    printf("%s judged,%d,\n%s tangles,%d,\n", name, r->judged, name,
           r->tangles);
    fflush(stdout);
}

// Enright's test --------------------------------------------------------------

static const tf_vector center = {{0.35, 0.35, 0.35}};
static const double radius = 0.15;

static run run_ball(int n, unsigned careless, int steps)
{
    tf_body body = {.axes = 3};
    tf_geodesic_add(&body, n);
    for (int i = 0; i < 3 * body.vertices; i++)
        body.position[i] = center.x[0] + radius * body.position[i];
    run r = run_new(&body);
    r.careless = careless;
    tf_velocity_field *vortices = tf_vortices;
    const tf_flow_options options = {.edge = 1.2046 * radius / n,
                                     .velocity = tf_field_apply,
                                     .context = &vortices,
                                     .clock = read_clock};
    make_steps(&r, &options, 3.0 / STEPS, steps);
    return r;
}

/// The distances of the vertices from the sphere: root of the mean square, and
/// largest, in thousandths.
static void measure_distances(const run *r, double *mean, double *most)
{
    const double *x = tf_adaptive_positions(r->surface);
    double squares = 0;
    *most = 0;
    for (int v = 0; v < r->last.vertices; v++) {
        double far =
            tf_vector_length(tf_vector_difference(tf_vector_at(x, v), center));
        squares += (far - radius) * (far - radius);
        *most = fmax(*most, 1000 * fabs(far - radius));
    }
    *mean = 1000 * sqrt(squares / r->last.vertices);
}

static void print_ball(int n)
{
    run r = run_ball(n, 0, STEPS);
    double mean, most;
    char name[20];
    snprintf(name, sizeof name, "%d", r.first.triangles);
    measure_distances(&r, &mean, &most);
    printf("%s edge,%.4f,\n", name, 1.2046 * radius / n);
    printf("%s most,%d,\n%s end,%d,\n", name, r.most, name, r.last.triangles);
    printf("%s volume,%.4f,%%\n", name, fabs(change(&r)));
    printf("%s rms,%.3f,1e-3\n%s max,%.1f,1e-3\n", name, mean, name, most);
    print_parts(name, &r);
    run_free(&r);
}

// Carelessness ----------------------------------------------------------------

static void print_careless(const char *name, unsigned careless)
{
    run r = run_ball(4, careless, STEPS);
    printf("careless %s,%.2f,%%\n", name, change(&r));
    fflush(stdout);
    run_free(&r);
}

static void print_careless_advance(void)
{
    run r = run_ball(8, 1U << CARELESS_ADVANCE, STEPS);
    double mean, most;
    measure_distances(&r, &mean, &most);
    printf("careless advance 1280,%.2f,%%\n", change(&r));
    printf("careless advance 1280 rms,%.2f,1e-3\n", mean);
    printf("careless advance 1280 max,%.1f,1e-3\n", most);
    run_free(&r);
}

// Scenes ----------------------------------------------------------------------

static void print_areas(const char *name, const run *r)
{
    printf("%s first,%d,\n", name, r->first.triangles);
    printf("%s most,%d,\n", name, r->most);
    printf("%s last,%d,\n", name, r->last.triangles);
    printf("%s parts,%d,\n", name, r->last.components);
    printf("%s area before,%.3f,\n", name, r->first.area);
    printf("%s area after,%.3f,\n", name, r->last.area);
    if (r->first.boundaries > 0)
        return;
    printf("%s volume,%.4f,%%\n", name, change(r));
    printf("%s merging,%.4f,%%\n", name,
           100 * r->reconnected / r->first.volume);
}

static void print_scene(const char *name)
{
    static const char *const changes[] = {"merges", "pinches", "drops"};
    const tf_scene *scene = tf_scene_named(tf_flow_scenes, name);
    tf_scene_setup setup = {.body.axes = 3};
    tf_flow_options options =
        tf_flow_options_of(scene, scene->resolution.usual);
    options.clock = read_clock;
    scene->build(&setup, options.edge);
    run r = run_new(&setup.body);
    make_steps(&r, &options, scene->step, scene->steps);
    printf("%s steps,%d,\n", name, scene->steps);
    print_areas(name, &r);
    for (int i = 0; i < 3; i++)
        printf("%s %s,%zu,\n", name, changes[i], r.done[i]);
    printf("%s contacts,%zu,\n", name, r.contacts);
    printf("%s failsafes,%zu,\n", name, r.failsafes);
    printf("%s refused,%zu,\n", name, r.refused);
    printf("%s genus,%d,\n", name, r.last.genus);
    print_parts(name, &r);
    run_free(&r);
}

// Balls that meet at random ---------------------------------------------------

enum {
    OFFSETS = 10,
    MEETING = 150 ///< steps, until the flow turns back
};

static run run_offset(int i)
{
    const tf_scene *scene = tf_scene_named(tf_flow_scenes, "spheres");
    const tf_flow_options options = tf_flow_options_of(scene, 0.04);
    generator random = generator_new((uint64_t)i);
    tf_scene_setup setup = {.body.axes = 3};
    tf_body *body = &setup.body;
    scene->build(&setup, options.edge);
    for (int k = 0; k < 3; k++) {
        double offset = uniform(&random, -0.06, 0.06);
        for (int v = body->vertices / 2; v < body->vertices; v++)
            body->position[3 * v + k] += offset;
    }
    run r = run_new(body);
    make_steps(&r, &options, scene->step, MEETING);
    return r;
}

static void print_offsets(void)
{
    int clean = 0, judged = 0, tangles = 0;
    for (int i = 0; i < OFFSETS; i++) {
        run r = run_offset(i);
        clean += r.done[TF_MERGE] == 1 && r.done[TF_PINCH] == 0 &&
                 r.last.components == 1 && r.last.genus == 0;
        judged += r.judged;
        tangles += r.tangles;
        run_free(&r);
    }
    printf("offsets tried,%d,\noffsets clean,%d,\n", OFFSETS, clean);
    printf("offsets judged,%d,\noffsets tangles,%d,\n", judged, tangles);
    fflush(stdout);
}

// Costs -----------------------------------------------------------------------

static void print_costs(void)
{
    enum {
        FEW = 20
    };
    static const int divisions[] = {4, 7, 13, 22, 40};
    for (int i = 0; i < 5; i++) {
        run r = run_ball(divisions[i], 0, FEW);
        double sum = 0;
        for (int k = 0; k < TF_FLOW_PARTS; k++)
            sum += r.seconds[k];
        printf("cost %d triangles,%d,\n", i, r.first.triangles);
        printf("cost %d step,%.3f,ms\n", i, 1e3 * sum / FEW);
        fflush(stdout);
        run_free(&r);
    }
}

// All of them -----------------------------------------------------------------

static void print_balls(void)
{
    static const int divisions[] = {4, 8, 16, 18};
    for (int i = 0; i < 4; i++)
        print_ball(divisions[i]);
}

static void print_all_careless(void)
{
    print_careless("split", 1U << TF_SPLIT);
    print_careless("collapse", 1U << TF_COLLAPSE);
    print_careless("flip", 1U << TF_FLIP);
    print_careless("smooth", 1U << TF_SMOOTH);
    print_careless("advance", 1U << CARELESS_ADVANCE);
    print_careless("all", (1U << CARELESS_BITS) - 1);
    print_careless_advance();
}

int main(int argc, char *argv[])
{
    static const char *const scenes[] = {"spheres", "dumbbell", "turbulence",
                                         "star", "sheets"};
    const char *only = argc > 1 ? argv[1] : NULL;
    if (!only || strcmp(only, "balls") == 0)
        print_balls();
    if (!only || strcmp(only, "careless") == 0)
        print_all_careless();
    for (int i = 0; i < 5; i++)
        if (!only || strcmp(only, scenes[i]) == 0)
            print_scene(scenes[i]);
    if (!only || strcmp(only, "offsets") == 0)
        print_offsets();
    if (!only || strcmp(only, "costs") == 0)
        print_costs();
    return 0;
}

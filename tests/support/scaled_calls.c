#include "support/scaled_calls.h"

#include "flow/flow.h"
#include "remesh/origins.h"
#include "remesh/remesh.h"
#include "support/surgery_runs.h"
#include "topology/reconnect.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Scenes at all scales --------------------------------------------------------

/// What to call, in the unit in which the scene was made.
typedef struct wish {
    scaled_call what;
    double edge, speed;
    int rounds;
} wish;

static wish choose_wish(generator *random, const adaptive_scene *scene)
{
    return (wish){.what = (scaled_call)below(random, SCALED_CALLS),
                  .edge = scene->unit * uniform(random, 0.4, 2),
                  .speed = scene->unit * uniform(random, -0.1, 0.1),
                  .rounds = 1 + below(random, 2)};
}

/// Shrinks axes, one to slivers, two to needles; returns the least exponent.
static int choose_shape(generator *random, int exponent[3])
{
    static const int most[] = {1, 1, 60, 700};
    int least = 0;
    exponent[0] = exponent[1] = exponent[2] = 0;
    for (int i = below(random, 3), far = most[below(random, 4)]; i > 0; i--) {
        int *axis = &exponent[below(random, 3)];
        *axis = -below(random, far);
        least = *axis < least ? *axis : least;
    }
    return least;
}

/// So that some bits are left below each coordinate of the scene.
static int choose_scale(generator *random, int least)
{
    int low = -900 - least;
    return low + below(random, 1000 - low);
}

static void scale_axes(double x[], int vertices, const int exponent[3])
{
    for (int i = 0; i < 3 * vertices; i++)
        x[i] = ldexp(x[i], exponent[i % 3]);
}

/// A run on a scene, which stays as it is, with all coordinates scaled.
static bool begin(surgery_run *run, const adaptive_scene *scene, int exponent)
{
    const int all[] = {exponent, exponent, exponent};
    run->scene = *scene;
    run->changed = 0;
    scale_axes(run->scene.position, scene->vertices, all);
    tf_mesh mesh = adaptive_scene_mesh(&run->scene);
    if (tf_adaptive_create(&mesh, run->scene.position, &run->surface, NULL) !=
        TF_OK)
        return false;
    memcpy(run->part, scene->part, sizeof scene->part);
    if (scene->kind != SHEETS)
        surgery_run_note(run);
    return true;
}

static bool is_too_large(const surgery_run *run, scaled_call what)
{
    double most = what == REMESH ? 0x1p1000 : 0x1p250;
    for (int i = 0; i < 3 * run->scene.vertices; i++)
        if (fabs(run->scene.position[i]) > most)
            return true;
    return false;
}

// Calls -----------------------------------------------------------------------

static bool is_share(double x)
{
    return x >= 0 && x <= 1 + 1e-9;
}

static const char *remesh(surgery_run *run, const wish *wanted, double unit,
                          tf_status *status)
{
    tf_remesh_options how = {.edge = wanted->edge * unit,
                             .rounds = wanted->rounds};
    const tf_remesh_report *r;
    *status = tf_adaptive_remesh(run->surface, &how, &r, NULL);
    bool good = *status != TF_OK ||
                (is_share(r->least_before) && is_share(r->mean_before) &&
                 is_share(r->least_after) && is_share(r->mean_after) &&
                 isfinite(r->distance));
    return good ? NULL : "the report of remeshing has no such numbers";
}

static const char *reconnect(surgery_run *run, const wish *wanted, double unit,
                             tf_status *status)
{
    tf_reconnect_options how = {.edge = wanted->edge * unit};
    const tf_reconnect_report *r;
    *status = tf_adaptive_reconnect(run->surface, &how, &r, NULL);
    for (int i = 0; i < TF_RECONNECTIONS && *status == TF_OK; i++)
        if (!isfinite(r->gained[i]))
            return "a volume is no number";
    return NULL;
}

static bool normals_are_good; // of the calls since

static void along_normals(void *context, double time, int points,
                          const double point[], const double normal[],
                          double velocity[])
{
    (void)time;
    for (int i = 0; i < 3 * points; i++) {
        normals_are_good &= isfinite(point[i]) && fabs(normal[i]) <= 1 + 1e-9;
        velocity[i] = *(const double *)context * normal[i];
    }
}

static const char *flow(surgery_run *run, const wish *wanted, double unit,
                        tf_status *status)
{
    double speed = wanted->speed * unit;
    tf_flow_options how = {.edge = wanted->edge * unit,
                           .velocity = along_normals,
                           .context = &speed};
    tf_flow *made;
    normals_are_good = true;
    if (tf_flow_create(run->surface, &made) != TF_OK)
        abort();
    *status = tf_flow_step(made, 0, 1, &how, NULL, NULL);
    tf_flow_free(made);
    return normals_are_good ? NULL : "a normal is no unit vector";
}

static const char *call(surgery_run *run, const wish *wanted, double unit,
                        tf_status *status)
{
    static const char *(*const calls[])(surgery_run *, const wish *, double,
                                        tf_status *) = {remesh, reconnect,
                                                        flow};
    return calls[wanted->what](run, wanted, unit, status);
}

// Judging ---------------------------------------------------------------------

/// After remeshing each vertex has a part from which it comes; otherwise parts
/// may have joined or come apart, and how they are nested is not judged.
static void label(surgery_run *run, scaled_call what)
{
    int vertices = tf_adaptive_mesh(run->surface)->vertices;
    const tf_origin *origin = tf_adaptive_origins(run->surface);
    if (what != REMESH) {
        run->scene.kind = SHEETS;
        run->scene.parts = label_parts(run->surface, run->part);
        return;
    }
    for (int v = 0; v < vertices; v++)
        run->part[v] =
            run->scene.part[run->scene.triangle[3 * origin[v].triangle]];
}

static const char *surface_fault(surgery_run *run, scaled_call what)
{
    const char *found = NULL;
    label(run, what);
    for (int part = 0; part < run->scene.parts && !found; part++) {
        run->changed = part;
        found = surgery_run_fault(run);
    }
    return found;
}

static const char *difference(const surgery_run *one, const surgery_run *other,
                              int exponent)
{
    tf_mesh mesh = *tf_adaptive_mesh(one->surface);
    tf_mesh same = *tf_adaptive_mesh(other->surface);
    const double *x = tf_adaptive_positions(one->surface);
    const double *y = tf_adaptive_positions(other->surface);
    if (mesh.vertices != same.vertices || mesh.triangles != same.triangles)
        return "at another scale there are other counts";
    for (int c = 0; c < 3 * mesh.triangles; c++) {
        bool gone = mesh.triangle[c / 3 * 3] < 0;
        if (gone ? same.triangle[c / 3 * 3] >= 0
                 : mesh.triangle[c] != same.triangle[c])
            return "at another scale there are other triangles";
    }
    for (int i = 0; i < 3 * mesh.vertices; i++)
        if (y[i] != ldexp(x[i], exponent))
            return "at another scale a coordinate is another";
    return NULL;
}

/// Calls for the same scene at its own scale, too.
static const char *compare(const adaptive_scene *scene, const wish *wanted,
                           const surgery_run *other, int exponent)
{
    static surgery_run one;
    tf_status status;
    if (!begin(&one, scene, 0))
        return "the scene is not embedded";
    const char *found = call(&one, wanted, 1, &status);
    if (!found && status != TF_OK)
        found = "at another scale the status is another";
    if (!found && wanted->what != FLOW)
        found = difference(&one, other, exponent);
    tf_adaptive_free(one.surface);
    return found;
}

// Running ---------------------------------------------------------------------

/// Without a fault, whether the status is the right one.
static const char *judge(surgery_run *run, const adaptive_scene *scene,
                         const wish *wanted, int exponent, tf_status status)
{
    if (is_too_large(run, wanted->what))
        return status == TF_OUT_OF_RANGE ? NULL : "it is not refused";
    if (status != TF_OK)
        return tf_status_message(status);
    const char *found = compare(scene, wanted, run, exponent);
    return found ? found : surface_fault(run, wanted->what);
}

const char *run_scaled_call(generator random, adaptive_scene_kind kind,
                            scaled_counts *counts)
{
    static adaptive_scene scene;
    static surgery_run run;
    int shape[3];
    adaptive_scene_make(&random, kind, &scene);
    int exponent = choose_scale(&random, choose_shape(&random, shape));
    scale_axes(scene.position, scene.vertices, shape);
    wish wanted = choose_wish(&random, &scene);
    if (!begin(&run, &scene, exponent))
        return "the scaled scene is not embedded";
    tf_status status;
    const char *found = call(&run, &wanted, ldexp(1, exponent), &status);
    if (!found)
        found = judge(&run, &scene, &wanted, exponent, status);
    (status == TF_OK ? counts->done : counts->refused)[wanted.what]++;
    tf_adaptive_free(run.surface);
    return found;
}

void scaled_counts_print(const scaled_counts *counts)
{
    static const char *const names[] = {"remesh", "reconnect", "flow"};
    printf("%-12s%10s%10s\n", "", "done", "refused");
    for (int i = 0; i < SCALED_CALLS; i++)
        printf("%-12s%10ld%10ld\n", names[i], counts->done[i],
               counts->refused[i]);
}

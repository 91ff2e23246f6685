//: Include what the command simulate needs

#include "files/visible.h"
#include "program/command.h"
#include "program/interruption.h"
#include "program/progress.h"
#include "program/simulation_folder.h"
#include "program/step_fields.h"
#include "scenes/scene_file.h"
#include "simulate/cloth_scenes.h"
#include "simulate/filed_scene.h"
#include "simulate/flow_scenes.h"
#include "simulate/scene_text.h"
#include "threads/threads.h"

#include <errno.h>
#include <string.h>

//: Find a built-in scene
/// NULL: none has that name.
static const tf_scene *scene_named(const char *name)
{
    const tf_scene *scene = tf_scene_named(tf_cloth_scenes, name);
    return scene ? scene : tf_scene_named(tf_flow_scenes, name);
}

static bool wants_list(const tf_request *request)
{
    return strcmp(request->operand[0], "list") == 0;
}

//: Check the resolution against the scene
static void check_size(const tf_request *request, const tf_scene *scene)
{
    if (tf_request_gave(request, "edge"))
        tf_request_refuse(request,
                          "--edge is for surfaces that flow; the scene %s has "
                          "a --size",
                          scene->name);
    if (tf_request_gave(request, "size") &&
        request->size < scene->resolution.least)
        tf_request_refuse(
            request, "--size must be %g or more for the scene %s, got '%d'",
            scene->resolution.least, scene->name, request->size);
}

static void check_edge(const tf_request *request, const tf_scene *scene)
{
    const tf_resolution *range = &scene->resolution;
    if (tf_request_gave(request, "size"))
        tf_request_refuse(request,
                          "--size is for cloth; the scene %s has an --edge",
                          scene->name);
    if (tf_request_gave(request, "edge") &&
        (request->edge > range->most || request->edge < range->least))
        tf_request_refuse(
            request, "--edge must be from %g to %g for the scene %s, got '%g'",
            range->least, range->most, scene->name, request->edge);
}

//: Check the arguments of simulate
/// Of a built-in scene.
static const tf_scene *need_scene(const tf_request *request, const char *name)
{
    const tf_scene *scene = scene_named(name);
    if (!scene)
        tf_request_refuse(
            request,
            "unknown scene '%s'; 'tanglefree simulate list' lists the scenes, "
            "and the name of a scene file ends in .yaml, .yml or .json",
            tf_make_visible(name).text);
    return scene;
}

static void check_built_in(const tf_request *request)
{
    const tf_scene *scene = need_scene(request, request->operand[0]);
    if (scene->field)
        check_edge(request, scene);
    else
        check_size(request, scene);
}

static void check(tf_request *request)
{
    bool filed = tf_is_scene(request->operand[0]);
    if (request->operands > 1 && !wants_list(request))
        tf_request_refuse(request, "one scene is required, got two");
    if (request->operands > 1)
        need_scene(request, request->operand[1]);
    if (wants_list(request))
        return;
    if (!filed)
        check_built_in(request);
    if (!request->out)
        tf_request_refuse(
            request, "--output DIR is required: the folder for the frames");
}

//: List the scenes for the user
static void list_scenes(const tf_scene list[])
{
    for (const tf_scene *s = list; s->name; s++) {
        printf("%-12s %s; %d steps, %s %g", s->name, s->shows, s->steps,
               s->kind->option, s->resolution.usual);
        printf(s->resolution.counts ? ": %s\n" : "\n", s->resolution.counts);
    }
}

//: Hold what simulate does
typedef struct run {
    const tf_request *request;
    const tf_scene *scene;
    double usual;                    ///< the usual resolution
    const tf_fault *fault_of_frames; ///< of those that the scene reads
    tf_threads *threads;
    int steps; ///< to be made in all
    tf_simulation *simulation;
    tf_simulation_folder folder;
    tf_step_totals totals;
    tf_progress_line progress;
    int signal; ///< that ended the run, or 0
} run;

static bool fault_in_step(run *r, tf_status status)
{
    if (r->fault_of_frames && r->fault_of_frames->text[0]) {
        r->folder.fault = *r->fault_of_frames;
        return false;
    }
    bool grew = status == TF_NOT_FINITE || status == TF_OUT_OF_RANGE;
    return tf_fault_set(
        &r->folder.fault, r->scene->name, -1, "step %d: %s",
        r->simulation ? r->simulation->step + 1 : 1,
        grew && r->scene->filed
            ? "positions grow without bounds; write lengths in meters, and "
              "take a shorter step or a softer material"
            : tf_status_message(status));
}

//: Make a step of the simulation, and write it
static bool add_step(run *r)
{
    char things[TF_STEP_WORDS];
    tf_simulation *s = r->simulation;
    tf_step_options how = {tf_threads_parallel(r->threads),
                           r->totals.steps == 0, tf_clock_seconds};
    tf_status status = s->scene->kind->step(s, &how);
    if (status != TF_OK)
        return fault_in_step(r, status);
    tf_step_totals_add(&r->totals, s);
    tf_step_describe(s, r->steps, things);
    tf_progress_line_show(&r->progress, s->step, things);
    return tf_simulation_folder_add(&r->folder, s);
}

//: Simulate
static double resolution_of(const run *r)
{
    return tf_request_gave(r->request, "size")   ? r->request->size
           : tf_request_gave(r->request, "edge") ? r->request->edge
                                                 : r->usual;
}

static bool simulate(run *r)
{
    const tf_request *wanted = r->request;
    tf_status status =
        tf_simulation_create(r->scene, resolution_of(r), &r->simulation);
    if (status != TF_OK)
        return fault_in_step(r, status);
    bool good = wanted->resume
                    ? tf_simulation_folder_resume(&r->folder, wanted->out,
                                                  r->simulation)
                    : tf_simulation_folder_begin(&r->folder, wanted->out,
                                                 r->simulation);
    if (good)
        tf_simulation_folder_forecast(&r->folder, r->simulation, r->steps);
    while (good && !r->signal && r->simulation->step < r->steps) {
        good = add_step(r);
        r->signal = tf_interruption();
    }
    return good;
}

//: Print what was simulated
static bool write_totals(run *r)
{
    return tf_step_totals_write(stdout, *r->request->format, &r->totals,
                                r->simulation) ||
           tf_fault_set_unwritten(&r->folder.fault, "standard output", errno);
}

static void print_end(const run *r, bool good)
{
    if (!good)
        tf_fault_print(&r->folder.fault, "tanglefree");
    else if (r->signal)
        fprintf(stderr,
                "tanglefree: interrupted after step %d of %d; go on with "
                "--resume\n",
                r->simulation->step, r->steps);
}

//: Run the command simulate
static int run_scene(run r)
{
    const tf_request *request = r.request;
    r.steps = r.scene->steps;
    if (tf_request_gave(request, "steps"))
        r.steps = request->steps;
    tf_interruption_hold(); // before there are threads
    tf_threads_create(request->threads, &r.threads);
    r.progress = tf_progress_line_begin(true);
    bool good = simulate(&r);
    tf_progress_line_end(&r.progress);
    if (good && !r.signal)
        good = write_totals(&r);
    print_end(&r, good);
    tf_simulation_folder_close(&r.folder);
    tf_simulation_free(r.simulation);
    tf_threads_free(r.threads);
    return !good ? 2 : r.signal ? 128 + r.signal : 0;
}

//: Run a scene file
/// Whether its shape, if it has one, has such a resolution.
static bool check_resolution(const tf_request *request, tf_filed_scene *filed)
{
    const tf_resolution *range = &filed->scene.resolution;
    bool size = tf_request_gave(request, "size");
    bool edge = tf_request_gave(request, "edge");
    double wanted = size ? request->size : request->edge;
    bool fits = (size || edge) && range->most > 0 &&
                size == !filed->scene.field && wanted >= range->least &&
                wanted <= range->most;
    if ((!size && !edge) || fits)
        return true;
    return range->most > 0
               ? tf_fault_set(&filed->fault, filed->path, -1,
                              "the scene has --%s, from %g to %g",
                              filed->scene.kind->option, range->least,
                              range->most)
               : tf_fault_set(&filed->fault, filed->path, -1,
                              "the meshes are as fine as their files; leave "
                              "out --%s",
                              size ? "size" : "edge");
}

static int run_file(const tf_request *request)
{
    tf_filed_scene filed;
    int status = 2;
    if (tf_filed_scene_read(&filed, request->operand[0]) &&
        check_resolution(request, &filed))
        status = run_scene((run){.request = request,
                                 .scene = &filed.scene,
                                 .usual = filed.resolution,
                                 .fault_of_frames = &filed.frames.fault});
    else
        tf_fault_print(&filed.fault, "tanglefree");
    tf_filed_scene_free(&filed);
    return status;
}

//: Run what is requested of simulate
static int run_list(const tf_request *request)
{
    if (request->operands > 1) {
        tf_scene_write(stdout, scene_named(request->operand[1]));
    } else {
        list_scenes(tf_cloth_scenes);
        list_scenes(tf_flow_scenes);
    }
    return 0;
}

static int run_simulate(const tf_request *request)
{
    const char *name = request->operand[0];
    if (wants_list(request))
        return run_list(request);
    if (tf_is_scene(name))
        return run_file(request);
    const tf_scene *scene = scene_named(name);
    return run_scene((run){
        .request = request, .scene = scene, .usual = scene->resolution.usual});
}

const tf_command tf_simulate_command = {
    .set = TF_SIMULATE,
    .name = "simulate",
    .purpose = "simulate a scene of cloth, or of a surface that flows",
    .operands = "SCENE\nlist [SCENE]",
    .least = 1,
    .most = 2,
    .wanted =
        "one scene is required; 'tanglefree simulate list' lists the scenes",
    .description = tf_simulate_description,
    .check = check,
    .run = run_simulate,
};

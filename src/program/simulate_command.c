//: Include what the command simulate needs
#define _GNU_SOURCE // isatty
#include "program/simulate_command.h"

#include "files/visible.h"
#include "program/arguments.h"
#include "program/clock.h"
#include "program/interruption.h"
#include "program/progress.h"
#include "program/simulation_folder.h"
#include "program/step_fields.h"
#include "program/threads.h"
#include "simulate/cloth_scenes.h"
#include "simulate/flow_scenes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

//: Hold what the command line requests of simulate
typedef struct request {
    const tf_scene *scene; ///< NULL: list all
    const char *folder;
    int steps;         ///< below 0: the usual number
    double size, edge; ///< the resolution; 0: the usual one
    int threads;
    bool resume;
} request;

//: Describe the usage of simulate
static const char description[] =
    "Simulate a scene in which cloth meets itself and other things, or a "
    "surface flows.\v"
    "SCENE is one of those that 'tanglefree simulate list' prints.  DIR is a "
    "folder that is not there yet, or empty.  In it frame-00000.ply is the "
    "start, and each step adds a frame, frame-00001.ply and so on, and a line "
    "to the table steps.csv.  A frame appears whole or not at all; it holds "
    "the positions of the vertices and, of cloth, their velocities.\n\n"
    "In no step do elements meet that share no vertex: that is exact.  A "
    "surface that flows is remeshed, merged and pinched between steps.\n\n"
    "The frames have the same bits for any number of threads, and even if the "
    "simulation was interrupted and went on with --resume.\n\n"
    "Exit status: 0 if all steps are made, 2 after any error, 130 after "
    "Ctrl-C, when the step that was being made is finished.";

enum {
    STEPS = 256, // the keys of options that have no short form
    SIZE,
    EDGE,
    RESUME,
    MOST_SIZE = 2000
};

static const struct argp_option options[] = {
    {"write", 'o', "DIR", 0, "The folder for the frames; required", 0},
    {"steps", STEPS, "N", 0, "How many steps; 'list' shows the default", 0},
    {"size", SIZE, "N", 0,
     "The resolution of cloth; 'list' shows what it counts, and the default",
     0},
    {"edge", EDGE, "LENGTH", 0,
     "The usual length of edges of a surface that flows; 'list' shows the "
     "default",
     0},
    {"resume", RESUME, NULL, 0, "Go on from the last frame in DIR", 0},
    {"threads", 't', "NUMBER", 0, TF_THREADS_HELP, 0},
    {0},
};

//: Parse a whole number
static int parse_count(struct argp_state *state, const char *option,
                       const char *text, int least, int most)
{
    char *end;
    long count = strtol(text, &end, 10);
    if (end == text || *end || count < least || count > most)
        argp_error(state,
                   "--%s needs a whole number from %d to %d, and not "
                   "'%s'",
                   option, least, most, tf_make_visible(text).text);
    return (int)count;
}

static double parse_length(struct argp_state *state, const char *option,
                           const char *text)
{
    char *end;
    double length = strtod(text, &end);
    if (end == text || *end || !(length > 0) || !isfinite(length))
        argp_error(state, "--%s needs a length above 0, and not '%s'", option,
                   tf_make_visible(text).text);
    return length;
}

//: Find the scene among the arguments of simulate
static void choose_scene(struct argp_state *state, const char *name)
{
    request *wanted = state->input;
    if (strcmp(name, "list") == 0)
        return;
    wanted->scene = tf_scene_named(tf_cloth_scenes, name);
    if (!wanted->scene)
        wanted->scene = tf_scene_named(tf_flow_scenes, name);
    if (!wanted->scene)
        argp_error(state,
                   "unknown scene '%s'; 'tanglefree simulate list' prints all",
                   tf_make_visible(name).text);
}

//: Check the arguments of simulate against its scene
/// The range of the resolution depends on the scene.
static void check_cloth(struct argp_state *state, const request *wanted)
{
    const tf_scene *scene = wanted->scene;
    if (wanted->edge > 0)
        argp_error(state,
                   "--edge is for surfaces that flow; the scene %s has "
                   "a --size",
                   scene->name);
    if (wanted->size > 0 && wanted->size < scene->resolution.least)
        argp_error(state, "the scene %s needs a --size of %g or more",
                   scene->name, scene->resolution.least);
}

static void check_flow(struct argp_state *state, const request *wanted)
{
    const tf_scene *scene = wanted->scene;
    if (wanted->size > 0)
        argp_error(state, "--size is for cloth; the scene %s has an --edge",
                   scene->name);
    if (wanted->edge > 0 && (wanted->edge > scene->resolution.most ||
                             wanted->edge < scene->resolution.least))
        argp_error(state, "the scene %s needs an --edge from %g to %g",
                   scene->name, scene->resolution.least,
                   scene->resolution.most);
}

static void check_request(struct argp_state *state)
{
    request *wanted = state->input;
    if (!wanted->scene)
        return;
    if (!wanted->folder)
        argp_error(state, "-o DIR is required: the folder for the frames");
    if (wanted->scene->field)
        check_flow(state, wanted);
    else
        check_cloth(state, wanted);
    if (wanted->steps < 0)
        wanted->steps = wanted->scene->steps;
}

//: Parse an argument of simulate
static error_t parse_argument(int key, char *text, struct argp_state *state)
{
    request *wanted = state->input;
    switch (key) {
    case 'o':
        wanted->folder = text;
        return 0;
    case STEPS:
        wanted->steps = parse_count(state, "steps", text, 0, TF_MOST_STEPS);
        return 0;
    case SIZE:
        wanted->size = parse_count(state, "size", text, 1, MOST_SIZE);
        return 0;
    case EDGE:
        wanted->edge = parse_length(state, "edge", text);
        return 0;
    case RESUME:
        wanted->resume = true;
        return 0;
    case 't':
        wanted->threads = tf_parse_threads(state, text);
        return 0;
    case ARGP_KEY_ARG:
        if (state->arg_num > 0)
            return ARGP_ERR_UNKNOWN;
        choose_scene(state, text);
        return 0;
    case ARGP_KEY_NO_ARGS:
        argp_error(state,
                   "no scene given; 'tanglefree simulate list' prints all");
        return 0;
    case ARGP_KEY_END:
        check_request(state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
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
    request request;
    tf_simulation *simulation;
    tf_simulation_folder folder;
    tf_step_totals totals;
    tf_progress progress;
    int signal; ///< that ended the run, or 0
    char fault[TF_FOLDER_FAULT_LENGTH];
} run;

static bool fault_in_step(run *r, tf_status status)
{
    snprintf(
        r->fault, sizeof r->fault, "%s: step %d: %s", r->request.scene->name,
        r->simulation ? r->simulation->step + 1 : 1, tf_status_message(status));
    return false;
}

//: Make a step of the simulation, and write it
static bool add_step(run *r)
{
    char things[TF_STEP_WORDS + 32], words[TF_STEP_WORDS];
    tf_simulation *s = r->simulation;
    tf_parallel threads = tf_threads(&r->request.threads);
    tf_step_options how = {&threads, r->totals.steps == 0, tf_clock_seconds};
    tf_status status = s->scene->kind->step(s, &how);
    if (status != TF_OK)
        return fault_in_step(r, status);
    tf_step_totals_add(&r->totals, s);
    tf_step_describe(s, words);
    snprintf(things, sizeof things, "of %d steps, %s", r->request.steps, words);
    tf_progress_show(&r->progress, s->step, things);
    return tf_simulation_folder_add(&r->folder, s);
}

//: Simulate
static bool simulate(run *r)
{
    const request *wanted = &r->request;
    double chosen = wanted->size + wanted->edge; // at most one is not 0
    tf_status status = tf_simulation_create(
        wanted->scene, chosen > 0 ? chosen : wanted->scene->resolution.usual,
        &r->simulation);
    if (status != TF_OK)
        return fault_in_step(r, status);
    bool good = wanted->resume
                    ? tf_simulation_folder_resume(&r->folder, wanted->folder,
                                                  r->simulation)
                    : tf_simulation_folder_begin(&r->folder, wanted->folder,
                                                 r->simulation);
    while (good && !r->signal && r->simulation->step < wanted->steps) {
        good = add_step(r);
        r->signal = tf_interruption();
    }
    return good;
}

//: Print what was simulated
static void print_end(const run *r, bool good)
{
    const char *fault = r->fault[0] ? r->fault : r->folder.fault;
    if (!good)
        fprintf(stderr, "tanglefree: %s\n", fault);
    else if (r->signal)
        fprintf(stderr,
                "tanglefree: interrupted after step %d of %d; go on with "
                "--resume\n",
                r->simulation->step, r->request.steps);
    else
        tf_step_totals_write(stdout, &r->totals, r->simulation);
}

//: Run the command simulate
int tf_simulate_command(int argc, char *argv[])
{
    static const struct argp parser = {
        options, parse_argument, "SCENE\nlist", description, NULL, NULL, NULL};
    run r = {.request = {.steps = -1, .threads = tf_threads_available()}};
    argp_parse(&parser, argc, argv, 0, NULL, &r.request);
    if (!r.request.scene) {
        list_scenes(tf_cloth_scenes);
        list_scenes(tf_flow_scenes);
        return 0;
    }

    // Nothing is printed until the line is erased: it may share its terminal.
    tf_interruption_hold();
    r.progress = tf_progress_begin();
    r.progress.wanted = isatty(STDERR_FILENO);
    bool good = simulate(&r);
    tf_progress_end(&r.progress);
    print_end(&r, good);
    tf_simulation_folder_close(&r.folder);
    tf_simulation_free(r.simulation);
    return !good ? 2 : r.signal ? 128 + r.signal : 0;
}

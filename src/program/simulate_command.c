//: Include what the command simulate needs
#define _GNU_SOURCE // isatty
#include "program/simulate_command.h"

#include "files/visible.h"
#include "program/arguments.h"
#include "program/clock.h"
#include "program/cloth_simulated.h"
#include "program/flow_simulated.h"
#include "program/interruption.h"
#include "program/progress.h"
#include "program/simulation_folder.h"
#include "program/summary.h"
#include "program/threads.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

//: Hold what the command line requests of simulate
typedef struct request {
    const tf_scene *scene;     ///< of cloth, or NULL
    const tf_flow_scene *flow; ///< or of a flow; if both are NULL, list all
    const char *folder;
    int steps, size, threads; ///< 0: the usual number
    double edge;              ///< 0: the usual length
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

static const double least_edge = 0.001;

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
    wanted->scene = tf_scene_named(name);
    wanted->flow = tf_flow_scene_named(name);
    if (!wanted->scene && !wanted->flow)
        argp_error(state,
                   "unknown scene '%s'; 'tanglefree simulate list' prints all",
                   tf_make_visible(name).text);
}

//: Check the arguments of simulate against its scene
/// The smallest size depends on the scene.
static void check_cloth(struct argp_state *state, request *wanted)
{
    if (wanted->edge > 0)
        argp_error(state,
                   "--edge is for surfaces that flow; the scene %s has "
                   "a --size",
                   wanted->scene->name);
    if (wanted->size == 0)
        wanted->size = wanted->scene->size;
    if (wanted->steps < 0)
        wanted->steps = wanted->scene->steps;
    if (wanted->size < wanted->scene->least)
        argp_error(state, "the scene %s needs a --size of %d or more",
                   wanted->scene->name, wanted->scene->least);
}

static void check_flow(struct argp_state *state, request *wanted)
{
    if (wanted->size > 0)
        argp_error(state, "--size is for cloth; the scene %s has an --edge",
                   wanted->flow->name);
    if (wanted->edge == 0)
        wanted->edge = wanted->flow->edge;
    if (wanted->steps < 0)
        wanted->steps = wanted->flow->steps;
    if (wanted->edge > wanted->flow->most || wanted->edge < least_edge)
        argp_error(state, "the scene %s needs an --edge from %g to %g",
                   wanted->flow->name, least_edge, wanted->flow->most);
}

static void check_request(struct argp_state *state)
{
    request *wanted = state->input;
    if ((wanted->scene || wanted->flow) && !wanted->folder)
        argp_error(state, "-o DIR is required: the folder for the frames");
    if (wanted->scene)
        check_cloth(state, wanted);
    if (wanted->flow)
        check_flow(state, wanted);
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
static void list_scenes(void)
{
    int count;
    const tf_scene *scene = tf_scenes(&count);
    for (int i = 0; i < count; i++, scene++)
        printf("%-12s %s; %d steps, size %d: %s\n", scene->name, scene->shows,
               scene->steps, scene->size, scene->size_means);
    const tf_flow_scene *flow = tf_flow_scenes(&count);
    for (int i = 0; i < count; i++, flow++)
        printf("%-12s %s; %d steps, edge %g\n", flow->name, flow->shows,
               flow->steps, flow->edge);
}

//: Hold what simulate does
typedef struct run {
    request request;
    tf_simulated *simulated;
    tf_simulation_folder folder;
    tf_progress progress;
    bool begun; ///< whether a step was made
    int signal; ///< that ended the run, or 0
    char fault[TF_FOLDER_FAULT_LENGTH];
} run;

static const char *name_of_scene(const request *wanted)
{
    return wanted->flow ? wanted->flow->name : wanted->scene->name;
}

static bool fault_in_step(run *r, tf_status status)
{
    snprintf(r->fault, sizeof r->fault, "%s: step %d: %s",
             name_of_scene(&r->request),
             r->simulated ? r->simulated->step + 1 : 1,
             tf_status_message(status));
    return false;
}

//: Make a step of the simulation, and write it
static bool add_step(run *r)
{
    char words[TF_SIMULATED_NAME], things[TF_SIMULATED_NAME + 32];
    tf_parallel threads = tf_threads(&r->request.threads);
    tf_step_way way = {&threads, !r->begun, tf_clock_seconds};
    tf_status status = r->simulated->kind->advance(r->simulated, &way, words);
    if (status != TF_OK)
        return fault_in_step(r, status);
    r->begun = true;
    snprintf(things, sizeof things, "of %d steps, %s", r->request.steps, words);
    tf_progress_show(&r->progress, r->simulated->step, things);
    return tf_simulation_folder_add(&r->folder, r->simulated);
}

//: Simulate
static tf_status set_up(run *r)
{
    const request *wanted = &r->request;
    return wanted->flow
               ? tf_flow_simulate(wanted->flow, wanted->edge, &r->simulated)
               : tf_cloth_simulate(wanted->scene, wanted->size, &r->simulated);
}

static bool simulate(run *r)
{
    const request *wanted = &r->request;
    tf_status status = set_up(r);
    if (status != TF_OK)
        return fault_in_step(r, status);
    bool good = wanted->resume
                    ? tf_simulation_folder_resume(&r->folder, wanted->folder,
                                                  r->simulated)
                    : tf_simulation_folder_begin(&r->folder, wanted->folder,
                                                 r->simulated);
    while (good && !r->signal && r->simulated->step < wanted->steps) {
        good = add_step(r);
        r->signal = tf_interruption();
    }
    return good;
}

//: Print what was simulated
static void print_total(const run *r)
{
    tf_entry entry[TF_SIMULATED_ENTRIES];
    int count = r->simulated->kind->summarize(r->simulated, entry);
    tf_summary_write(stdout, count, entry);
}

static void print_end(const run *r, bool good)
{
    const char *fault = r->fault[0] ? r->fault : r->folder.fault;
    if (!good)
        fprintf(stderr, "tanglefree: %s\n", fault);
    else if (r->signal)
        fprintf(stderr,
                "tanglefree: interrupted after step %d of %d; go on with "
                "--resume\n",
                r->simulated->step, r->request.steps);
    else
        print_total(r);
}

//: Run the command simulate
int tf_simulate_command(int argc, char *argv[])
{
    static const struct argp parser = {
        options, parse_argument, "SCENE\nlist", description, NULL, NULL, NULL};
    run r = {.request = {.steps = -1, .threads = tf_threads_available()}};
    argp_parse(&parser, argc, argv, 0, NULL, &r.request);
    if (!r.request.scene && !r.request.flow) {
        list_scenes();
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
    if (r.simulated)
        r.simulated->kind->free(r.simulated);
    return !good ? 2 : r.signal ? 128 + r.signal : 0;
}

//: Include what the commands about surfaces need
#include "program/surface_command.h"

#include "program/arguments.h"
#include "program/arithmetics.h"
#include "program/frames.h"
#include "program/narrow_phases.h"
#include "program/progress.h"
#include "program/surface_output.h"
#include "program/threads.h"

#include <string.h>

//: Hold what the command line requests about surfaces
typedef struct request {
    tf_format format;
    int threads;
    const tf_arithmetic *arithmetic;
    const tf_narrow_phase *narrow_phase;
    tf_contact_selection selection;
    char **paths;
    int path_count;
} request;

//: Describe the usage about surfaces
static const char detect_description[] =
    "Find every contact of a moving surface, step by step.\v"
    "Each file is a mesh in Wavefront OBJ or PLY; \"-\" is standard input.  "
    "All have the same elements, each in another position.  From each file to "
    "the next is a step, in which the vertices move in straight lines.  Faces "
    "are triangles.  Edges of their own (l in OBJ, edge in PLY) and vertices "
    "of no element take part, too.  A mesh without faces whose z are all 0 is "
    "in the plane.\n\n"
    "csv prints one row per contact, of two elements that share no vertex: the "
    "step, from 0; the kind, point-triangle (a touches bcd), edge-edge (ab "
    "touches cd) or in the plane point-edge (a touches bc); the vertices, from "
    "0; and toi_lo, toi_hi, nx, ny, nz, normal_velocity and case as in "
    "'tanglefree query'.  json prints the same and the summary.  summary "
    "counts steps, contacts and candidates (pairs whose boxes overlap), and "
    "how many of these were decided by an axis, by the filter and by signs.\n\n"
    "If the surface is free of intersections at the start ('tanglefree "
    "check'), and there is no contact, it is free of them at the end, and "
    "nothing has passed through anything.\n\n"
    "Exit status: 0 if there is no contact, 1 if there is one, 2 if the "
    "arguments or the input are invalid or the output cannot be written.";

static const char check_description[] =
    "Find where surfaces at rest intersect themselves.\v"
    "Each file is a mesh in Wavefront OBJ or PLY; \"-\" is standard input.  "
    "Faces are triangles.  Edges of their own (l in OBJ, edge in PLY) and "
    "vertices of no element take part, too.  A mesh without faces whose z are "
    "all 0 is in the plane.\n\n"
    "csv prints one row per intersection, of two elements that share no "
    "vertex: the file; the kind, edge-triangle (ab passes through cde), "
    "point-triangle (a lies on bcd) or edge-edge (ab meets cd); and the "
    "vertices, from 0.  json prints the same and the summary.  summary counts "
    "files and intersections.  The answers are exact.\n\n"
    "Exit status: 0 if all surfaces are free of intersections, 1 if one is "
    "not, 2 if the arguments or the input are invalid or the output cannot be "
    "written.";

#define TF_OUTPUT_OPTIONS                                                      \
    {"output", 'o', "FORMAT", 0, TF_ROWS_FORMAT_NAMES "; the default is csv",  \
     0},                                                                       \
    {                                                                          \
        "threads", 't', "NUMBER", 0, TF_THREADS_HELP, 0                        \
    }

static const struct argp_option detect_options[] = {
    {"first", 'f', NULL, 0, "Only the first contact of each step", 0},
    {"arithmetic", 'a', "NAME", 0,
     "How signs are found: " TF_ARITHMETIC_NAMES "; the default is exact", 0},
    {"narrow-phase", 'n', "NAME", 0,
     "What decides the candidates: " TF_NARROW_PHASE_NAMES
     "; the default is vector, which is faster; both give the same answers",
     0},
    TF_OUTPUT_OPTIONS,
    {0},
};

static const struct argp_option check_options[] = {
    TF_OUTPUT_OPTIONS,
    {0},
};

//: Parse an argument about surfaces
static error_t parse_argument(int key, char *text, struct argp_state *state)
{
    request *wanted = state->input;
    switch (key) {
    case 'f':
        wanted->selection = TF_FIRST_CONTACT;
        return 0;
    case 'a':
        if (!(wanted->arithmetic = tf_arithmetic_named(text)))
            tf_refuse_name(state, "arithmetic", text, TF_ARITHMETIC_NAMES);
        return 0;
    case 'n':
        if (!(wanted->narrow_phase = tf_narrow_phase_named(text)))
            tf_refuse_name(state, "narrow phase", text, TF_NARROW_PHASE_NAMES);
        return 0;
    case 'o':
        wanted->format = tf_parse_format(state, text, true);
        return 0;
    case 't':
        wanted->threads = tf_parse_threads(state, text);
        return 0;
    case ARGP_KEY_ARGS:
        wanted->paths = state->argv + state->next;
        wanted->path_count = state->argc - state->next;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

//: Check the number of files
static error_t parse_detect(int key, char *text, struct argp_state *state)
{
    const request *wanted = state->input;
    if (key == ARGP_KEY_END && wanted->path_count < 2)
        argp_error(state, "two files or more are required, START and END");
    return parse_argument(key, text, state);
}

static error_t parse_check(int key, char *text, struct argp_state *state)
{
    const request *wanted = state->input;
    if (key == ARGP_KEY_END && wanted->path_count < 1)
        argp_error(state, "a file is required, or - for standard input");
    return parse_argument(key, text, state);
}

//: Hold what a command does
typedef struct work {
    request request;
    tf_frames frames;
    tf_surface_output output;
    tf_progress progress;
} work;

/// Reports a status of the surface as a fault of the current file.
static bool succeeded(work *w, tf_status status, const tf_flaw *flaw)
{
    return status == TF_OK || tf_frames_fault(&w->frames, status, flaw);
}

//: Report a coordinate that is out of range about surfaces
static bool fault_in_range(work *w, int vertex)
{
    const tf_arithmetic *arithmetic = w->request.arithmetic;
    int axes = w->frames.axes;
    const double *x[2];
    for (int i = 0; i < 2; i++)
        x[i] = w->frames.file[i].position.item + 3 * (size_t)vertex;
    int i = 0;
    while (i < 2 * axes - 1 &&
           tf_arithmetic_fits(arithmetic, axes, x[i / axes][i % axes]))
        i++;
    tf_mesh_file *file = &w->frames.file[i / axes];
    return tf_mesh_file_fault(file, file->vertex_place.item[vertex],
                              TF_OUT_OF_RANGE_FAULT, x[i / axes][i % axes],
                              tf_arithmetic_name(arithmetic),
                              tf_arithmetic_bits(arithmetic, axes));
}

//: Detect the contacts of all steps
static bool detect_step(work *w)
{
    tf_parallel threads = tf_threads(&w->request.threads);
    tf_detect_options detection = {.selection = w->request.selection,
                                   .arithmetic = w->request.arithmetic,
                                   .narrow_phase = w->request.narrow_phase,
                                   .parallel = &threads};
    tf_motion motion = tf_frames_motion(&w->frames);
    tf_contacts found;
    tf_flaw flaw;
    tf_status status = tf_surface_detect(w->frames.surface, &motion, &detection,
                                         &found, &flaw);
    if (status == TF_OUT_OF_RANGE)
        return fault_in_range(w, flaw.vertex);
    return succeeded(w, status, &flaw) &&
           tf_surface_output_contacts(&w->output, w->frames.axes, &found);
}

static bool detect_all(work *w)
{
    for (int i = 0; i < w->request.path_count; i++) {
        if (!tf_frames_next(&w->frames, w->request.paths[i]) ||
            (i > 0 && !detect_step(w)))
            return false;
        tf_progress_show(&w->progress, (long)w->output.tally.parts, "steps");
    }
    return true;
}

//: Check all surfaces
static bool check_file(work *w, const char *path)
{
    tf_parallel threads = tf_threads(&w->request.threads);
    tf_frames_free(&w->frames);
    if (!tf_frames_next(&w->frames, path))
        return false;
    tf_motion rest = tf_frames_motion(&w->frames);
    tf_crossings found;
    tf_flaw flaw;
    tf_status status = tf_surface_check(w->frames.surface, rest.start,
                                        rest.vertices, &threads, &found, &flaw);
    return succeeded(w, status, &flaw) &&
           tf_surface_output_crossings(
               &w->output, tf_frames_file(&w->frames)->name, &found);
}

static bool check_all(work *w)
{
    for (int i = 0; i < w->request.path_count; i++) {
        if (!check_file(w, w->request.paths[i]))
            return false;
        tf_progress_show(&w->progress, (long)w->output.tally.parts, "files");
    }
    return true;
}

//: Print what went wrong about surfaces
static void print_errors(const work *w)
{
    if (w->output.records.error != 0)
        fprintf(stderr,
                "tanglefree: standard output: cannot write: %s; mend that and "
                "run again\n",
                strerror(w->output.records.error));
    for (int i = 0; i < 2; i++)
        if (w->frames.file[i].fault[0] != '\0')
            tf_mesh_file_print_fault(&w->frames.file[i], "tanglefree");
}

//: Run a command
static int run(int argc, char *argv[], const struct argp *parser, bool checks,
               bool (*do_all)(work *))
{
    work w = {.request = {.narrow_phase = tf_narrow_phase_named("vector"),
                          .threads = tf_threads_available()}};
    argp_parse(parser, argc, argv, 0, NULL, &w.request);

    w.progress = tf_progress_begin();
    bool good =
        tf_surface_output_begin(&w.output, stdout, w.request.format, checks) &&
        do_all(&w);
    tf_progress_end(&w.progress);
    good = tf_surface_output_end(&w.output) && good;
    print_errors(&w);
    tf_frames_free(&w.frames);
    return !good ? 2 : w.output.tally.tangled > 0;
}

int tf_detect_command(int argc, char *argv[])
{
    static const struct argp parser = {detect_options,
                                       parse_detect,
                                       "START END [END...]",
                                       detect_description,
                                       NULL,
                                       NULL,
                                       NULL};
    return run(argc, argv, &parser, false, detect_all);
}

int tf_check_command(int argc, char *argv[])
{
    static const struct argp parser = {
        check_options, parse_check, "FILE...", check_description,
        NULL,          NULL,        NULL};
    return run(argc, argv, &parser, true, check_all);
}

//: Include what the command remesh needs
#define _GNU_SOURCE // isatty
#include "program/remesh_command.h"

#include "program/arguments.h"
#include "program/clock.h"
#include "program/defects.h"
#include "program/frames.h"
#include "program/mesh_output.h"
#include "program/progress.h"
#include "program/remesh_output.h"
#include "remesh/remesh.h"

#include <float.h>
#include <limits.h>
#include <string.h>
#include <unistd.h>

//: Hold what the command line requests of remesh
typedef struct request {
    const char *in, *out;
    tf_remesh_options options;
    tf_format format;
} request;

//: Describe the usage of remesh
static const char description[] =
    "Give a surface triangles that are nearly equilateral.\v"
    "IN is a mesh in Wavefront OBJ or PLY; \"-\" is standard input.  It must "
    "be "
    "a surface that does not intersect or touch itself: each edge has two "
    "triangles, in opposite directions, or one.  OUT is OBJ or PLY as its "
    "ending says, .obj or .ply, or else as IN is, and appears whole or not at "
    "all.  If it is \"-\", the mesh is written to standard output, and the "
    "report to standard error.\n\n"
    "Long edges are split, short ones collapse, others flip, and vertices "
    "move along the surface.  Each change is tested exactly, so that OUT does "
    "not intersect itself either, and IN can be moved to it without passing "
    "through itself.  Boundaries and creases of more than 60 degrees stay.\n\n"
    "The report lists the triangles, their quality (1 is equilateral), how far "
    "the two surfaces are apart at most, and what was done and refused, by "
    "cause.\n\n"
    "Exit status: 0 if OUT is written, 2 after any error; then OUT is as it "
    "was before.";

enum {
    ROUNDS = 256, // the keys of options that have no short form
    OUTPUT
};

static const struct argp_option options[] = {
    {"write", 'o', "OUT", 0, "Where to write the new mesh; required", 0},
    {"edge", 'e', "L", 0, "The length that edges should have; required", 0},
    {"rounds", ROUNDS, "N", 0,
     "How often to go through all changes; the default is 5", 0},
    {"output", OUTPUT, "FORMAT", 0,
     "The report: " TF_REPORT_FORMAT_NAMES "; the default is summary", 0},
    {0},
};

//: Parse the numbers of remesh
static void parse_edge(request *wanted, const char *text,
                       struct argp_state *state)
{
    static const char words[] = "above 0, such as 0.1";
    wanted->options.edge = tf_parse_number(state, "edge", text, DBL_MAX, words);
    if (wanted->options.edge == 0)
        argp_error(state, "--edge=%s: the length must be %s", text, words);
}

static void parse_rounds(request *wanted, const char *text,
                         struct argp_state *state)
{
    static const char words[] = "a whole number from 1 to 1000";
    double number = tf_parse_number(state, "rounds", text, 1000, words);
    wanted->options.rounds = (int)number;
    if (wanted->options.rounds != number || number < 1)
        argp_error(state, "--rounds=%s: there must be %s", text, words);
}

//: Check the arguments of remesh
static void check_request(struct argp_state *state)
{
    const request *wanted = state->input;
    if (state->argc - state->next != 1)
        argp_error(state, "one file is required, IN");
    if (!wanted->out)
        argp_error(state, "-o OUT is required: where to write the new mesh");
    if (wanted->options.edge == 0)
        argp_error(state,
                   "--edge L is required: the length that edges should have");
}

//: Parse an argument of remesh
static error_t parse_argument(int key, char *text, struct argp_state *state)
{
    request *wanted = state->input;
    switch (key) {
    case 'o':
        wanted->out = text;
        return 0;
    case 'e':
        parse_edge(wanted, text, state);
        return 0;
    case ROUNDS:
        parse_rounds(wanted, text, state);
        return 0;
    case OUTPUT:
        wanted->format = tf_parse_format(state, text, false);
        return 0;
    case ARGP_KEY_ARGS:
        wanted->in = state->argv[state->next];
        check_request(state);
        return 0;
    case ARGP_KEY_NO_ARGS:
        check_request(state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

//: Hold what remesh does
typedef struct remeshing {
    request request;
    tf_frames frames;
    tf_adaptive_surface *surface;
    tf_remeshed done;
    tf_mesh_file mesh; ///< that is written
    tf_mesh_output out;
    tf_progress progress;
} remeshing;

//: Make the surface of a file adaptive
static bool load(remeshing *r)
{
    tf_mesh_file *file = &r->frames.file[r->frames.current];
    tf_mesh mesh = {.axes = 3,
                    .vertices = tf_mesh_file_vertices(file),
                    .triangles = tf_mesh_file_triangles(file),
                    .triangle = file->triangle.item,
                    .edges = tf_mesh_file_edges(file),
                    .edge = file->edge.item};
    tf_defect defect;
    r->done.triangles_before = mesh.triangles;
    tf_status status =
        tf_adaptive_create(&mesh, file->position.item, &r->surface, &defect);
    return status == TF_OK || tf_defect_fault(file, status, &defect);
}

//: Show the progress of remeshing
static void show_progress(void *context, const tf_remesh_report *so_far)
{
    size_t done = 0;
    for (int i = 0; i < TF_OPERATIONS; i++)
        done += so_far->tried[i][TF_COMMITTED];
    tf_progress_show(context, (long)done, "changes");
}

//: Remesh the surface of a file
static bool remesh(remeshing *r)
{
    tf_remesh_options *how = &r->request.options;
    how->progress = show_progress;
    how->context = &r->progress;
    double begin = tf_clock_seconds();
    tf_status status = tf_adaptive_remesh(r->surface, how, &r->done.report);
    r->done.seconds = tf_clock_seconds() - begin;
    r->done.edge = how->edge;
    tf_mesh_file *file = &r->frames.file[r->frames.current];
    if (status == TF_BAD_TOLERANCE)
        return tf_mesh_file_fault(
            file, -1,
            "--edge %g would take too many triangles; give a longer one",
            how->edge);
    return status == TF_OK || tf_defect_fault(file, status, &(tf_defect){0});
}

//: Fill a file with the surface
static bool fill_file(remeshing *r)
{
    const tf_mesh_file *in = tf_frames_file(&r->frames);
    tf_mesh mesh = tf_adaptive_mesh(r->surface);
    const double *x = tf_adaptive_positions(r->surface);
    bool good = true;
    r->mesh = (tf_mesh_file){
        .name = in->name, .format = in->format, .first_index = in->first_index};
    r->done.triangles_after = mesh.triangles;
    for (int v = 0; v < mesh.vertices && good; v++)
        good = tf_mesh_file_add_vertex(&r->mesh, x + 3 * (size_t)v, v);
    for (int t = 0; t < mesh.triangles && good; t++)
        good = tf_mesh_file_add_triangle(&r->mesh,
                                         mesh.triangle + 3 * (size_t)t, t);
    return good;
}

//: Remesh and write
static bool report_remeshing(FILE *stream, const void *context)
{
    const remeshing *r = context;
    return tf_remesh_output_write(stream, r->request.format, &r->done);
}

static bool do_all(remeshing *r)
{
    const request *wanted = &r->request;
    if (!tf_frames_next(&r->frames, wanted->in) || !load(r) ||
        !tf_mesh_output_begin(&r->out, wanted->out))
        return false;
    bool good = remesh(r) && fill_file(r);
    tf_progress_end(&r->progress);
    return good && tf_mesh_output_write(&r->out, &r->mesh, report_remeshing, r);
}

//: Print what went wrong in remesh
static void print_errors(const remeshing *r)
{
    const tf_mesh_file *files[] = {&r->frames.file[0], &r->frames.file[1],
                                   &r->mesh};
    for (int i = 0; i < 3; i++)
        if (files[i]->fault[0] != '\0')
            tf_mesh_file_print_fault(files[i], "tanglefree");
}

//: Run the command remesh
int tf_remesh_command(int argc, char *argv[])
{
    static const struct argp parser = {
        options, parse_argument, "IN", description, NULL, NULL, NULL};
    remeshing r = {.request.format = TF_SUMMARY};
    argp_parse(&parser, argc, argv, 0, NULL, &r.request);
    r.progress = tf_progress_begin();
    r.progress.wanted = isatty(STDERR_FILENO);
    bool good = do_all(&r);
    print_errors(&r);
    tf_mesh_output_end(&r.out);
    tf_adaptive_free(r.surface);
    tf_mesh_file_free(&r.mesh);
    tf_frames_free(&r.frames);
    return good ? 0 : 2;
}

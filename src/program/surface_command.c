//: Include what the commands about surfaces need
#include "fast/detect.h"
#include "program/arithmetics.h"
#include "program/command.h"
#include "program/destination.h"
#include "program/progress.h"
#include "program/surface_output.h"
#include "scenes/frames.h"
#include "threads/threads.h"

#include <limits.h>

//: Hold what a command does
typedef struct work {
    const tf_request *request;
    tf_threads *threads;
    tf_frames frames;
    tf_destination to;
    tf_surface_output output;
    tf_progress_line progress;
} work;

/// Reports a status of the surface as a fault of the current file.
static bool succeeded(work *w, const tf_error *error)
{
    return error->status == TF_OK || tf_frames_fault(&w->frames, error);
}

//: Report a coordinate that is out of range about surfaces
static bool fault_in_range(work *w, int vertex)
{
    const tf_arithmetic *arithmetic = w->request->answering.arithmetic;
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
    tf_detect_options detection = {
        .selection = w->request->first ? TF_FIRST_CONTACT : TF_ALL_CONTACTS,
        .arithmetic = w->request->answering.arithmetic,
        .narrow_phase = w->request->narrow_phase,
        .parallel = tf_threads_parallel(w->threads)};
    tf_motion motion = tf_frames_motion(&w->frames);
    tf_contacts found;
    tf_error error;
    tf_status status = tf_surface_detect(w->frames.surface, &motion, &detection,
                                         &found, &error);
    if (status == TF_OUT_OF_RANGE)
        return fault_in_range(w, error.vertex[0]);
    return succeeded(w, &error) &&
           tf_surface_output_contacts(&w->output, w->frames.axes, &found);
}

static bool detect_all(work *w)
{
    for (int i = 0; i < w->request->operands; i++) {
        if (!tf_frames_next(&w->frames, w->request->operand[i]) ||
            (i > 0 && !detect_step(w)))
            return false;
        tf_progress_line_show(&w->progress, (long)w->output.tally.parts,
                              "steps");
    }
    return true;
}

//: Check all surfaces
static bool check_thickness(work *w, const tf_motion *rest, bool tangled)
{
    tf_check_options options = {.parallel = tf_threads_parallel(w->threads)};
    tf_near_pairs found;
    tf_error error;
    tf_surface_near(w->frames.surface, rest->vertices, rest->start,
                    w->request->thickness, &options, &found, &error);
    return succeeded(w, &error) &&
           tf_surface_output_near(&w->output, tf_frames_file(&w->frames)->name,
                                  tangled, &found);
}

static bool check_file(work *w, const char *path)
{
    tf_frames_free(&w->frames);
    if (!tf_frames_next(&w->frames, path))
        return false;
    tf_motion rest = tf_frames_motion(&w->frames);
    tf_crossings found;
    tf_error error;
    tf_check_options options = {.parallel = tf_threads_parallel(w->threads)};
    tf_surface_check(w->frames.surface, rest.vertices, rest.start, &options,
                     &found, &error);
    bool tangled = error.status == TF_OK && found.count > 0;
    return succeeded(w, &error) &&
           tf_surface_output_crossings(
               &w->output, tf_frames_file(&w->frames)->name, &found) &&
           (!(w->request->thickness > 0) || check_thickness(w, &rest, tangled));
}

static bool check_all(work *w)
{
    for (int i = 0; i < w->request->operands; i++) {
        if (!check_file(w, w->request->operand[i]))
            return false;
        tf_progress_line_show(&w->progress, (long)w->output.tally.parts,
                              "files");
    }
    return true;
}

//: Write all rows about surfaces
static bool write_rows(work *w, bool checks, bool (*do_all)(work *))
{
    const tf_request *request = w->request;
    FILE *stream = tf_destination_begin(&w->to, request->out, &w->frames.fault)
                       ? tf_destination_open(&w->to)
                       : NULL;
    if (!stream)
        return false;
    bool good = tf_surface_output_begin(&w->output, stream, *request->format,
                                        checks, request->thickness > 0) &&
                do_all(w);
    tf_progress_line_end(&w->progress);
    good = tf_surface_output_end(&w->output) && good;
    return tf_destination_finish(&w->to, good, w->output.records.error);
}

//: Run a command about surfaces
static int run(const tf_request *request, bool checks, bool (*do_all)(work *))
{
    bool silent = !tf_destination_is_standard(request->out);
    work w = {.request = request, .progress = tf_progress_line_begin(silent)};
    tf_threads_create(request->threads, &w.threads);
    bool good = write_rows(&w, checks, do_all);
    tf_destination_end(&w.to);
    tf_fault_print(&w.frames.fault, "tanglefree");
    tf_frames_free(&w.frames);
    tf_threads_free(w.threads);
    return !good ? 2 : w.output.tally.tangled > 0;
}

static int run_detect(const tf_request *request)
{
    return run(request, false, detect_all);
}

static int run_check(const tf_request *request)
{
    return run(request, true, check_all);
}

//: Describe the commands about surfaces
const tf_command tf_detect_command = {
    .set = TF_DETECT,
    .name = "detect",
    .purpose = "find every contact of a moving surface",
    .operands = "START END [END...]",
    .least = 2,
    .most = INT_MAX,
    .wanted = "two files or more are required: START and END",
    .description = tf_detect_description,
    .run = run_detect,
};

const tf_command tf_check_command = {
    .set = TF_CHECK,
    .name = "check",
    .purpose = "find where a surface intersects itself",
    .operands = "FILE...",
    .least = 1,
    .most = INT_MAX,
    .wanted = "a file is required: its name, or - for standard input",
    .description = tf_check_description,
    .run = run_check,
};

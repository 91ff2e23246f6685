//: Include what the commands about surfaces need
#include "fast/detect.h"
#include "files/destination.h"
#include "program/arithmetics.h"
#include "program/command.h"
#include "program/progress.h"
#include "program/surface_output.h"
#include "scenes/natural_order.h"
#include "scenes/scene_file.h"
#include "scenes/scene_frames.h"
#include "scenes/seams.h"
#include "scenes/shown_frames.h"
#include "threads/threads.h"
#include "writers/endings.h"

#include <limits.h>
#include <stdlib.h>

//: Hold what a command does
typedef struct work {
    const tf_request *request;
    tf_threads *threads;
    tf_scene_meshes meshes;
    tf_scene_frames frames;
    tf_surface_part part;
    bool *hinted; ///< of each mesh: whether a hint was given at its seams
    tf_destination to;
    tf_surface_output output;
    bool shows; ///< whether the frames are written for ParaView
    tf_shown_frames shown;
    tf_contact_points points;
    tf_progress_line progress;
} work;

/// Reports a status of the surface as a fault of the current frame.
static bool succeeded(work *w, const tf_error *error)
{
    return error->status == TF_OK || tf_scene_frames_fault(&w->frames, error);
}

static bool fault_in_work_memory(work *w)
{
    return tf_fault_set(&w->frames.fault, w->request->operand[0], -1,
                        "not enough memory; divide the scene, or use a machine "
                        "with more");
}

//: List the meshes of a command
static bool is_scene(const tf_request *request)
{
    return tf_is_scene(request->operand[0]);
}

/// Adds a mesh whose frames are so many operands.
static bool add_mesh(work *w, int first, int frames)
{
    tf_scene_mesh *mesh = tf_scene_meshes_add(&w->meshes);
    bool good = mesh;
    for (int i = 0; i < frames && good; i++)
        good =
            tf_frame_names_add(&mesh->frames, w->request->operand[first + i]);
    w->meshes.frames = frames;
    return good || fault_in_work_memory(w);
}

static void drop_meshes(work *w)
{
    tf_scene_frames_free(&w->frames);
    tf_scene_meshes_free(&w->meshes);
    free(w->part.name);
    free(w->part.listed);
    free(w->hinted);
    w->hinted = NULL;
    w->part = (tf_surface_part){0};
}

//: Read the next frame of a command
/// Meshes that are operands are called as their files are.
static bool name_meshes(work *w)
{
    size_t meshes = (size_t)w->meshes.count;
    w->part = (tf_surface_part){.joined = &w->frames.joined,
                                .name = calloc(meshes, sizeof *w->part.name),
                                .listed = calloc(meshes, sizeof(bool))};
    w->hinted = calloc(meshes, sizeof *w->hinted);
    if (!w->part.name || !w->part.listed || !w->hinted)
        return fault_in_work_memory(w);
    for (int m = 0; m < w->meshes.count; m++)
        w->part.name[m] = is_scene(w->request)
                              ? w->meshes.mesh[m].name
                              : tf_scene_frames_file(&w->frames, m, 1)->name;
    return true;
}

static bool next_frame(work *w)
{
    w->frames.meshes = &w->meshes;
    w->frames.each = w->request->each;
    return tf_scene_frames_next(&w->frames) && (w->part.name || name_meshes(w));
}

//: Report a coordinate that is out of range about surfaces
static bool fault_in_range(work *w, int vertex)
{
    const tf_arithmetic *arithmetic = w->request->answering.arithmetic;
    tf_motion motion = tf_scene_frames_motion(&w->frames);
    int axes = motion.axes, i = 0, mesh[2];
    const double *x[2] = {motion.start + (size_t)axes * (size_t)vertex,
                          motion.end + (size_t)axes * (size_t)vertex};
    while (i < 2 * axes - 1 &&
           tf_arithmetic_fits(arithmetic, axes, x[i / axes][i % axes]))
        i++;
    tf_joined_localize(&w->frames.joined, 1, &vertex, 1, mesh);
    const tf_mesh_file *file =
        tf_scene_frames_file(&w->frames, mesh[0], i / axes);
    return tf_mesh_file_fault(file, file->vertex_place.item[vertex],
                              TF_OUT_OF_RANGE_FAULT, x[i / axes][i % axes],
                              tf_arithmetic_name(arithmetic),
                              tf_arithmetic_bits(arithmetic, axes));
}

//: Show the contacts of a step
static bool set_points(work *w, const tf_motion *motion,
                       const tf_contacts *found)
{
    return !w->shows || tf_contact_points_found(&w->points, motion, found) ||
           fault_in_work_memory(w);
}

static bool show_frame(work *w)
{
    return !w->shows || tf_shown_frames_add(&w->shown, &w->frames, &w->points);
}

//: Detect the contacts of all steps
static bool detect_step(work *w)
{
    tf_detect_options detection = {
        .selection = w->request->first ? TF_FIRST_CONTACT : TF_ALL_CONTACTS,
        .arithmetic = w->request->answering.arithmetic,
        .narrow_phase = w->request->narrow_phase,
        .parallel = tf_threads_parallel(w->threads)};
    tf_motion motion = tf_scene_frames_motion(&w->frames);
    tf_contacts found;
    tf_error error;
    tf_status status = tf_surface_detect(w->frames.surface, &motion, &detection,
                                         &found, &error);
    if (status == TF_OUT_OF_RANGE)
        return fault_in_range(w, error.vertex[0]);
    return succeeded(w, &error) && set_points(w, &motion, &found) &&
           tf_surface_output_contacts(&w->output, &w->part, motion.axes,
                                      &found);
}

static bool detect_all(work *w)
{
    const tf_request *request = w->request;
    if (is_scene(request) ? !tf_scene_file_read(&w->meshes, request->operand[0],
                                                &w->frames.fault)
                          : !add_mesh(w, 0, request->operands))
        return false;
    if (w->meshes.frames < 2)
        return tf_scene_fault_in_frames(&w->meshes, request->operand[0],
                                        &w->frames.fault);
    for (int i = 0; i < w->meshes.frames; i++) {
        if (!next_frame(w) || (i > 0 && !detect_step(w)) || !show_frame(w))
            return false;
        tf_progress_line_show(&w->progress, (long)w->output.tally.parts,
                              "steps");
    }
    return !w->shows || tf_shown_frames_end(&w->shown);
}

//: Check a frame
static bool check_thickness(work *w, const tf_motion *rest)
{
    tf_check_options options = {.parallel = tf_threads_parallel(w->threads)};
    tf_near_pairs found;
    tf_error error;
    tf_surface_near(w->frames.surface, rest->vertices, rest->end,
                    w->request->thickness, &options, &found, &error);
    return succeeded(w, &error) &&
           tf_surface_output_near(&w->output, &w->part, &found);
}

static bool check_frame(work *w)
{
    tf_motion rest = tf_scene_frames_motion(&w->frames);
    tf_crossings found;
    tf_error error;
    tf_check_options options = {.parallel = tf_threads_parallel(w->threads)};
    tf_surface_check(w->frames.surface, rest.vertices, rest.end, &options,
                     &found, &error);
    if (!succeeded(w, &error))
        return false;
    tf_hint_at_seams(&w->frames, &found, w->part.name, w->hinted);
    return tf_surface_output_crossings(&w->output, &w->part, &found) &&
           (!(w->request->thickness > 0) || check_thickness(w, &rest));
}

static bool check_frames(work *w, const char *things)
{
    for (int i = 0; i < w->meshes.frames; i++) {
        if (!next_frame(w) || !check_frame(w))
            return false;
        tf_surface_output_count(&w->output, &w->part);
        tf_progress_line_show(&w->progress, (long)w->output.tally.parts,
                              things);
    }
    return true;
}

//: Check files and scenes
static bool check_each(work *w)
{
    bool good = true;
    for (int i = 0; i < w->request->operands && good; i++) {
        drop_meshes(w);
        good = add_mesh(w, i, 1) && check_frames(w, "files");
    }
    return good;
}

static bool check_joined(work *w)
{
    bool good = true;
    for (int i = 0; i < w->request->operands && good; i++)
        good = add_mesh(w, i, 1);
    return good && check_frames(w, "files");
}

static bool check_all(work *w)
{
    const tf_request *request = w->request;
    if (is_scene(request))
        return tf_scene_file_read(&w->meshes, request->operand[0],
                                  &w->frames.fault) &&
               check_frames(w, "frames");
    return request->each ? check_each(w) : check_joined(w);
}

//: Write all rows about surfaces
static tf_surface_output_options output_of(const tf_request *request,
                                           bool checks)
{
    bool joined = checks && !request->each && request->operands > 1;
    return (tf_surface_output_options){.format = *request->format,
                                       .checks = checks,
                                       .measures = request->thickness > 0,
                                       .names = is_scene(request)
                                                    ? TF_NAMES_OF_MESHES
                                                : joined ? TF_NAMES_OF_FILES
                                                         : TF_NAMES_OF_FILE};
}

/// Rows go to standard output if a collection is written.
static FILE *begin_output(work *w)
{
    const char *out = w->request->out, *ending = tf_any_mesh_ending(out);
    if (!w->shows && ending) {
        tf_fault_set(&w->frames.fault, out, -1,
                     "the output is rows, not a mesh; leave out %s, or end the "
                     "name in .pvd for ParaView",
                     ending);
        return NULL;
    }
    if (w->shows && !tf_shown_frames_begin(&w->shown, out, &w->frames.fault))
        return NULL;
    return tf_destination_begin(&w->to, w->shows ? "-" : out, &w->frames.fault)
               ? tf_destination_open(&w->to)
               : NULL;
}

static bool write_rows(work *w, bool checks, bool (*do_all)(work *))
{
    const tf_request *request = w->request;
    tf_surface_output_options options = output_of(request, checks);
    FILE *stream = begin_output(w);
    if (!stream)
        return false;
    tf_surface_output_begin(&w->output, stream, &options);
    bool good = do_all(w);
    tf_progress_line_end(&w->progress);
    good = tf_surface_output_end(&w->output, good) && good;
    return tf_destination_finish(&w->to, good, w->output.records.error);
}

//: Run a command about surfaces
static int run(const tf_request *request, bool checks, bool (*do_all)(work *))
{
    bool shows = tf_is_collection(request->out);
    bool silent = !shows && !tf_destination_is_standard(request->out);
    work w = {.request = request,
              .shows = shows,
              .progress = tf_progress_line_begin(silent)};
    w.frames.meshes = &w.meshes;
    tf_threads_create(request->threads, &w.threads);
    bool good = write_rows(&w, checks, do_all);
    tf_destination_end(&w.to);
    tf_fault_print(&w.frames.fault, "tanglefree");
    drop_meshes(&w);
    tf_shown_frames_free(&w.shown);
    tf_contact_points_free(&w.points);
    tf_threads_free(w.threads);
    return !good ? 2 : w.output.tally.tangled > 0;
}

static int run_detect(const tf_request *request)
{
    if (!is_scene(request))
        tf_order_frames(request->operand, request->operands);
    return run(request, false, detect_all);
}

/// Before there were scenes, each frame was checked alone.
static void say_joined(const tf_request *request)
{
    if (!request->each && tf_are_numbered(request->operand, request->operands))
        fprintf(stderr,
                "tanglefree: %s and the other files are tested against each "
                "other; --each tests each alone\n",
                tf_make_visible(request->operand[0]).text);
}

static int run_check(const tf_request *request)
{
    say_joined(request);
    return run(request, true, check_all);
}

//: Refuse operands that do not go together
/// A scene is all that there is.
static void check_operands(tf_request *request)
{
    for (int i = 0; i < request->operands; i++)
        if (tf_is_scene(request->operand[i]) && request->operands > 1)
            tf_request_refuse(request,
                              "%s is a scene, which must be the only operand; "
                              "name the other files in it",
                              tf_make_visible(request->operand[i]).text);
}

static void check_check(tf_request *request)
{
    check_operands(request);
    if (tf_is_collection(request->out))
        tf_request_refuse(request,
                          "--output must be a file for rows, got '%s'; only "
                          "detect and resolve write collections for ParaView",
                          tf_make_visible(request->out).text);
}

static void check_detect(tf_request *request)
{
    check_operands(request);
    if (request->operands == 1 && !is_scene(request))
        tf_request_refuse(request, "%s", tf_detect_command.wanted);
}

//: Describe the commands about surfaces
const tf_command tf_detect_command = {
    .set = TF_DETECT,
    .name = "detect",
    .purpose = "find every contact of a moving surface",
    .operands = "START END [END...]\nSCENE",
    .least = 1,
    .most = INT_MAX,
    .wanted = "two files or more are required, START and END, or a scene, "
              "whose name ends in .yaml, .yml or .json",
    .description = tf_detect_description,
    .check = check_detect,
    .run = run_detect,
};

const tf_command tf_check_command = {
    .set = TF_CHECK,
    .name = "check",
    .purpose = "find where a surface intersects itself",
    .operands = "FILE...\nSCENE",
    .least = 1,
    .most = INT_MAX,
    .wanted = "a file is required: its name, or - for standard input",
    .description = tf_check_description,
    .check = check_check,
    .run = run_check,
};

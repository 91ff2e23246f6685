//: Include what untangling a scene needs
#include "program/scene_untangling.h"

#include "program/left_list.h"
#include "program/progress.h"
#include "program/reports.h"
#include "scenes/scene_file.h"
#include "scenes/scene_folder.h"
#include "threads/threads.h"

#include <math.h>
#include <stdlib.h>

//: Hold what untangles a scene
/// A row of the report.
typedef struct untangled_row {
    tf_untangled done; ///< first, for its fields
    size_t frame;
} untangled_row;

typedef struct untangled_scene {
    size_t frames, tangled; ///< of all frames, those that still are
    size_t before, left;    ///< intersections
    double farthest, seconds;
} untangled_scene;

enum {
    FIELDS = 30 // more than a row has
};

typedef struct scene_untangling {
    const tf_request *request;
    tf_threads *threads;
    tf_scene_meshes meshes;
    tf_scene_frames frames;
    const char **name;    ///< of each mesh
    double *inverse_mass; ///< of each vertex
    tf_field field[FIELDS];
    tf_scene_folder folder;
    tf_records records;
    tf_left_list left;
    untangled_scene sum;
    tf_progress_line progress;
} scene_untangling;

//: List the meshes of a tangled scene
static bool list_meshes(scene_untangling *u)
{
    size_t vertices = (size_t)tf_joined_vertices(&u->frames.joined);
    u->inverse_mass = malloc((vertices + 1) * sizeof *u->inverse_mass);
    u->name = malloc((size_t)u->meshes.count * sizeof *u->name);
    if (!u->inverse_mass || !u->name)
        return tf_mesh_file_fault_in_memory(
            tf_scene_frames_file(&u->frames, 0, 1));
    for (int m = 0; m < u->meshes.count; m++)
        u->name[m] = u->meshes.mesh[m].name;
    return tf_scene_frames_weigh(&u->frames, u->request->operand[0],
                                 u->inverse_mass);
}

//: Untangle a frame of a scene
static bool untangle_frame(scene_untangling *u, tf_untangled_frame *done,
                           untangled_row *row)
{
    tf_untangle_options how = {.size = sizeof how,
                               .parallel = tf_threads_parallel(u->threads),
                               .progress = tf_progress_line_show_stage,
                               .context = &u->progress};
    double start = tf_clock_seconds();
    bool good = tf_untangle_frame(&u->frames, u->inverse_mass, &how, done);
    tf_progress_line_end(&u->progress);
    if (good)
        tf_untangled_set(&row->done, done, tf_clock_seconds() - start);
    return good;
}

//: Report the frames of a scene
static const tf_field frame_field = TF_FIELD("frame", untangled_row, frame);
static const tf_field sum_fields[] = {
    TF_FIELD("frames", untangled_scene, frames),
    TF_FIELD("tangled frames", untangled_scene, tangled),
    TF_FIELD("intersections before", untangled_scene, before),
    TF_FIELD("intersections", untangled_scene, left),
    TF_FIELD("farthest", untangled_scene, farthest),
    TF_FIELD("seconds", untangled_scene, seconds),
    {0}};

static bool fault_in_report(scene_untangling *u)
{
    return tf_fault_set_unwritten(&u->frames.fault, "standard output",
                                  u->records.error);
}

static void begin_report(scene_untangling *u)
{
    tf_fields_join(u->field, &frame_field, tf_untangled_fields);
    tf_records_begin(&u->records, stdout, *u->request->format, "frames",
                     u->field);
}

static bool report_frame(scene_untangling *u, untangled_row *row)
{
    const tf_untangled *done = &row->done;
    row->frame = u->sum.frames++;
    u->sum.tangled += done->left > 0;
    u->sum.before += done->before;
    u->sum.left += done->left;
    u->sum.farthest = fmax(u->sum.farthest, done->report.farthest);
    u->sum.seconds += done->seconds;
    return tf_records_add(&u->records, row) || fault_in_report(u);
}

/// If not all frames were done, JSON alone has sums; if none was, nothing is
/// written.
static bool end_report(scene_untangling *u, bool done)
{
    if (!done && u->records.count == 0)
        return true;
    bool told = done || *u->request->format == TF_JSON;
    return (tf_records_end(&u->records, told ? sum_fields : NULL, &u->sum) ||
            fault_in_report(u)) &&
           tf_left_list_write(&u->left, &u->frames, stdout);
}

//: Untangle all frames of a scene
static bool begin_scene(scene_untangling *u)
{
    const tf_request *request = u->request;
    tf_fault *fault = &u->frames.fault;
    u->frames.keeps_sources = true;
    return tf_scene_file_read(&u->meshes, request->operand[0], fault) &&
           tf_scene_check_moving(&u->meshes, request->operand[0], "untangle",
                                 fault) &&
           tf_scene_frames_next(&u->frames) && list_meshes(u) &&
           tf_left_list_begin(&u->left, &u->frames, *request->format,
                              TF_NAMES_OF_MESHES, u->name) &&
           tf_scene_folder_begin(&u->folder, request->out, "", fault);
}

static bool do_frame(scene_untangling *u)
{
    tf_untangled_frame done;
    untangled_row row;
    return untangle_frame(u, &done, &row) &&
           tf_scene_folder_write(&u->folder, &u->frames) &&
           tf_left_list_add(&u->left, &u->frames, &done.left) &&
           report_frame(u, &row);
}

static bool do_scene(scene_untangling *u)
{
    bool good = begin_scene(u);
    if (!good)
        return false;
    begin_report(u);
    for (int i = 0; i < u->meshes.frames && good; i++)
        good = (i == 0 || tf_scene_frames_next(&u->frames)) && do_frame(u);
    return end_report(u, good) && good;
}

//: Run the untangling of a scene
int tf_scene_untangle(const tf_request *request)
{
    scene_untangling u = {.request = request,
                          .progress = tf_progress_line_begin(true)};
    u.frames.meshes = &u.meshes;
    tf_threads_create(request->threads, &u.threads);
    bool good = do_scene(&u);
    tf_fault_print(&u.frames.fault, "tanglefree");
    if (!good)
        tf_scene_folder_leave(&u.folder, &u.frames, u.sum.frames > 0);
    tf_left_list_free(&u.left);
    free(u.name);
    free(u.inverse_mass);
    tf_scene_frames_free(&u.frames);
    tf_scene_meshes_free(&u.meshes);
    tf_threads_free(u.threads);
    return !good ? 2 : u.sum.left > 0;
}

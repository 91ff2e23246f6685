//: Include what the command untangle needs
#include "files/masses.h"
#include "program/command.h"
#include "program/left_list.h"
#include "program/progress.h"
#include "program/reports.h"
#include "program/scene_untangling.h"
#include "scenes/scene_file.h"
#include "threads/threads.h"
#include "writers/collection.h"
#include "writers/mesh_output.h"

#include <stdlib.h>

//: Hold what untangle does
typedef struct untangling {
    const tf_request *request;
    tf_threads *threads;
    tf_scene_meshes meshes; ///< one
    tf_scene_frames frames; ///< one
    tf_columns columns;     ///< what the vertices of the file have
    double *inverse_mass;   ///< of each vertex: 0 if it is fixed, or 1
    tf_untangled done;
    tf_left_list left;
    tf_destination out;
    tf_progress_line progress;
} untangling;

static const tf_mesh_file *file_of(const untangling *u)
{
    return tf_scene_frames_file(&u->frames, 0, 1);
}

//: Read the mesh to untangle
static bool read(untangling *u)
{
    const char *path = u->request->operand[0];
    tf_scene_mesh *mesh = tf_scene_meshes_add(&u->meshes);
    if (!mesh || !tf_frame_names_add(&mesh->frames, path))
        return tf_fault_set(&u->frames.fault, path, -1, "%s",
                            tf_status_message(TF_OUT_OF_MEMORY));
    u->meshes.frames = 1;
    u->frames.columns = &u->columns;
    u->frames.keeps_sources = true;
    return tf_scene_frames_next(&u->frames);
}

//: Read the fixed vertices
static bool read_fixed(untangling *u)
{
    int vertices = tf_mesh_file_vertices(file_of(u));
    u->inverse_mass = malloc(((size_t)vertices + 1) * sizeof(double));
    if (!u->inverse_mass)
        return tf_mesh_file_fault_in_memory(file_of(u));
    for (int v = 0; v < vertices; v++)
        u->inverse_mass[v] = 1;
    return !u->request->fixed ||
           tf_fixed_read(u->request->fixed, vertices, u->inverse_mass,
                         &u->frames.fault);
}

//: Untangle the mesh
static bool untangle(untangling *u)
{
    tf_untangle_options how = {.size = sizeof how,
                               .parallel = tf_threads_parallel(u->threads),
                               .progress = tf_progress_line_show_stage,
                               .context = &u->progress};
    tf_untangled_frame done;
    double start = tf_clock_seconds();
    bool good = tf_untangle_frame(&u->frames, u->inverse_mass, &how, &done);
    tf_progress_line_end(&u->progress);
    if (good)
        tf_untangled_set(&u->done, &done, tf_clock_seconds() - start);
    return good && tf_left_list_add(&u->left, &u->frames, &done.left);
}

//: Write the untangled mesh
/// What is left is listed behind the report.
static bool write(untangling *u)
{
    const tf_mesh_file *file = file_of(u);
    tf_mesh_content content = {.mesh = tf_mesh_file_elements(file, 3),
                               .position =
                                   tf_scene_frames_positions(&u->frames, 0),
                               .columns = &u->columns,
                               .from = file};
    tf_mesh_report report = {*u->request->format, tf_untangled_fields,
                             &u->done};
    FILE *stream =
        tf_destination_is_standard(u->request->out) ? stderr : stdout;
    return tf_mesh_output_write(&u->out, &content, file, &report) &&
           tf_left_list_write(&u->left, &u->frames, stream);
}

static bool do_all(untangling *u)
{
    const tf_request *request = u->request;
    const char *name[] = {request->out};
    return read(u) && read_fixed(u) &&
           tf_mesh_output_begin(&u->out, request->out, file_of(u),
                                &u->frames.fault) &&
           tf_left_list_begin(&u->left, &u->frames, *request->format,
                              TF_NAMES_OF_FILE, name) &&
           untangle(u) && write(u);
}

//: Run the command untangle
static int untangle_mesh(const tf_request *request)
{
    untangling u = {.request = request,
                    .progress = tf_progress_line_begin(true)};
    u.frames.meshes = &u.meshes;
    tf_threads_create(request->threads, &u.threads);
    bool good = do_all(&u);
    tf_fault_print(&u.frames.fault, "tanglefree");
    tf_destination_end(&u.out);
    tf_left_list_free(&u.left);
    free(u.inverse_mass);
    tf_scene_frames_free(&u.frames);
    tf_scene_meshes_free(&u.meshes);
    tf_columns_free(&u.columns);
    tf_threads_free(u.threads);
    return !good ? 2 : u.done.left > 0;
}

static int run(const tf_request *request)
{
    return tf_is_scene(request->operand[0]) ? tf_scene_untangle(request)
                                            : untangle_mesh(request);
}

//: Refuse what does not go with an untangled scene
static void check_operand(tf_request *request)
{
    const char *out = request->out;
    bool shows = tf_is_collection(out);
    if (!tf_is_scene(request->operand[0]))
        return;
    if (tf_request_gave(request, "fixed"))
        tf_request_refuse(request, "--fixed is for a mesh; write 'role: fixed' "
                                   "or 'pinned:' in the scene");
    if (shows || tf_destination_is_standard(out))
        tf_request_refuse(
            request,
            "--output must be a folder for the frames of a scene, got '%s'%s",
            tf_make_visible(out).text,
            shows ? "; only detect and resolve write collections for ParaView"
                  : "");
}

const tf_command tf_untangle_command = {
    .set = TF_UNTANGLE,
    .name = "untangle",
    .purpose = "make a mesh clear that intersects itself",
    .operands = "IN\nSCENE",
    .least = 1,
    .most = 1,
    .wanted = "one file is required: IN, or a scene, whose name ends in .yaml, "
              ".yml or .json",
    .description = tf_untangle_description,
    .check = check_operand,
    .run = run,
};

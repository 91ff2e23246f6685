//: Include what the command remesh needs
#include "program/command.h"
#include "program/flaws.h"
#include "program/frames.h"
#include "program/mesh_output.h"
#include "program/progress.h"
#include "program/reports.h"
#include "remesh/remesh.h"

//: Hold what remesh does
typedef struct remeshing {
    const tf_request *request;
    tf_frames frames;
    tf_adaptive_surface *surface;
    tf_remeshed done;
    tf_destination out;
    tf_progress_line progress;
} remeshing;

//: Make the surface of a file adaptive
static bool load(remeshing *r)
{
    const tf_mesh_file *file = tf_frames_file(&r->frames);
    tf_mesh mesh = tf_mesh_file_elements(file, 3);
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
    tf_progress_line_show(context, (long)done, "changes");
}

//: Remesh the surface of a file
static bool remesh(remeshing *r)
{
    tf_remesh_options how = {.edge = r->request->edge,
                             .rounds = r->request->rounds,
                             .progress = show_progress,
                             .context = &r->progress};
    double begin = tf_clock_seconds();
    tf_status status = tf_adaptive_remesh(r->surface, &how, &r->done.report);
    r->done.seconds = tf_clock_seconds() - begin;
    r->done.edge = how.edge;
    const tf_mesh_file *file = tf_frames_file(&r->frames);
    if (status == TF_BAD_OPTION)
        return tf_mesh_file_fault(
            file, -1,
            "--edge %g would take too many triangles; give a longer one",
            how.edge);
    return status == TF_OK || tf_defect_fault(file, status, &(tf_defect){0});
}

//: Remesh and write
static bool write(remeshing *r)
{
    tf_mesh_content content = {.mesh = tf_adaptive_mesh(r->surface),
                               .position = tf_adaptive_positions(r->surface)};
    tf_mesh_report report = {*r->request->format, tf_remeshed_fields, &r->done};
    r->done.triangles_after = content.mesh.triangles;
    return tf_mesh_output_write(&r->out, &content,
                                tf_frames_file(&r->frames)->format, &report);
}

static bool do_all(remeshing *r)
{
    const tf_request *wanted = r->request;
    if (!tf_frames_next(&r->frames, wanted->operand[0]) || !load(r) ||
        !tf_destination_begin(&r->out, wanted->out, &r->frames.fault))
        return false;
    bool good = remesh(r);
    tf_progress_line_end(&r->progress);
    return good && write(r);
}

//: Run the command remesh
static int run(const tf_request *request)
{
    remeshing r = {.request = request,
                   .progress = tf_progress_line_begin(true)};
    bool good = do_all(&r);
    tf_fault_print(&r.frames.fault, "tanglefree");
    tf_destination_end(&r.out);
    tf_adaptive_free(r.surface);
    tf_frames_free(&r.frames);
    return good ? 0 : 2;
}

const tf_command tf_remesh_command = {
    .set = TF_REMESH,
    .name = "remesh",
    .purpose = "give a surface triangles that are nearly equilateral",
    .operands = "IN",
    .least = 1,
    .most = 1,
    .wanted = "one file is required: IN",
    .description = tf_remesh_description,
    .run = run,
};

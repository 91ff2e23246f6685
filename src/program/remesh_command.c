//: Include what the command remesh needs
#include "files/kept_edges.h"
#include "files/masses.h"
#include "program/command.h"
#include "program/progress.h"
#include "program/reports.h"
#include "remesh/origins.h"
#include "remesh/remesh.h"
#include "scenes/carried_faces.h"
#include "scenes/flaws.h"
#include "scenes/forecast.h"
#include "scenes/frames.h"
#include "writers/mesh_output.h"

#include <stdlib.h>
#include <string.h>

//: Hold what remesh does
typedef struct remeshing {
    const tf_request *request;
    tf_frames frames;
    tf_columns columns; ///< what the vertices of the file have
    tf_source source;   ///< the file itself
    tf_columns carried; ///< and those of the surface then
    tf_carried_faces faces;
    tf_adaptive_surface *surface;
    tf_kept_edges kept;
    double *length; ///< of each vertex, or NULL
    tf_remeshed done;
    tf_destination out;
    tf_progress_line progress;
} remeshing;

//: Make the surface of a file adaptive
/// Orients the triangles of the file as those of the surface, in which origins
/// are.
static void take_defects(remeshing *r, const tf_defects *defects)
{
    tf_mesh_file *file = &r->frames.file[r->frames.current];
    memcpy(file->triangle.item, tf_adaptive_mesh(r->surface)->triangle,
           file->triangle.count * sizeof *file->triangle.item);
    tf_defects_print(file, defects);
    tf_remeshed_set_defects(&r->done, defects);
}

/// Unless it is strict, a surface has no edges besides those of triangles.
static tf_mesh elements_of(const remeshing *r)
{
    tf_mesh mesh = tf_mesh_file_elements(tf_frames_file(&r->frames), 3);
    if (!r->request->strict && mesh.triangles > 0)
        mesh.edges = 0;
    return mesh;
}

static bool load(remeshing *r)
{
    const tf_mesh_file *file = tf_frames_file(&r->frames);
    tf_mesh mesh = elements_of(r);
    const double *position = file->position.item;
    const tf_defects *defects = NULL;
    tf_error error;
    r->done.triangles_before = mesh.triangles;
    tf_status status =
        r->request->strict
            ? tf_adaptive_create(&mesh, position, &r->surface, &error)
            : tf_adaptive_create_around(&mesh, position, &r->surface, &defects,
                                        &error);
    if (status != TF_OK)
        return tf_error_fault(file, &error);
    if (defects)
        take_defects(r, defects);
    return true;
}

//: Read which edges are kept
static bool read_kept(remeshing *r)
{
    const char *path = r->request->keep;
    int vertices =
        tf_mesh_file_elements(tf_frames_file(&r->frames), 3).vertices;
    return !path ||
           tf_kept_edges_read(&r->kept, path, vertices, &r->frames.fault);
}

//: Read how long edges are to be
static bool read_lengths(remeshing *r)
{
    const tf_request *wanted = r->request;
    const tf_mesh_file *file = tf_frames_file(&r->frames);
    size_t vertices = (size_t)tf_mesh_file_elements(file, 3).vertices;
    if (!wanted->lengths)
        return true;
    r->length = calloc(vertices + 1, sizeof *r->length);
    if (!r->length)
        return tf_mesh_file_fault_in_memory(file);
    return tf_lengths_read(wanted->lengths, (int)vertices, r->length,
                           &r->frames.fault);
}

//: Show the progress of remeshing
static bool show_progress(void *context, const tf_stage *stage)
{
    char things[64];
    snprintf(things, sizeof things, "of %zu: %s", stage->total, stage->name);
    if (stage->total > 0)
        tf_progress_line_show(context, (long)stage->done, things);
    return true;
}

//: Refuse how to remesh
/// A length that is too short, or a kept edge of the file that is none.
static bool refuse_option(remeshing *r, const tf_error *error)
{
    if (strcmp(error->option, "error") == 0)
        return tf_mesh_file_fault(tf_frames_file(&r->frames), -1,
                                  "--error %g can't be kept; give a larger one",
                                  error->value);
    if (strcmp(error->option, "keep") != 0)
        return tf_mesh_file_fault(
            tf_frames_file(&r->frames), -1,
            "--edge %g would take too many triangles; give a longer one",
            error->value);
    const int *vertex = r->kept.vertex + 2 * (ptrdiff_t)error->value;
    const char *path = r->request->keep;
    return vertex[0] == vertex[1]
               ? tf_fault_set(&r->frames.fault, path, -1,
                              "vertex %d has no triangle; it can't be kept",
                              vertex[0])
               : tf_fault_set(&r->frames.fault, path, -1,
                              "no edge joins the vertices %d and %d; keep "
                              "edges that the mesh has",
                              vertex[0], vertex[1]);
}

//: Remesh the surface of a file
static bool remesh(remeshing *r)
{
    tf_remesh_options how = {.size = sizeof how,
                             .edge = r->request->edge,
                             .rounds = r->request->rounds,
                             .progress = show_progress,
                             .context = &r->progress,
                             .crease = r->request->crease,
                             .keeps = r->kept.count,
                             .keep = r->kept.vertex,
                             .lengths = r->length,
                             .error = r->request->error};
    const tf_remesh_report *report;
    tf_error error;
    double begin = tf_clock_seconds();
    tf_status status = tf_adaptive_remesh(r->surface, &how, &report, &error);
    r->done.seconds = tf_clock_seconds() - begin;
    r->done.edge = how.edge;
    const tf_mesh_file *file = tf_frames_file(&r->frames);
    if (status == TF_BAD_OPTION)
        return refuse_option(r, &error);
    if (status != TF_OK)
        return tf_error_fault(file, &error);
    r->done.report = *report;
    return true;
}

//: Carry over what vertices have
/// Mixes the values at the corners where each vertex comes from.
static bool carry(remeshing *r)
{
    const tf_mesh_file *file = tf_frames_file(&r->frames);
    const tf_origin *origin = tf_adaptive_origins(r->surface);
    int vertices = tf_adaptive_mesh(r->surface)->vertices;
    r->carried.count = r->columns.count;
    memcpy(r->carried.column, r->columns.column, sizeof r->columns.column);
    for (int v = 0; v < vertices && r->columns.count > 0; v++)
        if (!tf_columns_mix(&r->carried, &r->columns,
                            file->triangle.item +
                                3 * (size_t)origin[v].triangle,
                            origin[v].barycentric))
            return tf_mesh_file_fault_in_memory(file);
    return tf_carried_faces_make(&r->faces, file, r->surface);
}

//: Remesh and write
static bool write(remeshing *r)
{
    tf_mesh_content content = {.mesh = *tf_adaptive_mesh(r->surface),
                               .position = tf_adaptive_positions(r->surface),
                               .columns =
                                   r->carried.count > 0 ? &r->carried : NULL};
    if (r->faces.triangle) {
        content.faces = &r->faces.made;
        content.mesh.triangle = r->faces.triangle;
    }
    tf_mesh_report report = {*r->request->format, tf_remeshed_fields, &r->done};
    r->done.triangles_after = content.mesh.triangles;
    return tf_mesh_output_write(&r->out, &content, tf_frames_file(&r->frames),
                                &report);
}

static bool do_all(remeshing *r)
{
    const tf_request *wanted = r->request;
    if (!tf_frames_next(&r->frames, wanted->operand[0]) || !load(r) ||
        !read_kept(r) || !read_lengths(r) ||
        !tf_carried_faces_begin(&r->faces, tf_frames_file(&r->frames),
                                &r->kept) ||
        !tf_mesh_output_begin(&r->out, wanted->out, tf_frames_file(&r->frames),
                              &r->frames.fault))
        return false;
    if (!wanted->error && !wanted->lengths)
        tf_forecast_triangles(tf_frames_file(&r->frames), wanted->edge);
    bool good = remesh(r);
    tf_progress_line_end(&r->progress);
    return good && carry(r) && write(r);
}

//: Run the command remesh
static int run(const tf_request *request)
{
    if (request->edge == 0 && request->error == 0 && !request->lengths)
        tf_request_refuse(request, "--edge L, --lengths FILE or --error D is "
                                   "required: how long edges should be");
    remeshing r = {.request = request,
                   .progress = tf_progress_line_begin(true)};
    r.frames.columns = &r.columns;
    r.frames.source = &r.source;
    r.source.faces = &r.faces.from;
    bool good = do_all(&r);
    tf_fault_print(&r.frames.fault, "tanglefree");
    tf_destination_end(&r.out);
    tf_kept_edges_free(&r.kept);
    free(r.length);
    tf_adaptive_free(r.surface);
    tf_columns_free(&r.columns);
    tf_columns_free(&r.carried);
    tf_carried_faces_free(&r.faces);
    tf_source_free(&r.source);
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

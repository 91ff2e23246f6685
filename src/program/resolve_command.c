//: Include what the command resolve needs
#include "files/masses.h"
#include "program/command.h"
#include "program/progress.h"
#include "program/reports.h"
#include "program/response_request.h"
#include "program/scene_resolving.h"
#include "program/surface_output.h"
#include "response/resolve.h"
#include "scenes/flaws.h"
#include "scenes/frames.h"
#include "scenes/scene_file.h"
#include "threads/threads.h"
#include "untangle/tangled_zones.h"
#include "writers/collection.h"
#include "writers/contact_points.h"
#include "writers/mesh_output.h"
#include "writers/vtp_writer.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

//: Hold what resolve does
typedef struct resolving {
    const tf_request *request;
    tf_threads *threads;
    tf_frames frames;
    tf_columns columns;   ///< of the end
    tf_source source;     ///< that, too
    double *inverse_mass; ///< NULL: 1 for all
    double *friction;     ///< of each vertex, or NULL
    int *zone;            ///< of each facet, or NULL
    tf_crossing *exempt;  ///< intersections in zones
    tf_resolver *resolver;
    tf_resolved done;
    tf_destination out;
    bool shows; ///< whether the frames are written for ParaView
    tf_collection shown;
    tf_contact_points points;
    tf_progress_line progress;
} resolving;

//: Read the masses of all vertices
static bool allocate_masses(resolving *r, int vertices)
{
    r->inverse_mass = malloc(sizeof *r->inverse_mass * (size_t)vertices);
    if (!r->inverse_mass)
        return tf_status_fault(tf_frames_file(&r->frames), TF_OUT_OF_MEMORY);
    for (int v = 0; v < vertices; v++)
        r->inverse_mass[v] = 1;
    return true;
}

static bool read_masses(resolving *r)
{
    const tf_request *wanted = r->request;
    int vertices = tf_mesh_file_vertices(tf_frames_file(&r->frames));
    if (!wanted->fixed && !wanted->masses)
        return true;
    return allocate_masses(r, vertices) &&
           (!wanted->masses ||
            tf_masses_read(wanted->masses, vertices, r->inverse_mass,
                           &r->frames.fault)) &&
           (!wanted->fixed || tf_fixed_read(wanted->fixed, vertices,
                                            r->inverse_mass, &r->frames.fault));
}

//: Read the friction of all vertices
static bool read_friction(resolving *r)
{
    const char *path = r->request->vertex_friction;
    int vertices = tf_mesh_file_vertices(tf_frames_file(&r->frames));
    if (!path)
        return true;
    r->friction = malloc(sizeof *r->friction * (size_t)vertices);
    if (!r->friction)
        return tf_status_fault(tf_frames_file(&r->frames), TF_OUT_OF_MEMORY);
    return tf_friction_read(path, vertices, r->friction, &r->frames.fault);
}

//: Find the zones of what crosses at the start
static bool keep_crossings(resolving *r, const tf_crossings *found)
{
    r->exempt = malloc((found->count + 1) * sizeof *r->exempt);
    r->done.exempt_crossings = found->count;
    if (r->exempt && found->count > 0)
        memcpy(r->exempt, found->crossing, found->count * sizeof *r->exempt);
    return r->exempt || tf_status_fault(&r->frames.file[0], TF_OUT_OF_MEMORY);
}

static bool allocate_zones(resolving *r)
{
    int facets;
    if (r->frames.axes == 2)
        tf_surface_edges(r->frames.surface, &facets);
    else
        tf_surface_triangles(r->frames.surface, &facets);
    r->zone = malloc(((size_t)facets + 1) * sizeof *r->zone);
    return r->zone || tf_status_fault(&r->frames.file[0], TF_OUT_OF_MEMORY);
}

/// If they are to be left out.
static bool find_zones(resolving *r)
{
    tf_motion motion = tf_frames_motion(&r->frames);
    tf_check_options how = {.parallel = tf_threads_parallel(r->threads)};
    tf_crossings found;
    tf_error error;
    if (!r->request->exempt_crossings)
        return true;
    if (!allocate_zones(r))
        return false;
    tf_status status =
        tf_surface_zones(r->frames.surface, motion.vertices, motion.start, 0,
                         &how, r->zone, &r->done.exempt_zones, &found, &error);
    return status == TF_OK ? keep_crossings(r, &found)
                           : tf_error_fault(&r->frames.file[0], &error);
}

//: Resolve the step between two frames
static tf_response_options options_of(resolving *r)
{
    tf_response_options how = tf_response_requested(r->request, &r->progress);
    how.check_start = true;
    how.parallel = tf_threads_parallel(r->threads);
    how.vertex_friction = r->friction;
    how.zone = r->zone;
    return how;
}

static bool respond(resolving *r)
{
    tf_response_options how = options_of(r);
    tf_motion motion = tf_frames_motion(&r->frames);
    tf_error error;
    const tf_response_report *report;
    double begin = tf_clock_seconds();
    tf_status status = tf_step_resolve(r->resolver, motion.vertices,
                                       motion.start, tf_frames_end(&r->frames),
                                       r->inverse_mass, &how, &report, &error);
    r->done.seconds = tf_clock_seconds() - begin;
    if (status == TF_OK)
        r->done.report = *report;
    return status == TF_OK || (status == TF_START_NOT_CLEAR
                                   ? tf_error_fault(&r->frames.file[0], &error)
                                   : tf_frames_fault(&r->frames, &error));
}

static bool resolve(resolving *r)
{
    tf_status status = tf_resolver_create(r->frames.surface, &r->resolver);
    bool good = status == TF_OK
                    ? find_zones(r) && respond(r)
                    : tf_status_fault(tf_frames_file(&r->frames), status);
    tf_frames_change(&r->frames);
    return good;
}

//: Resolve and write
/// Reads the start, and the end with all that it has.
static bool read(resolving *r)
{
    if (!tf_frames_next(&r->frames, r->request->operand[0]))
        return false;
    r->frames.columns = &r->columns;
    r->frames.source = &r->source;
    return tf_frames_next(&r->frames, r->request->operand[1]);
}

static bool begin_output(resolving *r)
{
    const char *out = r->request->out;
    return r->shows
               ? tf_collection_begin(&r->shown, out, &r->frames.fault)
               : tf_mesh_output_begin(&r->out, out, tf_frames_file(&r->frames),
                                      &r->frames.fault);
}

/// What is written of a file with the same elements as the end.
static tf_mesh_content content_of(const resolving *r, const tf_mesh_file *file)
{
    return (tf_mesh_content){.mesh = tf_mesh_file_elements(file, 3),
                             .position = file->position.item,
                             .columns = &r->columns,
                             .from = file};
}

/// Writes the start and the end of the step as frames.
static bool show(resolving *r)
{
    tf_motion motion = tf_frames_motion(&r->frames);
    bool good = true;
    for (int i = 0; i < 2 && good; i++) {
        tf_mesh_content content = content_of(r, &r->frames.file[i]);
        tf_polydata mesh = tf_polydata_of_mesh(&content);
        good = i == 0 ||
               tf_contact_points_answered(&r->points, &motion, r->resolver) ||
               tf_status_fault(&r->frames.file[i], TF_OUT_OF_MEMORY);
        tf_polydata contacts = tf_contact_points_data(&r->points);
        good = good && tf_collection_add(&r->shown, &mesh, &contacts);
    }
    return good && tf_collection_end(&r->shown);
}

/// Lists what was left out, where the mesh is not.
static bool list_exempt(resolving *r)
{
    bool taken = tf_destination_is_standard(r->request->out);
    tf_crossings left_out = {r->done.exempt_crossings, r->exempt};
    return left_out.count == 0 ||
           tf_surface_output_append(taken ? stderr : stdout,
                                    *r->request->format, &r->frames.file[0],
                                    r->request->operand[0], &left_out) ||
           tf_fault_set_unwritten(&r->frames.fault, "the list", errno);
}

static bool write_shown(resolving *r, const tf_mesh_content *content,
                        const tf_mesh_report *report)
{
    tf_mesh_output_remark(r->request->out, content, content->from);
    return show(r) &&
           (tf_report_write(stdout, report->format, report->field,
                            report->record) ||
            tf_fault_set_unwritten(&r->frames.fault, "standard output", errno));
}

/// Writes the end of the step, in its format.
static bool write(resolving *r)
{
    const tf_mesh_file *end = tf_frames_file(&r->frames);
    tf_mesh_content content = content_of(r, end);
    tf_mesh_report report = {*r->request->format, tf_resolved_fields, &r->done};
    bool clear = r->done.report.first_contacts + r->done.report.first_near == 0;
    r->done.status = clear ? "clear" : "resolved";
    return (r->shows ? write_shown(r, &content, &report)
                     : tf_mesh_output_write(&r->out, &content, end, &report)) &&
           list_exempt(r);
}

static bool do_all(resolving *r)
{
    if (!read(r) || !read_masses(r) || !read_friction(r) || !begin_output(r))
        return false;
    bool good = resolve(r);
    tf_progress_line_end(&r->progress);
    if (!good)
        return false;
    return write(r);
}

//: End resolve
static void free_all(resolving *r)
{
    tf_destination_end(&r->out);
    tf_contact_points_free(&r->points);
    tf_resolver_free(r->resolver);
    free(r->inverse_mass);
    free(r->friction);
    free(r->zone);
    free(r->exempt);
    tf_frames_free(&r->frames);
    tf_columns_free(&r->columns);
    tf_source_free(&r->source);
    tf_threads_free(r->threads);
}

//: Run the command resolve
static int resolve_meshes(const tf_request *request)
{
    resolving r = {.request = request,
                   .shows = tf_is_collection(request->out),
                   .points = {.answered = true},
                   .progress = tf_progress_line_begin(true)};
    tf_threads_create(request->threads, &r.threads);
    bool good = do_all(&r);
    tf_fault_print(&r.frames.fault, "tanglefree");
    free_all(&r);
    return good ? 0 : 2;
}

static int run(const tf_request *request)
{
    return tf_is_scene(request->operand[0]) ? tf_scene_resolve(request)
                                            : resolve_meshes(request);
}

//: Refuse what does not go with a scene
static void check_scene(tf_request *request)
{
    static const char *const lists[] = {"fixed", "masses", "vertex-friction"};
    static const char *const keys[] = {"role: scripted", "mass:", "friction:"};
    for (int i = 0; i < 3; i++)
        if (tf_request_gave(request, lists[i]))
            tf_request_refuse(request,
                              "--%s is for two meshes; write '%s' in the scene",
                              lists[i], keys[i]);
    if (request->exempt_crossings)
        tf_request_refuse(request, "--exempt-crossings is for two meshes");
    if (tf_destination_is_standard(request->out))
        tf_request_refuse(request, "--output must be a folder for the frames "
                                   "of a scene, got '-'");
}

static void check_operands(tf_request *request)
{
    bool scene = tf_is_scene(request->operand[0]);
    if ((request->operands == 1) != scene)
        tf_request_refuse(request, "%s", tf_resolve_command.wanted);
    if (scene)
        check_scene(request);
}

const tf_command tf_resolve_command = {
    .set = TF_RESOLVE,
    .name = "resolve",
    .purpose = "change the end of a step such that nothing meets",
    .operands = "START END\nSCENE",
    .least = 1,
    .most = 2,
    .wanted = "two files are required, START and END, or a scene, whose name "
              "ends in .yaml, .yml or .json",
    .description = tf_resolve_description,
    .check = check_operands,
    .run = run,
};

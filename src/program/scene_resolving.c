//: Include what resolving a scene needs
#include "program/scene_resolving.h"

#include "program/reports.h"
#include "program/response_request.h"
#include "response/resolve.h"
#include "scenes/flaws.h"
#include "scenes/scene_file.h"
#include "scenes/scene_folder.h"
#include "scenes/shown_frames.h"
#include "threads/threads.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

//: Hold what resolves a scene
/// A row of the report.
typedef struct resolved_step {
    tf_resolved done; ///< first, for its fields
    size_t step;
} resolved_step;

typedef struct resolved_scene {
    size_t steps, resolved, contacts, held; ///< held: steps in which scripted
                                            ///< vertices were
    double seconds;
} resolved_scene;

enum {
    FIELDS = 40 // more than a row has
};

typedef struct scene_resolving {
    const tf_request *request;
    tf_threads *threads;
    tf_scene_meshes meshes;
    tf_scene_frames frames;
    double *inverse_mass; ///< of each vertex
    double *friction;     ///< of each vertex
    tf_surface *surface;  ///< that of the resolver
    tf_resolver *resolver;
    tf_field field[FIELDS];
    bool shows; ///< whether the frames are written for ParaView
    tf_shown_frames shown;
    tf_scene_folder folder; ///< otherwise
    tf_contact_points points;
    tf_records records;
    resolved_scene sum;
    tf_progress_line progress;
} scene_resolving;

//: Take masses and friction from the meshes
static void set_friction(scene_resolving *r, int m)
{
    double friction = r->meshes.mesh[m].friction;
    const int *first = r->frames.joined.first_vertex + m;
    for (int v = first[0]; v < first[1]; v++)
        r->friction[v] = friction >= 0 ? friction : r->request->friction;
}

static bool weigh(scene_resolving *r)
{
    size_t vertices = (size_t)tf_joined_vertices(&r->frames.joined);
    r->inverse_mass = malloc(vertices * sizeof *r->inverse_mass);
    r->friction = malloc(vertices * sizeof *r->friction);
    if (!r->inverse_mass || !r->friction)
        return tf_mesh_file_fault_in_memory(
            tf_scene_frames_file(&r->frames, 0, 1));
    for (int m = 0; m < r->meshes.count; m++)
        set_friction(r, m);
    return tf_scene_frames_weigh(&r->frames, r->request->operand[0],
                                 r->inverse_mass);
}

//: Resolve a step of a scene
/// A curve may leave the plane, and then has another surface.
static bool renew_resolver(scene_resolving *r)
{
    if (r->resolver && r->surface == r->frames.surface)
        return true;
    tf_resolver_free(r->resolver);
    r->resolver = NULL;
    r->surface = r->frames.surface;
    tf_status status = tf_resolver_create(r->surface, &r->resolver);
    return status == TF_OK ||
           tf_status_fault(tf_scene_frames_file(&r->frames, 0, 1), status);
}

/// What one step leaves is a legal start for the next.
static tf_response_options options_of(scene_resolving *r)
{
    tf_response_options how = tf_response_requested(r->request, &r->progress);
    how.check_start = r->sum.steps == 0;
    how.parallel = tf_threads_parallel(r->threads);
    how.vertex_friction = r->friction;
    return how;
}

/// The contacts of the step, which was resolved.
static bool set_points(scene_resolving *r)
{
    tf_motion motion = tf_scene_frames_motion(&r->frames);
    return tf_contact_points_answered(&r->points, &motion, r->resolver) ||
           tf_mesh_file_fault_in_memory(tf_scene_frames_file(&r->frames, 0, 1));
}

static bool resolve_step(scene_resolving *r, tf_resolved *done)
{
    tf_response_options how = options_of(r);
    tf_motion motion = tf_scene_frames_motion(&r->frames);
    tf_error error;
    const tf_response_report *report;
    double begin = tf_clock_seconds();
    if (tf_step_resolve(r->resolver, motion.vertices, motion.start,
                        tf_scene_frames_end(&r->frames), r->inverse_mass, &how,
                        &report, &error) != TF_OK)
        return tf_scene_frames_fault(&r->frames, &error);
    tf_scene_frames_change(&r->frames);
    if (r->shows && !set_points(r))
        return false;
    bool clear = report->first_contacts + report->first_near == 0;
    *done = (tf_resolved){.status = clear ? "clear" : "resolved",
                          .report = *report,
                          .seconds = tf_clock_seconds() - begin};
    return true;
}

//: Write the frames of resolved meshes
static bool write_meshes(scene_resolving *r)
{
    return r->shows ? tf_shown_frames_add(&r->shown, &r->frames, &r->points)
                    : tf_scene_folder_write(&r->folder, &r->frames);
}

//: Report the steps of a scene
static const tf_field step_field = TF_FIELD("step", resolved_step, step);
static const tf_field sum_fields[] = {
    TF_FIELD("steps", resolved_scene, steps),
    TF_FIELD("resolved steps", resolved_scene, resolved),
    TF_FIELD("first contacts", resolved_scene, contacts),
    TF_FIELD("held steps", resolved_scene, held),
    TF_FIELD("seconds", resolved_scene, seconds),
    {0}};

static bool fault_in_report(scene_resolving *r)
{
    return tf_fault_set_unwritten(&r->frames.fault, "standard output",
                                  r->records.error);
}

static void begin_report(scene_resolving *r)
{
    tf_fields_join(r->field, &step_field, tf_resolved_fields);
    tf_records_begin(&r->records, stdout, *r->request->format, "steps",
                     r->field);
}

static bool report_step(scene_resolving *r, const tf_resolved *done)
{
    resolved_step row = {*done, r->sum.steps};
    r->sum.steps++;
    r->sum.resolved +=
        done->report.first_contacts + done->report.first_near > 0;
    r->sum.contacts += done->report.first_contacts;
    r->sum.held += done->report.held > 0;
    r->sum.seconds += done->seconds;
    return tf_records_add(&r->records, &row) || fault_in_report(r);
}

/// If not all steps were done, JSON alone has sums; if none was, nothing is told.
static bool end_report(scene_resolving *r, bool done)
{
    if (!done && r->records.count == 0)
        return true;
    bool told = done || *r->request->format == TF_JSON;
    return tf_records_end(&r->records, told ? sum_fields : NULL, &r->sum) ||
           fault_in_report(r);
}

//: Resolve all steps of a scene
static bool begin_frames(scene_resolving *r)
{
    const char *out = r->request->out;
    return r->shows ? tf_shown_frames_begin(&r->shown, out, &r->frames.fault)
                    : tf_scene_folder_begin(&r->folder, out,
                                            ", or end the name in .pvd",
                                            &r->frames.fault);
}

static bool begin_scene(scene_resolving *r)
{
    const char *path = r->request->operand[0];
    r->frames.meshes = &r->meshes;
    r->frames.keeps_sources = !r->shows;
    if (!tf_scene_file_read(&r->meshes, path, &r->frames.fault))
        return false;
    if (r->meshes.frames < 2)
        return tf_scene_fault_in_frames(&r->meshes, path, &r->frames.fault);
    return tf_scene_check_moving(&r->meshes, path, "resolve",
                                 &r->frames.fault) &&
           tf_scene_frames_next(&r->frames) && weigh(r) && begin_frames(r) &&
           write_meshes(r);
}

static bool do_step(scene_resolving *r)
{
    tf_resolved done;
    bool good = tf_scene_frames_next(&r->frames) && renew_resolver(r) &&
                resolve_step(r, &done);
    tf_progress_line_end(&r->progress);
    return good && write_meshes(r) && report_step(r, &done);
}

static bool do_scene(scene_resolving *r)
{
    bool good = begin_scene(r);
    if (!good)
        return false;
    begin_report(r);
    for (int i = 1; i < r->meshes.frames && good; i++)
        good = do_step(r);
    good = good && (!r->shows || tf_shown_frames_end(&r->shown));
    return end_report(r, good) && good;
}

//: Run the resolution of a scene
int tf_scene_resolve(const tf_request *request)
{
    scene_resolving r = {.request = request,
                         .shows = tf_is_collection(request->out),
                         .points = {.answered = true},
                         .progress = tf_progress_line_begin(true)};
    tf_threads_create(request->threads, &r.threads);
    bool good = do_scene(&r);
    tf_fault_print(&r.frames.fault, "tanglefree");
    // Without a whole step nothing is worth keeping.
    if (!good)
        tf_scene_folder_leave(&r.folder, &r.frames, r.sum.steps > 0);
    tf_resolver_free(r.resolver);
    free(r.inverse_mass);
    free(r.friction);
    tf_shown_frames_free(&r.shown);
    tf_contact_points_free(&r.points);
    tf_scene_frames_free(&r.frames);
    tf_scene_meshes_free(&r.meshes);
    tf_threads_free(r.threads);
    return good ? 0 : 2;
}

//: Include what resolving a scene needs
#define _POSIX_C_SOURCE 200809L // rmdir
#include "program/scene_resolving.h"

#include "files/folder.h"
#include "program/mesh_frame.h"
#include "program/reports.h"
#include "program/response_request.h"
#include "response/resolve.h"
#include "scenes/flaws.h"
#include "scenes/forecast.h"
#include "scenes/scene_file.h"
#include "scenes/scene_frames.h"
#include "scenes/shown_frames.h"
#include "threads/threads.h"
#include "writers/endings.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

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
    bool has_folder;
    double bytes;                  ///< of the meshes that were written
    char path[TF_MESH_FRAME_PATH]; ///< of the file at work, which faults name
    tf_contact_points points;
    tf_records records;
    resolved_scene sum;
    tf_progress_line progress;
} scene_resolving;

//: Take masses and friction from the meshes
static double inverse_mass_of(const tf_scene_mesh *mesh, int vertices)
{
    return mesh->role != TF_MOVING ? 0
           : mesh->mass > 0        ? vertices / mesh->mass
                                   : 1;
}

static bool weigh_mesh(scene_resolving *r, int m)
{
    const tf_scene_mesh *mesh = &r->meshes.mesh[m];
    const int *first = r->frames.joined.first_vertex + m;
    for (int v = first[0]; v < first[1]; v++) {
        r->inverse_mass[v] = inverse_mass_of(mesh, first[1] - first[0]);
        r->friction[v] =
            mesh->friction >= 0 ? mesh->friction : r->request->friction;
    }
    return tf_scene_mesh_pin(mesh, r->request->operand[0], first[1] - first[0],
                             r->inverse_mass + first[0], &r->frames.fault);
}

static bool weigh(scene_resolving *r)
{
    size_t vertices = (size_t)tf_joined_vertices(&r->frames.joined);
    r->inverse_mass = malloc(vertices * sizeof *r->inverse_mass);
    r->friction = malloc(vertices * sizeof *r->friction);
    if (!r->inverse_mass || !r->friction)
        return tf_mesh_file_fault_in_memory(
            tf_scene_frames_file(&r->frames, 0, 1));
    bool good = true;
    for (int m = 0; m < r->meshes.count && good; m++)
        good = weigh_mesh(r, m);
    return good;
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

//: Write the frames of a scene
/// Whether a mesh is not where its frame has it.
static bool is_displaced(const scene_resolving *r, int m)
{
    const tf_doubles *position =
        &tf_scene_frames_file(&r->frames, m, 1)->position;
    return memcmp(position->item, tf_scene_frames_positions(&r->frames, m),
                  position->count * sizeof *position->item) != 0;
}

/// Writes a frame of a mesh that moves, and of another if that was held back.
static bool write_mesh(scene_resolving *r, int m)
{
    bool moves = r->meshes.mesh[m].role == TF_MOVING;
    if (!moves && !is_displaced(r, m))
        return true;
    tf_mesh_frame frame = {r->request->out, r->meshes.mesh[m].name,
                           r->frames.count - 1,
                           tf_scene_frames_file(&r->frames, m, 1),
                           tf_scene_frames_positions(&r->frames, m)};
    bool good = tf_mesh_frame_write(&frame, r->path, &r->frames.fault);
    r->bytes += good ? tf_bytes_of(r->path) : 0;
    if (good && !moves)
        fprintf(stderr,
                "tanglefree: %s was held back in frame %d; %s has its actual "
                "positions\n",
                tf_make_visible(r->meshes.mesh[m].name).text,
                r->frames.count - 1, tf_make_visible(r->path).text);
    return good;
}

static bool write_meshes(scene_resolving *r)
{
    bool good = true;
    if (r->shows)
        return tf_shown_frames_add(&r->shown, &r->frames, &r->points);
    for (int m = 0; m < r->meshes.count && good; m++)
        good = write_mesh(r, m);
    if (r->frames.count == 1 && good)
        tf_forecast_frames(r->request->out, r->meshes.frames, r->bytes);
    return good;
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

static void list_fields(tf_field field[FIELDS])
{
    int i = 0;
    for (*field++ = step_field; tf_resolved_fields[i].name; i++)
        field[i] = tf_resolved_fields[i];
    field[i] = (tf_field){0};
}

static bool fault_in_report(scene_resolving *r)
{
    return tf_fault_set_unwritten(&r->frames.fault, "standard output",
                                  r->records.error);
}

static void begin_report(scene_resolving *r)
{
    list_fields(r->field);
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
    const char *out = r->request->out, *ending = tf_any_mesh_ending(out);
    if (r->shows)
        return tf_shown_frames_begin(&r->shown, out, &r->frames.fault);
    if (ending)
        return tf_fault_set(&r->frames.fault, out, -1,
                            "the frames of a scene need a folder; leave out "
                            "%s, or end the name in .pvd",
                            ending);
    r->has_folder = tf_folder_begin(out, "", &r->frames.fault);
    return r->has_folder;
}

static bool has_moving_mesh(const tf_scene_meshes *meshes)
{
    int m = 0;
    while (m < meshes->count && meshes->mesh[m].role != TF_MOVING)
        m++;
    return m < meshes->count;
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
    if (!has_moving_mesh(&r->meshes))
        return tf_fault_set(&r->frames.fault, path, -1,
                            "no mesh is moving, so there is nothing to "
                            "resolve; let one be, by its role");
    return tf_scene_frames_next(&r->frames) && weigh(r) && begin_frames(r) &&
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

//: Leave what was done before an error
static void delete_frames(const scene_resolving *r)
{
    for (int i = 0; i < r->frames.count; i++)
        for (int m = 0; m < r->meshes.count; m++)
            tf_mesh_frame_delete(
                &(tf_mesh_frame){r->request->out, r->meshes.mesh[m].name, i,
                                 tf_scene_frames_file(&r->frames, m, 1), NULL});
    rmdir(r->request->out);
}

/// Without a whole step nothing is worth keeping.
static void leave_frames(const scene_resolving *r)
{
    if (r->has_folder && r->sum.steps == 0)
        delete_frames(r);
    else if (r->has_folder)
        fprintf(stderr,
                "tanglefree: %s has the frames before that; delete it, or "
                "choose another, to begin again\n",
                tf_make_visible(r->request->out).text);
}

int tf_scene_resolve(const tf_request *request)
{
    scene_resolving r = {.request = request,
                         .shows = tf_is_collection(request->out),
                         .points = {.answered = true},
                         .progress = tf_progress_line_begin(true)};
    tf_threads_create(request->threads, &r.threads);
    bool good = do_scene(&r);
    tf_fault_print(&r.frames.fault, "tanglefree");
    if (!good)
        leave_frames(&r);
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

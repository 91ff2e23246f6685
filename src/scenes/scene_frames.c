//: Include what the frames of a scene need
#include "scenes/scene_frames.h"

#include "formats/mesh_reader.h"
#include "scenes/flaws.h"
#include "scenes/remarks.h"
#include "scenes/same_elements.h"

#include <stdlib.h>
#include <string.h>

//: Choose the files of a frame
static bool stays(const tf_scene_frames *frames, int mesh)
{
    const tf_scene_mesh *own = &frames->meshes->mesh[mesh];
    return own->role == TF_FIXED || own->frames.count == 1;
}

const tf_mesh_file *tf_scene_frames_file(const tf_scene_frames *frames,
                                         int mesh, int time)
{
    bool before = time == 0 && frames->count > 1;
    int slot = before ? 1 - frames->current : frames->current;
    return &frames->file[mesh][stays(frames, mesh) ? 0 : slot];
}

//: Read the files of a frame
/// An empty source for the current file of a mesh; NULL: it keeps none.
static tf_source *renew_source(const tf_scene_frames *frames, int mesh)
{
    if (!frames->keeps_sources)
        return NULL;
    for (int i = 0; i < 2; i++)
        tf_source_free(&frames->source[mesh][i]);
    return &frames->source[mesh][frames->current];
}

/// A mesh that stays is read once.
static bool read_file(tf_scene_frames *frames, int mesh)
{
    const tf_scene_mesh *own = &frames->meshes->mesh[mesh];
    tf_mesh_file *file = &frames->file[mesh][frames->current];
    if (frames->count > 0 && stays(frames, mesh))
        return true;
    tf_source *source = renew_source(frames, mesh);
    tf_mesh_file_free(file);
    if (!tf_mesh_file_read_all(file, tf_scene_mesh_path(own, frames->count),
                               mesh == 0 ? frames->columns : NULL, source,
                               &frames->fault))
        return false;
    tf_remarks_print(file);
    return frames->count == 0 ||
           tf_continue_sequence(file, &frames->file[mesh][1 - frames->current]);
}

static bool read_files(tf_scene_frames *frames)
{
    size_t meshes = (size_t)frames->meshes->count;
    frames->current = frames->count % 2;
    if (!frames->file) {
        frames->file = calloc(meshes, sizeof *frames->file);
        frames->source = calloc(meshes, sizeof *frames->source);
    }
    if (!frames->file || !frames->source)
        return tf_fault_set(&frames->fault,
                            frames->meshes->mesh[0].frames.path[0], -1,
                            "not enough memory for %d meshes; divide the scene",
                            frames->meshes->count);
    bool good = true;
    for (int m = 0; m < frames->meshes->count && good; m++)
        good = read_file(frames, m);
    return good;
}

//: Join the files of a frame
/// The files of the current frame, to be freed.  NULL: there is a fault.
static const tf_mesh_file **list_files(tf_scene_frames *frames)
{
    int meshes = frames->meshes->count;
    const tf_mesh_file **file = malloc((size_t)meshes * sizeof *file);
    for (int m = 0; m < meshes && file; m++)
        file[m] = tf_scene_frames_file(frames, m, 1);
    if (!file)
        tf_mesh_file_fault_in_memory(tf_scene_frames_file(frames, 0, 1));
    return file;
}

static bool join_files(tf_scene_frames *frames)
{
    if (frames->joined.meshes > 0)
        return true;
    const tf_mesh_file **file = list_files(frames);
    bool good =
        file && tf_joined_make(&frames->joined, frames->meshes->count, file);
    free(file);
    return good;
}

//: Gather the positions of a frame
/// A mesh that stays and moves is where the step before has left it.
static void gather_mesh(tf_scene_frames *frames, int mesh)
{
    size_t first = 3 * (size_t)frames->joined.first_vertex[mesh];
    const tf_mesh_file *file = tf_scene_frames_file(frames, mesh, 1);
    const double *before = frames->position[1 - frames->current];
    bool kept = frames->count > 0 && stays(frames, mesh) &&
                frames->meshes->mesh[mesh].role == TF_MOVING;
    memcpy(frames->position[frames->current] + first,
           kept ? before + first : file->position.item,
           file->position.count * sizeof *before);
}

static bool gather(tf_scene_frames *frames)
{
    size_t vertices = (size_t)tf_joined_vertices(&frames->joined);
    double **position = &frames->position[frames->current];
    if (!*position)
        *position = malloc((3 * vertices + 1) * sizeof **position);
    if (!*position)
        return tf_mesh_file_fault_in_memory(tf_scene_frames_file(frames, 0, 1));
    for (int m = 0; m < frames->meshes->count; m++)
        gather_mesh(frames, m);
    return true;
}

//: Leave out pairs of meshes
/// Two elements of one mesh may meet, those of two unless these are of a group.
static bool may_meet(void *context, const tf_element_pair *pair)
{
    const tf_scene_frames *frames = context;
    int second = pair->kind == TF_EDGE_EDGE ? 2 : 1;
    int a = tf_joined_mesh(&frames->joined, pair->vertex[0]);
    int b = tf_joined_mesh(&frames->joined, pair->vertex[second]);
    const char *own = frames->meshes->mesh[a].group;
    const char *other = frames->meshes->mesh[b].group;
    return a == b ||
           (!frames->each && !(own && other && strcmp(own, other) == 0));
}

static bool has_groups(const tf_scene_meshes *meshes)
{
    bool found = false;
    for (int m = 0; m < meshes->count && !found; m++)
        found = meshes->mesh[m].group;
    return found;
}

tf_pair_filter tf_scene_frames_filter(tf_scene_frames *frames)
{
    return frames->each || has_groups(frames->meshes)
               ? (tf_pair_filter){.size = sizeof(tf_pair_filter),
                                  .wanted = may_meet,
                                  .context = frames}
               : (tf_pair_filter){0};
}

static tf_status leave_out(tf_scene_frames *frames, tf_error *error)
{
    tf_pair_filter filter = tf_scene_frames_filter(frames);
    return filter.wanted
               ? tf_surface_set_filter(frames->surface, &filter, error)
               : TF_OK;
}

//: Make the surface of a scene
static bool is_flat_list(const double x[], int vertices)
{
    int v = 0;
    while (v < vertices && x[3 * (size_t)v + 2] == 0)
        v++;
    return v == vertices;
}

static bool is_flat_scene(const tf_scene_frames *frames)
{
    int meshes = frames->joined.meshes;
    int vertices = tf_joined_vertices(&frames->joined);
    return frames->joined.first_triangle[meshes] == 0 &&
           is_flat_list(frames->position[frames->current], vertices) &&
           (frames->count == 0 ||
            is_flat_list(frames->position[1 - frames->current], vertices));
}

static tf_status create(tf_scene_frames *frames,
                        const tf_mesh_file *const file[], tf_error *error)
{
    const tf_joined *joined = &frames->joined;
    int *triangle, *edge;
    tf_status status = error->status = TF_OUT_OF_MEMORY;
    if (tf_joined_elements(joined, file, &triangle, &edge)) {
        tf_mesh mesh = {.axes = frames->axes,
                        .vertices = tf_joined_vertices(joined),
                        .triangles = joined->first_triangle[joined->meshes],
                        .triangle = triangle,
                        .edges = joined->first_edge[joined->meshes],
                        .edge = edge};
        status = tf_surface_create(&mesh, &frames->surface, error);
    }
    free(triangle);
    free(edge);
    return status == TF_OK ? leave_out(frames, error) : status;
}

static bool make_scene_surface(tf_scene_frames *frames)
{
    int axes = is_flat_scene(frames) ? 2 : 3;
    if (frames->surface && axes == frames->axes)
        return true;
    const tf_mesh_file **file = list_files(frames);
    tf_error error = {.subject = TF_NO_SUBJECT};
    tf_surface_free(frames->surface);
    frames->surface = NULL;
    frames->axes = axes;
    bool good = file && (create(frames, file, &error) == TF_OK ||
                         tf_scene_frames_fault(frames, &error));
    free(file);
    return good;
}

//: Leave out z in the plane of a scene
static bool flatten_slot(tf_scene_frames *frames, int slot)
{
    size_t vertices = (size_t)tf_joined_vertices(&frames->joined);
    const double *x = frames->position[slot];
    double *flat = frames->flat[slot];
    if (!flat)
        flat = malloc(2 * (vertices + 1) * sizeof *flat);
    if (!flat)
        return tf_mesh_file_fault_in_memory(tf_scene_frames_file(frames, 0, 1));
    frames->flat[slot] = flat;
    for (size_t v = 0; v < vertices && x; v++)
        memcpy(flat + 2 * v, x + 3 * v, 2 * sizeof *flat);
    return true;
}

static bool flatten_scene(tf_scene_frames *frames)
{
    return frames->axes == 3 ||
           (flatten_slot(frames, 0) && flatten_slot(frames, 1));
}

//: Read the next frame of a scene
bool tf_scene_frames_next(tf_scene_frames *frames)
{
    if (!read_files(frames) || !join_files(frames) || !gather(frames) ||
        !make_scene_surface(frames))
        return false;
    frames->count++;
    return flatten_scene(frames);
}

//: Lend the positions of a scene
static double *positions_at(const tf_scene_frames *frames, int slot)
{
    return frames->axes == 2 ? frames->flat[slot] : frames->position[slot];
}

tf_motion tf_scene_frames_motion(const tf_scene_frames *frames)
{
    int end = frames->current, start = frames->count > 1 ? 1 - end : end;
    return (tf_motion){.axes = frames->axes,
                       .vertices = tf_joined_vertices(&frames->joined),
                       .start = positions_at(frames, start),
                       .end = positions_at(frames, end)};
}

const double *tf_scene_frames_positions(const tf_scene_frames *frames, int mesh)
{
    return frames->position[frames->current] +
           3 * (size_t)frames->joined.first_vertex[mesh];
}

//: Change the end of a step of a scene
double *tf_scene_frames_end(tf_scene_frames *frames)
{
    return positions_at(frames, frames->current);
}

void tf_scene_frames_change(tf_scene_frames *frames)
{
    size_t vertices = (size_t)tf_joined_vertices(&frames->joined);
    double *x = frames->position[frames->current];
    const double *flat = frames->flat[frames->current];
    for (size_t v = 0; v < vertices && frames->axes == 2; v++)
        memcpy(x + 3 * v, flat + 2 * v, 2 * sizeof *flat);
}

//: Divide the polygons of a changed scene
static bool divide_mesh(tf_scene_frames *frames, int mesh)
{
    tf_mesh_file *file = &frames->file[mesh][frames->current];
    memcpy(file->position.item, tf_scene_frames_positions(frames, mesh),
           file->position.count * sizeof *file->position.item);
    return tf_mesh_file_divide(file);
}

bool tf_scene_frames_divide(tf_scene_frames *frames)
{
    bool good = true;
    for (int m = 0; m < frames->meshes->count && good; m++)
        good = divide_mesh(frames, m);
    tf_surface_free(frames->surface);
    frames->surface = NULL;
    return good && make_scene_surface(frames);
}

//: Weigh the vertices of a scene
static double inverse_mass_of(const tf_scene_mesh *mesh, int vertices)
{
    return mesh->role != TF_MOVING ? 0
           : mesh->mass > 0        ? vertices / mesh->mass
                                   : 1;
}

bool tf_scene_frames_weigh(tf_scene_frames *frames, const char *path,
                           double inverse_mass[])
{
    bool good = true;
    for (int m = 0; m < frames->meshes->count && good; m++) {
        const tf_scene_mesh *mesh = &frames->meshes->mesh[m];
        int first = frames->joined.first_vertex[m];
        int vertices = frames->joined.first_vertex[m + 1] - first;
        for (int v = 0; v < vertices; v++)
            inverse_mass[first + v] = inverse_mass_of(mesh, vertices);
        good = tf_scene_mesh_pin(mesh, path, vertices, inverse_mass + first,
                                 &frames->fault);
    }
    return good;
}

//: Describe what is wrong with a scene
bool tf_scene_frames_fault(const tf_scene_frames *frames, const tf_error *error)
{
    tf_error own = *error;
    int mesh[2];
    int time = error->status == TF_START_NOT_CLEAR ? 0 : 1;
    tf_joined_localize_error(&frames->joined, &own, mesh);
    const tf_mesh_file *file = tf_scene_frames_file(frames, mesh[0], time);
    return mesh[0] == mesh[1]
               ? tf_error_fault(file, &own)
               : tf_pair_fault(
                     file, tf_scene_frames_file(frames, mesh[1], time), &own);
}

//: Free the frames of a scene
void tf_scene_frames_free(tf_scene_frames *frames)
{
    for (int m = 0; m < frames->meshes->count; m++)
        for (int i = 0; i < 2; i++) {
            if (frames->file)
                tf_mesh_file_free(&frames->file[m][i]);
            if (frames->source)
                tf_source_free(&frames->source[m][i]);
        }
    free(frames->file);
    free(frames->source);
    tf_joined_free(&frames->joined);
    tf_surface_free(frames->surface);
    for (int i = 0; i < 2; i++) {
        free(frames->position[i]);
        free(frames->flat[i]);
    }
    *frames = (tf_scene_frames){.meshes = frames->meshes,
                                .each = frames->each,
                                .columns = frames->columns,
                                .keeps_sources = frames->keeps_sources};
}

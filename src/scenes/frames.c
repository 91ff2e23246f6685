//: Include what frames need
#include "scenes/frames.h"

#include "formats/mesh_reader.h"
#include "scenes/flaws.h"
#include "scenes/remarks.h"
#include "scenes/same_elements.h"

#include <stdlib.h>
#include <string.h>

//: Describe what is wrong with a frame
bool tf_frames_fault(const tf_frames *frames, const tf_error *error)
{
    return tf_error_fault(tf_frames_file(frames), error);
}

//: Make the surface of a step
static bool is_flat(const tf_frames *frames)
{
    return tf_mesh_file_is_flat(&frames->file[0]) &&
           (frames->count == 1 || tf_mesh_file_is_flat(&frames->file[1]));
}

static bool make_surface(tf_frames *frames)
{
    int axes = is_flat(frames) ? 2 : 3;
    if (frames->surface && axes == frames->axes)
        return true;
    tf_mesh mesh = tf_mesh_file_elements(tf_frames_file(frames), axes);
    tf_error error;
    tf_surface_free(frames->surface);
    frames->surface = NULL;
    frames->axes = axes;
    tf_status status = tf_surface_create(&mesh, &frames->surface, &error);
    return status == TF_OK || tf_frames_fault(frames, &error);
}

//: Leave out z in the plane
static bool flatten(tf_frames *frames)
{
    for (int i = 0; i < 2 && frames->axes == 2; i++) {
        const tf_mesh_file *file = &frames->file[i];
        size_t vertices = (size_t)tf_mesh_file_vertices(file);
        double *flat =
            realloc(frames->flat[i], 2 * (vertices + 1) * sizeof *flat);
        if (!flat)
            return tf_mesh_file_fault_in_memory(file);
        frames->flat[i] = flat;
        for (size_t v = 0; v < vertices; v++)
            memcpy(flat + 2 * v, file->position.item + 3 * v, 2 * sizeof *flat);
    }
    return true;
}

//: Begin frames anew
/// With the current file, in its place; the one before is dropped.
static void begin_anew(tf_frames *frames)
{
    frames->fault.text[0] = '\0';
    tf_mesh_file_free(&frames->file[1 - frames->current]);
    tf_surface_free(frames->surface);
    frames->surface = NULL;
    frames->count = frames->current;
    frames->is_new = true;
}

//: Find out whether elements may have been replaced
/// Surfaces are remeshed, curves are not.
static bool may_differ(const tf_frames *frames)
{
    return frames->may_differ && tf_mesh_file_edges(&frames->file[0]) == 0 &&
           tf_mesh_file_edges(&frames->file[1]) == 0;
}

//: Continue the frames
static bool continue_frames(tf_frames *frames)
{
    tf_mesh_file *file = &frames->file[frames->current];
    const tf_mesh_file *before = &frames->file[1 - frames->current];
    bool same = tf_continue_sequence(file, before);
    if (!same && may_differ(frames))
        begin_anew(frames);
    return same || frames->is_new;
}

//: Read the next frame
bool tf_frames_next(tf_frames *frames, const char *path)
{
    frames->current = frames->count % 2;
    tf_mesh_file *file = &frames->file[frames->current];
    tf_mesh_file_free(file);
    if (!tf_mesh_file_read_all(file, path, frames->columns, frames->source,
                               &frames->fault))
        return false;
    tf_remarks_print(file);
    frames->is_new = frames->count == 0;
    if (frames->count > 0 && !continue_frames(frames))
        return false;
    frames->count++;
    return make_surface(frames) && flatten(frames);
}

//: Lend a frame
const tf_mesh_file *tf_frames_file(const tf_frames *frames)
{
    return &frames->file[frames->current];
}

static const double *positions(const tf_frames *frames, int i)
{
    return frames->axes == 2 ? frames->flat[i] : frames->file[i].position.item;
}

tf_motion tf_frames_motion(const tf_frames *frames)
{
    int end = frames->current, start = frames->count > 1 ? 1 - end : end;
    return (tf_motion){.axes = frames->axes,
                       .vertices = tf_mesh_file_vertices(&frames->file[end]),
                       .start = positions(frames, start),
                       .end = positions(frames, end)};
}

//: Change a frame
double *tf_frames_end(tf_frames *frames)
{
    int end = frames->current;
    return frames->axes == 2 ? frames->flat[end]
                             : frames->file[end].position.item;
}

void tf_frames_change(tf_frames *frames)
{
    tf_mesh_file *file = &frames->file[frames->current];
    const double *flat = frames->flat[frames->current];
    size_t vertices = (size_t)tf_mesh_file_vertices(file);
    for (size_t v = 0; v < vertices && frames->axes == 2; v++)
        memcpy(file->position.item + 3 * v, flat + 2 * v, 2 * sizeof *flat);
}

//: Divide the polygons of a changed frame
bool tf_frames_divide(tf_frames *frames)
{
    tf_surface_free(frames->surface);
    frames->surface = NULL;
    return tf_mesh_file_divide(&frames->file[frames->current]) &&
           make_surface(frames);
}

//: Free the frames
void tf_frames_free(tf_frames *frames)
{
    for (int i = 0; i < 2; i++) {
        tf_mesh_file_free(&frames->file[i]);
        free(frames->flat[i]);
    }
    tf_surface_free(frames->surface);
    *frames = (tf_frames){0};
}

//: Include what untangling a frame needs
#include "scenes/untangled_frame.h"

#include "scenes/flaws.h"

#include <stdlib.h>
#include <string.h>

//: Hold the untangling of a frame
typedef struct untangling {
    tf_scene_frames *frames;
    tf_untangle_options how;
    bool *fixed; ///< of each vertex
    tf_untangled_frame *done;
    bool divides;      ///< whether triangles of polygons depend on positions
    double *in, *best; ///< positions: those that were given, and those with the
                       ///< fewest intersections
    size_t bytes;      ///< of either
} untangling;

//: Untangle with the triangles of now
/// From the positions that were given.
static bool untangle(untangling *u, tf_untangle_report *report)
{
    tf_scene_frames *frames = u->frames;
    tf_resolver *resolver = NULL;
    tf_error error;
    tf_status status = tf_resolver_create(frames->surface, &resolver);
    if (status != TF_OK)
        return tf_status_fault(tf_scene_frames_file(frames, 0, 1), status);
    status =
        tf_untangle(resolver, tf_joined_vertices(&frames->joined), u->in,
                    tf_scene_frames_end(frames), &u->how, report, NULL, &error);
    tf_resolver_free(resolver);
    return status == TF_OK || tf_scene_frames_fault(frames, &error);
}

//: Find what is left of a tangle
static bool find_left(untangling *u)
{
    tf_motion rest = tf_scene_frames_motion(u->frames);
    tf_check_options how = {.parallel = u->how.parallel};
    tf_error error;
    return tf_surface_check(u->frames->surface, rest.vertices, rest.end, &how,
                            &u->done->left, &error) == TF_OK ||
           tf_scene_frames_fault(u->frames, &error);
}

/// As it is for those who read the files.
static bool divide(untangling *u)
{
    tf_scene_frames_change(u->frames);
    return (!u->divides || tf_scene_frames_divide(u->frames)) && find_left(u);
}

//: Begin to untangle a frame
static bool has_polygons(const tf_scene_frames *frames)
{
    bool found = false;
    for (int m = 0; m < frames->meshes->count && !found; m++)
        found = tf_mesh_file_polygons(tf_scene_frames_file(frames, m, 1)) > 0;
    return found;
}

static bool reserve(untangling *u, size_t vertices)
{
    u->bytes = (size_t)u->frames->axes * vertices * sizeof *u->in;
    u->in = malloc(u->bytes + 1);
    u->best = malloc(u->bytes + 1);
    u->fixed = malloc(vertices + 1);
    return (u->in && u->best && u->fixed) ||
           tf_mesh_file_fault_in_memory(tf_scene_frames_file(u->frames, 0, 1));
}

static bool begin(untangling *u, const double inverse_mass[])
{
    size_t vertices = (size_t)tf_joined_vertices(&u->frames->joined);
    u->divides = u->frames->count == 1 && has_polygons(u->frames);
    if (!reserve(u, vertices))
        return false;
    memcpy(u->in, tf_scene_frames_end(u->frames), u->bytes);
    memcpy(u->best, u->in, u->bytes);
    for (size_t v = 0; v < vertices; v++)
        u->fixed[v] = inverse_mass[v] == 0;
    u->how.fixed = u->fixed;
    bool good = find_left(u);
    u->done->before = u->done->left.count;
    return good;
}

//: Untangle until the divided polygons are clear
enum {
    PASSES = 10
};

/// Each pass untangles with the triangles that the last one has led to.
/// Without polygons there is but one.
static bool untangle_all(untangling *u)
{
    size_t least = u->done->before + 1;
    int passes = u->divides ? PASSES : 1;
    for (int pass = 0; pass < passes && least > 0; pass++) {
        tf_untangle_report report;
        if (!untangle(u, &report) || !divide(u))
            return false;
        if (u->done->left.count >= least)
            continue;
        least = u->done->left.count;
        u->done->report = report;
        memcpy(u->best, tf_scene_frames_end(u->frames), u->bytes);
    }
    memcpy(tf_scene_frames_end(u->frames), u->best, u->bytes);
    return divide(u);
}

//: Untangle a frame
bool tf_untangle_frame(tf_scene_frames *frames, const double inverse_mass[],
                       const tf_untangle_options *how, tf_untangled_frame *done)
{
    *done = (tf_untangled_frame){0};
    untangling u = {.frames = frames, .how = *how, .done = done};
    bool good = begin(&u, inverse_mass) && untangle_all(&u);
    free(u.in);
    free(u.best);
    free(u.fixed);
    return good;
}

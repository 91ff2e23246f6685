//: Include what frames to look at need
#include "scenes/shown_frames.h"

#include "scenes/forecast.h"
#include "writers/vtp_writer.h"

#include <stdlib.h>

//: Begin and end frames to look at
bool tf_shown_frames_begin(tf_shown_frames *shown, const char *path,
                           tf_fault *fault)
{
    *shown = (tf_shown_frames){0};
    return tf_collection_begin(&shown->collection, path, fault);
}

bool tf_shown_frames_end(tf_shown_frames *shown)
{
    return tf_collection_end(&shown->collection);
}

void tf_shown_frames_free(tf_shown_frames *shown)
{
    free(shown->triangle);
    free(shown->edge);
    free(shown->mesh);
    *shown = (tf_shown_frames){0};
}

//: List the elements of frames to look at
static bool list_shown_elements(tf_shown_frames *shown,
                                const tf_scene_frames *frames)
{
    int meshes = frames->joined.meshes;
    const tf_mesh_file **file = malloc((size_t)meshes * sizeof *file);
    for (int m = 0; m < meshes && file; m++)
        file[m] = tf_scene_frames_file(frames, m, 1);
    bool good = file && tf_joined_elements(&frames->joined, file,
                                           &shown->triangle, &shown->edge);
    free(file);
    return good;
}

static bool number_meshes(tf_shown_frames *shown, const tf_joined *joined)
{
    size_t vertices = (size_t)tf_joined_vertices(joined);
    shown->mesh = malloc((vertices + 1) * sizeof *shown->mesh);
    for (int m = 0; m < joined->meshes && shown->mesh; m++)
        for (int v = joined->first_vertex[m]; v < joined->first_vertex[m + 1];
             v++)
            shown->mesh[v] = m;
    return shown->mesh;
}

static bool list_all(tf_shown_frames *shown, const tf_scene_frames *frames)
{
    return shown->mesh ||
           (list_shown_elements(shown, frames) &&
            number_meshes(shown, &frames->joined)) ||
           tf_fault_set(shown->collection.fault, shown->collection.path, -1,
                        "not enough memory; divide the scene, or use a machine "
                        "with more");
}

//: Add a frame to look at
static tf_polydata data_of(const tf_shown_frames *shown,
                           const tf_scene_frames *frames)
{
    const tf_joined *joined = &frames->joined;
    tf_mesh_content content = {
        .mesh = {.axes = 3,
                 .vertices = tf_joined_vertices(joined),
                 .triangles = joined->first_triangle[joined->meshes],
                 .triangle = shown->triangle,
                 .edges = joined->first_edge[joined->meshes],
                 .edge = shown->edge},
        .position = tf_scene_frames_positions(frames, 0)};
    tf_polydata data = tf_polydata_of_mesh(&content);
    if (joined->meshes > 1)
        tf_polydata_add(&data, &(tf_polydata_array){.name = "mesh",
                                                    .type = TF_INT,
                                                    .components = 1,
                                                    .rows = data.position.rows,
                                                    .integer = shown->mesh});
    return data;
}

bool tf_shown_frames_add(tf_shown_frames *shown, const tf_scene_frames *frames,
                         const tf_contact_points *contacts)
{
    if (!list_all(shown, frames))
        return false;
    tf_polydata mesh = data_of(shown, frames);
    tf_polydata points = tf_contact_points_data(contacts);
    tf_collection *to = &shown->collection;
    bool good = tf_collection_add(to, &mesh, &points);
    if (to->frames == 1)
        tf_forecast_frames(to->path, frames->meshes->frames, to->bytes);
    return good;
}

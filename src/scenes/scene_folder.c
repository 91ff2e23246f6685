//: Include what the folder of a scene needs
#define _POSIX_C_SOURCE 200809L // rmdir
#include "scenes/scene_folder.h"

#include "files/folder.h"
#include "scenes/forecast.h"
#include "writers/endings.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

//: Begin the folder of a scene
bool tf_scene_folder_begin(tf_scene_folder *folder, const char *path,
                           const char *otherwise, tf_fault *fault)
{
    const char *ending = tf_any_mesh_ending(path);
    if (ending)
        return tf_fault_set(fault, path, -1,
                            "the frames of a scene need a folder; leave out "
                            "%s%s",
                            ending, otherwise);
    bool good = tf_folder_begin(path, "", fault);
    folder->path = good ? path : NULL;
    return good;
}

//: Write the frames of a scene
/// Whether a mesh is not where its frame has it.
static bool is_displaced(const tf_scene_frames *frames, int m)
{
    const tf_doubles *position = &tf_scene_frames_file(frames, m, 1)->position;
    return memcmp(position->item, tf_scene_frames_positions(frames, m),
                  position->count * sizeof *position->item) != 0;
}

static bool write_mesh(tf_scene_folder *folder, tf_scene_frames *frames, int m)
{
    const tf_scene_mesh *mesh = &frames->meshes->mesh[m];
    int number = frames->count - 1;
    bool moves = mesh->role == TF_MOVING;
    if (!moves && !is_displaced(frames, m))
        return true;
    tf_mesh_frame frame = {folder->path, mesh->name, number,
                           tf_scene_frames_file(frames, m, 1),
                           tf_scene_frames_positions(frames, m)};
    bool good = tf_mesh_frame_write(&frame, folder->file, &frames->fault);
    folder->bytes += good ? tf_bytes_of(folder->file) : 0;
    if (good && !moves)
        fprintf(stderr,
                "tanglefree: %s was held back in frame %d; %s has its actual "
                "positions\n",
                tf_make_visible(mesh->name).text, number,
                tf_make_visible(folder->file).text);
    return good;
}

bool tf_scene_folder_write(tf_scene_folder *folder, tf_scene_frames *frames)
{
    bool good = true;
    for (int m = 0; m < frames->meshes->count && good; m++)
        good = write_mesh(folder, frames, m);
    if (frames->count == 1 && good)
        tf_forecast_frames(folder->path, frames->meshes->frames, folder->bytes);
    return good;
}

//: Leave what was done before an error
static void delete_frames(const tf_scene_folder *folder,
                          const tf_scene_frames *frames)
{
    for (int i = 0; i < frames->count; i++)
        for (int m = 0; m < frames->meshes->count; m++)
            tf_mesh_frame_delete(
                &(tf_mesh_frame){folder->path, frames->meshes->mesh[m].name, i,
                                 tf_scene_frames_file(frames, m, 1), NULL});
    rmdir(folder->path);
}

void tf_scene_folder_leave(const tf_scene_folder *folder,
                           const tf_scene_frames *frames, bool keeps)
{
    if (folder->path && !keeps)
        delete_frames(folder, frames);
    else if (folder->path)
        fprintf(stderr,
                "tanglefree: %s has the frames before that; delete it, or "
                "choose another, to begin again\n",
                tf_make_visible(folder->path).text);
}

//: Find out whether a mesh moves
bool tf_scene_check_moving(const tf_scene_meshes *meshes, const char *path,
                           const char *done, tf_fault *fault)
{
    int m = 0;
    while (m < meshes->count && meshes->mesh[m].role != TF_MOVING)
        m++;
    return m < meshes->count ||
           tf_fault_set(fault, path, -1,
                        "no mesh is moving, so there is nothing to %s; let one "
                        "be, by its role",
                        done);
}

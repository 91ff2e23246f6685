//: Declare the folder of a scene
#pragma once

#include "scenes/scene_frames.h"
#include "writers/mesh_frame.h"

/// A folder for the frames of the meshes of a scene that move, NAME-00000.obj
/// and so on, each in the format of its own file.  All zero: it is not there.
typedef struct tf_scene_folder {
    const char *path;              ///< borrowed; NULL: it was not begun
    double bytes;                  ///< of the files that were written
    char file[TF_MESH_FRAME_PATH]; ///< the one at work, which faults name
} tf_scene_folder;

/// Makes the folder, or takes an empty one.  False: there is a fault, for
/// example that the name is that of a mesh.
/// @param otherwise what to do about that besides leaving out the ending,
///     behind a comma; or ""
bool tf_scene_folder_begin(tf_scene_folder *folder, const char *path,
                           const char *otherwise, tf_fault *fault);

/// Writes the current frame of each mesh that moves, and of another one if that
/// is not where its frame has it, and then says so.  Each file appears whole or
/// not at all.  False: there is a fault of the frames.
bool tf_scene_folder_write(tf_scene_folder *folder, tf_scene_frames *frames);

/// Leaves the folder after an error: says that there are frames in it, or
/// deletes these and the folder if none is worth keeping.
void tf_scene_folder_leave(const tf_scene_folder *folder,
                           const tf_scene_frames *frames, bool keeps);

//: Declare how to find out what a scene moves
/// Whether any mesh moves; otherwise that is a fault of the scene's file, for
/// which `done` is what would be done to the mesh: "resolve".
bool tf_scene_check_moving(const tf_scene_meshes *meshes, const char *path,
                           const char *done, tf_fault *fault);

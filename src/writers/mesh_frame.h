//: Declare frames of meshes
#pragma once

#include "formats/mesh_file.h"

enum {
    TF_MESH_FRAME_PATH = 4096 ///< bytes of its path, with the 0 at the end
};

/// A mesh of a scene as a file of its own, in a folder.
typedef struct tf_mesh_frame {
    const char *folder;
    const char *name;         ///< of the mesh
    int number;               ///< of the frame
    const tf_mesh_file *from; ///< the file whose format, and all but the
                              ///< positions, it takes over
    const double *position;   ///< three coordinates a vertex
} tf_mesh_frame;

/// Deletes the file, if it is there.
void tf_mesh_frame_delete(const tf_mesh_frame *frame);

/// Writes the file, called as the mesh is, with the number of the frame and the
/// ending of its format, such as shirt-00012.obj.  It appears whole or not at
/// all.  False: there is a fault, which borrows the path.
/// @param[out] path that of the file
bool tf_mesh_frame_write(const tf_mesh_frame *frame,
                         char path[TF_MESH_FRAME_PATH], tf_fault *fault);

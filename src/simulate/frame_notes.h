//: Declare notes on frames
#pragma once

#include "scenes/joined.h"
#include "scenes/scene_meshes.h"

/// What a note says of a mesh.
typedef struct tf_mesh_note {
    int end; ///< how many vertices it and the meshes before it have
    tf_role role;
} tf_mesh_note;

/// What the frames of a scene say in their headers, for those who draw them.
/// All zero, but for `up`: nothing.
typedef struct tf_frame_notes {
    int up; ///< the axis that points up, 0 to 2; -1: nothing is said
    tf_mesh_note *mesh; ///< in the order of their vertices
    int meshes;
} tf_frame_notes;

/// The notes on a scene as lines of text, to be freed: "up y", and for each mesh
/// "mesh of 120 vertices, scripted: body".  NULL: there is no memory.
char *tf_frame_notes_write(const tf_scene_meshes *meshes,
                           const tf_joined *joined);

/// Reads the notes among the comments of a PLY file, if it has some.  False:
/// there is no memory.  Free them in any case.
bool tf_frame_notes_read(tf_frame_notes *notes, const char *path);

/// What moves a vertex: TF_MOVING unless a note says otherwise.
tf_role tf_frame_notes_role(const tf_frame_notes *notes, int vertex);

void tf_frame_notes_free(tf_frame_notes *notes);

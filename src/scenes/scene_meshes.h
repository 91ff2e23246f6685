//: Declare the meshes of a scene
#pragma once

#include "files/choice.h"
#include "files/fault.h"
#include "scenes/frame_names.h"

/// What moves a mesh of a scene.
typedef enum tf_role {
    TF_MOVING = 0, ///< it goes where it can
    TF_SCRIPTED,   ///< it goes where its frames say
    TF_FIXED       ///< it stays at its first frame
} tf_role;

/// The roles by their names.
extern const tf_choice tf_roles[];

/// A mesh of a scene.  The texts are its own.
typedef struct tf_scene_mesh {
    char *name;
    tf_frame_names frames; ///< one at least; one alone stays where it is
    tf_role role;
    double mass;     ///< of all vertices together; 0: 1 for each
    double friction; ///< Coulomb's coefficient; below 0: the usual one
    char *group;     ///< meshes of one are not tested against each other; NULL:
                     ///< it belongs to none
    long line;       ///< of the scene file, from 1; -1: there is none
} tf_scene_mesh;

/// The meshes of a scene.  All zero: there are none.
typedef struct tf_scene_meshes {
    tf_scene_mesh *mesh;
    int count;
    int frames; ///< of the scene: those of the meshes that have the most
} tf_scene_meshes;

//: Declare how to list the meshes of a scene
/// Adds a mesh that moves, without name and frames, to be completed.  NULL:
/// there is no memory.
tf_scene_mesh *tf_scene_meshes_add(tf_scene_meshes *meshes);

void tf_scene_meshes_free(tf_scene_meshes *meshes);

/// Gives names to meshes that have none, from their files: without folder and
/// ending, and if there are several frames without the number at the end and
/// what divides it from the rest.  False: there is no memory.
bool tf_scene_meshes_name(tf_scene_meshes *meshes);

/// Counts the frames, and checks that the meshes go together: each has one frame
/// or as many as the others, unless it is fixed; no two have the same name; and
/// of those that move all have a mass or none.  False: there is a fault.
/// @param file the scene file, borrowed for the fault
bool tf_scene_meshes_check(tf_scene_meshes *meshes, const char *file,
                           tf_fault *fault);

/// The file of a mesh in a frame of the scene.
const char *tf_scene_mesh_path(const tf_scene_mesh *mesh, int frame);

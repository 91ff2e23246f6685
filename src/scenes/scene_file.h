//: Declare how to read a scene file
#pragma once

#include "scenes/scene_meshes.h"

/// Whether a file is a scene, not a mesh: its name ends in .yaml, .yml or .json.
bool tf_is_scene(const char *path);

/// Reads the scene file at `path`, a document of YAML, and finds the files that
/// it names, which it does not read:
///
///     meshes:
///       - name: shirt             # or what its files are called
///         frames: walk/shirt-*.obj  # or a list; relative to the scene file
///         role: moving            # which is usual; or scripted, or fixed
///         mass: 0.2               # of the whole mesh; 1 for each vertex
///         friction: 0.4           # or the usual one
///         group: outfit           # or none
///         material: {density: 0.15, stretch: 300, bend: 1.5e-4}
///         pinned: [0, 7]          # or a file
///     rate: 25                    # frames a second; for tf_scene_physics
///
/// False: there is a fault, which borrows the path.  Free the meshes in any
/// case.
bool tf_scene_file_read(tf_scene_meshes *meshes, const char *path,
                        tf_fault *fault);

/// The same for a simulation, which may have a shape in place of meshes.
bool tf_simulated_file_read(tf_scene_meshes *meshes, const char *path,
                            tf_fault *fault);

/// What is wrong with a scene that should have steps.
#define TF_NO_STEP_FAULT                                                       \
    "has only one frame, so there is no step; give a mesh that isn't fixed "   \
    "two "                                                                     \
    "frames or more"

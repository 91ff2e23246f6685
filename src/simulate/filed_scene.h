//: Declare scenes from files
#pragma once

#include "scenes/scene_frames.h"
#include "simulate/scene.h"

/// A scene that was read from a file.  It must stay where it is in memory as
/// long as it is simulated.
typedef struct tf_filed_scene {
    tf_scene scene;    ///< to be simulated once
    double resolution; ///< its usual one, or that of the file
    char name[40];     ///< the scene's: that of the file, without its folder
    const char *path;
    tf_scene_meshes meshes; ///< none: it has a shape
    tf_scene_frames frames; ///< of the meshes: those around the last time
    tf_body body;           ///< that they make, until it is simulated
    int axes, vertices;     ///< its own
    const double *mass;     ///< of its vertices; lent by the body
    double *friction;       ///< of its vertices; NULL: that of the scene
    char *notes;            ///< on its frames, or NULL
    tf_fault fault;         ///< of the file, or of one that it names
} tf_filed_scene;

/// Reads a scene file, and all frames of its meshes, to see that they are good.
///
/// A mesh that moves starts where its first frame has it, and is made of its
/// material: edges are springs, and pairs of triangles resist folds.  Its pinned
/// vertices, and scripted meshes, go where the frames say, along straight lines
/// between one frame and the next, and stay after the last one.
/// @param path borrowed
/// @return false: there is a fault
bool tf_filed_scene_read(tf_filed_scene *filed, const char *path);

void tf_filed_scene_free(tf_filed_scene *filed);

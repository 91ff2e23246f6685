//: Declare the scenes
#pragma once

#include "simulate/air.h"
#include "simulate/body.h"
#include "simulate/handle.h"

enum {
    TF_MOST_HANDLES = 2
};

/// What a scene begins with.
typedef struct tf_stage {
    tf_body body;
    int handles;
    tf_handle handle[TF_MOST_HANDLES];
} tf_stage;

/// A scene that can be simulated.
typedef struct tf_scene {
    const char *name;
    const char *shows;      ///< what happens in it, in a line
    const char *size_means; ///< of what the size is the number
    int size;               ///< the usual one
    int least;              ///< the smallest
    int steps;              ///< how many there usually are
    int axes;               ///< 3, or 2 in the plane
    double step;            ///< how long one takes, in seconds
    double gravity;         ///< in meters per square second
    tf_air air;
    double friction; ///< Coulomb's coefficient
    void (*build)(tf_stage *stage, int size);
} tf_scene;

/// All scenes, and how many there are.
const tf_scene *tf_scenes(int *count);

/// The scene of that name; NULL if there is none.
const tf_scene *tf_scene_named(const char *name);

/// Sets the stage of a scene.
/// @param size at least scene->least
/// @param[out] stage its body to be freed; without memory that has failed
void tf_scene_build(const tf_scene *scene, int size, tf_stage *stage);

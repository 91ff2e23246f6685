//: Declare what a mesh of a scene has
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

/// What a mesh is made of when it is simulated; below 0: the usual one.
typedef struct tf_scene_material {
    double density; ///< in kilograms per square meter
    double stretch; ///< what an edge resists, in newtons per meter
    double bend;    ///< what a fold resists, in newton meters
} tf_scene_material;

//: Declare a mesh of a scene
/// The texts and lists are its own.
typedef struct tf_scene_mesh {
    char *name;
    tf_frame_names frames; ///< one at least; one alone stays where it is
    tf_role role;
    double mass;     ///< of all vertices together; 0: 1 for each
    double friction; ///< Coulomb's coefficient; below 0: the usual one
    char *group;     ///< meshes of one are not tested against each other; NULL:
                     ///< it belongs to none
    tf_scene_material material;
    int *pinned;              ///< vertices that go where the frames say
    int pins;                 ///< how many are listed
    tf_frame_names pinned_in; ///< one file that lists them, or none
    long pinned_line;         ///< of the scene file, from 1
    long line;                ///< of the scene file, from 1; -1: there is none
} tf_scene_mesh;

//: Declare how a scene is simulated
/// The air in a scene, as tf_air.
typedef struct tf_scene_air {
    bool given; ///< otherwise it is the usual air
    double drag, wind[3], veer, gust;
} tf_scene_air;

/// How a scene is simulated.  A number below 0, or NULL: the usual one.
typedef struct tf_scene_physics {
    char *shows;                ///< what happens in it, in a line
    char *shape;                ///< the built-in scene in place of meshes
    long shape_line;            ///< of the scene file, from 1
    long resolution_line;       ///< the same of size or edge
    int size;                   ///< its resolution, as --size
    double edge;                ///< the same, as --edge
    int steps;                  ///< how many
    double step;                ///< how long one takes, in seconds
    double rate;                ///< how many frames a second has
    double gravity;             ///< in meters per square second
    int up;                     ///< the axis that points up, 0 to 2
    double friction;            ///< Coulomb's coefficient
    tf_scene_air air;           ///< about it
    tf_scene_material material; ///< of meshes without their own
} tf_scene_physics;

//: Declare the meshes of a scene together
/// All zero: there are none.
typedef struct tf_scene_meshes {
    tf_scene_mesh *mesh;
    int count;
    int frames; ///< of the scene: those of the meshes that have the most
    tf_scene_physics physics; ///< of a scene that was read from a file
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

/// Sets those of a mesh's inverse masses to 0 whose vertices are pinned.  False:
/// there is a fault.
/// @param file the scene file, borrowed for the fault
bool tf_scene_mesh_pin(const tf_scene_mesh *mesh, const char *file,
                       int vertices, double inverse_mass[], tf_fault *fault);

/// The file of a mesh in a frame of the scene.
const char *tf_scene_mesh_path(const tf_scene_mesh *mesh, int frame);

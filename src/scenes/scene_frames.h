//: Declare the frames of a scene
#pragma once

#include "query/motion.h"
#include "scenes/joined.h"
#include "scenes/scene_meshes.h"
#include "surface/pair_filter.h"
#include "surface/surface.h"

/// The frames of the meshes of a scene, one after another, and the surface that
/// they make together.  All zero but for what is to be set first: no frame was
/// read.
typedef struct tf_scene_frames {
    const tf_scene_meshes *meshes; ///< to be set first; borrowed
    bool each; ///< to be set first: whether no mesh is tested against another
    bool keeps_sources;  ///< to be set first: whether the current files keep
                         ///< theirs
    tf_columns *columns; ///< to be set first: for those of the first mesh, or
                         ///< NULL
    tf_mesh_file (*file)[2]; ///< of each mesh: that of the current frame, and
                             ///< that of the one before
    tf_source (*source)[2];  ///< the same, if they are kept
    int current;             ///< which of the two is the current one
    int count;               ///< how many frames were read, or one more
    tf_joined joined;
    int axes; ///< of the surface
    tf_surface *surface;
    double *position[2]; ///< of all vertices, three coordinates each
    double *flat[2];     ///< in the plane: the same without z
    tf_fault fault;
} tf_scene_frames;

/// Reads the next frame of each mesh, and makes the surface of it and the frame
/// before: one of the plane if both are.  A mesh that stays keeps its place: one
/// that moves ends where it has ended before.  False: there is a fault.
bool tf_scene_frames_next(tf_scene_frames *frames);

/// The step from the frame before to the current one; with one frame only, at
/// rest.
tf_motion tf_scene_frames_motion(const tf_scene_frames *frames);

/// Which pairs of the surface's elements may meet; all zero: all.
tf_pair_filter tf_scene_frames_filter(tf_scene_frames *frames);

/// The positions at the end of that step, to be changed; and how that is made
/// known before the next frame.
double *tf_scene_frames_end(tf_scene_frames *frames);
void tf_scene_frames_change(tf_scene_frames *frames);

/// Gives changed positions to the files of the first frame, divides their
/// polygons anew, as whoever reads these positions will, and makes the surface
/// anew.  False: there is a fault.
bool tf_scene_frames_divide(tf_scene_frames *frames);

/// Sets the inverse masses of all vertices: 0 for those that go where their
/// frames say, which are those of meshes that don't move, and pinned ones.
/// False: there is a fault.
/// @param path of the scene file, borrowed for the fault
bool tf_scene_frames_weigh(tf_scene_frames *frames, const char *path,
                           double inverse_mass[]);

//: Declare the files of a scene
/// The file of a mesh at the start of the step, 0, or at its end, 1.
const tf_mesh_file *tf_scene_frames_file(const tf_scene_frames *frames,
                                         int mesh, int time);

/// The positions of a mesh at the end of the step, three coordinates each.
const double *tf_scene_frames_positions(const tf_scene_frames *frames,
                                        int mesh);

/// Describes an error as the fault of the file of the mesh that it is about, at
/// the end of the step, or at its start if that is meant; false.
bool tf_scene_frames_fault(const tf_scene_frames *frames,
                           const tf_error *error);

void tf_scene_frames_free(tf_scene_frames *frames);

//: Declare the frames of a surface
#pragma once

#include "formats/mesh_file.h"
#include "query/motion.h"
#include "surface/surface.h"

/// A sequence of files that hold the same elements in several positions, and
/// the surface that they are.  If they may differ, the sequence begins anew with
/// each file that holds others, unless some are edges: a surface may have been
/// remeshed, but curves never are.
typedef struct tf_frames {
    tf_mesh_file file[2]; ///< the current one, and the one before it
    int current;          ///< which of the two is the current one
    int count;            ///< how many were read, or one more
    bool may_differ;      ///< to be set first
    tf_columns *columns;  ///< to be set first: for those of the last file, or
                          ///< NULL
    tf_source *source;    ///< the same, for the last file itself
    bool is_new;          ///< the sequence began with the last file
    int axes;             ///< of the surface
    tf_surface *surface;
    double *flat[2]; ///< in the plane: the positions, without z
    tf_fault fault;
} tf_frames;

/// Reads the next file, and makes the surface of it and the one before: one of
/// the plane if both are.  False: there is a fault.  It is
/// an error if the two do not have the same elements, unless they may differ.
bool tf_frames_next(tf_frames *frames, const char *path);

/// The file that was read last.
const tf_mesh_file *tf_frames_file(const tf_frames *frames);

/// The step from the frame before to the current one; with one frame only, at
/// rest.
tf_motion tf_frames_motion(const tf_frames *frames);

/// The positions at the end of that step, to be changed.
double *tf_frames_end(tf_frames *frames);

/// Gives changed positions to the current file; its z stays in the plane.
void tf_frames_change(tf_frames *frames);

/// Divides the polygons of the current file anew, whose positions have changed,
/// and makes the surface anew.  False: there is a fault.
bool tf_frames_divide(tf_frames *frames);

/// Describes an error as the fault of the current file; false.
bool tf_frames_fault(const tf_frames *frames, const tf_error *error);

void tf_frames_free(tf_frames *frames);

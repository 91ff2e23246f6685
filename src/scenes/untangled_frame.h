//: Declare how to untangle a frame
#pragma once

#include "scenes/scene_frames.h"
#include "untangle/untangle.h"

/// What untangling a frame did.
typedef struct tf_untangled_frame {
    size_t before;     ///< intersections, with polygons divided where their
                       ///< corners were
    tf_crossings left; ///< those that are left, with polygons divided where
                       ///< their corners are; lent by the surface until its
                       ///< next check
    tf_untangle_report report; ///< of the untangling that led there
} tf_untangled_frame;

/// Moves the vertices of the current frame such that it does not intersect
/// itself, as tf_untangle does, or to where the fewest intersections were
/// found.  Whoever reads a first frame divides its polygons where their corners
/// are, so there this is done over until they are clear as they are divided
/// then; later frames have the triangles of the first one.  False: there is a
/// fault of the frames.
/// @param inverse_mass of each vertex; those of 0 stay, bit for bit
/// @param how threads and progress; what is fixed is not looked at
bool tf_untangle_frame(tf_scene_frames *frames, const double inverse_mass[],
                       const tf_untangle_options *how,
                       tf_untangled_frame *done);

//: Declare frames to look at
#pragma once

#include "scenes/scene_frames.h"
#include "writers/collection.h"
#include "writers/contact_points.h"

/// The frames of a scene as a collection for ParaView: the joined meshes, with an
/// array mesh of their numbers if there are several, and contacts.  All zero: it
/// has not begun.
typedef struct tf_shown_frames {
    tf_collection collection;
    int *triangle, *edge; ///< of the joined meshes
    int *mesh;            ///< of each vertex
} tf_shown_frames;

/// Begins a collection.  This and all below are false after an error, which is in
/// the fault.
bool tf_shown_frames_begin(tf_shown_frames *shown, const char *path,
                           tf_fault *fault);

/// Adds the current frame, and the contacts of the step that ends there.  After
/// the first one, the bytes of all frames are forecast.
bool tf_shown_frames_add(tf_shown_frames *shown, const tf_scene_frames *frames,
                         const tf_contact_points *contacts);

/// Writes the list of all frames.
bool tf_shown_frames_end(tf_shown_frames *shown);

void tf_shown_frames_free(tf_shown_frames *shown);

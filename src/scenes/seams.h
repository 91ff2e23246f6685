//: Declare hints at seams
#pragma once

#include "scenes/scene_frames.h"
#include "surface/check.h"

/// Says on standard error, of each mesh that has not been hinted at, how many of
/// its intersections are of elements that have corners at one position, as at
/// seams that are not welded, and how many of its vertices coincide with others;
/// nothing, if none are.
/// @param found intersections of the current frame
/// @param name what each mesh is called
/// @param hinted of each mesh; to be set
void tf_hint_at_seams(const tf_scene_frames *frames, const tf_crossings *found,
                      const char *const name[], bool hinted[]);

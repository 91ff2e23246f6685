//: Declare how to untangle a scene
#pragma once

#include "program/options.h"

/// Untangles each frame of the scene that is the operand by itself, and writes
/// those of its meshes that move, a report, and what is left.  Returns the exit
/// status.
int tf_scene_untangle(const tf_request *request);

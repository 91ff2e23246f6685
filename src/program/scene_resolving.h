//: Declare how to resolve a scene
#pragma once

#include "program/options.h"

/// Resolves all steps of the scene that is the operand, one after another, and
/// writes the frames of its meshes and a report.  Returns the exit status.
int tf_scene_resolve(const tf_request *request);

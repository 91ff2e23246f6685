//: Declare scenes as texts
#pragma once

#include "simulate/scene.h"

#include <stdio.h>

/// Writes a built-in scene as a scene file, from which tf_filed_scene_read makes
/// the same scene.  Errors are those of the stream.
void tf_scene_write(FILE *stream, const tf_scene *scene);

//: Declare what is wrong with a mesh file
#pragma once

#include "files/mesh_file.h"
#include "response/options.h"
#include "surface/surface.h"
#include "surgery/adaptive.h"

/// Each describes, as the fault of a file, and returns false:
/// why it holds no surface,
bool tf_flaw_fault(const tf_mesh_file *file, tf_status status,
                   const tf_flaw *flaw);

/// why it holds no adaptive surface,
bool tf_defect_fault(const tf_mesh_file *file, tf_status status,
                     const tf_defect *defect);

/// or which elements keep a response from its start, which it holds.
bool tf_obstacle_fault(const tf_mesh_file *file, const tf_obstacle *obstacle);

//: Declare the defects of a mesh file
#pragma once

#include "files/mesh_file.h"
#include "surgery/adaptive.h"

/// Describes why a file holds no adaptive surface, and where, as its fault;
/// returns false.
bool tf_defect_fault(tf_mesh_file *file, tf_status status,
                     const tf_defect *defect);

//: Declare remarks on files
#pragma once

#include "formats/mesh_file.h"

/// Prints on standard error what was done to a file that was read, of each kind
/// for the first such file of the program alone.
void tf_remarks_print(const tf_mesh_file *file);

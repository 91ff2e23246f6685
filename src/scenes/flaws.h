//: Declare what is wrong with a mesh file
#pragma once

#include "base/error.h"
#include "formats/mesh_file.h"
#include "surgery/defects.h"

/// Describes an error as the fault of a file whose elements were given to the
/// library, with the line that it is about, if there is one; returns false.
bool tf_error_fault(const tf_mesh_file *file, const tf_error *error);

/// The same for a status alone.
bool tf_status_fault(const tf_mesh_file *file, tf_status status);

/// Describes an error about a pair of elements of two files as the fault of the
/// first, whose element comes first; returns false.
bool tf_pair_fault(const tf_mesh_file *file, const tf_mesh_file *other,
                   const tf_error *error);

/// Prints on standard error how many edges of a file that are of no triangle are
/// left out, how many triangles were turned over, all defects, of each kind the
/// first twenty, and how much is left alone.
void tf_defects_print(const tf_mesh_file *file, const tf_defects *defects);

//: Declare forecasts
#pragma once

#include "formats/mesh_file.h"

// Each says on standard error what long work will make, before it begins, so
// that a wrong unit or number is seen at once; of other work it says nothing.

/// The triangles of a mesh with edges of that length, above 0, if there will be
/// more than 50,000.  More than can be counted are left to the error.
void tf_forecast_triangles(const tf_mesh_file *file, double edge);

/// Frames to be written to a path, of so many bytes each, if they are more than
/// 100 MB.
void tf_forecast_frames(const char *path, int frames, double bytes);

/// The bytes of a file, 0 if there is none.
double tf_bytes_of(const char *path);

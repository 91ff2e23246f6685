//: Declare how corners are welded
#pragma once

#include "formats/mesh_file.h"

/// A table of the vertices of a file by their positions, for formats in which
/// each triangle has positions of its own.  All zero: it is empty.
typedef struct tf_welder {
    int *slot; ///< a vertex, counted from 1; 0: none
    size_t slots;
} tf_welder;

/// Finds the vertex at exactly this position (-0 and 0 are the same), or adds
/// one, so that vertices are in the order in which they first appear.  False:
/// there is a fault.
bool tf_welder_find(tf_welder *welder, tf_mesh_file *file, const double x[3],
                    long place, int *vertex);

/// Fetches what finding this position will read, some corners before.
void tf_welder_expect(const tf_welder *welder, const double x[3]);

void tf_welder_free(tf_welder *welder);

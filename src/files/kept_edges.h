//: Declare files of kept edges
#pragma once

#include "files/fault.h"

/// Edges that a file names, by their vertices.  All zero: there are none.
typedef struct tf_kept_edges {
    int count;
    int *vertex; ///< two of each; the same twice: the line has one alone
} tf_kept_edges;

/// Reads a file with one or two numbers of vertices, from 0, in each line.
/// False: there is a fault.  Free the edges in any case.
bool tf_kept_edges_read(tf_kept_edges *kept, const char *path, int vertices,
                        tf_fault *fault);

/// Adds the edge between two vertices.  False: there is no memory.
bool tf_kept_edges_add(tf_kept_edges *kept, int from, int to);

void tf_kept_edges_free(tf_kept_edges *kept);

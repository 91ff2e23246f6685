//: Declare lists of elements
#pragma once

#include "surface/buffer.h"

/// A list of edges or triangles: the vertices of each in increasing order, the
/// list sorted, and no element twice.
typedef struct tf_elements {
    int corners; ///< 2 or 3
    int count;
    int *corner; ///< `corners` indices each
    tf_buffer storage;
} tf_elements;

/// Sorts the vertices of one element.
void tf_element_sort(int corners, int corner[]);

/// Workspace for sorting lists of elements, one after another.
typedef struct tf_sort_workspace {
    tf_buffer other; ///< as many elements as the list has
    tf_buffer place; ///< of each vertex: where the next element with it goes
} tf_sort_workspace;

/// Makes a list of `count` elements that are in its storage, in any order.  False
/// if there is no memory.
bool tf_elements_sort(tf_elements *list, int count, int vertices,
                      tf_sort_workspace *workspace);

void tf_sort_workspace_free(tf_sort_workspace *workspace);

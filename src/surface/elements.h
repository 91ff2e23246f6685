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

/// Makes a list of `count` elements that are in its storage, in any order.
/// False if there is no memory.
bool tf_elements_sort(tf_elements *list, int count, int vertices);

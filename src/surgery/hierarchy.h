//: Declare the hierarchy of boxes
#pragma once

#include "surface/buffer.h"
#include "surgery/cuboid.h"

/// A binary tree of boxes over elements that come and go.  Each branch holds
/// the boxes of its two children, and the first one is above the root, as its
/// child 0, so that every element has a branch.
typedef struct tf_hierarchy {
    int branches;             ///< in use or free
    int free_branch;          ///< the first of a list linked by `parent`, or -1
    tf_buffer branch, parent; ///< `parent`: the branch of each element, or -1
    tf_buffer stack;          ///< of a search
} tf_hierarchy;

/// Makes room for elements numbered from 0, so that nothing below can fail.
/// False if there is no memory.
bool tf_hierarchy_reserve(tf_hierarchy *of, int elements);
void tf_hierarchy_free(tf_hierarchy *of);

//: Declare how elements come and go
/// Builds a balanced hierarchy of the elements order[0] to order[count - 1],
/// of those boxes; changes their order.
void tf_hierarchy_build(tf_hierarchy *of, const tf_cuboid box[], int order[],
                        int count);

void tf_hierarchy_insert(tf_hierarchy *of, int element, tf_cuboid box);
void tf_hierarchy_remove(tf_hierarchy *of, int element);

/// Gives an element another box, in the same place.
void tf_hierarchy_change(tf_hierarchy *of, int element, tf_cuboid box);

/// Lists the elements whose boxes overlap `box`; returns how many.
int tf_hierarchy_find(tf_hierarchy *of, const tf_cuboid *box, int found[]);

//: Declare how the nearest element is found
/// Finds an element whose distance from a point is least: `squared` computes the
/// square of the distance of one.  Returns the element and sets the square; -1 if
/// there is none.
int tf_hierarchy_nearest(tf_hierarchy *of, const double x[3],
                         double (*squared)(void *context, int element),
                         void *context, double *least);

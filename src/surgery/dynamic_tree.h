//: Declare the dynamic tree
#pragma once

#include "base/watch.h"
#include "surface/buffer.h"
#include "surgery/aabb.h"

/// A binary tree of boxes over elements that come and go.  Each branch holds
/// the boxes of its two children, and the first one is above the root, as its
/// child 0, so that every element has a branch.
typedef struct tf_dynamic_tree {
    int branches;             ///< in use or free
    int free_branch;          ///< the first of a list linked by `parent`, or -1
    tf_buffer branch, parent; ///< `parent`: the branch of each element, or -1
    tf_buffer stack;          ///< of a search
} tf_dynamic_tree;

/// Makes room for elements numbered from 0, so that nothing below can fail.
/// False if there is no memory.
bool tf_dynamic_tree_reserve(tf_dynamic_tree *tree, int elements);
void tf_dynamic_tree_free(tf_dynamic_tree *tree);

/// Makes a tree, which has room for so many elements, the same as another one.
void tf_dynamic_tree_copy(tf_dynamic_tree *to, const tf_dynamic_tree *from,
                          int elements);

//: Declare how elements come and go
/// Builds a balanced tree of the elements order[0] to order[count - 1],
/// of those boxes; changes their order.  False if the caller of the watch, which
/// may be NULL, cancels; then the tree is of no use.
bool tf_dynamic_tree_build(tf_dynamic_tree *tree, const tf_aabb box[],
                           int order[], int count, tf_watch *watch);

void tf_dynamic_tree_insert(tf_dynamic_tree *tree, int element, tf_aabb box);
void tf_dynamic_tree_remove(tf_dynamic_tree *tree, int element);

/// Gives an element another box, in the same place.
void tf_dynamic_tree_change(tf_dynamic_tree *tree, int element, tf_aabb box);

/// Lists the elements whose boxes overlap `box`; returns how many.
int tf_dynamic_tree_find(tf_dynamic_tree *tree, const tf_aabb *box,
                         int found[]);

//: Declare how the nearest element is found
/// Finds an element whose distance from a point is least: `squared` computes the
/// square of the distance of one.  Returns the element and sets the square; -1 if
/// there is none, or the distance of none is finite.
int tf_dynamic_tree_nearest(tf_dynamic_tree *tree, const double x[3],
                            double (*squared)(void *context, int element),
                            void *context, double *least);

//: Declare packs of boxes
#pragma once

#include "surface/box.h"
#include "surface/buffer.h"
#include "surface/morton.h"

enum {
    TF_LANES = 16,      ///< boxes a pack, which are as many as a vector holds
    TF_TREE_LEVELS = 8, ///< enough for any number of elements: 16^8 > 2^31
};

/// The boxes of up to TF_LANES elements or packs, by coordinate.  Those of
/// lanes that are not used are empty.
typedef struct tf_pack {
    float low[TF_SIDES][TF_LANES], high[TF_SIDES][TF_LANES];
} tf_pack;

//: Declare the tree of boxes
/// Elements in Morton order, TF_LANES to a leaf.  Above the packs of the leaves
/// are levels of packs, each of the boxes of TF_LANES packs of the level below,
/// up to a single one; so the children of pack i are the packs 16 i to 16 i +
/// 15, and there are no pointers.
typedef struct tf_tree {
    int count;                 ///< of elements
    int corners;               ///< of an element: 1, 2 or 3 vertices
    bool swept;                ///< as tf_tree_elements has it
    int levels;                ///< at least 2, unless there are no elements
    int packs[TF_TREE_LEVELS]; ///< of each level; the first are the leaves
    tf_pack *level[TF_TREE_LEVELS]; ///< their packs
    int (*element)[TF_LANES];       ///< of each leaf, -1 in an unused lane
    int (*corner)[TF_LANES]; ///< of each leaf, for each corner: the vertices
    tf_buffer pack_storage, element_storage, corner_storage;
} tf_tree;

//: Declare how to build a tree
/// Room for building trees, one after another.
typedef struct tf_tree_workspace {
    tf_buffer keys, sorted, counts;
} tf_tree_workspace;

/// What a tree is built of.
typedef struct tf_tree_elements {
    int count, corners;
    const int *corner;     ///< the vertices of one element after another; NULL:
                           ///< element i is the vertex i
    const tf_path *vertex; ///< the paths of the vertices
    const tf_box *whole;   ///< the union of all of these
    bool swept; ///< whether the boxes around the ends hold the starts as well
} tf_tree_elements;

/// Builds the tree anew, in memory that is kept.  False if there is not enough.
bool tf_tree_build(tf_tree *tree, const tf_tree_elements *elements,
                   tf_tree_workspace *workspace, const tf_parallel *parallel);

void tf_tree_free(tf_tree *tree);
void tf_tree_workspace_free(tf_tree_workspace *workspace);

//: Declare how to fill a pack
static inline void tf_pack_set_box(tf_pack *pack, int lane, const tf_box *box)
{
    for (int k = 0; k < TF_SIDES; k++) {
        pack->low[k][lane] = box->low[k];
        pack->high[k][lane] = box->high[k];
    }
}

/// The union of all boxes of a pack.
tf_box tf_pack_union(const tf_pack *pack);

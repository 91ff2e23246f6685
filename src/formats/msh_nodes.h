//: Declare the nodes of Gmsh
#pragma once

#include "formats/mesh_file.h"

/// A node of Gmsh, which calls it by a tag.
typedef struct tf_msh_node {
    int tag, vertex;
} tf_msh_node;

/// The nodes of a file.  All zero: there are none.
typedef struct tf_msh_nodes {
    tf_ints tag;       ///< in the order of the file
    tf_msh_node *node; ///< by tags; NULL: the tags are consecutive
} tf_msh_nodes;

/// Orders all nodes by their tags.  False: there is no memory, or two have the
/// tag `*twice` (else 0).
bool tf_msh_nodes_order(tf_msh_nodes *nodes, int *twice);

/// The vertex that a tag means, or -1.
int tf_msh_nodes_find(const tf_msh_nodes *nodes, int tag);

void tf_msh_nodes_free(tf_msh_nodes *nodes);

//: Declare joined meshes
#pragma once

#include "base/error.h"
#include "formats/mesh_file.h"

/// Several meshes as one: the vertices, triangles and edges of each follow those
/// of the meshes before it.  All zero: there are none.
typedef struct tf_joined {
    int meshes;
    int *first_vertex, *first_triangle, *first_edge; ///< of each mesh, and at
                                                     ///< the end how many all
                                                     ///< have
} tf_joined;

/// Joins meshes.  False: there is a fault of one of them, for example an index
/// of no vertex of its own.  Free it in any case.
bool tf_joined_make(tf_joined *joined, int meshes,
                    const tf_mesh_file *const file[]);
void tf_joined_free(tf_joined *joined);

/// How many vertices all meshes have.
int tf_joined_vertices(const tf_joined *joined);

//: Declare how joined meshes are told apart
/// The mesh of a joined vertex.
int tf_joined_mesh(const tf_joined *joined, int vertex);

/// Replaces joined vertices, of two elements of which the first has `first`, by
/// the numbers that they have in their meshes; below 0 there is none.
/// @param[out] mesh those of the two elements; the same if there is one only
void tf_joined_localize(const tf_joined *joined, int count, int vertex[],
                        int first, int mesh[2]);

/// The same with what an error is about.
void tf_joined_localize_error(const tf_joined *joined, tf_error *error,
                              int mesh[2]);

//: Declare how to list the elements of joined meshes
/// All elements, with joined indices.  The lists are to be freed.  False: there
/// is no memory.
bool tf_joined_elements(const tf_joined *joined,
                        const tf_mesh_file *const file[], int **triangle,
                        int **edge);

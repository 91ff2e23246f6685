//: Declare how faces are carried over
#pragma once

#include "files/kept_edges.h"
#include "formats/face_attributes.h"
#include "surgery/adaptive.h"

/// What the faces of a file have, and what those of its remeshed surface have
/// then.  All zero: nothing yet.
typedef struct tf_carried_faces {
    tf_face_attributes from; ///< read with the file
    int *face;               ///< of each triangle of the file
    int *texture;            ///< of each corner of these: a row, or -1
    tf_face_attributes made;
    int *triangle; ///< the remeshed ones, three vertices each, those of a
                   ///< heading one after the other
} tf_carried_faces;

/// Adds the borders to kept edges: the edges between faces that differ in what
/// they have, or in texture coordinates at an end.  False: there is a fault.
/// @param file with triangles that agree at edges; those of more than two are not
///     looked at
bool tf_carried_faces_begin(tf_carried_faces *carried, const tf_mesh_file *file,
                            tf_kept_edges *kept);

/// Makes what the faces have of the surface after it was remeshed.  False: there
/// is a fault.
bool tf_carried_faces_make(tf_carried_faces *carried, const tf_mesh_file *file,
                           const tf_adaptive_surface *surface);

void tf_carried_faces_free(tf_carried_faces *carried);

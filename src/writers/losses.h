//: Declare what is lost
#pragma once

#include "writers/mesh_content.h"

enum {
    TF_LOSSES_ROOM = 400
};

/// Names what is not kept of a file: "comments, groups and normals", or "" if all
/// is.
typedef struct tf_losses {
    char text[TF_LOSSES_ROOM];
} tf_losses;

/// What a mesh written in a format does not keep of the file that it was read
/// from, which has a source.
/// @param keeps_faces whether it has what the faces had: see tf_face_attributes
tf_losses tf_find_losses(const tf_mesh_file *file, tf_mesh_format format,
                         bool keeps_faces);

/// How many coordinates of a mesh are no floats.
size_t tf_count_rounded(const double position[], size_t coordinates);

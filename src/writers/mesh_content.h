//: Declare the content of a mesh
#pragma once

#include "formats/face_attributes.h"

/// What is written of a mesh.
typedef struct tf_mesh_content {
    tf_mesh mesh;              ///< the elements; in the plane z is 0
    const double *position;    ///< of each vertex
    const double *velocity;    ///< the properties vx, vy and vz of PLY; or NULL
    const char *comment;       ///< a line of the header of PLY; or NULL
    const char *notes;         ///< more such lines; or NULL
    const tf_columns *columns; ///< what else each vertex has, in space; or
                               ///< NULL.  OBJ has red, green and blue alone
    const tf_face_attributes *faces; ///< what each face has in this format, of
                                     ///< OBJ or PLY; or NULL
    const tf_mesh_file *from;   ///< the file that has the same elements, and
                                ///< polygons or a source perhaps; or NULL
    const tf_mesh_file *joined; ///< the file of which vertices were joined, if
                                ///< its source can be written; or NULL
    const int *number;          ///< of each of its vertices here, or -1
} tf_mesh_content;

/// How many faces a content has: polygons, and triangles that are of none.
int tf_mesh_content_faces(const tf_mesh_content *content);

/// Steps to the next face, as tf_mesh_file_next_face.
bool tf_mesh_content_next_face(const tf_mesh_content *content, tf_face *face);

/// The color of a vertex, from 0 to 1, those of columns of small integers as
/// parts of the greatest.  False: it has none.
bool tf_mesh_content_color(const tf_mesh_content *content, int vertex,
                           double color[3]);

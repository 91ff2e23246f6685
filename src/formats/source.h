//: Declare the source of a mesh
#pragma once

#include "formats/columns.h"

#include <stddef.h>

/// Where the coordinates of a vertex, or of a corner, are in a file: the byte at
/// which each begins.  One that is not there begins behind the one before it, at
/// something that is no number.
typedef struct tf_source_point {
    size_t at[3];
    int vertex;
} tf_source_point;

/// What a part of a file is: all of a vertex, of a face or of edges; in OBJ, of
/// points; an index of a vertex in what came last; or how many of them PLY
/// declares.
typedef enum tf_part_kind {
    TF_VERTEX_PART = 0,
    TF_FACE_PART,
    TF_EDGE_PART,
    TF_POINT_PART,
    TF_CORNER_PART,
    TF_VERTEX_COUNT_PART,
    TF_FACE_COUNT_PART,
    TF_EDGE_COUNT_PART,
} tf_part_kind;

/// A part of a file.
typedef struct tf_source_part {
    size_t at, length; ///< its bytes; with the end of its lines, if it is whole
    tf_part_kind kind;
    int vertex; ///< of a corner
} tf_source_part;

/// See formats/face_attributes.h.
typedef struct tf_face_attributes tf_face_attributes;

/// A file as it was read, so that it can be written again with other
/// coordinates.  All zero: there is none.
typedef struct tf_source {
    char *text; ///< all bytes, decompressed; a zero follows them
    size_t size;
    tf_source_point *point; ///< in the order of the file
    size_t points, room;
    /// To be set first: whether OBJ and PLY keep their parts, too, so that their
    /// vertices can be numbered anew.  It is not set any more when others refer
    /// to vertices than vertices, triangles, polygons, edges and points.
    bool keeps_parts;
    /// To be set first: for what the faces of OBJ and PLY have; borrowed; NULL:
    /// that is skipped.
    tf_face_attributes *faces;
    tf_source_part *part; ///< in the order of the file
    size_t parts, part_room;
    bool is_big_endian; ///< in binary
    bool welds; ///< vertices were made of corners, where -0 and 0 are the same
    tf_number_type type[3]; ///< of x, y and z, in PLY and in binary
    /// Where PLY declares these types, in so many bytes; 0: nowhere.
    size_t word[3], word_length[3];
    bool lacks_z; ///< PLY declares no z
    size_t y_end; ///< where the name of y ends in the header
} tf_source;

/// Adds a point.  False: there is no memory.
bool tf_source_add(tf_source *source, const tf_source_point *point);

/// Adds a part.  False: there is no memory.
bool tf_source_add_part(tf_source *source, const tf_source_part *part);

/// Frees what a source holds, and makes it empty.
void tf_source_free(tf_source *source);

//: Declare what faces have
#pragma once

#include "formats/mesh_file.h"

/// A part of a text.
typedef struct tf_excerpt {
    size_t at, length; ///< in bytes
} tf_excerpt;

typedef struct tf_excerpts {
    tf_excerpt *item;
    size_t count, room;
} tf_excerpts;

/// The lines of OBJ that say what the faces after them belong to.
typedef enum tf_heading_line {
    TF_OBJECT_LINE = 0, ///< o
    TF_GROUP_LINE,      ///< g
    TF_MATERIAL_LINE,   ///< usemtl
    TF_HEADING_LINES
} tf_heading_line;

/// What the faces of a mesh have besides their corners.  All zero: nothing.
struct tf_face_attributes {
    const char *text;    ///< of the file, to which excerpts refer; borrowed
    tf_excerpts library; ///< of OBJ, the lines that name files of materials
    tf_excerpts heading; ///< of OBJ: TF_HEADING_LINES each, without the ends of
                         ///< lines; the length 0: there is no such line
    tf_columns row;      ///< of each face: its properties in PLY that are
                         ///< integers; in OBJ one number, of its heading
    tf_columns texture;  ///< three texture coordinates a row; none in PLY
    int texture_axes;    ///< how many of them are there
    tf_ints corner;      ///< of each corner of each face the row of its texture
                         ///< coordinates, or -1; empty if there are none
};

/// Whether two faces have the same row.
bool tf_face_attributes_agree(const tf_face_attributes *faces, int face,
                              int other);

/// Appends an excerpt.  False: there is no memory.
bool tf_excerpts_add(tf_excerpts *list, const tf_excerpt *excerpt);

void tf_face_attributes_free(tf_face_attributes *faces);

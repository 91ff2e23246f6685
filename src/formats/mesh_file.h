//: Declare mesh files
#pragma once

#include "files/fault.h"
#include "formats/columns.h"
#include "formats/source.h"
#include "surface/mesh.h"

#include <stddef.h>

//: Declare what a mesh file holds
/// A list of integers or coordinates that grows.
typedef struct tf_ints {
    int *item;
    size_t count, room;
} tf_ints;

typedef struct tf_doubles {
    double *item;
    size_t count, room;
} tf_doubles;

/// Appends integers.  False: there is no memory.
bool tf_ints_add(tf_ints *list, size_t count, const int item[]);

typedef enum tf_mesh_format {
    TF_OBJ = 0,
    TF_PLY_TEXT,
    TF_PLY_LITTLE_ENDIAN,
    TF_PLY_BIG_ENDIAN,
    TF_STL_TEXT,
    TF_STL_BINARY,
    TF_OFF,
    TF_MSH,
    TF_VTP, ///< written only
} tf_mesh_format;

/// The contents of a mesh file.  All indices are 0-based, and may still name no
/// vertex.  A polygon is a face with more than three corners; its triangles,
/// two fewer than it has corners, are where the face is among all others.
typedef struct tf_mesh_file {
    const char *name;    ///< of the file, for messages; borrowed
    tf_fault *fault;     ///< to be set
    tf_columns *columns; ///< borrowed, for what else the vertices have; NULL:
                         ///< that is skipped
    tf_source *source;   ///< borrowed, for the file itself; NULL: that is not
                         ///< kept
    tf_mesh_format format;
    int first_index;     ///< what the file calls the first vertex: 0 or 1
    tf_doubles position; ///< three coordinates a vertex, z = 0 if none is given
    tf_ints triangle;    ///< three indices each; those of polygons are right
                         ///< when these are divided
    tf_ints edge;        ///< two indices each
    tf_ints polygon;     ///< two numbers each: its first triangle, and its
                         ///< first corner
    tf_ints corner;      ///< the indices of all corners of polygons
    bool counts_bytes;   ///< places are bytes, not lines
    /// Where each item is in the file: a line from 1, or a byte from 0; below 0
    /// where that is no int.
    tf_ints vertex_place, triangle_place, edge_place;
    long flat_place; ///< that of the first vertex without z; 0: there is none
    int left_out[4]; ///< elements by their dimensions; triangles without area
} tf_mesh_file;

//: Declare how to look at a mesh
/// Frees what a file holds, and makes it empty.
void tf_mesh_file_free(tf_mesh_file *file);

/// How many vertices, triangles and edges a file has.
int tf_mesh_file_vertices(const tf_mesh_file *file);
int tf_mesh_file_triangles(const tf_mesh_file *file);
int tf_mesh_file_edges(const tf_mesh_file *file);

/// How many of its faces are polygons.
int tf_mesh_file_polygons(const tf_mesh_file *file);

/// Whether a file holds a curve of the plane: no triangles, and z = 0
/// throughout.
bool tf_mesh_file_is_flat(const tf_mesh_file *file);

/// The elements of a file, which lends them.
tf_mesh tf_mesh_file_elements(const tf_mesh_file *file, int axes);

//: Declare how to go through the faces
/// A face of a file.  All zero: there is none yet.
typedef struct tf_face {
    const int *corner; ///< the indices of its corners, as in the file
    int corners;       ///< how many
    int triangle;      ///< the first of its corners - 2 triangles
    int polygon;       ///< how many polygons come before it
} tf_face;

/// Steps to the next face in the order of the file, from none to the first one;
/// false after the last.
bool tf_mesh_file_next_face(const tf_mesh_file *file, tf_face *face);

//: Declare the faults of a mesh file
/// Sets a fault at a place, below 0 of the whole file, as printf; false, for the
/// caller to return.
__attribute__((format(printf, 3, 4))) bool
tf_mesh_file_fault(const tf_mesh_file *file, long place, const char *format,
                   ...);

/// Sets a fault if so many corners are too few for a face.
bool tf_mesh_file_check_corners(const tf_mesh_file *file, int corners,
                                long place);

/// Sets the fault that there is no memory; false.
bool tf_mesh_file_fault_in_memory(const tf_mesh_file *file);

//: Declare how to add to a mesh
/// How many parts the source has; and ends the one that was added after so
/// many, if there is one.
size_t tf_mesh_file_parts(const tf_mesh_file *file);
void tf_mesh_file_end_part(const tf_mesh_file *file, size_t part,
                           const char *start, const char *end);

/// Lets the source keep no parts: something in it is of no kind that has parts.
void tf_mesh_file_drop_parts(tf_mesh_file *file);

/// Each adds an item, and sets a fault and returns false if there is no memory
/// or there are too many.  A face has three corners or more.
bool tf_mesh_file_add_vertex(tf_mesh_file *file, const double x[3], long place);
bool tf_mesh_file_add_row(tf_mesh_file *file, const double value[]);
/// Of the source, if that is kept; the text begins at `start`.
bool tf_mesh_file_add_point(tf_mesh_file *file, int vertex, const char *start,
                            const char *const at[3]);
/// Of the source, if that keeps parts: what is from `at` to `end`.
bool tf_mesh_file_add_part(tf_mesh_file *file, tf_part_kind kind, int vertex,
                           const char *start, const char *at, const char *end);
bool tf_mesh_file_add_triangle(tf_mesh_file *file, const int vertex[3],
                               long place);
bool tf_mesh_file_add_face(tf_mesh_file *file, const int corner[], int corners,
                           long place);
bool tf_mesh_file_add_edge(tf_mesh_file *file, const int vertex[2], long place);

//: Declare how to divide polygons
/// Divides all polygons, when all vertices are known; see tf_polygon_divide.
/// It is a fault if one has a corner that is no vertex, or one twice that is not
/// at a slit.
bool tf_mesh_file_divide(tf_mesh_file *file);

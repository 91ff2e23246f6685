//: Include what writing PLY needs
#include "writers/ply_writer.h"

#include "writers/encoder.h"

#include <string.h>

//: Write the properties of PLY
static const char *const encodings[] = {
    [TF_PLY_TEXT] = "ascii",
    [TF_PLY_LITTLE_ENDIAN] = "binary_little_endian",
    [TF_PLY_BIG_ENDIAN] = "binary_big_endian",
};

static const char *const type_names[] = {
    [TF_CHAR] = "char",     [TF_UCHAR] = "uchar",  [TF_SHORT] = "short",
    [TF_USHORT] = "ushort", [TF_INT] = "int",      [TF_UINT] = "uint",
    [TF_FLOAT] = "float",   [TF_DOUBLE] = "double"};

/// Those of the columns that follow so many coordinates.
static void write_column_names(FILE *stream, const tf_columns *columns,
                               int after)
{
    for (int i = 0; columns && i < columns->count; i++)
        if (columns->column[i].after == after)
            fprintf(stream, "property %s %s\n",
                    type_names[columns->column[i].type],
                    columns->column[i].name);
}

static void write_properties(FILE *stream, const char *prefix,
                             const tf_columns *columns)
{
    for (int k = 0; k < 3; k++) {
        write_column_names(stream, columns, k);
        fprintf(stream, "property double %s%c\n", prefix, "xyz"[k]);
    }
    write_column_names(stream, columns, 3);
}

/// Behind the corners, whatever they were behind.
static void write_face_properties(FILE *stream, const tf_face_attributes *faces)
{
    for (int k = 0; faces && k <= 3; k++)
        write_column_names(stream, &faces->row, k);
}

//: Choose the type of the lengths of faces
/// What most readers expect, unless a face has more corners.
static tf_number_type length_type(const tf_mesh_content *content)
{
    tf_number_type type = TF_UCHAR;
    for (tf_face face = {0}; tf_mesh_content_next_face(content, &face);)
        if (face.corners > 255)
            type = TF_INT;
    return type;
}

//: Write the header of PLY
/// A comment for each line of a text, which may be NULL.
static void write_comments(FILE *stream, const char *text)
{
    while (text) {
        int length = (int)strcspn(text, "\n");
        fprintf(stream, "comment %.*s\n", length, text);
        text = text[length] ? text + length + 1 : NULL;
    }
}

static void write_ply_header(FILE *stream, const tf_mesh_content *content,
                             tf_mesh_format format)
{
    const tf_mesh *mesh = &content->mesh;
    fprintf(stream, "ply\nformat %s 1.0\n", encodings[format]);
    write_comments(stream, content->comment);
    write_comments(stream, content->notes);
    fprintf(stream, "element vertex %d\n", mesh->vertices);
    write_properties(stream, "", content->columns);
    if (content->velocity)
        write_properties(stream, "v", NULL);
    if (mesh->triangles > 0) {
        fprintf(
            stream, "element face %d\nproperty list %s int vertex_indices\n",
            tf_mesh_content_faces(content), type_names[length_type(content)]);
        write_face_properties(stream, content->faces);
    }
    if (mesh->edges > 0)
        fprintf(stream,
                "element edge %d\nproperty int vertex1\nproperty int vertex2\n",
                mesh->edges);
    fputs("end_header\n", stream);
}

//: Write a row in its order
static void write_row(const tf_encoder *to, const tf_columns *columns,
                      const double x[], int row)
{
    const double *value = tf_columns_row(columns, row);
    for (int k = 0, written = 0; k <= 3; k++) {
        for (int i = 0; i < columns->count; i++) {
            if (columns->column[i].after != k)
                continue;
            if (written++ > 0)
                tf_encode_blank(to);
            tf_encode(to, columns->column[i].type, value[i]);
        }
        if (k < 3 && written++ > 0)
            tf_encode_blank(to);
        if (k < 3)
            tf_encode_double(to, x[k]);
    }
}

//: Write the items of PLY
static void write_vertex(const tf_encoder *to, const tf_mesh_content *content,
                         int vertex)
{
    int axes = content->mesh.axes;
    size_t place = (size_t)axes * (size_t)vertex;
    const double *x = content->position + place;
    if (content->columns)
        write_row(to, content->columns, x, vertex);
    else
        tf_encode_position(to, x, axes);
    if (content->velocity) {
        tf_encode_blank(to);
        tf_encode_position(to, content->velocity + place, axes);
    }
    tf_encode_line_end(to);
}

static void write_indices(const tf_encoder *to, const int index[], int count)
{
    for (int i = 0; i < count; i++) {
        if (i > 0)
            tf_encode_blank(to);
        tf_encode_integer(to, index[i], 4);
    }
}

static void write_edge(const tf_encoder *to, const int vertex[2])
{
    write_indices(to, vertex, 2);
    tf_encode_line_end(to);
}

/// In the order of the header.
static void write_face_row(const tf_encoder *to,
                           const tf_face_attributes *faces, int face)
{
    for (int k = 0; faces && k <= 3; k++)
        for (int i = 0; i < faces->row.count; i++) {
            if (faces->row.column[i].after != k)
                continue;
            tf_encode_blank(to);
            tf_encode(to, faces->row.column[i].type,
                      tf_columns_row(&faces->row, face)[i]);
        }
}

static void write_faces(const tf_encoder *to, const tf_mesh_content *content)
{
    int bytes = tf_number_bytes(length_type(content)), count = 0;
    for (tf_face face = {0}; tf_mesh_content_next_face(content, &face);) {
        tf_encode_integer(to, face.corners, bytes);
        tf_encode_blank(to);
        write_indices(to, face.corner, face.corners);
        write_face_row(to, content->faces, count++);
        tf_encode_line_end(to);
    }
}

//: Write PLY
void tf_ply_write(FILE *stream, const tf_mesh_content *content,
                  tf_mesh_format format)
{
    const tf_mesh *mesh = &content->mesh;
    const tf_encoder to = {stream, format == TF_PLY_TEXT,
                           format == TF_PLY_BIG_ENDIAN};
    write_ply_header(stream, content, format);
    for (int v = 0; v < mesh->vertices; v++)
        write_vertex(&to, content, v);
    write_faces(&to, content);
    for (int e = 0; e < mesh->edges; e++)
        write_edge(&to, mesh->edge + 2 * (size_t)e);
}

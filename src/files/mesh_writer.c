//: Include what writing meshes needs
#define _GNU_SOURCE // strcasecmp
#include "files/mesh_writer.h"

#include <stdint.h>
#include <string.h>

//: Choose the format of a file
static bool ends_in(const char *path, const char *ending)
{
    size_t length = strlen(path), own = strlen(ending);
    return length >= own && strcasecmp(path + length - own, ending) == 0;
}

tf_mesh_format tf_mesh_format_of(const char *path, tf_mesh_format usual)
{
    if (ends_in(path, ".obj"))
        return TF_OBJ;
    if (ends_in(path, ".ply") && usual == TF_OBJ)
        return TF_PLY_LITTLE_ENDIAN;
    return usual;
}

//: Write the header of PLY
static const char *const encodings[] = {
    [TF_PLY_TEXT] = "ascii",
    [TF_PLY_LITTLE_ENDIAN] = "binary_little_endian",
    [TF_PLY_BIG_ENDIAN] = "binary_big_endian",
};

static void write_properties(FILE *stream, const char *prefix)
{
    for (const char *axis = "xyz"; *axis; axis++)
        fprintf(stream, "property double %s%c\n", prefix, *axis);
}

static void write_ply_header(FILE *stream, const tf_mesh_content *content,
                             tf_mesh_format format)
{
    const tf_mesh *mesh = &content->mesh;
    fprintf(stream, "ply\nformat %s 1.0\n", encodings[format]);
    if (content->comment)
        fprintf(stream, "comment %s\n", content->comment);
    fprintf(stream, "element vertex %d\n", mesh->vertices);
    write_properties(stream, "");
    if (content->velocity)
        write_properties(stream, "v");
    if (mesh->triangles > 0)
        fprintf(stream,
                "element face %d\nproperty list uchar int vertex_indices\n",
                mesh->triangles);
    if (mesh->edges > 0)
        fprintf(stream,
                "element edge %d\nproperty int vertex1\nproperty int vertex2\n",
                mesh->edges);
    fputs("end_header\n", stream);
}

//: Write numbers in an encoding
/// How numbers are written.
typedef struct encoder {
    FILE *stream;
    tf_mesh_format format;
} encoder;

static void write_bytes(const encoder *to, uint64_t bits, int count)
{
    bool big = to->format == TF_PLY_BIG_ENDIAN;
    for (int i = 0; i < count; i++) {
        int place = big ? count - 1 - i : i;
        fputc((int)(bits >> 8 * place & 0xff), to->stream);
    }
}

static bool is_text(const encoder *to)
{
    return to->format == TF_OBJ || to->format == TF_PLY_TEXT;
}

/// In the plane the third is 0.  17 digits determine a double.
static void write_coordinates(const encoder *to, const double x[], int axes)
{
    for (int k = 0; k < 3; k++) {
        double number = k < axes ? x[k] : 0;
        uint64_t bits;
        memcpy(&bits, &number, sizeof bits);
        if (is_text(to))
            fprintf(to->stream, k > 0 ? " %.17g" : "%.17g", number);
        else
            write_bytes(to, bits, 8);
    }
}

/// OBJ counts from 1.
static void write_indices(const encoder *to, const int index[], int count)
{
    int first = to->format == TF_OBJ;
    for (int i = 0; i < count; i++)
        if (is_text(to))
            fprintf(to->stream, i > 0 ? " %d" : "%d", index[i] + first);
        else
            write_bytes(to, (uint64_t)index[i], 4);
}

//: Write the items of a mesh
/// In OBJ with the word that begins its line.
static void begin_item(const encoder *to, const char *word)
{
    if (to->format == TF_OBJ)
        fputs(word, to->stream);
}

static void end_item(const encoder *to)
{
    if (is_text(to))
        fputc('\n', to->stream);
}

static void write_vertex(const encoder *to, const tf_mesh_content *content,
                         int vertex)
{
    int axes = content->mesh.axes;
    size_t place = (size_t)axes * (size_t)vertex;
    begin_item(to, "v ");
    write_coordinates(to, content->position + place, axes);
    if (content->velocity && to->format != TF_OBJ) {
        fputs(is_text(to) ? " " : "", to->stream);
        write_coordinates(to, content->velocity + place, axes);
    }
    end_item(to);
}

/// PLY has the number of corners first.
static void write_triangle(const encoder *to, const int corner[3])
{
    begin_item(to, "f ");
    if (to->format == TF_PLY_TEXT)
        fputs("3 ", to->stream);
    else if (!is_text(to))
        fputc(3, to->stream);
    write_indices(to, corner, 3);
    end_item(to);
}

static void write_edge(const encoder *to, const int end[2])
{
    begin_item(to, "l ");
    write_indices(to, end, 2);
    end_item(to);
}

//: Write a mesh
void tf_mesh_write(FILE *stream, const tf_mesh_content *content,
                   tf_mesh_format format)
{
    const tf_mesh *mesh = &content->mesh;
    const encoder to = {stream, format};
    if (format != TF_OBJ)
        write_ply_header(stream, content, format);
    for (int v = 0; v < mesh->vertices; v++)
        write_vertex(&to, content, v);
    for (int t = 0; t < mesh->triangles; t++)
        write_triangle(&to, mesh->triangle + 3 * (size_t)t);
    for (int e = 0; e < mesh->edges; e++)
        write_edge(&to, mesh->edge + 2 * (size_t)e);
}

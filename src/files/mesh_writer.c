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

//: Write OBJ
// 17 digits determine a double.
static void write_obj(FILE *stream, const tf_mesh_file *mesh)
{
    const double *x = mesh->position.item;
    const int *corner = mesh->triangle.item, *edge = mesh->edge.item;
    for (int v = 0; v < tf_mesh_file_vertices(mesh); v++, x += 3)
        fprintf(stream, "v %.17g %.17g %.17g\n", x[0], x[1], x[2]);
    for (int t = 0; t < tf_mesh_file_triangles(mesh); t++, corner += 3)
        fprintf(stream, "f %d %d %d\n", corner[0] + 1, corner[1] + 1,
                corner[2] + 1);
    for (int e = 0; e < tf_mesh_file_edges(mesh); e++, edge += 2)
        fprintf(stream, "l %d %d\n", edge[0] + 1, edge[1] + 1);
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

static void write_ply_header(FILE *stream, const tf_mesh_file *mesh,
                             tf_mesh_format format, const tf_mesh_state *state)
{
    fprintf(stream, "ply\nformat %s 1.0\n", encodings[format]);
    if (state)
        fprintf(stream, "comment %s\n", state->comment);
    fprintf(stream, "element vertex %d\n", tf_mesh_file_vertices(mesh));
    write_properties(stream, "");
    if (state && state->velocity)
        write_properties(stream, "v");
    if (tf_mesh_file_triangles(mesh) > 0)
        fprintf(stream,
                "element face %d\nproperty list uchar int vertex_indices\n",
                tf_mesh_file_triangles(mesh));
    if (tf_mesh_file_edges(mesh) > 0)
        fprintf(stream,
                "element edge %d\nproperty int vertex1\nproperty int vertex2\n",
                tf_mesh_file_edges(mesh));
    fputs("end_header\n", stream);
}

//: Write what follows the header of PLY as text
static void write_ply_text(FILE *stream, const tf_mesh_file *mesh)
{
    const double *x = mesh->position.item;
    const int *corner = mesh->triangle.item, *edge = mesh->edge.item;
    for (int v = 0; v < tf_mesh_file_vertices(mesh); v++, x += 3)
        fprintf(stream, "%.17g %.17g %.17g\n", x[0], x[1], x[2]);
    for (int t = 0; t < tf_mesh_file_triangles(mesh); t++, corner += 3)
        fprintf(stream, "3 %d %d %d\n", corner[0], corner[1], corner[2]);
    for (int e = 0; e < tf_mesh_file_edges(mesh); e++, edge += 2)
        fprintf(stream, "%d %d\n", edge[0], edge[1]);
}

//: Write what follows the header of PLY in binary
typedef struct bytes {
    FILE *stream;
    bool big_endian;
} bytes;

static void write_bytes(const bytes *to, uint64_t bits, int count)
{
    for (int i = 0; i < count; i++) {
        int place = to->big_endian ? count - 1 - i : i;
        fputc((int)(bits >> 8 * place & 0xff), to->stream);
    }
}

static void write_doubles(const bytes *to, const double x[], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        uint64_t bits;
        memcpy(&bits, &x[i], sizeof bits);
        write_bytes(to, bits, 8);
    }
}

static void write_indices(const bytes *to, const int index[], int count)
{
    for (int i = 0; i < count; i++)
        write_bytes(to, (uint64_t)index[i], 4);
}

static void write_vertices(const bytes *to, const tf_mesh_file *mesh,
                           const tf_mesh_state *state)
{
    for (size_t i = 0; i < mesh->position.count; i += 3) {
        write_doubles(to, mesh->position.item + i, 3);
        if (state && state->velocity)
            write_doubles(to, state->velocity + i, 3);
    }
}

static void write_elements(const bytes *to, const tf_mesh_file *mesh)
{
    const int *corner = mesh->triangle.item, *edge = mesh->edge.item;
    for (int t = 0; t < tf_mesh_file_triangles(mesh); t++, corner += 3) {
        write_bytes(to, 3, 1);
        write_indices(to, corner, 3);
    }
    for (int e = 0; e < tf_mesh_file_edges(mesh); e++, edge += 2)
        write_indices(to, edge, 2);
}

//: Write a mesh
void tf_mesh_write(FILE *stream, const tf_mesh_file *mesh,
                   tf_mesh_format format)
{
    if (format == TF_OBJ) {
        write_obj(stream, mesh);
        return;
    }
    write_ply_header(stream, mesh, format, NULL);
    bytes to = {stream, format == TF_PLY_BIG_ENDIAN};
    if (format == TF_PLY_TEXT) {
        write_ply_text(stream, mesh);
        return;
    }
    write_vertices(&to, mesh, NULL);
    write_elements(&to, mesh);
}

//: Write a mesh that moves
void tf_mesh_write_state(FILE *stream, const tf_mesh_file *mesh,
                         const tf_mesh_state *state)
{
    bytes to = {stream, false};
    write_ply_header(stream, mesh, TF_PLY_LITTLE_ENDIAN, state);
    write_vertices(&to, mesh, state);
    write_elements(&to, mesh);
}

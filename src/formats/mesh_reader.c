//: Include what reading meshes needs
#include "formats/mesh_reader.h"

#include "formats/obj_file.h"
#include "formats/ply_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

//: Check the whole of a file
static bool check_whole(const tf_mesh_file *file)
{
    if (tf_mesh_file_vertices(file) == 0)
        return tf_mesh_file_fault(
            file, -1, "no vertices; the file must be a mesh in OBJ or PLY");
    if (tf_mesh_file_triangles(file) + tf_mesh_file_edges(file) == 0)
        return tf_mesh_file_fault(
            file, -1, "no triangles and no edges; a mesh must have some");
    if (file->flat_place > 0 && tf_mesh_file_triangles(file) > 0)
        return tf_mesh_file_fault(file, file->flat_place,
                                  "a vertex without z; the vertices of "
                                  "triangles must have three coordinates");
    return true;
}

//: Read all bytes
typedef struct bytes {
    char *item;
    size_t count, room;
} bytes;

static bool make_room(bytes *text)
{
    size_t room = 2 * text->room + (1 << 17);
    char *moved = realloc(text->item, room);
    if (moved)
        *text = (bytes){moved, text->count, room};
    return moved;
}

/// Whether the last bytes show that no more need be read, for the text is none.
static bool is_hopeless(const bytes *text, size_t last)
{
    return !tf_is_ply(text->item, text->count) &&
           memchr(text->item + text->count - last, '\0', last);
}

static bool read_all(FILE *stream, bytes *text)
{
    size_t got, wanted;
    do {
        if (!make_room(text))
            return false;
        wanted = text->room - text->count - 1;
        got = fread(text->item + text->count, 1, wanted, stream);
        text->count += got;
    } while (got == wanted && !is_hopeless(text, got));
    text->item[text->count] = '\0';
    return true;
}

//: Read a mesh file
bool tf_mesh_file_parse(tf_mesh_file *file, const char *name, const char *text,
                        size_t size, tf_columns *columns, tf_fault *fault)
{
    *file = (tf_mesh_file){.name = name, .columns = columns, .fault = fault};
    bool good = tf_is_ply(text, size) ? tf_ply_parse(file, text, size)
                                      : tf_obj_parse(file, text, size);
    return good && check_whole(file) && tf_mesh_file_divide(file);
}

static bool read_stream(tf_mesh_file *file, FILE *stream)
{
    bytes text = {0};
    errno = 0;
    bool good =
        !read_all(stream, &text) ? tf_mesh_file_fault_in_memory(file)
        : ferror(stream)
            ? tf_fault_set_unread(file->fault, file->name, -1, errno)
            : tf_mesh_file_parse(file, file->name, text.item, text.count,
                                 file->columns, file->fault);
    free(text.item);
    return good;
}

bool tf_mesh_file_read(tf_mesh_file *file, const char *path,
                       tf_columns *columns, tf_fault *fault)
{
    bool standard = strcmp(path, "-") == 0;
    FILE *stream = standard ? stdin : fopen(path, "rb");
    *file = (tf_mesh_file){.name = standard ? "standard input" : path,
                           .columns = columns,
                           .fault = fault};
    if (!stream)
        return tf_fault_set_unopened(fault, path, errno);
    bool good = read_stream(file, stream);
    if (!standard)
        fclose(stream);
    return good;
}

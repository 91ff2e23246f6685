//: Include what mesh files need
#define _GNU_SOURCE
#include "files/mesh_file.h"

#include "files/obj_file.h"
#include "files/ply_file.h"

#include <errno.h>
#include <limits.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

//: Describe what is wrong with a mesh file
bool tf_mesh_file_fault(tf_mesh_file *file, long place, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(file->fault, sizeof file->fault, format, arguments);
    va_end(arguments);
    file->fault_place = place;
    return false;
}

void tf_mesh_file_print_fault(const tf_mesh_file *file, const char *program)
{
    fprintf(stderr, "%s: %s:", program, tf_make_visible(file->name).text);
    if (file->fault_place >= 0)
        fprintf(stderr,
                file->counts_bytes ? " byte %ld:" : "%ld:", file->fault_place);
    fprintf(stderr, " %s\n", file->fault);
}

//: Describe what is wrong with a word
bool tf_mesh_file_fault_in_word(tf_mesh_file *file, long place,
                                const char *word, const char *verdict)
{
    size_t length = strcspn(word, " \t\r\n");
    if (length == 0)
        return tf_mesh_file_fault(file, place,
                                  "a NUL byte; the file must be plain text "
                                  "(ASCII or UTF-8, not UTF-16) or binary PLY");
    return tf_mesh_file_fault(file, place, "\"%s\" is %s",
                              tf_quote(word, length).text, verdict);
}

//: Make room in a list
/// Room for `more` items of `size` bytes; the list, moved, or NULL.
static void *extend(void *item, size_t count, size_t *room, size_t more,
                    size_t size)
{
    if (count + more <= *room)
        return item;
    size_t wanted = 2 * (count + more);
    void *moved =
        wanted > SIZE_MAX / size ? NULL : realloc(item, wanted * size);
    if (moved)
        *room = wanted;
    return moved;
}

static bool add_ints(tf_ints *list, int count, const int item[])
{
    int *moved = extend(list->item, list->count, &list->room, (size_t)count,
                        sizeof *item);
    if (!moved)
        return false;
    list->item = moved;
    memcpy(moved + list->count, item, sizeof *item * (size_t)count);
    list->count += (size_t)count;
    return true;
}

static bool add_doubles(tf_doubles *list, int count, const double item[])
{
    double *moved = extend(list->item, list->count, &list->room, (size_t)count,
                           sizeof *item);
    if (!moved)
        return false;
    list->item = moved;
    memcpy(moved + list->count, item, sizeof *item * (size_t)count);
    list->count += (size_t)count;
    return true;
}

//: Add to a mesh
static bool fault_in_memory(tf_mesh_file *file)
{
    return tf_mesh_file_fault(
        file, -1,
        "not enough memory; divide the mesh, or use a machine with more");
}

/// Adds the place of an item, unless there are too many: a surface counts the
/// edges of all triangles by an int.
static bool add_place(tf_mesh_file *file, tf_ints *places, long place)
{
    enum {
        MOST = INT_MAX / 4
    };
    int kept = place > INT_MAX ? -1 : (int)place;
    if (places->count == MOST)
        return tf_mesh_file_fault(
            file, place,
            "more than %d vertices, triangles or edges; divide the mesh", MOST);
    return add_ints(places, 1, &kept) || fault_in_memory(file);
}

bool tf_mesh_file_add_vertex(tf_mesh_file *file, const double x[3], long place)
{
    return add_place(file, &file->vertex_place, place) &&
           (add_doubles(&file->position, 3, x) || fault_in_memory(file));
}

bool tf_mesh_file_add_triangle(tf_mesh_file *file, const int vertex[3],
                               long place)
{
    return add_place(file, &file->triangle_place, place) &&
           (add_ints(&file->triangle, 3, vertex) || fault_in_memory(file));
}

bool tf_mesh_file_add_edge(tf_mesh_file *file, const int vertex[2], long place)
{
    return add_place(file, &file->edge_place, place) &&
           (add_ints(&file->edge, 2, vertex) || fault_in_memory(file));
}

//: Count what a file holds
int tf_mesh_file_vertices(const tf_mesh_file *file)
{
    return (int)file->vertex_place.count;
}

int tf_mesh_file_triangles(const tf_mesh_file *file)
{
    return (int)file->triangle_place.count;
}

int tf_mesh_file_edges(const tf_mesh_file *file)
{
    return (int)file->edge_place.count;
}

bool tf_mesh_file_is_flat(const tf_mesh_file *file)
{
    bool flat = tf_mesh_file_triangles(file) == 0;
    for (size_t i = 2; i < file->position.count && flat; i += 3)
        flat = file->position.item[i] == 0;
    return flat;
}

//: Check the whole of a file
static bool check_whole(tf_mesh_file *file)
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
        char *moved = extend(text->item, text->count, &text->room, 1 << 16, 1);
        if (!moved)
            return false;
        text->item = moved;
        wanted = text->room - text->count - 1;
        got = fread(moved + text->count, 1, wanted, stream);
        text->count += got;
    } while (got == wanted && !is_hopeless(text, got));
    text->item[text->count] = '\0';
    return true;
}

//: Read a mesh file
bool tf_mesh_file_parse(tf_mesh_file *file, const char *name, const char *text,
                        size_t size)
{
    *file = (tf_mesh_file){.name = name};
    bool good = tf_is_ply(text, size) ? tf_ply_parse(file, text, size)
                                      : tf_obj_parse(file, text, size);
    return good && check_whole(file);
}

static bool read_stream(tf_mesh_file *file, const char *name, FILE *stream)
{
    bytes text = {0};
    *file = (tf_mesh_file){.name = name};
    errno = 0;
    bool good =
        !read_all(stream, &text) ? fault_in_memory(file)
        : ferror(stream)
            ? tf_mesh_file_fault(file, -1,
                                 "cannot read: %s; check that this is a file",
                                 strerror(errno))
            : tf_mesh_file_parse(file, name, text.item, text.count);
    free(text.item);
    return good;
}

bool tf_mesh_file_read(tf_mesh_file *file, const char *path)
{
    if (strcmp(path, "-") == 0)
        return read_stream(file, "standard input", stdin);
    *file = (tf_mesh_file){.name = path};
    FILE *stream = fopen(path, "rb");
    if (!stream)
        return tf_mesh_file_fault(file, -1, "cannot open: %s; check the name",
                                  strerror(errno));
    bool good = read_stream(file, path, stream);
    fclose(stream);
    return good;
}

//: Free a mesh file
void tf_mesh_file_free(tf_mesh_file *file)
{
    free(file->position.item);
    free(file->triangle.item);
    free(file->edge.item);
    free(file->vertex_place.item);
    free(file->triangle_place.item);
    free(file->edge_place.item);
    *file = (tf_mesh_file){0};
}

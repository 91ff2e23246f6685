//: Include what reading meshes needs
#define _GNU_SOURCE // memmem
#include "formats/mesh_reader.h"

#include "formats/face_attributes.h"
#include "formats/file_bytes.h"
#include "formats/foreign.h"
#include "formats/msh_file.h"
#include "formats/obj_file.h"
#include "formats/off_file.h"
#include "formats/ply_file.h"
#include "formats/stl_file.h"
#include "formats/words.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

//: Check the whole of a file
static bool check_whole(const tf_mesh_file *file)
{
    if (tf_mesh_file_vertices(file) == 0)
        return tf_mesh_file_fault(
            file, -1, "no vertices; %s",
            file->format == TF_MSH
                ? "mesh the geometry first, for instance by gmsh -2"
                : "the file must be a mesh in OBJ, PLY, STL, OFF or .msh");
    if (tf_mesh_file_triangles(file) + tf_mesh_file_edges(file) == 0)
        return tf_mesh_file_fault(
            file, -1, "no triangles and no edges; a mesh must have some");
    if (file->flat_place > 0 && tf_mesh_file_triangles(file) > 0)
        return tf_mesh_file_fault(file, file->flat_place,
                                  "a vertex without z; the vertices of "
                                  "triangles must have three coordinates");
    return true;
}

//: Choose a reader
typedef bool parser(tf_mesh_file *file, const char *text, size_t size);

/// Whether a name ends in this, perhaps with .gz behind it.
static bool is_named(const char *name, const char *ending)
{
    size_t length = strlen(name), own = strlen(ending);
    if (length > 3 && strcasecmp(name + length - 3, ".gz") == 0)
        length -= 3;
    return length > own && strncasecmp(name + length - own, ending, own) == 0;
}

static bool parse_foreign(tf_mesh_file *file, const char *text, size_t size)
{
    const tf_foreign *is = tf_foreign_find(text, size);
    return tf_mesh_file_fault(file, -1, "this is %s; %s", is->name, is->mend);
}

/// Binary STL of which a part is missing, for instance.
static bool is_damaged_stl(const tf_mesh_file *file, const char *text,
                           size_t size)
{
    return memchr(text, '\0', size) &&
           (is_named(file->name, ".stl") || tf_is_text_stl(text, size));
}

static bool is_nameless_off(const tf_mesh_file *file, const char *text,
                            size_t size)
{
    return is_named(file->name, ".off") && tf_is_nameless_off(text, size);
}

/// By the content, and by the name where that does not tell.
static parser *choose_parser(const tf_mesh_file *file, const char *text,
                             size_t size)
{
    return tf_is_ply(text, size)               ? tf_ply_parse
           : tf_is_binary_stl(text, size)      ? tf_binary_stl_parse
           : tf_foreign_find(text, size)       ? parse_foreign
           : tf_is_msh(text, size)             ? tf_msh_parse
           : tf_is_off(text, size)             ? tf_off_parse
           : is_damaged_stl(file, text, size)  ? tf_binary_stl_parse
           : is_nameless_off(file, text, size) ? tf_off_parse
           : tf_is_text_stl(text, size)        ? tf_text_stl_parse
                                               : tf_obj_parse;
}

//: Read the lines of old Macs
/// How many bytes are text, from the first one on: the header of PLY alone if it
/// declares another format.
static size_t count_text(const char *text, size_t size)
{
    const char *end = tf_is_ply(text, size) ? strstr(text, "end_header") : NULL;
    if (!end)
        return memchr(text, '\0', size) ? 0 : size;
    size_t header = (size_t)(end - text);
    bool is_text = memmem(text, header, "\nformat ascii", 13) ||
                   memmem(text, header, "\rformat ascii", 13);
    return is_text ? size : header + sizeof "end_header";
}

/// The next carriage return that alone ends a line; NULL: there is none.
static char *find_old_end(char *at, const char *end)
{
    while (at < end && (at = memchr(at, '\r', (size_t)(end - at))) != NULL &&
           at[1] == '\n')
        at++;
    return at < end ? at : NULL;
}

/// Ends these lines by line feeds.
static void mend_line_ends(char *text, size_t size)
{
    char *end = text + count_text(text, size), *at = text;
    while ((at = find_old_end(at, end)) != NULL)
        *at = '\n';
}

//: Parse a mesh file
static bool parse(tf_mesh_file *file, char *text, size_t size)
{
    mend_line_ends(text, size);
    if (size == 0)
        return tf_mesh_file_fault(file, -1,
                                  "the file is empty; export it again");
    return choose_parser(file, text, size)(file, text, size) &&
           check_whole(file) && tf_mesh_file_divide(file);
}

bool tf_mesh_file_parse(tf_mesh_file *file, const char *name, char *text,
                        size_t size, tf_columns *columns, tf_fault *fault)
{
    *file = (tf_mesh_file){.name = name, .columns = columns, .fault = fault};
    return parse(file, text, size);
}

//: Keep the bytes of a mesh file
/// Copies them before the ends of lines are mended.
static bool copy_old_lines(const tf_mesh_file *file, char *text, size_t size)
{
    tf_source *source = file->source;
    if (!source || !find_old_end(text, text + count_text(text, size)))
        return true;
    source->text = malloc(size + 1);
    if (!source->text)
        return tf_mesh_file_fault_in_memory(file);
    memcpy(source->text, text, size + 1);
    return true;
}

/// Takes them, unless they were copied.
static void keep_text(tf_source *source, char *text, size_t size)
{
    if (!source || source->text)
        free(text);
    else
        source->text = text;
    if (source)
        source->size = size;
    if (source && source->faces)
        source->faces->text = source->text;
}

bool tf_mesh_file_parse_all(tf_mesh_file *file, const char *name, char *text,
                            size_t size, tf_columns *columns, tf_source *source,
                            tf_fault *fault)
{
    *file = (tf_mesh_file){
        .name = name, .columns = columns, .source = source, .fault = fault};
    bool good = copy_old_lines(file, text, size) && parse(file, text, size);
    keep_text(source, text, size);
    return good;
}

//: Read a mesh file
/// Whether the last bytes show that no more need be read: they are no text, and
/// there are more than a file of STL would have.
static bool is_hopeless(const tf_bytes *bytes, size_t last)
{
    const char *text = bytes->item;
    size_t size = bytes->count;
    return !tf_is_ply(text, size) && !tf_is_msh(text, size) &&
           tf_is_above_binary_stl(text, size) &&
           (tf_foreign_find(text, size) ||
            memchr(text + size - last, '\0', last));
}

bool tf_mesh_file_read_all(tf_mesh_file *file, const char *path,
                           tf_columns *columns, tf_source *source,
                           tf_fault *fault)
{
    const char *name = strcmp(path, "-") == 0 ? "standard input" : path;
    tf_bytes bytes = {0};
    *file = (tf_mesh_file){.name = name, .columns = columns, .fault = fault};
    if (tf_bytes_read(&bytes, path, name, is_hopeless, fault))
        return tf_mesh_file_parse_all(file, name, bytes.item, bytes.count,
                                      columns, source, fault);
    tf_bytes_free(&bytes);
    return false;
}

bool tf_mesh_file_read(tf_mesh_file *file, const char *path,
                       tf_columns *columns, tf_fault *fault)
{
    return tf_mesh_file_read_all(file, path, columns, NULL, fault);
}

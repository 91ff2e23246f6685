//: Include what losses need
#define _GNU_SOURCE // memmem
#include "writers/losses.h"

#include "files/text.h"
#include "formats/binary.h"
#include "writers/encoder.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

//: Name what a file may have
typedef enum thing {
    COMMENTS,
    NAMES,
    GROUPS,
    MATERIALS,
    SMOOTHING,
    TEXTURE,
    NORMALS,
    COLORS,
    VERTEX_PROPERTIES,
    FACE_PROPERTIES,
    EDGE_PROPERTIES,
    ELEMENTS,
    LINES,
    POLYGONS,
    EDGES,
    THINGS,
    NOTHING
} thing;

static const char *const thing_names[THINGS] = {
    [COMMENTS] = "comments",
    [NAMES] = "object names",
    [GROUPS] = "groups",
    [MATERIALS] = "materials",
    [SMOOTHING] = "smoothing groups",
    [TEXTURE] = "texture coordinates",
    [NORMALS] = "normals",
    [COLORS] = "colors",
    [VERTEX_PROPERTIES] = "properties of vertices",
    [FACE_PROPERTIES] = "properties of faces",
    [EDGE_PROPERTIES] = "properties of edges",
    [ELEMENTS] = "other elements",
    [LINES] = "other lines",
    [POLYGONS] = "polygons",
    [EDGES] = "edges",
};

/// A set of things.
typedef struct things {
    bool has[THINGS + 2];
} things;

//: Name what words mean
typedef struct meaning {
    const char *word;
    thing thing;
} meaning;

static thing meaning_of(const meaning list[], const char *word, size_t length,
                        thing other)
{
    for (; list->word; list++)
        if (strlen(list->word) == length &&
            memcmp(list->word, word, length) == 0)
            return list->thing;
    return other;
}

//: Walk through lines
/// Steps over blanks, and over a word; returns the word.
static const char *next_word(const char **at, size_t *length)
{
    const char *word = *at + strspn(*at, " \t");
    *length = strcspn(word, " \t\r\n");
    *at = word + *length;
    return word;
}

/// NULL: it was the last one.
static const char *next_line(const char *at)
{
    at += strcspn(at, "\r\n");
    return *at ? at + 1 : NULL;
}

//: Find out what is in the lines of OBJ
static void find_in_obj(const char *text, bool keeps_faces, things *found)
{
    static const meaning words[] = {
        {"v", NOTHING},  {"f", NOTHING},   {"l", NOTHING},
        {"", NOTHING},   {"#", COMMENTS},  {"o", NAMES},
        {"g", GROUPS},   {"s", SMOOTHING}, {"usemtl", MATERIALS},
        {"vt", TEXTURE}, {"vn", NORMALS},  {"mtllib", MATERIALS},
        {NULL, NOTHING}};
    for (const char *line = text; line; line = next_line(line)) {
        size_t length;
        const char *at = line, *word = next_word(&at, &length);
        found->has[*word == '#' ? COMMENTS
                                : meaning_of(words, word, length, LINES)] =
            true;
    }
    found->has[NAMES] &= !keeps_faces;
    found->has[GROUPS] &= !keeps_faces;
    found->has[MATERIALS] &= !keeps_faces;
    found->has[TEXTURE] &= !keeps_faces;
}

//: Find out what is in the header of PLY
/// Those of vertices that are no lists are found among the columns; integers of
/// faces may be kept.
static thing meaning_of_property(thing of, const char *at, bool keeps_faces)
{
    static const meaning words[] = {
        {"vertex_indices", NOTHING}, {"vertex_index", NOTHING},
        {"vertex1", NOTHING},        {"vertex2", NOTHING},
        {"texcoord", TEXTURE},       {NULL, NOTHING}};
    size_t length;
    const char *type = next_word(&at, &length);
    bool list = length == 4 && memcmp(type, "list", 4) == 0;
    for (int i = 0; i < (list ? 2 : 0); i++)
        next_word(&at, &length);
    const char *name = next_word(&at, &length);
    bool is_integer = *type != 'f' && *type != 'd';
    bool is_kept = of == VERTEX_PROPERTIES ||
                   (of == FACE_PROPERTIES && is_integer && keeps_faces);
    return is_kept && !list ? NOTHING : meaning_of(words, name, length, of);
}

static thing meaning_of_element(const char *at)
{
    static const meaning words[] = {{"vertex", VERTEX_PROPERTIES},
                                    {"face", FACE_PROPERTIES},
                                    {"edge", EDGE_PROPERTIES},
                                    {"tristrips", FACE_PROPERTIES},
                                    {NULL, NOTHING}};
    size_t length;
    const char *name = next_word(&at, &length);
    return meaning_of(words, name, length, ELEMENTS);
}

static void find_in_ply(const char *text, bool keeps_faces, things *found)
{
    static const meaning words[] = {
        {"comment", COMMENTS}, {"obj_info", COMMENTS},
        {"element", ELEMENTS}, {"property", VERTEX_PROPERTIES},
        {"end_header", LINES}, {NULL, NOTHING}};
    thing of = NOTHING, line_is = NOTHING;
    for (const char *line = text; line && line_is != LINES;
         line = next_line(line)) {
        size_t length;
        const char *at = line, *word = next_word(&at, &length);
        line_is = meaning_of(words, word, length, NOTHING);
        if (line_is == ELEMENTS)
            of = meaning_of_element(at);
        if (line_is == COMMENTS)
            found->has[COMMENTS] = true;
        if (line_is == VERTEX_PROPERTIES)
            found->has[meaning_of_property(of, at, keeps_faces)] = true;
    }
}

//: Find out what is in STL
/// In text, a name follows the word solid.
static void find_in_text_stl(const char *text, things *found)
{
    static const meaning words[] = {{"solid", NAMES}, {NULL, NOTHING}};
    for (const char *line = text; line; line = next_line(line)) {
        size_t length;
        const char *at = line, *word = next_word(&at, &length);
        thing is = meaning_of(words, word, length, NOTHING);
        next_word(&at, &length);
        found->has[length > 0 ? is : NOTHING] = true;
    }
}

/// In binary, some programs keep a color in the last two bytes of a triangle.
static void find_in_binary_stl(const tf_source *source, things *found)
{
    enum {
        HEAD = 84,
        FACET = 50
    };
    for (size_t at = HEAD; at + FACET <= source->size; at += FACET)
        if (tf_gather_bytes(source->text + at + FACET - 2, 2, false) != 0)
            found->has[COLORS] = true;
}

//: Find out what is in OFF
/// What the letters in front of the word OFF, if it is there, say that vertices
/// have.
static void find_in_off_head(const char *word, size_t length, things *found)
{
    bool there = memmem(word, length, "OFF", 3);
    for (; there && *word && *word != 'O'; word++)
        found->has[*word == 'C'   ? COLORS
                   : *word == 'N' ? NORMALS
                                  : TEXTURE] = true;
}

/// Whether more follows the corners of a face.
static bool has_more(const char *line)
{
    int wanted = atoi(line) + 1, words = 0;
    size_t length;
    while (*next_word(&line, &length) != '#' && length > 0)
        words++;
    return words > wanted;
}

/// The faces are all alike, so that the last one tells.
static void find_in_off(const char *text, things *found)
{
    const char *last = NULL;
    for (const char *line = text; line; line = next_line(line)) {
        size_t length;
        const char *at = line, *word = next_word(&at, &length);
        found->has[memchr(line, '#', strcspn(line, "\r\n")) ? COMMENTS
                                                            : NOTHING] = true;
        if (length == 0 || *word == '#')
            continue;
        if (!last)
            find_in_off_head(word, length, found);
        last = line;
    }
    found->has[last && has_more(last) ? COLORS : NOTHING] = true;
}

//: Find out what is in Gmsh's format
static void find_in_msh(const tf_mesh_file *file, things *found)
{
    const tf_source *source = file->source;
    static const char names[] = "$PhysicalNames";
    if (memmem(source->text, source->size, names, sizeof names - 1))
        found->has[GROUPS] = true;
    if (file->left_out[0] + file->left_out[1] + file->left_out[3] > 0)
        found->has[ELEMENTS] = true;
}

//: Find out what columns hold
static void find_in_columns(const tf_columns *columns, bool keeps_colors,
                            things *found)
{
    static const meaning words[] = {
        {"red", COLORS}, {"green", COLORS},      {"blue", COLORS},
        {"nx", NORMALS}, {"ny", NORMALS},        {"nz", NORMALS},
        {"u", TEXTURE},  {"v", TEXTURE},         {"s", TEXTURE},
        {"t", TEXTURE},  {"texture_u", TEXTURE}, {"texture_v", TEXTURE},
        {NULL, NOTHING}};
    for (int i = 0; columns && i < columns->count; i++) {
        const char *name = columns->column[i].name;
        thing is = meaning_of(words, name, strlen(name), VERTEX_PROPERTIES);
        found->has[is == COLORS && keeps_colors ? NOTHING : is] = true;
    }
}

//: Find what is lost
/// The formats that hold colors of vertices, their properties, polygons or
/// edges.
static bool holds(tf_mesh_format format, thing what)
{
    bool stl = format == TF_STL_TEXT || format == TF_STL_BINARY;
    return what == COLORS     ? !stl
           : what == POLYGONS ? !stl && format != TF_VTP
           : what == EDGES    ? !stl && format != TF_OFF
                              : format != TF_OBJ && format != TF_OFF && !stl;
}

static void find_in_source(const tf_mesh_file *file, bool keeps_faces,
                           things *found)
{
    const char *text = tf_text_begin(file->source->text);
    switch (file->format) {
    case TF_OBJ:
        find_in_obj(text, keeps_faces, found);
        break;
    case TF_STL_TEXT:
        find_in_text_stl(text, found);
        break;
    case TF_STL_BINARY:
        find_in_binary_stl(file->source, found);
        break;
    case TF_OFF:
        find_in_off(text, found);
        break;
    case TF_MSH:
        find_in_msh(file, found);
        break;
    default:
        find_in_ply(file->source->text, keeps_faces, found);
        break;
    }
}

static void find_all(const tf_mesh_file *file, tf_mesh_format format,
                     bool keeps_faces, things *lost)
{
    find_in_source(file, keeps_faces, lost);
    if (!holds(format, VERTEX_PROPERTIES))
        find_in_columns(file->columns, holds(format, COLORS), lost);
    lost->has[POLYGONS] =
        tf_mesh_file_polygons(file) > 0 && !holds(format, POLYGONS);
    lost->has[EDGES] = tf_mesh_file_edges(file) > 0 && !holds(format, EDGES);
}

//: List what is lost
static void add_text(tf_losses *list, const char *text)
{
    size_t length = strlen(list->text);
    snprintf(list->text + length, sizeof list->text - length, "%s", text);
}

tf_losses tf_find_losses(const tf_mesh_file *file, tf_mesh_format format,
                         bool keeps_faces)
{
    tf_losses list = {""};
    things lost = {{0}};
    int count = 0, listed = 0;
    find_all(file, format, keeps_faces, &lost);
    for (int i = 0; i < THINGS; i++)
        count += lost.has[i];
    for (int i = 0; i < THINGS; i++)
        if (lost.has[i]) {
            listed++;
            add_text(&list, listed == 1       ? ""
                            : listed == count ? " and "
                                              : ", ");
            add_text(&list, thing_names[i]);
        }
    return list;
}

//: Count what is rounded
size_t tf_count_rounded(const double position[], size_t coordinates)
{
    size_t count = 0;
    for (size_t i = 0; i < coordinates; i++)
        count += !tf_number_fits(TF_FLOAT, position[i]);
    return count;
}

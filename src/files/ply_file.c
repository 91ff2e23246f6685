//: Include what PLY files need
#include "files/ply_file.h"

#include "files/number.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

//: List the types of properties
typedef enum kind {
    SIGNED,
    UNSIGNED,
    FLOAT,
} kind;

typedef struct type {
    const char *name;
    kind kind;
    int bytes;
} type;

static const type types[] = {
    {"char", SIGNED, 1},     {"int8", SIGNED, 1},     {"uchar", UNSIGNED, 1},
    {"uint8", UNSIGNED, 1},  {"short", SIGNED, 2},    {"int16", SIGNED, 2},
    {"ushort", UNSIGNED, 2}, {"uint16", UNSIGNED, 2}, {"int", SIGNED, 4},
    {"int32", SIGNED, 4},    {"uint", UNSIGNED, 4},   {"uint32", UNSIGNED, 4},
    {"float", FLOAT, 4},     {"float32", FLOAT, 4},   {"double", FLOAT, 8},
    {"float64", FLOAT, 8},
};

//: Declare the header
enum {
    PROPERTIES = 64, // of an element
    ELEMENTS = 16,
    WORD = 32
};

/// What a property means for the mesh.
typedef enum role {
    NOTHING = -1,
    FIRST = 0, ///< x, or vertex1, or the list of the corners of a face
    SECOND,    ///< y, or vertex2
    THIRD,     ///< z
} role;

typedef struct property {
    const type *length; ///< of a list: of its length; NULL: it is no list
    const type *item;
    role role;
} property;

typedef enum target {
    SKIPPED,
    VERTICES,
    FACES,
    EDGES,
} target;

typedef struct element {
    target target;
    long line; ///< that declares it
    long count;
    int properties;
    property property[PROPERTIES];
} element;

typedef enum encoding {
    UNKNOWN,
    TEXT,
    LITTLE_ENDIAN,
    BIG_ENDIAN,
} encoding;

typedef struct reader {
    tf_mesh_file *file;
    const char *text, *at, *end;
    long line; ///< of the text; in binary of the header only
    encoding encoding;
    int elements;
    element element[ELEMENTS];
} reader;

static long place(const reader *r)
{
    return r->file->counts_bytes ? (long)(r->at - r->text) : r->line;
}

//: Read a word of the header
/// Reads the next word of the line, cut where it is long; empty at its end.
static void read_word(reader *r, char word[WORD])
{
    size_t length = 0;
    while (*r->at == ' ' || *r->at == '\t')
        r->at++;
    for (; r->at < r->end && !strchr(" \t\r\n", *r->at); r->at++)
        if (length < WORD - 1)
            word[length++] = *r->at >= ' ' && *r->at <= '~' ? *r->at : '?';
    word[length] = '\0';
}

/// Steps over the end of a line; false at the end of the file.
static bool end_line(reader *r)
{
    while (r->at < r->end && *r->at != '\n')
        r->at++;
    if (r->at == r->end)
        return false;
    r->at++;
    r->line++;
    return true;
}

//: Read the format
static bool read_format(reader *r)
{
    static const char *const names[] = {"ascii", "binary_little_endian",
                                        "binary_big_endian"};
    char word[WORD];
    read_word(r, word);
    for (int i = 0; i < 3; i++)
        if (strcmp(word, names[i]) == 0)
            r->encoding = (encoding)(TEXT + i);
    return r->encoding != UNKNOWN ||
           tf_mesh_file_fault(r->file, r->line,
                              "unknown format \"%s\"; write ascii, "
                              "binary_little_endian or binary_big_endian",
                              word);
}

//: Read the declaration of an element
static target target_named(const char *name)
{
    return strcmp(name, "vertex") == 0 ? VERTICES
           : strcmp(name, "face") == 0 ? FACES
           : strcmp(name, "edge") == 0 ? EDGES
                                       : SKIPPED;
}

/// The element for a target; NULL if none is declared.
static const element *element_for(const reader *r, target wanted)
{
    for (int i = 0; i < r->elements; i++)
        if (r->element[i].target == wanted)
            return &r->element[i];
    return NULL;
}

static bool read_count(reader *r, long *count)
{
    char word[WORD], *end;
    read_word(r, word);
    long long read = strtoll(word, &end, 10);
    if (end == word || *end || read < 0 || read > INT_MAX)
        return tf_mesh_file_fault(
            r->file, r->line,
            "\"%s\" is not a number of elements; write an integer from 0 to %d",
            word, INT_MAX);
    *count = (long)read;
    return true;
}

static bool read_element(reader *r)
{
    char name[WORD];
    read_word(r, name);
    element made = {.target = target_named(name), .line = r->line};
    if (r->elements == ELEMENTS)
        return tf_mesh_file_fault(r->file, r->line,
                                  "more than %d elements; delete those that "
                                  "are no vertices, faces or edges",
                                  ELEMENTS);
    if (made.target != SKIPPED && element_for(r, made.target))
        return tf_mesh_file_fault(r->file, r->line,
                                  "a second element %s; declare it once", name);
    if (!read_count(r, &made.count))
        return false;
    r->element[r->elements++] = made;
    return true;
}

//: Read the declaration of a property
static const type *type_named(const char *name)
{
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        if (strcmp(name, types[i].name) == 0)
            return &types[i];
    return NULL;
}

/// The corners of a face are a list; all others that have a role are none.
static role role_named(target of, bool list, const char *name)
{
    static const char *const names[][3] = {
        [VERTICES] = {"x", "y", "z"},
        [FACES] = {"vertex_indices", "vertex_index", ""},
        [EDGES] = {"vertex1", "vertex2", ""},
    };
    if (of == SKIPPED || list != (of == FACES))
        return NOTHING;
    for (int i = 0; i < 3; i++)
        if (strcmp(name, names[of][i]) == 0)
            return of == FACES ? FIRST : (role)i;
    return NOTHING;
}

/// Reads the name of a type.
static bool read_type(reader *r, char word[WORD], const type **found)
{
    *found = type_named(word);
    return *found ||
           tf_mesh_file_fault(
               r->file, r->line,
               "unknown type \"%s\"; use one of PLY's, such as double", word);
}

static bool read_property(reader *r)
{
    char word[WORD];
    property made = {0};
    if (r->elements == 0)
        return tf_mesh_file_fault(
            r->file, r->line,
            "a property before all elements; write an element line first");
    element *of = &r->element[r->elements - 1];
    read_word(r, word);
    if (strcmp(word, "list") == 0) {
        read_word(r, word);
        if (!read_type(r, word, &made.length))
            return false;
        read_word(r, word);
    }
    if (!read_type(r, word, &made.item))
        return false;
    read_word(r, word);
    made.role = role_named(of->target, made.length, word);
    if (of->properties == PROPERTIES)
        return tf_mesh_file_fault(r->file, r->line,
                                  "more than %d properties; delete those that "
                                  "are no coordinates or indices",
                                  PROPERTIES);
    of->property[of->properties++] = made;
    return true;
}

//: Check a declaration
static bool declares(const element *of, role wanted)
{
    bool found = false;
    for (int i = 0; i < of->properties; i++)
        found |= of->property[i].role == wanted;
    return found;
}

static bool check_element(reader *r, const element *of)
{
    static const char *const faults[] = {
        [VERTICES] = "the vertices have no x or no y; declare the properties "
                     "double x and double y",
        [FACES] = "the faces have no corners; declare the property list uchar "
                  "int vertex_indices",
        [EDGES] = "the edges have no ends; declare the properties int vertex1 "
                  "and int vertex2",
    };
    return of->target == SKIPPED ||
           (declares(of, FIRST) &&
            (of->target == FACES || declares(of, SECOND))) ||
           tf_mesh_file_fault(r->file, of->line, "%s", faults[of->target]);
}

static bool check_depth(reader *r)
{
    const element *vertices = element_for(r, VERTICES);
    const element *faces = element_for(r, FACES);
    return !vertices || !faces || faces->count == 0 ||
           declares(vertices, THIRD) ||
           tf_mesh_file_fault(r->file, vertices->line,
                              "vertices without z; the vertices of triangles "
                              "must have three coordinates");
}

static bool check_header(reader *r)
{
    for (int i = 0; i < r->elements; i++)
        if (!check_element(r, &r->element[i]))
            return false;
    return check_depth(r) &&
           (r->encoding != UNKNOWN ||
            tf_mesh_file_fault(r->file, r->line,
                               "the header has no format; add a line such as "
                               "\"format ascii 1.0\""));
}

//: Read the header
/// Reads a line; `*last`: it is the last one.
static bool read_header_line(reader *r, bool *last)
{
    char word[WORD];
    read_word(r, word);
    *last = strcmp(word, "end_header") == 0;
    if (*last || !*word || strcmp(word, "comment") == 0 ||
        strcmp(word, "obj_info") == 0)
        return true;
    if (strcmp(word, "format") == 0)
        return read_format(r);
    if (strcmp(word, "element") == 0)
        return read_element(r);
    if (strcmp(word, "property") == 0)
        return read_property(r);
    return tf_mesh_file_fault(r->file, r->line,
                              "a header line cannot begin with \"%s\"; begin "
                              "comments with \"comment\"",
                              word);
}

static bool read_header(reader *r)
{
    for (bool last = false; !last;) {
        if (!end_line(r))
            return tf_mesh_file_fault(
                r->file, r->line,
                "the header ends too early; the file may be cut short");
        if (!read_header_line(r, &last))
            return false;
    }
    if (!check_header(r))
        return false;
    return end_line(r) ||
           tf_mesh_file_fault(
               r->file, r->line,
               "nothing follows the header; the file may be cut short");
}

//: Read a number in binary
/// The unsigned number of some bytes.
static uint64_t gather_bytes(const reader *r, int bytes)
{
    const unsigned char *at = (const unsigned char *)r->at;
    uint64_t number = 0;
    for (int i = 0; i < bytes; i++) {
        int shift = r->encoding == BIG_ENDIAN ? bytes - 1 - i : i;
        number |= (uint64_t)at[i] << 8 * shift;
    }
    return number;
}

static double decode(const type *of, uint64_t bits)
{
    if (of->kind == UNSIGNED)
        return (double)bits;
    if (of->kind == SIGNED) {
        uint64_t sign = UINT64_C(1) << (8 * of->bytes - 1);
        return (double)(int64_t)((bits ^ sign) - sign);
    }
    double wide;
    float narrow;
    uint32_t low = (uint32_t)bits;
    memcpy(&wide, &bits, sizeof wide);
    memcpy(&narrow, &low, sizeof narrow);
    return of->bytes == 8 ? wide : (double)narrow;
}

static bool fault_in_end(reader *r)
{
    return tf_mesh_file_fault(r->file, place(r),
                              "the file ends too early; it may be cut short, "
                              "or the header declares too many elements");
}

static bool read_binary(reader *r, const type *of, double *number)
{
    if (r->end - r->at < of->bytes)
        return fault_in_end(r);
    *number = decode(of, gather_bytes(r, of->bytes));
    r->at += of->bytes;
    return true;
}

//: Find a word in text
static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

static void skip_blanks(reader *r)
{
    while (is_blank(*r->at))
        r->at++;
}

static void skip_blank_lines(reader *r)
{
    for (skip_blanks(r); *r->at == '\n'; skip_blanks(r)) {
        r->at++;
        r->line++;
    }
}

/// Finds the next word of the line.
static bool find_word(reader *r)
{
    skip_blanks(r);
    if (r->at == r->end)
        return fault_in_end(r);
    return *r->at != '\n' ||
           tf_mesh_file_fault(r->file, r->line,
                              "the line ends too early; it must have all that "
                              "the header declares for an element");
}

//: Read a number in text
static bool fault_in_word(reader *r, const char *word, const char *verdict)
{
    return tf_mesh_file_fault_in_word(r->file, r->line, word, verdict);
}

static bool read_text(reader *r, double *number)
{
    if (!find_word(r))
        return false;
    const char *word = r->at;
    return (tf_number_read(&r->at, number) &&
            (is_blank(*r->at) || *r->at == '\n' || *r->at == '\0')) ||
           fault_in_word(
               r, word,
               "not a finite number; write a decimal or a hexadecimal float");
}

static bool read_number(reader *r, const type *of, double *number)
{
    return r->encoding == TEXT ? read_text(r, number)
                               : read_binary(r, of, number);
}

//: Skip a value
/// Skips a word, which may be no number, not even a finite one.
static bool skip_word(reader *r)
{
    if (!find_word(r))
        return false;
    if (*r->at == '\0')
        return fault_in_word(r, r->at, "");
    r->at += strcspn(r->at, " \t\r\n");
    return true;
}

static bool skip_value(reader *r, const type *of)
{
    if (r->encoding == TEXT)
        return skip_word(r);
    if (r->end - r->at < of->bytes)
        return fault_in_end(r);
    r->at += of->bytes;
    return true;
}

//: Read an index
static bool read_index(reader *r, const type *of, int *index)
{
    long at = place(r);
    double number;
    if (!read_number(r, of, &number))
        return false;
    if (!(number >= 0 && number <= INT_MAX && number == floor(number)))
        return tf_mesh_file_fault(
            r->file, at,
            "%.17g is not an index or a length; write an integer from 0",
            number);
    *index = (int)number;
    return true;
}

//: Read a list
/// Reads the corners of a face, or skips another list.
static bool read_list(reader *r, const property *of, int corner[3])
{
    long at = place(r);
    int length = 0;
    if (!read_index(r, of->length, &length))
        return false;
    bool corners = of->role != NOTHING;
    if (corners && length != 3)
        return tf_mesh_file_fault(
            r->file, at,
            length > 3 ? "a face with %d corners; triangulate the mesh, for "
                         "instance by Blender's export option Triangulated Mesh"
                       : "a face with %d corners; each must have three",
            length);
    for (int i = 0; i < length; i++)
        if (corners ? !read_index(r, of->item, &corner[i])
                    : !skip_value(r, of->item))
            return false;
    return true;
}

//: Read an item of an element
/// What an item gives to the mesh.
typedef struct item {
    double x[3];
    int vertex[3];
} item;

static bool read_coordinate(reader *r, const type *of, double *x)
{
    long at = place(r);
    return read_number(r, of, x) &&
           (isfinite(*x) || tf_mesh_file_fault(r->file, at,
                                               "a coordinate is not finite; "
                                               "remove NaNs and infinities"));
}

static bool read_value(reader *r, target to, const property *of, item *made)
{
    if (of->length)
        return read_list(r, of, made->vertex);
    if (of->role == NOTHING)
        return skip_value(r, of->item);
    return to == VERTICES ? read_coordinate(r, of->item, &made->x[of->role])
                          : read_index(r, of->item, &made->vertex[of->role]);
}

static bool read_values(reader *r, const element *of, item *made)
{
    for (int i = 0; i < of->properties; i++)
        if (!read_value(r, of->target, &of->property[i], made))
            return false;
    return true;
}

//: Add an item to the mesh
static bool add_item(reader *r, target to, const item *made, long at)
{
    switch (to) {
    case VERTICES:
        return tf_mesh_file_add_vertex(r->file, made->x, at);
    case FACES:
        return tf_mesh_file_add_triangle(r->file, made->vertex, at);
    case EDGES:
        return tf_mesh_file_add_edge(r->file, made->vertex, at);
    default:
        return true;
    }
}

static bool end_text(reader *r)
{
    skip_blanks(r);
    return *r->at == '\n' || r->at == r->end ||
           fault_in_word(r, r->at,
                         "more than the header declares for an element; begin "
                         "each element on a new line");
}

static bool read_item(reader *r, const element *of)
{
    item made = {0};
    if (r->encoding == TEXT)
        skip_blank_lines(r);
    long at = place(r);
    return read_values(r, of, &made) && (r->encoding != TEXT || end_text(r)) &&
           add_item(r, of->target, &made, at);
}

//: Read what follows the header
static bool read_items(reader *r)
{
    for (int e = 0; e < r->elements; e++)
        for (long i = 0;
             r->element[e].properties > 0 && i < r->element[e].count; i++)
            if (!read_item(r, &r->element[e]))
                return false;
    if (r->encoding == TEXT)
        skip_blank_lines(r);
    return r->at == r->end ||
           tf_mesh_file_fault(r->file, place(r),
                              "more follows than the header declares; correct "
                              "the numbers of elements");
}

//: Read PLY
bool tf_is_ply(const char *text, size_t size)
{
    return size >= 4 && strncmp(text, "ply", 3) == 0 &&
           (text[3] == '\n' || text[3] == '\r');
}

bool tf_ply_parse(tf_mesh_file *file, const char *text, size_t size)
{
    reader r = {
        .file = file, .text = text, .at = text, .end = text + size, .line = 1};
    static const tf_mesh_format formats[] = {
        [UNKNOWN] = TF_PLY_TEXT,
        [TEXT] = TF_PLY_TEXT,
        [LITTLE_ENDIAN] = TF_PLY_LITTLE_ENDIAN,
        [BIG_ENDIAN] = TF_PLY_BIG_ENDIAN,
    };
    bool good = read_header(&r);
    file->format = formats[r.encoding];
    file->counts_bytes = good && r.encoding != TEXT;
    return good && read_items(&r);
}

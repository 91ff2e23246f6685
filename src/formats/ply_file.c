//: Include what PLY files need
#include "formats/ply_file.h"

#include "files/number.h"
#include "files/text.h"
#include "formats/binary.h"
#include "formats/face_attributes.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

//: Declare the types of properties
typedef enum kind {
    SIGNED,
    UNSIGNED,
    FLOAT,
} kind;

typedef struct ply_type {
    kind kind;
    int bytes;
} ply_type;

/// Each has two names, one after the other.
static const char *const type_names[] = {
    "char",   "int8",    "uchar",  "uint8",  "short", "int16",
    "ushort", "uint16",  "int",    "int32",  "uint",  "uint32",
    "float",  "float32", "double", "float64"};

static const ply_type types[] = {{SIGNED, 1},   {UNSIGNED, 1}, {SIGNED, 2},
                                 {UNSIGNED, 2}, {SIGNED, 4},   {UNSIGNED, 4},
                                 {FLOAT, 4},    {FLOAT, 8}};

//: Declare the header
enum {
    PROPERTIES = 64, // of an element
    ELEMENTS = 16,
    WORDS = 5, // of a line that are looked at
    NONE = -1
};

typedef struct ply_property {
    const char *name; ///< in the header, so long
    size_t name_length;
    const ply_type *length; ///< of a list: of its length; NULL: it is no list
    const ply_type *item;
    int role;   ///< what it means: the place of its name, or NONE
    int column; ///< that it fills, or NONE
} ply_property;

/// What is read of a file.
typedef enum target {
    VERTICES,
    FACES,
    STRIPS,
    EDGES,
    TARGETS
} target;

static const char *const target_names[] = {"vertex", "face", "tristrips",
                                           "edge"};

static const char *const role_names[TARGETS][3] = {
    [VERTICES] = {"x", "y", "z"},
    [FACES] = {"vertex_indices", "vertex_index", ""}, // either is the corners
    [STRIPS] = {"vertex_indices", "vertex_index", ""},
    [EDGES] = {"vertex1", "vertex2", ""},
};

typedef struct ply_element {
    int target; ///< or NONE
    long line;  ///< that declares it
    int count;
    int properties;
    ply_property property[PROPERTIES];
} ply_element;

//: Declare the reader of PLY
typedef struct reader {
    tf_text text; ///< its line is, in binary, that of the header
    const char *start, *end;
    const char *row;    ///< where a line of the header begins
    tf_mesh_file *file; ///< its format is TF_OBJ until that is known
    int elements;
    ply_element element[ELEMENTS];
    double value[TF_MOST_COLUMNS]; ///< of a vertex or a face, for its columns
    tf_ints corner;                ///< of a face
} reader;

static long place(const reader *r)
{
    return r->file->counts_bytes ? (long)(r->text.at - r->start) : r->text.line;
}

static bool is_text(const reader *r)
{
    return r->file->format == TF_PLY_TEXT;
}

/// The place of a name in a list, or NONE.
static int place_of(const char *name, const char *const names[], int count)
{
    for (int i = 0; i < count; i++)
        if (strcmp(name, names[i]) == 0)
            return i;
    return NONE;
}

//: Walk through the header
/// Steps over the end of a line; false at the end of the file.
static bool end_line(reader *r)
{
    tf_text *text = &r->text;
    const char *end = memchr(text->at, '\n', (size_t)(r->end - text->at));
    if (!end)
        return false;
    text->at = end + 1;
    text->line++;
    return true;
}

/// Takes the words of a line; those that are not there are empty.
static void split_line(reader *r, tf_quoted word[WORDS])
{
    tf_text *text = &r->text;
    r->row = text->at;
    for (int i = 0; i < WORDS; i++) {
        tf_text_skip_blanks(text);
        size_t length = strcspn(text->at, " \t\r\n");
        word[i] = tf_quote(text->at, length);
        text->at += length;
    }
}

/// The word of the line that comes after so many others.
static const char *find_word(const reader *r, int words)
{
    const char *word = r->row;
    for (int i = 0; i < words; i++) {
        word += strspn(word, " \t");
        word += strcspn(word, " \t\r\n");
    }
    return word + strspn(word, " \t");
}

//: Read the format
static bool read_format(reader *r, const char *name)
{
    static const char *const names[] = {"ascii", "binary_little_endian",
                                        "binary_big_endian"};
    int found = place_of(name, names, 3);
    if (found != NONE)
        r->file->format = (tf_mesh_format)(TF_PLY_TEXT + found);
    return found != NONE ||
           tf_text_fault(&r->text,
                         "unknown format '%s'; write ascii, "
                         "binary_little_endian or binary_big_endian",
                         name);
}

//: Keep the parts of PLY
/// Those of strips, and of elements that are not known, have no kinds.
static bool keep_count(const reader *r, const ply_element *element)
{
    static const tf_part_kind kinds[] = {[VERTICES] = TF_VERTEX_COUNT_PART,
                                         [FACES] = TF_FACE_COUNT_PART,
                                         [EDGES] = TF_EDGE_COUNT_PART};
    const char *count = find_word(r, 2);
    if (element->target == NONE || element->target == STRIPS) {
        tf_mesh_file_drop_parts(r->file);
        return true;
    }
    return tf_mesh_file_add_part(r->file, kinds[element->target], -1, r->start,
                                 count, count + strcspn(count, " \t\r\n"));
}

static bool keep_row(const reader *r, const ply_element *element)
{
    static const tf_part_kind kinds[] = {[VERTICES] = TF_VERTEX_PART,
                                         [FACES] = TF_FACE_PART,
                                         [EDGES] = TF_EDGE_PART};
    const char *at = r->text.at;
    return element->target == NONE || element->target == STRIPS ||
           tf_mesh_file_add_part(r->file, kinds[element->target], -1, r->start,
                                 at, at);
}

/// An index from there on, of that type.
static bool keep_corner(const reader *r, const ply_type *type, int vertex,
                        const char *at)
{
    if (type->kind == FLOAT)
        tf_mesh_file_drop_parts(r->file);
    return tf_mesh_file_add_part(r->file, TF_CORNER_PART, vertex, r->start,
                                 is_text(r) ? at + strspn(at, " \t\r") : at,
                                 r->text.at);
}

//: Read the declaration of an element
/// The element for a target; NULL if none is declared.
static const ply_element *element_for(const reader *r, int wanted)
{
    for (int i = 0; i < r->elements; i++)
        if (r->element[i].target == wanted)
            return &r->element[i];
    return NULL;
}

static bool read_count(const reader *r, const char *word, int *count)
{
    const char *at = word;
    int64_t read = NONE;
    if (!tf_integer_read(&at, &read) || *at || read < 0 || read > INT_MAX)
        return tf_text_fault(
            &r->text,
            "'%s' is not a number of elements; write an integer from 0 to %d",
            word, INT_MAX);
    *count = (int)read;
    return true;
}

static bool read_element(reader *r, const char *name, const char *count)
{
    ply_element made = {.target = place_of(name, target_names, TARGETS),
                        .line = r->text.line};
    if (r->elements == ELEMENTS)
        return tf_text_fault(&r->text,
                             "more than %d elements; delete those that are no "
                             "vertices, faces or edges",
                             ELEMENTS);
    if (made.target != NONE && element_for(r, made.target))
        return tf_text_fault(&r->text, "a second element %s; declare it once",
                             name);
    if (!read_count(r, count, &made.count))
        return false;
    r->element[r->elements++] = made;
    return keep_count(r, &made);
}

//: Declare a column
/// The columns that keep a scalar property without a role, or NULL: all of
/// vertices, and integers of faces.
static tf_columns *columns_for(const reader *r, const ply_element *element,
                               const ply_property *made)
{
    tf_face_attributes *faces = r->file->source ? r->file->source->faces : NULL;
    if (made->length || made->role != NONE)
        return NULL;
    return element->target == VERTICES ? r->file->columns
           : element->target == FACES && faces && made->item->kind != FLOAT
               ? &faces->row
               : NULL;
}

static bool add_column(const reader *r, const ply_element *element,
                       tf_columns *columns, ply_property *made)
{
    tf_column *column = &columns->column[columns->count];
    if (made->name_length >= sizeof column->name)
        return tf_text_fault(&r->text,
                             "the name of a property has %zu bytes; shorten it "
                             "to %zu or fewer",
                             made->name_length, sizeof column->name - 1);
    *column = (tf_column){.type = (tf_number_type)(made->item - types)};
    memcpy(column->name, made->name, made->name_length);
    for (int i = 0; i < element->properties; i++)
        column->after += element->property[i].role != NONE;
    made->column = columns->count++;
    return true;
}

//: Name a property
static void find_name(const reader *r, int words, ply_property *made)
{
    made->name = find_word(r, words);
    made->name_length = strcspn(made->name, " \t\r\n");
}

static bool have_same_name(const ply_property *one, const ply_property *other)
{
    return one->name_length == other->name_length &&
           memcmp(one->name, other->name, one->name_length) == 0;
}

/// What is skipped with its element may have any names.
static bool check_name(const reader *r, const ply_element *element,
                       const ply_property *made)
{
    tf_quoted quoted = tf_quote(made->name, made->name_length);
    for (int i = 0; element->target != NONE && i < element->properties; i++) {
        const ply_property *before = &element->property[i];
        if (have_same_name(before, made))
            return tf_text_fault(&r->text,
                                 "a second property '%s'; declare it once",
                                 quoted.text);
        if (made->role != NONE && before->role == made->role)
            return tf_text_fault(&r->text,
                                 "a second list of corners, '%s'; declare one",
                                 quoted.text);
    }
    return true;
}

//: Keep where coordinates are declared
static void keep_declaration(const reader *r, const ply_property *made)
{
    tf_source *source = r->file->source;
    const char *type = find_word(r, 1);
    if (!source)
        return;
    source->type[made->role] = (tf_number_type)(made->item - types);
    source->word[made->role] = (size_t)(type - r->start);
    source->word_length[made->role] = strcspn(type, " \t\r\n");
    if (made->role == 1)
        source->y_end = (size_t)(made->name + made->name_length - r->start);
}

//: Read the declaration of a property
static bool find_type(const reader *r, const char *name, const ply_type **found)
{
    int i = place_of(name, type_names, sizeof type_names / sizeof *type_names);
    if (i == NONE)
        return tf_text_fault(
            &r->text, "unknown type '%s'; use one of PLY's, such as double",
            name);
    *found = &types[i / 2];
    return true;
}

static bool has_corners(int to)
{
    return to == FACES || to == STRIPS;
}

/// Corners are a list; no other property with a role is one.
static int role_named(int wanted, bool list, const char *name)
{
    if (wanted == NONE || list != has_corners(wanted))
        return NONE;
    int role = place_of(name, role_names[wanted], 3);
    return has_corners(wanted) && role > 0 ? 0 : role;
}

static bool read_property(reader *r, const tf_quoted word[])
{
    bool list = strcmp(word[0].text, "list") == 0;
    const tf_quoted *item = list ? word + 2 : word;
    ply_property made = {.column = NONE};
    if (r->elements == 0)
        return tf_text_fault(
            &r->text,
            "a property before all elements; write an element line first");
    ply_element *element = &r->element[r->elements - 1];
    if ((list && !find_type(r, word[1].text, &made.length)) ||
        !find_type(r, item[0].text, &made.item))
        return false;
    made.role = role_named(element->target, list, item[1].text);
    find_name(r, list ? 4 : 2, &made);
    if (element->properties == PROPERTIES)
        return tf_text_fault(&r->text,
                             "more than %d properties; delete those that are "
                             "no coordinates or indices",
                             PROPERTIES);
    tf_columns *columns = columns_for(r, element, &made);
    if (!check_name(r, element, &made) ||
        (columns && !add_column(r, element, columns, &made)))
        return false;
    if (element->target == VERTICES && made.role != NONE)
        keep_declaration(r, &made);
    element->property[element->properties++] = made;
    return true;
}

//: Check a declaration
static bool declares(const ply_element *element, int role)
{
    bool found = false;
    for (int i = 0; i < element->properties; i++)
        found |= element->property[i].role == role;
    return found;
}

static bool check_element(const reader *r, const ply_element *element)
{
    static const char *const faults[] = {
        [VERTICES] = "the vertices have no x or no y; declare the properties "
                     "double x and double y",
        [FACES] = "the faces have no corners; declare the property list uchar "
                  "int vertex_indices",
        [STRIPS] = "the strips have no corners; declare the property list int "
                   "int vertex_indices",
        [EDGES] = "the edges have no ends; declare the properties int vertex1 "
                  "and int vertex2",
    };
    return element->target == NONE ||
           (declares(element, 0) &&
            (has_corners(element->target) || declares(element, 1))) ||
           tf_mesh_file_fault(r->file, element->line, "%s",
                              faults[element->target]);
}

static bool has_any(const reader *r, int wanted)
{
    const ply_element *element = element_for(r, wanted);
    return element && element->count > 0;
}

static bool check_header(const reader *r)
{
    const ply_element *vertices = element_for(r, VERTICES);
    for (int i = 0; i < r->elements; i++)
        if (!check_element(r, &r->element[i]))
            return false;
    if (vertices && (has_any(r, FACES) || has_any(r, STRIPS)) &&
        !declares(vertices, 2))
        return tf_mesh_file_fault(r->file, vertices->line,
                                  "vertices without z; the vertices of "
                                  "triangles must have three coordinates");
    if (r->file->source && vertices) {
        r->file->source->lacks_z = !declares(vertices, 2);
        r->file->source->is_big_endian = r->file->format == TF_PLY_BIG_ENDIAN;
    }
    return r->file->format != TF_OBJ ||
           tf_text_fault(&r->text, "the header has no format; add a line such "
                                   "as 'format ascii 1.0'");
}

//: Read the header
/// Reads a line; `*last`: it is the last one.
static bool read_header_line(reader *r, bool *last)
{
    tf_quoted word[WORDS];
    split_line(r, word);
    const char *first = word[0].text;
    *last = strcmp(first, "end_header") == 0;
    if (*last || !*first || strcmp(first, "comment") == 0 ||
        strcmp(first, "obj_info") == 0)
        return true;
    if (strcmp(first, "format") == 0)
        return read_format(r, word[1].text);
    if (strcmp(first, "element") == 0)
        return read_element(r, word[1].text, word[2].text);
    if (strcmp(first, "property") == 0)
        return read_property(r, word + 1);
    return tf_text_fault(&r->text,
                         "a header line cannot begin with '%s'; begin "
                         "comments with 'comment'",
                         first);
}

static bool read_header(reader *r)
{
    for (bool last = false; !last;) {
        if (!end_line(r))
            return tf_text_fault(
                &r->text,
                "the header ends too early; the file may be cut short");
        if (!read_header_line(r, &last))
            return false;
    }
    return check_header(r) &&
           (end_line(r) ||
            tf_text_fault(
                &r->text,
                "nothing follows the header; the file may be cut short"));
}

//: Read a number in binary
static double decode(const reader *r, const ply_type *type)
{
    bool big = r->file->format == TF_PLY_BIG_ENDIAN;
    if (type->kind == FLOAT)
        return type->bytes == 8 ? tf_gather_double(r->text.at, big)
                                : (double)tf_gather_float(r->text.at, big);
    uint64_t bits = tf_gather_bytes(r->text.at, type->bytes, big);
    uint64_t sign = UINT64_C(1) << (8 * type->bytes - 1);
    return type->kind == UNSIGNED ? (double)bits
                                  : (double)(int64_t)((bits ^ sign) - sign);
}

static bool fault_in_end(const reader *r)
{
    return tf_mesh_file_fault(r->file, place(r),
                              "the file ends too early; it may be cut short, "
                              "or the header declares too many elements");
}

//: Find a value
static void skip_blank_lines(tf_text *text)
{
    for (tf_text_skip_blanks(text); *text->at == '\n';
         tf_text_skip_blanks(text)) {
        text->at++;
        text->line++;
    }
}

/// Finds the next value, in text in the same line.
static bool find_value(reader *r, const ply_type *type)
{
    tf_text *text = &r->text;
    if (is_text(r))
        tf_text_skip_blanks(text);
    if (r->end - text->at < (is_text(r) ? 1 : type->bytes))
        return fault_in_end(r);
    return !is_text(r) || *text->at != '\n' ||
           tf_text_fault(text, "the line ends too early; it must have all that "
                               "the header declares for an element");
}

//: Read or skip a value
static bool read_number(reader *r, const ply_type *type, double *number)
{
    if (!find_value(r, type))
        return false;
    if (is_text(r))
        return tf_text_read_number(&r->text, " \t\r\n", number);
    *number = decode(r, type);
    r->text.at += type->bytes;
    return true;
}

/// In text a word may be skipped that is no number, not even a finite one.
static bool skip_value(reader *r, const ply_type *type)
{
    if (!find_value(r, type))
        return false;
    size_t length =
        is_text(r) ? strcspn(r->text.at, " \t\r\n") : (size_t)type->bytes;
    r->text.at += length;
    return length > 0 || tf_text_fault_in_nul(&r->text);
}

//: Read the value of a column
/// In text what is no finite number is read as no number at all.
static bool read_column(reader *r, const ply_property *property)
{
    double *value = &r->value[property->column];
    if (!is_text(r))
        return read_number(r, property->item, value);
    if (!find_value(r, property->item))
        return false;
    const char *at = r->text.at;
    if (!tf_number_read(&at, value) || !tf_ends_word(*at, " \t\r\n"))
        *value = NAN;
    return skip_value(r, property->item);
}

//: Read an index
/// An integer that is not below `least`.
static bool read_index(reader *r, const ply_type *type, int least, int *index)
{
    long at = place(r);
    double number;
    if (!read_number(r, type, &number))
        return false;
    if (!(number >= least && number <= INT_MAX && number == floor(number)))
        return tf_mesh_file_fault(
            r->file, at,
            "%.17g is not an index or a length; write an integer from 0",
            number);
    *index = (int)number;
    return true;
}

//: Read a list
/// -1 ends a strip within a list of them.
static bool add_corner(reader *r, int to, const ply_type *type)
{
    int vertex = 0;
    const char *at = r->text.at;
    return read_index(r, type, to == STRIPS ? -1 : 0, &vertex) &&
           keep_corner(r, type, vertex, at) &&
           (tf_ints_add(&r->corner, 1, &vertex) ||
            tf_mesh_file_fault_in_memory(r->file));
}

/// Reads corners, or skips another list.
static bool read_list(reader *r, int to, const ply_property *property)
{
    long at = place(r);
    int length = 0;
    if (!read_index(r, property->length, 0, &length) ||
        (property->role != NONE && to == FACES &&
         !tf_mesh_file_check_corners(r->file, length, at)))
        return false;
    for (int i = 0; i < length; i++)
        if (property->role != NONE ? !add_corner(r, to, property->item)
                                   : !skip_value(r, property->item))
            return false;
    return true;
}

//: Read an item of an element
/// What an item gives to the mesh.
typedef struct item {
    double x[3];
    const char *at[3]; ///< where these begin
    int vertex[2];     ///< of an edge
} item;

/// A z that is not there would follow y.
static bool read_coordinate(reader *r, const ply_property *property, item *made)
{
    int k = property->role;
    long at = place(r);
    if (!find_value(r, property->item))
        return false;
    made->at[k] = r->text.at;
    if (!read_number(r, property->item, &made->x[k]))
        return false;
    if (k == 1 && r->file->source && r->file->source->lacks_z)
        made->at[2] = r->text.at;
    return (isfinite(made->x[k]) ||
            tf_mesh_file_fault(r->file, at,
                               "a coordinate is infinite or NaN; write finite "
                               "numbers"));
}

static bool read_end(reader *r, const ply_property *property, item *made)
{
    int *vertex = &made->vertex[property->role];
    const char *at = r->text.at;
    return read_index(r, property->item, 0, vertex) &&
           keep_corner(r, property->item, *vertex, at);
}

static bool read_value(reader *r, int to, const ply_property *property,
                       item *made)
{
    if (property->length)
        return read_list(r, to, property);
    if (property->role == NONE)
        return property->column == NONE ? skip_value(r, property->item)
                                        : read_column(r, property);
    return to == VERTICES ? read_coordinate(r, property, made)
                          : read_end(r, property, made);
}

static bool read_values(reader *r, const ply_element *element, item *made)
{
    for (int i = 0; i < element->properties; i++)
        if (!read_value(r, element->target, &element->property[i], made))
            return false;
    return true;
}

//: Add strips of triangles
/// Every second triangle of a strip turns the other way around.  Those with a
/// corner twice are there to join strips.
static bool add_strip(const reader *r, const int corner[], size_t corners,
                      long at)
{
    for (size_t i = 2; i < corners; i++) {
        const int *c = corner + i - 2;
        int vertex[] = {c[i % 2], c[1 - i % 2], c[2]};
        bool joins = c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
        if (!joins && !tf_mesh_file_add_triangle(r->file, vertex, at))
            return false;
    }
    return true;
}

static bool add_strips(const reader *r, long at)
{
    size_t first = 0;
    for (size_t i = 0; i <= r->corner.count; i++)
        if (i == r->corner.count || r->corner.item[i] < 0) {
            if (i - first > 2 &&
                !add_strip(r, r->corner.item + first, i - first, at))
                return false;
            first = i + 1;
        }
    return true;
}

//: Add what a face has
static bool add_face_row(const reader *r)
{
    tf_face_attributes *faces = r->file->source ? r->file->source->faces : NULL;
    return !faces || tf_columns_add(&faces->row, r->value) ||
           tf_mesh_file_fault_in_memory(r->file);
}

/// The triangles of strips have no rows; where there are some, no face has one.
static void drop_rows(const reader *r)
{
    if (r->file->source && r->file->source->faces && has_any(r, STRIPS))
        tf_columns_free(&r->file->source->faces->row);
}

//: Add an item to the mesh
static bool add_item(const reader *r, int to, const item *made, long at)
{
    switch (to) {
    case VERTICES:
        return tf_mesh_file_add_point(r->file, tf_mesh_file_vertices(r->file),
                                      r->start, made->at) &&
               tf_mesh_file_add_vertex(r->file, made->x, at) &&
               tf_mesh_file_add_row(r->file, r->value);
    case FACES:
        return add_face_row(r) &&
               tf_mesh_file_add_face(r->file, r->corner.item,
                                     (int)r->corner.count, at);
    case STRIPS:
        return add_strips(r, at);
    case EDGES:
        return tf_mesh_file_add_edge(r->file, made->vertex, at);
    default:
        return true;
    }
}

static bool end_item(reader *r)
{
    tf_text *text = &r->text;
    if (!is_text(r))
        return true;
    tf_text_skip_blanks(text);
    return *text->at == '\n' || text->at == r->end ||
           tf_text_fault_in_word(text, text->at, strcspn(text->at, " \t\r\n"),
                                 "more than the header declares for an "
                                 "element; begin each element on a new line");
}

static bool read_item(reader *r, const ply_element *element)
{
    item made = {0};
    r->corner.count = 0;
    if (is_text(r))
        skip_blank_lines(&r->text);
    long at = place(r);
    size_t part = tf_mesh_file_parts(r->file);
    if (!keep_row(r, element) || !read_values(r, element, &made) ||
        !end_item(r))
        return false;
    bool lines = is_text(r) && r->text.at < r->end;
    tf_mesh_file_end_part(r->file, part, r->start, r->text.at + lines);
    return add_item(r, element->target, &made, at);
}

//: Read what follows the header
static bool read_items(reader *r)
{
    for (const ply_element *e = r->element; e < r->element + r->elements; e++)
        for (int i = 0; e->properties > 0 && i < e->count; i++)
            if (!read_item(r, e))
                return false;
    if (is_text(r))
        skip_blank_lines(&r->text);
    return r->text.at == r->end ||
           tf_mesh_file_fault(r->file, place(r),
                              "more follows than the header declares; correct "
                              "the numbers of elements");
}

//: Read PLY
bool tf_is_ply(const char *text, size_t size)
{
    const char *at = tf_text_begin(text);
    return size >= 4 && strncmp(at, "ply", 3) == 0 &&
           (at[3] == '\n' || at[3] == '\r');
}

bool tf_ply_parse(tf_mesh_file *file, const char *text, size_t size)
{
    reader r = {.text = {.name = file->name,
                         .at = tf_text_begin(text),
                         .line = 1,
                         .fault = file->fault},
                .start = text,
                .end = text + size,
                .file = file};
    bool good = read_header(&r);
    file->counts_bytes = good && !is_text(&r);
    good = good && read_items(&r);
    drop_rows(&r);
    free(r.corner.item);
    return good;
}

//: Include what OBJ files need
#include "formats/obj_file.h"

#include "files/number.h"
#include "files/text.h"
#include "formats/face_attributes.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

//: Walk through the text
typedef struct reader {
    tf_text text;
    const char *start;
    tf_mesh_file *file;
    tf_ints corner; ///< of a face
    int texture;    ///< the row of the last corner that was read, or -1
    tf_face_attributes *faces;            ///< to be filled, or NULL
    tf_excerpt heading[TF_HEADING_LINES]; ///< the last lines of each kind
    bool is_new_heading;                  ///< whether they are not yet kept
    double heading_number;
} reader;

/// Steps over blanks, and over the end of a line that a backslash continues.
static void skip_blanks(tf_text *text)
{
    for (;;) {
        tf_text_skip_blanks(text);
        size_t end = text->at[0] != '\\' ? 0 : 1 + (text->at[1] == '\r');
        if (end == 0 || text->at[end] != '\n')
            return;
        text->at += end + 1;
        text->line++;
    }
}

static bool ends_word(char c)
{
    return tf_ends_word(c, " \t\r\n\\#");
}

/// Finds the next word of the line; false at its end.
static bool find_word(reader *r)
{
    skip_blanks(&r->text);
    return !tf_ends_word(*r->text.at, "\n#");
}

//: Describe what is wrong with a line
static bool fault_in_word(const reader *r, const char *word,
                          const char *verdict)
{
    return tf_text_fault_in_word(&r->text, word, strcspn(word, " \t\r\n"),
                                 verdict);
}

static bool fault_in_end(const reader *r, const char *wanted)
{
    return tf_text_fault(&r->text, "the line ends too early; %s", wanted);
}

//: Read the color of a vertex
/// Begins the columns of colors; the vertices before are white.
static bool begin_colors(const tf_mesh_file *file)
{
    static const char *const names[] = {"red", "green", "blue"};
    static const double white[] = {1, 1, 1};
    tf_columns *columns = file->columns;
    columns->count = 3;
    for (int i = 0; i < 3; i++) {
        columns->column[i] = (tf_column){.type = TF_DOUBLE, .after = 3};
        strcpy(columns->column[i].name, names[i]);
    }
    for (int v = tf_mesh_file_vertices(file); v > 1; v--)
        if (!tf_columns_add(columns, white))
            return tf_mesh_file_fault_in_memory(file);
    return true;
}

/// Of the last vertex: after its position, if there are six numbers.
static bool add_color(tf_mesh_file *file, int count, const double number[6])
{
    static const double white[] = {1, 1, 1};
    const tf_columns *columns = file->columns;
    if (!columns || (count != 6 && columns->count == 0))
        return true;
    return (columns->count > 0 || begin_colors(file)) &&
           tf_mesh_file_add_row(file, count == 6 ? number + 3 : white);
}

//: Read a vertex
/// What follows the first three numbers may be a color, or a weight, which does
/// not count.
static bool read_vertex(reader *r)
{
    double x[6] = {0}, extra;
    const char *at[4] = {0}; // where each begins, the third where y ends
    long place = r->text.line;
    int count = 0;
    for (; find_word(r); count++) {
        at[count < 3 ? count : 3] = r->text.at;
        if (!tf_text_read_number(&r->text, " \t\r\n\\#",
                                 count < 6 ? &x[count] : &extra))
            return false;
        at[count == 1 ? 2 : 3] = r->text.at;
    }
    if (count < 2)
        return fault_in_end(r, "a vertex is v x y z");
    if (count == 2 && r->file->flat_place == 0)
        r->file->flat_place = place;
    return tf_mesh_file_add_point(r->file, tf_mesh_file_vertices(r->file),
                                  r->start, at) &&
           tf_mesh_file_add_vertex(r->file, x, place) &&
           add_color(r->file, count, x);
}

//: Read the index of a corner
/// Reads an integer that an int holds.
static bool read_index(const char **at, int64_t *index)
{
    return tf_integer_read(at, index) && llabs(*index) <= INT_MAX;
}

/// Reads the indices of a texture, or 0, and steps over that of a normal; either
/// may be left out.
static bool read_other_indices(const char **at, int64_t *texture)
{
    int64_t number[2] = {0};
    for (int i = 0; i < 2 && **at == '/'; i++) {
        ++*at;
        bool left_out = **at == '/' || ends_word(**at);
        if (!left_out && !read_index(at, &number[i]))
            return false;
    }
    *texture = number[0];
    return ends_word(**at);
}

/// Those of textures count like those of vertices.
static bool find_texture(reader *r, int64_t number, const char *word)
{
    int64_t rows = r->faces ? (int64_t)r->faces->texture.rows : 0;
    if (r->faces && number < -rows)
        return fault_in_word(r, word,
                             "before the first texture coordinates; -1 is the "
                             "last vt above this line");
    r->texture = (int)(number > 0   ? number - 1
                       : number < 0 ? rows + number
                                    : -1);
    return true;
}

/// Negative numbers count back from the last vertex so far.
static bool read_corner(reader *r, int *vertex)
{
    const char *word = r->text.at;
    int64_t number = 0, vertices = tf_mesh_file_vertices(r->file), texture = 0;
    bool good = read_index(&r->text.at, &number);
    const char *end = r->text.at;
    if (!good || !read_other_indices(&r->text.at, &texture) || number == 0)
        return fault_in_word(r, word,
                             "not a corner; write the number of a vertex, from "
                             "1, or vertex/texture/normal");
    if (number < -vertices)
        return fault_in_word(
            r, word,
            "before the first vertex; -1 is the last vertex above this line");
    *vertex = (int)(number > 0 ? number - 1 : vertices + number);
    return find_texture(r, texture, word) &&
           tf_mesh_file_add_part(r->file, TF_CORNER_PART, *vertex, r->start,
                                 word, end);
}

//: Keep what faces have besides corners
static bool same_excerpts(const reader *r, const tf_excerpt *one,
                          const tf_excerpt *other)
{
    for (int i = 0; i < TF_HEADING_LINES; i++)
        if (one[i].length != other[i].length ||
            memcmp(r->start + one[i].at, r->start + other[i].at,
                   one[i].length) != 0)
            return false;
    return true;
}

/// Finds the number of the heading by now, which may have been there before.
static bool number_heading(reader *r)
{
    tf_excerpts *all = &r->faces->heading;
    size_t count = all->count / TF_HEADING_LINES, i = 0;
    while (i < count &&
           !same_excerpts(r, all->item + i * TF_HEADING_LINES, r->heading))
        i++;
    for (int k = 0; k < TF_HEADING_LINES && i == count; k++)
        if (!tf_excerpts_add(all, &r->heading[k]))
            return tf_mesh_file_fault_in_memory(r->file);
    r->heading_number = (double)i;
    r->is_new_heading = false;
    return true;
}

static bool keep_face(reader *r)
{
    if (!r->faces)
        return true;
    if (r->is_new_heading && !number_heading(r))
        return false;
    return tf_columns_add(&r->faces->row, &r->heading_number) ||
           tf_mesh_file_fault_in_memory(r->file);
}

static bool keep_texture(const reader *r)
{
    return !r->faces || tf_ints_add(&r->faces->corner, 1, &r->texture) ||
           tf_mesh_file_fault_in_memory(r->file);
}

/// When all of them are known.
static bool check_textures(const reader *r)
{
    const int *corner = r->faces ? r->faces->corner.item : NULL;
    size_t rows = r->faces ? r->faces->texture.rows : 0;
    for (tf_face face = {0}; corner && tf_mesh_file_next_face(r->file, &face);)
        for (int i = 0; i < face.corners; i++, corner++)
            if (*corner >= 0 && (size_t)*corner >= rows)
                return tf_mesh_file_fault(
                    r->file, r->file->triangle_place.item[face.triangle],
                    "there are no texture coordinates %lld; the last vt of the "
                    "file is %zu",
                    *corner + 1LL, rows);
    return true;
}

//: Read a face
static bool read_face(reader *r)
{
    long place = r->text.line;
    for (r->corner.count = 0; find_word(r);) {
        int vertex;
        if (!read_corner(r, &vertex) || !keep_texture(r))
            return false;
        if (!tf_ints_add(&r->corner, 1, &vertex))
            return tf_mesh_file_fault_in_memory(r->file);
    }
    if (r->corner.count < 3)
        return fault_in_end(r, "a face has three corners or more");
    return keep_face(r) && tf_mesh_file_add_face(r->file, r->corner.item,
                                                 (int)r->corner.count, place);
}

//: Read a line of edges
static bool read_edges(reader *r)
{
    int corner[2] = {0};
    int count = 0;
    long place = r->text.line;
    for (; find_word(r); count++) {
        corner[0] = corner[1];
        if (!read_corner(r, &corner[1]) ||
            (count > 0 && !tf_mesh_file_add_edge(r->file, corner, place)))
            return false;
    }
    return count >= 2 || fault_in_end(r, "an l line has two corners or more");
}

//: Keep what is skipped
/// Points have vertices, of which only a source knows.  What is wrong with them
/// is no fault.
static bool keep_points(reader *r)
{
    tf_text before = r->text;
    int vertex;
    tf_fault unused, *fault = r->file->fault;
    bool good = true;
    r->text.fault = r->file->fault = &unused;
    while (good && find_word(r))
        good = read_corner(r, &vertex);
    r->text.fault = r->file->fault = fault;
    if (!good) {
        tf_mesh_file_drop_parts(r->file);
        r->text = before;
    }
    return true;
}

/// Curves and surfaces have vertices, too, in ways that no one else reads.
static bool drop_parts(reader *r)
{
    tf_mesh_file_drop_parts(r->file);
    return true;
}

//: Keep texture coordinates
static bool add_texture(reader *r, const double x[3], int axes)
{
    tf_face_attributes *faces = r->faces;
    faces->texture.count = 3;
    faces->texture_axes =
        axes > faces->texture_axes ? axes : faces->texture_axes;
    for (int i = 0; i < 3; i++)
        faces->texture.column[i].type = TF_DOUBLE;
    return tf_columns_add(&faces->texture, x) ||
           tf_mesh_file_fault_in_memory(r->file);
}

static bool read_texture(reader *r)
{
    double x[3] = {0};
    int axes = 0;
    if (!r->faces)
        return true;
    for (r->text.at += strlen("vt"); axes < 3 && find_word(r); axes++)
        if (!tf_text_read_number(&r->text, " \t\r\n\\#", &x[axes]))
            return false;
    return axes > 0 ? add_texture(r, x, axes)
                    : fault_in_end(r, "texture coordinates are vt u v");
}

//: Keep headings
/// The rest of a line, without blanks at its end.
static tf_excerpt line_at(const reader *r)
{
    size_t length = strcspn(r->text.at, "\n");
    while (length > 0 && tf_ends_word(r->text.at[length - 1], " \t\r"))
        length--;
    return (tf_excerpt){(size_t)(r->text.at - r->start), length};
}

static bool change_heading(reader *r, tf_heading_line line)
{
    r->heading[line] = line_at(r);
    r->is_new_heading = true;
    return true;
}

static bool keep_object(reader *r)
{
    return change_heading(r, TF_OBJECT_LINE);
}

static bool keep_group(reader *r)
{
    return change_heading(r, TF_GROUP_LINE);
}

static bool keep_material(reader *r)
{
    return change_heading(r, TF_MATERIAL_LINE);
}

static bool keep_library(reader *r)
{
    tf_excerpt line = line_at(r);
    return !r->faces || tf_excerpts_add(&r->faces->library, &line) ||
           tf_mesh_file_fault_in_memory(r->file);
}

//: Keep other lines
static bool keep_others(reader *r)
{
    static const struct {
        const char *word;
        bool (*keep)(reader *r);
    } others[] = {{"curv", drop_parts},      {"curv2", drop_parts},
                  {"surf", drop_parts},      {"vt", read_texture},
                  {"o", keep_object},        {"g", keep_group},
                  {"usemtl", keep_material}, {"mtllib", keep_library}};
    size_t length = strcspn(r->text.at, " \t\r\n\\#");
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (strlen(others[i].word) == length &&
            memcmp(others[i].word, r->text.at, length) == 0)
            return others[i].keep(r);
    return true;
}

//: Read a line of OBJ
typedef struct line_kind {
    char word; ///< 0: any other
    tf_part_kind part;
    bool (*read)(reader *r);
} line_kind;

static const line_kind *kind_of_line(const reader *r)
{
    static const line_kind kinds[] = {{'v', TF_VERTEX_PART, read_vertex},
                                      {'f', TF_FACE_PART, read_face},
                                      {'l', TF_EDGE_PART, read_edges},
                                      {'p', TF_POINT_PART, keep_points},
                                      {'\0', TF_POINT_PART, NULL}};
    char word = ends_word(r->text.at[0]) || !ends_word(r->text.at[1])
                    ? '\0'
                    : r->text.at[0];
    const line_kind *kind = kinds;
    while (kind->word && kind->word != word)
        kind++;
    return kind;
}

/// By its first word; `row` is where it begins.
static bool read_content(reader *r, const char *row)
{
    const line_kind *kind = kind_of_line(r);
    if (!kind->word)
        return keep_others(r);
    r->text.at++;
    return tf_mesh_file_add_part(r->file, kind->part, -1, r->start, row, row) &&
           kind->read(r);
}

static bool read_line(reader *r)
{
    tf_text *text = &r->text;
    const char *row = text->at;
    size_t part = tf_mesh_file_parts(r->file);
    skip_blanks(text);
    if (!read_content(r, row))
        return false;
    text->at += strcspn(text->at, "\n");
    if (*text->at == '\n') {
        text->at++;
        text->line++;
    }
    tf_mesh_file_end_part(r->file, part, r->start, text->at);
    return true;
}

//: Read OBJ
static bool read_lines(reader *r)
{
    while (*r->text.at)
        if (!read_line(r))
            return false;
    return true;
}

bool tf_obj_parse(tf_mesh_file *file, const char *text, size_t size)
{
    reader r = {.text = {.name = file->name,
                         .at = tf_text_begin(text),
                         .line = 1,
                         .fault = file->fault},
                .start = text,
                .file = file,
                .faces = file->source ? file->source->faces : NULL,
                .is_new_heading = true};
    file->first_index = 1;
    if (r.faces)
        r.faces->row.count = 1;
    bool good = read_lines(&r) &&
                (r.text.at == text + size || tf_text_fault_in_nul(&r.text)) &&
                check_textures(&r);
    free(r.corner.item);
    return good;
}

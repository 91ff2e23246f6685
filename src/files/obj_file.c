//: Include what OBJ files need
#include "files/obj_file.h"

#include "files/number.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

//: Walk through the text
typedef struct reader {
    tf_mesh_file *file;
    const char *at; ///< in the text
    long line;
} reader;

/// Steps over blanks, and over the end of a line that a backslash continues.
static void skip_blanks(reader *r)
{
    for (;;) {
        while (*r->at == ' ' || *r->at == '\t' || *r->at == '\r')
            r->at++;
        size_t end = r->at[0] != '\\' ? 0 : 1 + (r->at[1] == '\r');
        if (end == 0 || r->at[end] != '\n')
            return;
        r->at += end + 1;
        r->line++;
    }
}

static bool ends_line(char c)
{
    return c == '\n' || c == '\0' || c == '#';
}

static bool ends_word(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\\' || ends_line(c);
}

//: Describe what is wrong with a line
static bool fault_in_word(reader *r, const char *word, const char *verdict)
{
    return tf_mesh_file_fault_in_word(r->file, r->line, word, verdict);
}

static bool fault_in_end(reader *r, const char *wanted)
{
    return tf_mesh_file_fault(r->file, r->line, "the line ends too early; %s",
                              wanted);
}

//: Read a coordinate
static bool read_coordinate(reader *r, double *x)
{
    const char *word = r->at;
    if (!tf_number_read(&r->at, x) || !ends_word(*r->at))
        return fault_in_word(
            r, word,
            "not a finite number; write a decimal or a hexadecimal float");
    return isfinite(*x) ||
           fault_in_word(r, word,
                         "beyond the largest double; scale the scene down");
}

//: Read a vertex
/// What follows the first three numbers, a weight or a color, does not count.
static bool read_vertex(reader *r)
{
    double x[3] = {0}, extra;
    long place = r->line;
    int count = 0;
    for (skip_blanks(r); !ends_line(*r->at); skip_blanks(r), count++)
        if (!read_coordinate(r, count < 3 ? &x[count] : &extra))
            return false;
    if (count < 2)
        return fault_in_end(r, "a vertex is v x y z");
    if (count == 2 && r->file->flat_place == 0)
        r->file->flat_place = place;
    return tf_mesh_file_add_vertex(r->file, x, place);
}

//: Read the index of a corner
/// Reads the integer that starts here; false if there is none, or its size is
/// beyond that of an int.
static bool read_integer(const char **at, int64_t *number)
{
    bool negative = **at == '-';
    const char *first = *at + (negative || **at == '+'), *digit = first;
    int64_t size = 0;
    for (; *digit >= '0' && *digit <= '9' && size <= INT_MAX; digit++)
        size = 10 * size + (*digit - '0');
    *number = negative ? -size : size;
    *at = digit;
    return digit > first && size <= INT_MAX;
}

/// Steps over the indices of a texture and a normal, either of which may be
/// left out.
static bool skip_other_indices(const char **at)
{
    int64_t unused;
    for (int i = 0; i < 2 && **at == '/'; i++) {
        ++*at;
        bool left_out = **at == '/' || ends_word(**at);
        if (!left_out && !read_integer(at, &unused))
            return false;
    }
    return ends_word(**at);
}

/// Negative numbers count back from the last vertex so far.
static bool read_corner(reader *r, int *vertex)
{
    const char *word = r->at;
    int64_t number, vertices = tf_mesh_file_vertices(r->file);
    if (!read_integer(&r->at, &number) || !skip_other_indices(&r->at) ||
        number == 0)
        return fault_in_word(r, word,
                             "not a corner; write the number of a vertex, from "
                             "1, or vertex/texture/normal");
    if (number < -vertices)
        return fault_in_word(
            r, word,
            "before the first vertex; -1 is the last vertex above this line");
    *vertex = (int)(number > 0 ? number - 1 : vertices + number);
    return true;
}

//: Read a face
static bool read_face(reader *r)
{
    int corner[3];
    int count = 0;
    long place = r->line;
    for (skip_blanks(r); !ends_line(*r->at); skip_blanks(r), count++) {
        if (count == 3)
            return tf_mesh_file_fault(
                r->file, r->line,
                "a face with more than three corners; triangulate the mesh, "
                "for instance by Blender's export option Triangulated Mesh");
        if (!read_corner(r, &corner[count]))
            return false;
    }
    if (count < 3)
        return fault_in_end(r, "a face has three corners");
    return tf_mesh_file_add_triangle(r->file, corner, place);
}

//: Read a line of edges
static bool read_edges(reader *r)
{
    int corner[2] = {0};
    int count = 0;
    long place = r->line;
    for (skip_blanks(r); !ends_line(*r->at); skip_blanks(r), count++) {
        corner[0] = corner[1];
        if (!read_corner(r, &corner[1]) ||
            (count > 0 && !tf_mesh_file_add_edge(r->file, corner, place)))
            return false;
    }
    return count >= 2 || fault_in_end(r, "an l line has two corners or more");
}

//: Read a line of OBJ
typedef bool line_reader(reader *r);

static bool skip_line(reader *r)
{
    (void)r;
    return true;
}

/// What reads a line, by its first word.
static line_reader *reader_of(const char *word)
{
    if (word[0] == '\0' || !ends_word(word[1]))
        return skip_line;
    return word[0] == 'v'   ? read_vertex
           : word[0] == 'f' ? read_face
           : word[0] == 'l' ? read_edges
                            : skip_line;
}

static bool read_line(reader *r)
{
    skip_blanks(r);
    line_reader *read_rest = reader_of(r->at);
    r->at += read_rest != skip_line;
    if (!read_rest(r))
        return false;
    r->at += strcspn(r->at, "\n");
    if (*r->at == '\n') {
        r->at++;
        r->line++;
    }
    return true;
}

//: Read OBJ
bool tf_obj_parse(tf_mesh_file *file, const char *text, size_t size)
{
    bool marked = strncmp(text, "\xEF\xBB\xBF", 3) == 0;
    reader r = {file, text + (marked ? 3 : 0), 1};
    file->first_index = 1;
    while (*r.at)
        if (!read_line(&r))
            return false;
    // What ends a text that goes on is a NUL byte.
    return r.at == text + size || fault_in_word(&r, r.at, "");
}

//: Include what files of masses need
#include "files/masses.h"

#include "files/number.h"
#include "files/text_lines.h"

#include <math.h>
#include <string.h>

//: Read the words of all lines
/// A list that is being read.
typedef struct list {
    tf_text_lines lines;
    int vertices;
    int count;        ///< of words so far
    double *number;   ///< of each vertex
    const char *name; ///< of such numbers
} list;

/// Reads the word that begins here, and steps behind it.
typedef bool word_reader(list *read, tf_text *text);

static bool ends_word(char c)
{
    return tf_ends_word(c, " \t#");
}

static bool fault_in_word(const tf_text *text, const char *verdict)
{
    return tf_text_fault_in_word(text, text->at, strcspn(text->at, " \t#"),
                                 verdict);
}

static bool read_line(list *read, word_reader *read_word)
{
    tf_text *text = &read->lines.text;
    for (; !tf_ends_word(*text->at, "#"); tf_text_skip_blanks(text)) {
        if (!read_word(read, text))
            return false;
        read->count++;
    }
    return true;
}

/// Reads the file, and returns how many words it has; -1: there is a fault.
static int read_words(list *read, const char *path, tf_fault *fault,
                      word_reader *read_word)
{
    tf_reading reading = tf_text_lines_open(&read->lines, path, fault)
                             ? tf_text_lines_next(&read->lines)
                             : TF_READ_FAULT;
    while (reading == TF_READ_GOOD)
        reading = read_line(read, read_word) ? tf_text_lines_next(&read->lines)
                                             : TF_READ_FAULT;
    tf_text_lines_close(&read->lines);
    return reading == TF_READ_END ? read->count : -1;
}

//: Read a number for each vertex
/// Takes the number of the next vertex.
static bool take_number(list *read, tf_text *text, double number,
                        const char *end)
{
    if (read->count == read->vertices)
        return tf_text_fault(text,
                             "more %s than the %d vertices; write one for each",
                             read->name, read->vertices);
    read->number[read->count] = number;
    text->at = end;
    return true;
}

static bool read_numbers(list *read, const char *path, tf_fault *fault,
                         word_reader *read_word)
{
    int count = read_words(read, path, fault, read_word);
    return count == read->vertices ||
           (count >= 0 &&
            tf_fault_set(fault,
                         strcmp(path, "-") == 0 ? "standard input" : path, -1,
                         "the number of %s is %d, but there are %d "
                         "vertices; write one for each, in their order",
                         read->name, count, read->vertices));
}

//: Read masses
/// The inverse has to be a number, too.
static bool read_mass(list *read, tf_text *text)
{
    const char *at = text->at;
    double mass;
    if (!tf_number_read(&at, &mass) || !ends_word(*at) || !(mass > 0) ||
        !isfinite(mass) || !isfinite(1 / mass))
        return fault_in_word(text,
                             "not a mass; write a number above 0 such as 0.5");
    return take_number(read, text, 1 / mass, at);
}

bool tf_masses_read(const char *path, int vertices, double inverse_mass[],
                    tf_fault *fault)
{
    list read = {
        .vertices = vertices, .number = inverse_mass, .name = "masses"};
    return read_numbers(&read, path, fault, read_mass);
}

//: Read friction
static bool read_coefficient(list *read, tf_text *text)
{
    const char *at = text->at;
    double friction;
    if (!tf_number_read(&at, &friction) || !ends_word(*at) ||
        !(friction >= 0) || !isfinite(friction))
        return fault_in_word(text, "not a coefficient of friction; write a "
                                   "number from 0 on such as 0.5");
    return take_number(read, text, friction, at);
}

bool tf_friction_read(const char *path, int vertices, double friction[],
                      tf_fault *fault)
{
    list read = {.vertices = vertices,
                 .number = friction,
                 .name = "coefficients of friction"};
    return read_numbers(&read, path, fault, read_coefficient);
}

//: Read lengths
static bool read_length(list *read, tf_text *text)
{
    const char *at = text->at;
    double length;
    if (!tf_number_read(&at, &length) || !ends_word(*at) || !(length > 0) ||
        !isfinite(length))
        return fault_in_word(
            text, "not a length; write a number above 0 such as 0.5");
    return take_number(read, text, length, at);
}

bool tf_lengths_read(const char *path, int vertices, double length[],
                     tf_fault *fault)
{
    list read = {.vertices = vertices, .number = length, .name = "lengths"};
    return read_numbers(&read, path, fault, read_length);
}

//: Read scripted vertices
bool tf_vertex_read(tf_text *text, int vertices, int *vertex)
{
    const char *at = text->at;
    int64_t number;
    if (*at == '-' || *at == '+' || !tf_integer_read(&at, &number) ||
        !ends_word(*at))
        return fault_in_word(text, "not a vertex; write its number, from 0");
    if (number >= vertices)
        return tf_text_fault(
            text, "there is no vertex %s; they are numbered from 0 to %d",
            tf_quote(text->at, (size_t)(at - text->at)).text, vertices - 1);
    *vertex = (int)number;
    text->at = at;
    return true;
}

static bool read_vertex(list *read, tf_text *text)
{
    int vertex = 0;
    if (!tf_vertex_read(text, read->vertices, &vertex))
        return false;
    read->number[vertex] = 0;
    return true;
}

bool tf_fixed_read(const char *path, int vertices, double inverse_mass[],
                   tf_fault *fault)
{
    list read = {.vertices = vertices, .number = inverse_mass};
    return read_words(&read, path, fault, read_vertex) >= 0;
}

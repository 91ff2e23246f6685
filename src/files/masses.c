//: Include what files of masses need
#include "files/masses.h"

#include "files/number.h"
#include "files/visible.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

//: Describe what is wrong with a mass or a vertex
static bool fault_in_word(tf_text_lines *lines, const char *verdict)
{
    size_t length = strcspn(lines->at, " \t#");
    return tf_text_lines_fault(lines, lines->line, "\"%s\" is %s",
                               tf_quote(lines->at, length).text, verdict);
}

static bool ends_word(char c)
{
    return c == ' ' || c == '\t' || c == '#' || c == '\0';
}

//: Read the words of all lines
/// A list that is being read.
typedef struct list {
    tf_text_lines *lines;
    int vertices;
    int count; ///< of words so far
    double *inverse_mass;
} list;

/// Reads the word that begins here, and steps behind it.
typedef bool word_reader(list *read);

static bool read_line(list *read, word_reader *read_word)
{
    tf_text_lines *lines = read->lines;
    while (*lines->at != '\0' && *lines->at != '#') {
        if (!read_word(read))
            return false;
        read->count++;
        tf_text_lines_skip_blanks(lines);
    }
    return true;
}

static bool read_words(list *read, const char *path, word_reader *read_word)
{
    if (!tf_text_lines_open(read->lines, path))
        return false;
    tf_reading reading;
    while ((reading = tf_text_lines_next(read->lines)) == TF_READ_GOOD)
        if (!read_line(read, read_word))
            return false;
    return reading == TF_READ_END;
}

//: Read masses
/// The inverse has to be a number, too.
static bool read_mass(list *read)
{
    tf_text_lines *lines = read->lines;
    const char *at = lines->at;
    double mass;
    if (!tf_number_read(&at, &mass) || !ends_word(*at) || !(mass > 0) ||
        !isfinite(mass) || !isfinite(1 / mass))
        return fault_in_word(lines,
                             "not a mass; write a positive number such as 0.5");
    if (read->count == read->vertices)
        return tf_text_lines_fault(
            lines, lines->line,
            "more masses than the %d vertices; write one for each",
            read->vertices);
    read->inverse_mass[read->count] = 1 / mass;
    lines->at = at;
    return true;
}

bool tf_masses_read(tf_text_lines *lines, const char *path, int vertices,
                    double inverse_mass[])
{
    list read = {lines, vertices, 0, inverse_mass};
    return read_words(&read, path, read_mass) &&
           (read.count == vertices ||
            tf_text_lines_fault(lines, 0,
                                "the number of masses is %d, but there are %d "
                                "vertices; write one for each, in their order",
                                read.count, vertices));
}

//: Read scripted vertices
static bool read_vertex(list *read)
{
    tf_text_lines *lines = read->lines;
    const char *at = lines->at;
    int64_t vertex = 0;
    for (; *at >= '0' && *at <= '9'; at++)
        if (vertex < read->vertices)
            vertex = 10 * vertex + (*at - '0');
    if (at == lines->at || !ends_word(*at))
        return fault_in_word(lines, "not a vertex; write its number, from 0");
    if (vertex >= read->vertices)
        return tf_text_lines_fault(
            lines, lines->line,
            "there is no vertex %s; they are numbered from 0 to %d",
            tf_quote(lines->at, (size_t)(at - lines->at)).text,
            read->vertices - 1);
    read->inverse_mass[vertex] = 0;
    lines->at = at;
    return true;
}

bool tf_fixed_read(tf_text_lines *lines, const char *path, int vertices,
                   double inverse_mass[])
{
    list read = {lines, vertices, 0, inverse_mass};
    return read_words(&read, path, read_vertex);
}

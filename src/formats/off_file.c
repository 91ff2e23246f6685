//: Include what OFF files need
#include "formats/off_file.h"

#include "formats/words.h"

#include <stdlib.h>
#include <string.h>

//: Recognize OFF
/// Begins behind blank lines and comments.
static tf_words begin(tf_mesh_file *file, const char *text, size_t size)
{
    tf_words words = tf_words_of(file, text, size);
    words.has_comments = true;
    tf_words_find(&words);
    return words;
}

/// Where the word OFF ends, after the letters of its beginning; or NULL.  In
/// some files the first number follows without a blank.
static const char *find_end(const char *at)
{
    static const char *const letters[] = {"ST", "C", "N", "4", "n"};
    for (int i = 0; i < 5; i++)
        if (strncmp(at, letters[i], strlen(letters[i])) == 0)
            at += strlen(letters[i]);
    bool found =
        strncmp(at, "OFF", 3) == 0 && tf_ends_word(at[3], " \t\r\n#0123456789");
    return found ? at + 3 : NULL;
}

bool tf_is_off(const char *text, size_t size)
{
    return find_end(begin(&(tf_mesh_file){0}, text, size).text.at);
}

bool tf_is_nameless_off(const char *text, size_t size)
{
    char first = *begin(&(tf_mesh_file){0}, text, size).text.at;
    return first >= '0' && first <= '9';
}

//: Read the header of OFF
/// How many of each there are.
typedef struct counts {
    int vertices, faces;
} counts;

/// Steps over the word OFF, if it is there.
static bool take_word(tf_words *words)
{
    const char *first = words->text.at, *end = find_end(first);
    if (!end)
        return true;
    if (memchr(first, '4', (size_t)(end - first)) ||
        memchr(first, 'n', (size_t)(end - first)))
        return tf_words_fault(words, "OFF with other coordinates than three; "
                                     "export the mesh with three");
    words->text.at = end;
    return !tf_words_take(words, "BINARY") ||
           tf_text_fault(&words->text,
                         "this is binary OFF; save the mesh as text");
}

static bool read_counts(tf_words *words, counts *made)
{
    bool good = take_word(words) &&
                tf_words_read_integer(words, 0, &made->vertices) &&
                tf_words_read_integer(words, 0, &made->faces);
    tf_words_skip_line(words);
    return good;
}

//: Read the vertices of OFF
static bool read_vertices(tf_words *words, int count)
{
    for (int i = 0; i < count; i++) {
        double x[3];
        const char *at[3];
        if (!tf_words_need(words))
            return false;
        long place = words->text.line;
        if (!tf_words_read_position(words, x, at) ||
            !tf_mesh_file_add_point(words->file, i, words->start, at) ||
            !tf_mesh_file_add_vertex(words->file, x, place))
            return false;
        tf_words_skip_line(words);
    }
    return true;
}

//: Read the faces of OFF
static bool read_corners(tf_words *words, tf_ints *corner, long place)
{
    int count;
    corner->count = 0;
    if (!tf_words_read_integer(words, 0, &count) ||
        !tf_mesh_file_check_corners(words->file, count, place))
        return false;
    for (int i = 0; i < count; i++) {
        int vertex;
        if (!tf_words_read_integer(words, 0, &vertex))
            return false;
        if (!tf_ints_add(corner, 1, &vertex))
            return tf_mesh_file_fault_in_memory(words->file);
    }
    return true;
}

static bool read_faces(tf_words *words, int count, tf_ints *corner)
{
    for (int i = 0; i < count; i++) {
        if (!tf_words_need(words))
            return false;
        long place = words->text.line;
        if (!read_corners(words, corner, place) ||
            !tf_mesh_file_add_face(words->file, corner->item,
                                   (int)corner->count, place))
            return false;
        tf_words_skip_line(words);
    }
    return true;
}

//: Read OFF
static bool check_end(tf_words *words)
{
    return !tf_words_find(words) ||
           tf_text_fault(&words->text,
                         "more follows than the header declares; correct the "
                         "numbers of vertices and faces");
}

bool tf_off_parse(tf_mesh_file *file, const char *text, size_t size)
{
    tf_words words = begin(file, text, size);
    tf_ints corner = {0};
    counts made = {0};
    file->format = TF_OFF;
    bool good = read_counts(&words, &made) &&
                read_vertices(&words, made.vertices) &&
                read_faces(&words, made.faces, &corner) && check_end(&words);
    free(corner.item);
    return good;
}

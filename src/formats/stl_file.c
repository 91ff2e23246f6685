//: Include what STL files need
#include "formats/stl_file.h"

#include "formats/binary.h"
#include "formats/welder.h"
#include "formats/words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

//: Recognize STL
enum {
    HEADER = 84, // bytes, of which the last four count the triangles
    FACET = 50,  // bytes: a normal, three corners, and two that mean nothing
    AHEAD = 400  // bytes, by which memory is fetched before its facet
};

static size_t bytes_of_facets(const char *text)
{
    return FACET * (size_t)tf_gather_bytes(text + HEADER - 4, 4, false);
}

bool tf_is_binary_stl(const char *text, size_t size)
{
    return size >= HEADER && size - HEADER == bytes_of_facets(text);
}

bool tf_is_above_binary_stl(const char *text, size_t size)
{
    return size >= HEADER && size - HEADER > bytes_of_facets(text);
}

bool tf_is_text_stl(const char *text, size_t size)
{
    tf_words words = tf_words_of(&(tf_mesh_file){0}, text, size);
    return tf_words_take(&words, "solid");
}

//: Add a facet
/// One with two corners at one position is counted alone.
static bool add_facet(tf_mesh_file *file, const int corner[3], long place)
{
    if (corner[0] == corner[1] || corner[1] == corner[2] ||
        corner[2] == corner[0]) {
        file->left_out[2]++;
        return true;
    }
    return tf_mesh_file_add_triangle(file, corner, place);
}

//: Read a facet in binary
/// The byte at which a corner begins.
static size_t corner_at(size_t facet, size_t corner)
{
    return facet + 12 + 12 * corner;
}

static void gather_corner(const char *text, size_t at, double x[3])
{
    for (size_t k = 0; k < 3; k++)
        x[k] = tf_gather_float(text + at + 4 * k, false);
}

static bool read_corner_at(tf_mesh_file *file, tf_welder *welder,
                           const char *text, size_t at, int *vertex)
{
    double x[3];
    gather_corner(text, at, x);
    for (size_t k = 0; k < 3; k++)
        if (!isfinite(x[k]))
            return tf_mesh_file_fault(file, (long)(at + 4 * k),
                                      "a coordinate is infinite or NaN; write "
                                      "finite numbers");
    return tf_welder_find(welder, file, x, (long)at, vertex) &&
           tf_mesh_file_add_point(
               file, *vertex, text,
               (const char *[]){text + at, text + at + 4, text + at + 8});
}

static bool read_facet(tf_mesh_file *file, tf_welder *welder, const char *text,
                       size_t facet)
{
    int corner[3];
    for (size_t i = 0; i < 3; i++)
        if (!read_corner_at(file, welder, text, corner_at(facet, i),
                            &corner[i]))
            return false;
    return add_facet(file, corner, (long)facet);
}

static void expect_facet(const tf_welder *welder, const char *text,
                         size_t facet)
{
    for (size_t i = 0; i < 3; i++) {
        double x[3];
        gather_corner(text, corner_at(facet, i), x);
        tf_welder_expect(welder, x);
    }
}

//: Describe the source of STL
static void describe_source(const tf_mesh_file *file)
{
    if (!file->source)
        return;
    file->source->welds = true;
    for (int k = 0; k < 3; k++)
        file->source->type[k] = TF_FLOAT;
}

//: Read STL in binary
static bool check_size(const tf_mesh_file *file, const char *text, size_t size)
{
    if (size < HEADER)
        return tf_mesh_file_fault(file, (long)size,
                                  "the file ends too early; binary STL has a "
                                  "header of %d bytes, and text begins with "
                                  "the word solid",
                                  HEADER);
    size_t facets = bytes_of_facets(text) / FACET;
    size_t wanted = HEADER + bytes_of_facets(text);
    return size == wanted ||
           tf_mesh_file_fault(
               file, HEADER - 4,
               "the file has %zu bytes, but its header declares %zu "
               "triangle%s, "
               "for which it needs %zu; it may be cut short, or have another "
               "format",
               size, facets, facets == 1 ? "" : "s", wanted);
}

bool tf_binary_stl_parse(tf_mesh_file *file, const char *text, size_t size)
{
    tf_welder welder = {0};
    file->format = TF_STL_BINARY;
    file->counts_bytes = true;
    describe_source(file);
    bool good = check_size(file, text, size);
    for (size_t at = HEADER; good && at < size; at += FACET) {
        if (size - at > AHEAD)
            expect_facet(&welder, text, at + AHEAD);
        good = read_facet(file, &welder, text, at);
    }
    tf_welder_free(&welder);
    return good;
}

//: Read a loop
/// A solid that is being read.
typedef struct solid {
    tf_words words;
    tf_welder welder;
} solid;

static bool need_word(tf_words *words, const char *word, const char *verdict)
{
    return tf_words_take(words, word) ||
           (tf_words_need(words) && tf_words_fault(words, verdict));
}

static bool read_corner(solid *s, int *vertex)
{
    double x[3];
    const char *at[3];
    if (!need_word(&s->words, "vertex",
                   "not the word vertex; a loop has three of them"))
        return false;
    long place = s->words.text.line;
    return tf_words_read_position(&s->words, x, at) &&
           tf_welder_find(&s->welder, s->words.file, x, place, vertex) &&
           tf_mesh_file_add_point(s->words.file, *vertex, s->words.start, at);
}

/// What follows the word facet, whose normal is skipped.
static bool read_loop(solid *s)
{
    tf_words *words = &s->words;
    long place = words->text.line;
    int corner[3];
    tf_words_skip_line(words);
    if (!need_word(words, "outer", "not the words outer loop; a facet has one"))
        return false;
    tf_words_skip_line(words);
    return read_corner(s, &corner[0]) && read_corner(s, &corner[1]) &&
           read_corner(s, &corner[2]) &&
           need_word(words, "endloop",
                     "not the word endloop; a loop has three vertices") &&
           need_word(words, "endfacet", "not the word endfacet; add it") &&
           add_facet(words->file, corner, place);
}

//: Read STL as text
/// What follows the word solid, up to endsolid.  Names are skipped.
static bool read_solid(solid *s)
{
    tf_words_skip_line(&s->words);
    while (tf_words_take(&s->words, "facet"))
        if (!read_loop(s))
            return false;
    bool ended = need_word(&s->words, "endsolid",
                           "not the word facet or endsolid; write one of them");
    tf_words_skip_line(&s->words);
    return ended;
}

bool tf_text_stl_parse(tf_mesh_file *file, const char *text, size_t size)
{
    solid s = {.words = tf_words_of(file, text, size)};
    s.words.early_end = "'endsolid' is missing; the file may be cut short";
    file->format = TF_STL_TEXT;
    describe_source(file);
    bool good = true;
    while (good && tf_words_find(&s.words))
        good = need_word(&s.words, "solid",
                         "not the word solid; text of STL begins with it") &&
               read_solid(&s);
    tf_welder_free(&s.welder);
    return good;
}

//: Include what describing flaws needs
#include "scenes/flaws.h"

#include "base/fail.h"
#include "base/sentence.h"

#include <stdarg.h>
#include <stdio.h>

//: Find the place of a flaw in a file
/// -1: it has none.
static long place_of(const tf_mesh_file *file, const tf_error *error)
{
    const tf_ints *places[] = {[TF_VERTEX] = &file->vertex_place,
                               [TF_EDGE] = &file->edge_place,
                               [TF_TRIANGLE] = &file->triangle_place};
    bool placed = error->subject >= TF_VERTEX && error->subject <= TF_TRIANGLE;
    return placed ? places[error->subject]->item[error->index] : -1;
}

//: Tell what else there is to do
static const char *advice(const tf_error *error)
{
    switch (error->status) {
    case TF_START_NOT_CLEAR:
    case TF_NOT_EMBEDDED:
        return ", see 'tanglefree check' for all such pairs";
    case TF_BAD_INDEX: // and not that there is no such vertex
        return error->vertex[0] >= 0 && error->vertex[0] < error->vertices
                   ? ", here and in all files"
                   : "";
    default:
        return "";
    }
}

//: Describe a flaw by its place in the file
typedef struct flaw_words {
    long place;
    char text[512];
} flaw_words;

/// The numbers of a pair are those of the rows that `check` prints.
static flaw_words words_of(const tf_mesh_file *file, const tf_error *error)
{
    flaw_words words = {.place = place_of(file, error)};
    int first = words.place < 0 ? 0 : file->first_index;
    tf_sentence_write(error, first, words.place >= 0, words.text,
                      sizeof words.text);
    return words;
}

bool tf_error_fault(const tf_mesh_file *file, const tf_error *error)
{
    flaw_words words = words_of(file, error);
    return tf_mesh_file_fault(file, words.place, "%s%s", words.text,
                              advice(error));
}

bool tf_status_fault(const tf_mesh_file *file, tf_status status)
{
    tf_error error;
    tf_fail(&error, status);
    return tf_error_fault(file, &error);
}

//: Describe a pair of elements of two files
/// An element in words, with its vertices from 0.
typedef struct element_words {
    char text[64];
} element_words;

static element_words element_of(int vertices, const int vertex[])
{
    static const char *const names[] = {"", "vertex", "edge", "triangle"};
    element_words words;
    int length = snprintf(words.text, sizeof words.text, "%s", names[vertices]);
    for (int i = 0; i < vertices; i++)
        length +=
            snprintf(words.text + length, sizeof words.text - (size_t)length,
                     " %d", vertex[i]);
    return words;
}

bool tf_pair_fault(const tf_mesh_file *file, const tf_mesh_file *other,
                   const tf_error *error)
{
    static const struct {
        int first, second; // vertices of the elements
        const char *verb;
    } forms[] = {[TF_POINT_EDGE_PAIR] = {1, 2, "lies on"},
                 [TF_POINT_TRIANGLE_PAIR] = {1, 3, "lies on"},
                 [TF_EDGE_EDGE_PAIR] = {2, 2, "meets"},
                 [TF_EDGE_TRIANGLE_PAIR] = {2, 3, "passes through"}};
    int first = forms[error->subject].first;
    return tf_mesh_file_fault(
        file, -1,
        "%s %s %s of %s (numbered from 0) before the step begins; move them "
        "apart%s",
        element_of(first, error->vertex).text, forms[error->subject].verb,
        element_of(forms[error->subject].second, error->vertex + first).text,
        tf_make_visible(other->name).text, advice(error));
}

//: Print a defect
__attribute__((format(printf, 3, 4))) static void
print_remark(const tf_mesh_file *file, long place, const char *format, ...)
{
    tf_fault remark;
    va_list arguments;
    va_start(arguments, format);
    tf_fault_set_list(&remark, file->name, place, format, arguments);
    va_end(arguments);
    remark.counts_bytes = file->counts_bytes;
    tf_fault_print(&remark, "tanglefree");
}

//: Print defects of a kind
enum {
    MOST_LINES = 20 ///< about defects of one kind
};

/// Those of one status from the first on; returns how many they are.
static size_t print_kind(const tf_mesh_file *file, size_t count,
                         const tf_error defect[])
{
    size_t same = 0;
    for (; same < count && defect[same].status == defect->status; same++) {
        if (same >= MOST_LINES)
            continue;
        flaw_words words = words_of(file, &defect[same]);
        print_remark(file, words.place, "%s", words.text);
    }
    if (same > MOST_LINES)
        print_remark(file, -1, "%zu more like these", same - MOST_LINES);
    return same;
}

//: Print all defects
void tf_defects_print(const tf_mesh_file *file, const tf_defects *defects)
{
    int edges = tf_mesh_file_edges(file);
    if (edges > 0)
        print_remark(file, file->edge_place.item[0],
                     "%d edge%s of no triangle, from here on, %s left out",
                     edges, edges == 1 ? "" : "s", edges == 1 ? "is" : "are");
    if (defects->turned > 0)
        print_remark(file, -1, "%d triangle%s turned over, as %s neighbors are",
                     defects->turned, defects->turned == 1 ? " is" : "s are",
                     defects->turned == 1 ? "its" : "their");
    for (size_t i = 0; i < defects->count;)
        i += print_kind(file, defects->count - i, defects->defect + i);
    if (defects->count > 0)
        print_remark(file, -1,
                     "%d of %d vertices and %d of %d triangles are left alone "
                     "because of that",
                     defects->vertices, tf_mesh_file_vertices(file),
                     defects->triangles, tf_mesh_file_triangles(file));
}

//: Include what sentences need
#include "base/sentence.h"

#include "base/require.h"

#include <stdarg.h>
#include <stdio.h>

//: Tabulate pairs
typedef struct pair_form {
    int first, second; ///< how many vertices each element has
    const char *verb;
} pair_form;

static const pair_form *form_of(tf_subject pair)
{
    static const pair_form forms[] = {
        [TF_POINT_EDGE_PAIR] = {1, 2, "lies on"},
        [TF_POINT_TRIANGLE_PAIR] = {1, 3, "lies on"},
        [TF_EDGE_EDGE_PAIR] = {2, 2, "meets"},
        [TF_EDGE_TRIANGLE_PAIR] = {2, 3, "passes through"},
    };
    bool known = pair >= TF_POINT_EDGE_PAIR && pair <= TF_EDGE_TRIANGLE_PAIR;
    return known ? &forms[pair] : NULL;
}

//: Write to a sentence
typedef struct sentence {
    char *buffer;
    size_t size, length;
    int first; ///< the number of the first vertex
} sentence;

#ifdef __GNUC__
__attribute__((format(printf, 2, 3)))
#endif
static void
put(sentence *s, const char *format, ...)
{
    va_list arguments;
    size_t used = s->length < s->size ? s->length : s->size;
    va_start(arguments, format);
    int more = vsnprintf(s->size ? s->buffer + used : NULL, s->size - used,
                         format, arguments);
    va_end(arguments);
    s->length += more > 0 ? (size_t)more : 0;
}

static long long number_of(const sentence *s, int vertex)
{
    return (long long)vertex + s->first;
}

//: Name an element of a pair
static void put_element(sentence *s, int vertices, const int vertex[])
{
    static const char *const names[] = {"", "vertex", "edge", "triangle"};
    put(s, "%s", names[vertices]);
    for (int i = 0; i < vertices; i++)
        put(s, " %lld", number_of(s, vertex[i]));
}

static void put_pair(sentence *s, const tf_error *error)
{
    const pair_form *form = form_of(error->subject);
    if (!form) {
        put(s, "two elements touch or intersect");
        return;
    }
    put_element(s, form->first, error->vertex);
    put(s, " %s ", form->verb);
    put_element(s, form->second, error->vertex + form->first);
    put(s, " (numbered from %d)", s->first);
}

//: Name what is wrong in a list
static void put_place(sentence *s, const tf_error *error)
{
    static const char *const names[] = {[TF_VERTEX] = "vertex",
                                        [TF_EDGE] = "edge",
                                        [TF_TRIANGLE] = "triangle",
                                        [TF_BATCH_QUERY] = "query"};
    static const char *const times[] = {" at the start of the step",
                                        " at the end of the step"};
    if (error->subject < TF_VERTEX || error->subject > TF_BATCH_QUERY)
        return;
    long long first = error->subject == TF_VERTEX ? s->first : 0;
    bool timed = error->time == 0 || error->time == 1;
    put(s, "%s %lld", names[error->subject], (long long)error->index + first);
    if (error->subject == TF_BATCH_QUERY && timed)
        put(s, ", vertex %lld", number_of(s, error->vertex[0]));
    put(s, "%s: ", timed ? times[error->time] : "");
}

//: Describe a bad index
static void put_bad_index(sentence *s, const tf_error *error)
{
    long long vertex = number_of(s, error->vertex[0]);
    if (error->vertex[0] >= 0 && error->vertex[0] < error->vertices)
        put(s,
            error->subject == TF_BATCH_QUERY
                ? "vertex %lld is there twice; give different ones"
                : "vertex %lld is a corner twice; delete the triangle or edge",
            vertex);
    else
        put(s, "there is no vertex %lld; they are numbered from %d to %lld",
            vertex, s->first, number_of(s, error->vertices) - 1);
}

//: Describe what no adaptive surface has
static void put_bad_edge(sentence *s, const tf_error *error)
{
    long long from = number_of(s, error->vertex[0]);
    long long to = number_of(s, error->vertex[1]);
    if (error->subject == TF_TRIANGLE)
        put(s,
            "another triangle passes the edge from vertex %lld to %lld in the "
            "same direction; orient them consistently, or divide the surface "
            "there",
            from, to);
    else
        put(s,
            "the edge from vertex %lld to %lld belongs to no triangle; remove "
            "it",
            from, to);
}

static void put_bad_vertex(sentence *s, const tf_error *error)
{
    put(s,
        "the triangles at vertex %lld form more than one ring or fan; give "
        "each a vertex of its own",
        number_of(s, error->vertex[0]));
}

//: Describe what a status alone does not tell
/// False if the status's own message tells it all.
static bool put_details(sentence *s, const tf_error *error)
{
    switch (error->status) {
    case TF_BAD_INDEX:
        put_bad_index(s, error);
        return true;
    case TF_BAD_OPTION:
        put(s, "must be %s, got %g", error->range, error->value);
        return true;
    case TF_EDGE_NOT_MANIFOLD:
        put_bad_edge(s, error);
        return true;
    case TF_VERTEX_NOT_MANIFOLD:
        put_bad_vertex(s, error);
        return true;
    case TF_COLLINEAR:
        put(s, "the corners of this triangle are on one line; remove it, or "
               "move a corner off");
        return true;
    case TF_NOT_EMBEDDED:
        put_pair(s, error);
        put(s, "; move them apart");
        return true;
    case TF_START_NOT_CLEAR:
        put_pair(s, error);
        put(s, " before the step begins; move them apart");
        return true;
    default:
        return false;
    }
}

//: Write a sentence about an error
size_t tf_sentence_write(const tf_error *error, int first, bool in_file,
                         char buffer[], size_t size)
{
    TF_REQUIRE(error && (buffer || size == 0));
    sentence s = {buffer, size, 0, first};
    if (size > 0)
        buffer[0] = '\0';
    if (!in_file)
        put_place(&s, error);
    if (error->option)
        put(&s, "%s ", error->option);
    bool about = error->subject != TF_NO_SUBJECT;
    if (!about || !put_details(&s, error))
        put(&s, "%s", tf_status_message(error->status));
    return s.length;
}

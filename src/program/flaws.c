//: Include what describing flaws needs
#include "program/flaws.h"

#include "base/fail.h"
#include "base/sentence.h"

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
/// The numbers of a pair are those of the rows that `check` prints.
bool tf_error_fault(const tf_mesh_file *file, const tf_error *error)
{
    char sentence[512];
    long place = place_of(file, error);
    int first = place < 0 ? 0 : file->first_index;
    tf_sentence_write(error, first, place >= 0, sentence, sizeof sentence);
    return tf_mesh_file_fault(file, place, "%s%s", sentence, advice(error));
}

bool tf_status_fault(const tf_mesh_file *file, tf_status status)
{
    tf_error error;
    tf_fail(&error, status);
    return tf_error_fault(file, &error);
}

//: Tabulate how elements meet
typedef struct meeting {
    const char *verb;
    int first, second; ///< how many vertices each element has
} meeting;

static const meeting crossings[] = {
    [TF_EDGE_THROUGH_TRIANGLE] = {"passes through", 2, 3},
    [TF_POINT_ON_TRIANGLE] = {"lies on", 1, 3},
    [TF_EDGE_ON_EDGE] = {"meets", 2, 2},
};

//: Name an element by its vertices
enum {
    NAME = 64
};

static void name_element(char name[NAME], int vertices, const int vertex[])
{
    static const char *const names[] = {"", "vertex", "edge", "triangle"};
    int length = snprintf(name, NAME, "%s", names[vertices]);
    for (int i = 0; i < vertices; i++)
        length +=
            snprintf(name + length, (size_t)(NAME - length), " %d", vertex[i]);
}

//: Describe a meeting
enum {
    MEETING = 2 * NAME + 32
};

static void describe_meeting(char text[MEETING], const meeting *how,
                             const int vertex[])
{
    char first[NAME], second[NAME];
    name_element(first, how->first, vertex);
    name_element(second, how->second, vertex + how->first);
    snprintf(text, MEETING, "%s %s %s (numbered from 0)", first, how->verb,
             second);
}

//: Describe an edge of a file that no surface has
static bool fault_in_edge(const tf_mesh_file *file, const tf_defect *defect)
{
    int first = file->first_index;
    int from = defect->vertex[0] + first, to = defect->vertex[1] + first;
    if (defect->triangle < 0)
        return tf_mesh_file_fault(
            file, file->edge_place.item[0],
            "the edge from vertex %d to %d belongs to no triangle; remove it",
            from, to);
    return tf_mesh_file_fault(
        file, file->triangle_place.item[defect->triangle],
        "another triangle passes the edge from vertex %d to %d in the same "
        "direction; orient them consistently, or divide the surface there",
        from, to);
}

//: Describe a vertex of a file that no surface has
static bool fault_in_vertex(const tf_mesh_file *file, const tf_defect *defect)
{
    int vertex = defect->vertex[0];
    return tf_mesh_file_fault(
        file, file->vertex_place.item[vertex],
        "the triangles at vertex %d form more than one ring or fan; give each "
        "a vertex of its own",
        vertex + file->first_index);
}

//: Describe a defect
bool tf_defect_fault(const tf_mesh_file *file, tf_status status,
                     const tf_defect *defect)
{
    char text[MEETING];
    switch (status) {
    case TF_EDGE_NOT_MANIFOLD:
        return fault_in_edge(file, defect);
    case TF_VERTEX_NOT_MANIFOLD:
        return fault_in_vertex(file, defect);
    case TF_COLLINEAR:
        return tf_mesh_file_fault(
            file, file->triangle_place.item[defect->triangle],
            "the corners of this triangle are on one line; remove it, or move "
            "a corner off");
    case TF_NOT_EMBEDDED:
        describe_meeting(text, &crossings[defect->crossing.kind],
                         defect->crossing.vertex);
        return tf_mesh_file_fault(
            file, -1,
            "%s; move them apart, see 'tanglefree check' for all such pairs",
            text);
    default:
        return tf_mesh_file_fault(file, -1, "%s", tf_status_message(status));
    }
}

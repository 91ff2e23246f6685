//: Include what obstacles need
#include "program/obstacles.h"

#include <stdio.h>

//: Tabulate how elements meet
typedef struct meeting {
    const char *verb;
    int first, second; ///< how many vertices each element has
} meeting;

static const meeting touchings[] = {
    [TF_POINT_EDGE] = {"lies on", 1, 2},
    [TF_POINT_TRIANGLE] = {"lies on", 1, 3},
    [TF_EDGE_EDGE] = {"meets", 2, 2},
};

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

//: Describe an obstacle
bool tf_obstacle_fault(tf_mesh_file *start, const tf_obstacle *obstacle)
{
    char text[MEETING];
    describe_meeting(text,
                     obstacle->touching != TF_NO_KIND
                         ? &touchings[obstacle->touching]
                         : &crossings[obstacle->crossing],
                     obstacle->vertex);
    return tf_mesh_file_fault(start, -1,
                              "%s before the step begins; move them apart, see "
                              "'tanglefree check' for "
                              "all such pairs",
                              text);
}

//: Describe a crossing
bool tf_crossing_fault(tf_mesh_file *file, const tf_crossing *crossing)
{
    char text[MEETING];
    describe_meeting(text, &crossings[crossing->kind], crossing->vertex);
    return tf_mesh_file_fault(
        file, -1,
        "%s; move them apart, see 'tanglefree check' for all such pairs", text);
}

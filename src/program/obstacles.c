//: Include what obstacles need
#include "program/obstacles.h"

#include <stdio.h>

//: Tabulate how elements meet
/// An element is named by how many vertices it has.
typedef struct meeting {
    int first;
    const char *verb;
    int second;
} meeting;

static const meeting touchings[] = {
    [TF_POINT_EDGE] = {1, "lies on", 2},
    [TF_POINT_TRIANGLE] = {1, "lies on", 3},
    [TF_EDGE_EDGE] = {2, "meets", 2},
};

static const meeting crossings[] = {
    [TF_EDGE_THROUGH_TRIANGLE] = {2, "passes through", 3},
    [TF_POINT_ON_TRIANGLE] = {1, "lies on", 3},
    [TF_EDGE_ON_EDGE] = {2, "meets", 2},
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

//: Describe an obstacle
bool tf_obstacle_fault(tf_mesh_file *start, const tf_obstacle *obstacle)
{
    const meeting *how = obstacle->touching != TF_NO_KIND
                             ? &touchings[obstacle->touching]
                             : &crossings[obstacle->crossing];
    char first[NAME], second[NAME];
    name_element(first, how->first, obstacle->vertex);
    name_element(second, how->second, obstacle->vertex + how->first);
    return tf_mesh_file_fault(
        start, -1,
        "%s %s %s (numbered from 0) before the step begins; move them apart, "
        "see 'tanglefree check' for all such pairs",
        first, how->verb, second);
}

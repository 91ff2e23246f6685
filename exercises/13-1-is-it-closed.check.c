#include "check.h"

#include "surface/mesh.h"

#include <stdio.h>

bool is_closed(const tf_mesh *mesh);

typedef struct example {
    const char *what;
    int vertices, triangles;
    int triangle[8][3];
    bool closed;
} example;

static const example examples[] = {
    {"a single triangle", 3, 1, {{0, 1, 2}}, false},
    {"a tetrahedron", 4, 4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, true},
    {"a tetrahedron with its corners listed from other starts",
     4,
     4,
     {{2, 1, 0}, {1, 3, 0}, {3, 1, 2}, {0, 3, 2}},
     true},
    {"a tetrahedron without one face",
     4,
     3,
     {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}},
     false},
    {"a tetrahedron with one face turned over",
     4,
     4,
     {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
     false},
    {"both sides of one triangle", 3, 2, {{0, 1, 2}, {2, 1, 0}}, true},
    {"one triangle, listed twice", 3, 2, {{0, 1, 2}, {0, 1, 2}}, false},
    {"two tetrahedra with a common edge, at which four triangles meet",
     6,
     8,
     {{0, 2, 1},
      {0, 1, 3},
      {1, 2, 3},
      {2, 0, 3},
      {0, 4, 1},
      {0, 1, 5},
      {1, 4, 5},
      {4, 0, 5}},
     true},
    {"a tetrahedron with a fin",
     5,
     5,
     {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 4}},
     false},
    {"both sides of one triangle, twice over",
     3,
     4,
     {{0, 1, 2}, {2, 1, 0}, {1, 2, 0}, {1, 0, 2}},
     true},
    {"a triangle, listed twice, and its other side",
     3,
     3,
     {{0, 1, 2}, {1, 2, 0}, {2, 1, 0}},
     false},
};

TEST(every_edge_runs_both_ways)
{
    const example *given = &examples[_i];
    tf_mesh mesh = {.axes = 3,
                    .vertices = given->vertices,
                    .triangles = given->triangles,
                    .triangle = given->triangle[0]};
    char list[200];
    int length = 0;
    for (int i = 0; i < given->triangles; i++)
        length += snprintf(list + length, sizeof list - (size_t)length,
                           " (%d %d %d)", given->triangle[i][0],
                           given->triangle[i][1], given->triangle[i][2]);
    check_input("%s:%s", given->what, list);
    bool got;
    check_value(got, is_closed(&mesh));
    check_bool(given->closed, got);
}

void run_tests(void)
{
    check_run(sizeof examples / sizeof *examples, every_edge_runs_both_ways);
}

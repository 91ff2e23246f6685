#include "check.h"

#include "support/support.h"

#include <stdio.h>
#include <string.h>

enum {
    RING = 9, // vertices of a ring of triangles
    MOST_RINGS = 6,
    TRIANGLES = 2 * RING * MOST_RINGS + 20
};

int count_handles(int vertices, int triangles, const int triangle[][3]);

typedef struct mesh {
    int vertices, triangles, triangle[TRIANGLES][3];
} mesh;

// Surfaces --------------------------------------------------------------------

static void add(mesh *of, int a, int b, int c)
{
    memcpy(of->triangle[of->triangles++], (int[]){a, b, c}, 3 * sizeof(int));
}

static mesh tetrahedron(void)
{
    return (mesh){4, 4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

/// A ring of three vertices across and three around; the triangles of its
/// squares follow each other.
static void add_ring(mesh *of)
{
    int first = of->vertices;
    of->vertices += RING;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            int k = (i + 1) % 3, l = (j + 1) % 3;
            int a = first + 3 * i + j, b = first + 3 * k + j;
            int c = first + 3 * k + l, d = first + 3 * i + l;
            add(of, a, b, c);
            add(of, a, c, d);
        }
}

/// Unites two parts: a triangle of each goes, and their vertices become the
/// same.
static void unite(mesh *of, int s, int t)
{
    int from[3],
        to[3] = {of->triangle[s][0], of->triangle[s][2], of->triangle[s][1]};
    memcpy(from, of->triangle[t], sizeof from);
    of->triangle[s][0] = of->triangle[t][0] = -1;
    for (int i = 0; i < 3 * of->triangles; i++) {
        int *v = &of->triangle[i / 3][i % 3];
        for (int k = 0; k < 3; k++)
            if (*v == from[k]) {
                *v = to[k];
                break;
            }
    }
}

/// So many rings in a row, united.
static mesh rings(int count)
{
    mesh made = {0};
    for (int i = 0; i < count; i++) {
        int first = made.triangles;
        add_ring(&made);
        if (i > 0)
            unite(&made, first - 1, first);
    }
    return made;
}

// Tests -----------------------------------------------------------------------

static void expect(int right, const mesh *of)
{
    char text[12 * TRIANGLES], expected[16];
    int length = 0;
    for (int t = 0; t < of->triangles; t++)
        length += snprintf(text + length, sizeof text - (size_t)length,
                           "%s%d %d %d", t == 0 ? "" : ", ", of->triangle[t][0],
                           of->triangle[t][1], of->triangle[t][2]);
    check_input("%d vertices; triangles %s", of->vertices, text);
    int got;
    check_value(got, count_handles(of->vertices, of->triangles,
                                   (const int(*)[3])of->triangle));
    snprintf(expected, sizeof expected, "%d", right);
    check_that(got == right, expected, "%d", got);
}

TEST(a_ball)
{
    mesh of = tetrahedron();
    expect(0, &of);
}

TEST(vertices_that_are_gone)
{
    mesh of = tetrahedron();
    of.vertices += 5;
    expect(0, &of);
}

TEST(gaps)
{
    mesh of = tetrahedron();
    for (int i = 0; i < 6; i++)
        add(&of, -1, i, -1);
    expect(0, &of);
}

TEST(rings_in_a_row)
{
    for (int count = 1; count <= MOST_RINGS; count++) {
        mesh of = rings(count);
        expect(count, &of);
    }
}

void run_tests(void)
{
    check_run(1, a_ball);
    check_run(1, vertices_that_are_gone);
    check_run(1, gaps);
    check_run(1, rings_in_a_row);
}

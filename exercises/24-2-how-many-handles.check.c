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

static void add(mesh *m, int a, int b, int c)
{
    memcpy(m->triangle[m->triangles++], (int[]){a, b, c}, 3 * sizeof(int));
}

static mesh tetrahedron(void)
{
    return (mesh){4, 4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

/// A ring of three vertices across and three around; the triangles of its
/// squares follow each other.
static void add_ring(mesh *m)
{
    int first = m->vertices;
    m->vertices += RING;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            int k = (i + 1) % 3, l = (j + 1) % 3;
            int a = first + 3 * i + j, b = first + 3 * k + j;
            int c = first + 3 * k + l, d = first + 3 * i + l;
            add(m, a, b, c);
            add(m, a, c, d);
        }
}

/// Unites two parts: a triangle of each goes, and their vertices become the
/// same.
static void unite(mesh *m, int s, int t)
{
    int from[3],
        to[3] = {m->triangle[s][0], m->triangle[s][2], m->triangle[s][1]};
    memcpy(from, m->triangle[t], sizeof from);
    m->triangle[s][0] = m->triangle[t][0] = -1;
    for (int i = 0; i < 3 * m->triangles; i++) {
        int *v = &m->triangle[i / 3][i % 3];
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

static void expect(int right, const mesh *m)
{
    char text[12 * TRIANGLES], expected[16];
    int length = 0;
    for (int t = 0; t < m->triangles; t++)
        length += snprintf(text + length, sizeof text - (size_t)length,
                           "%s%d %d %d", t == 0 ? "" : ", ", m->triangle[t][0],
                           m->triangle[t][1], m->triangle[t][2]);
    check_input("%d vertices; triangles %s", m->vertices, text);
    int got;
    check_value(got, count_handles(m->vertices, m->triangles,
                                   (const int(*)[3])m->triangle));
    snprintf(expected, sizeof expected, "%d", right);
    check_that(got == right, expected, "%d", got);
}

TEST(a_ball)
{
    mesh m = tetrahedron();
    expect(0, &m);
}

TEST(vertices_that_are_gone)
{
    mesh m = tetrahedron();
    m.vertices += 5;
    expect(0, &m);
}

TEST(gaps)
{
    mesh m = tetrahedron();
    for (int i = 0; i < 6; i++)
        add(&m, -1, i, -1);
    expect(0, &m);
}

TEST(rings_in_a_row)
{
    for (int count = 1; count <= MOST_RINGS; count++) {
        mesh m = rings(count);
        expect(count, &m);
    }
}

void run_tests(void)
{
    check_run(1, a_ball);
    check_run(1, vertices_that_are_gone);
    check_run(1, gaps);
    check_run(1, rings_in_a_row);
}

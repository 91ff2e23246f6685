#include "check.h"

#include "support/support.h"

#include <stdio.h>
#include <string.h>

enum {
    VERTICES = 40,
    TRIANGLES = 80
};

bool may_collapse(int vertices, int triangles, const int triangle[][3], int a,
                  int b);

typedef struct mesh {
    int vertices, triangles, triangle[TRIANGLES][3];
} mesh;

// Surfaces --------------------------------------------------------------------

/// Splits a triangle in three by a vertex inside.
static void add_inside(mesh *m, int t)
{
    int v = m->vertices++, *old = m->triangle[t];
    int a = old[0], b = old[1], c = old[2];
    memcpy(m->triangle[m->triangles++], (int[]){b, c, v}, 3 * sizeof(int));
    memcpy(m->triangle[m->triangles++], (int[]){c, a, v}, 3 * sizeof(int));
    old[2] = v;
}

static mesh tetrahedron(void)
{
    return (mesh){4, 4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

static mesh octahedron(void)
{
    mesh made = {.vertices = 6, .triangles = 8};
    for (int i = 0; i < 4; i++) {
        int next = (i + 1) % 4;
        memcpy(made.triangle[i], (int[]){i, next, 4}, 3 * sizeof(int));
        memcpy(made.triangle[4 + i], (int[]){next, i, 5}, 3 * sizeof(int));
    }
    return made;
}

/// A torus with a waist of `around` edges, divided into squares.
static mesh torus(int around, int across)
{
    mesh made = {.vertices = around * across};
    for (int i = 0; i < around; i++)
        for (int j = 0; j < across; j++) {
            int k = (i + 1) % around, l = (j + 1) % across;
            int a = i * across + j, b = k * across + j, c = k * across + l,
                d = i * across + l;
            memcpy(made.triangle[made.triangles++], (int[]){a, b, c},
                   3 * sizeof(int));
            memcpy(made.triangle[made.triangles++], (int[]){a, c, d},
                   3 * sizeof(int));
        }
    return made;
}

// Judging ---------------------------------------------------------------------

static mesh collapsed(const mesh *m, int a, int b)
{
    mesh made = {.vertices = m->vertices};
    for (int t = 0; t < m->triangles; t++) {
        int *added = made.triangle[made.triangles];
        for (int i = 0; i < 3; i++)
            added[i] = m->triangle[t][i] == a ? b : m->triangle[t][i];
        made.triangles += added[0] != added[1] && added[1] != added[2] &&
                          added[2] != added[0];
    }
    return made;
}

/// How many triangles have the edge in this direction.
static int count_edge(const mesh *m, int from, int to)
{
    int count = 0;
    for (int t = 0; t < m->triangles; t++)
        for (int i = 0; i < 3; i++)
            count +=
                m->triangle[t][i] == from && m->triangle[t][(i + 1) % 3] == to;
    return count;
}

static bool same_vertices(const int a[3], const int b[3])
{
    for (int i = 0; i < 3; i++)
        if (a[i] != b[0] && a[i] != b[1] && a[i] != b[2])
            return false;
    return true;
}

/// The vertex that precedes in the triangle with an edge from `from` to `to`.
static int before_edge(const mesh *m, int from, int to)
{
    for (int t = 0; t < m->triangles; t++)
        for (int i = 0; i < 3; i++)
            if (m->triangle[t][i] == from && m->triangle[t][(i + 1) % 3] == to)
                return m->triangle[t][(i + 2) % 3];
    return -1;
}

/// Whether the triangles at a vertex form one ring.
static bool is_ring(const mesh *m, int vertex)
{
    int all = 0, first = -1, size = 0;
    for (int t = 0; t < m->triangles; t++)
        for (int i = 0; i < 3; i++)
            if (m->triangle[t][i] == vertex) {
                all++;
                first = m->triangle[t][(i + 1) % 3];
            }
    int at = first;
    do {
        at = before_edge(m, vertex, at);
        size++;
    } while (at != first && size <= all);
    return all == 0 || size == all;
}

static bool is_surface(const mesh *m)
{
    for (int t = 0; t < m->triangles; t++) {
        for (int i = 0; i < 3; i++) {
            int a = m->triangle[t][i], b = m->triangle[t][(i + 1) % 3];
            if (count_edge(m, a, b) != 1 || count_edge(m, b, a) != 1)
                return false;
        }
        for (int s = 0; s < t; s++)
            if (same_vertices(m->triangle[s], m->triangle[t]))
                return false;
    }
    for (int v = 0; v < m->vertices; v++)
        if (!is_ring(m, v))
            return false;
    return true;
}

// Tests -----------------------------------------------------------------------

static void expect(const mesh *m, int a, int b)
{
    char text[12 * TRIANGLES];
    int length = 0;
    for (int t = 0; t < m->triangles; t++)
        length += snprintf(text + length, sizeof text - (size_t)length,
                           "%s%d %d %d", t == 0 ? "" : ", ", m->triangle[t][0],
                           m->triangle[t][1], m->triangle[t][2]);
    check_input("edge %d %d of the triangles %s", a, b, text);
    mesh after = collapsed(m, a, b);
    bool got;
    check_value(got,
                may_collapse(m->vertices, m->triangles, m->triangle, a, b));
    check_bool(is_surface(&after), got);
}

static void expect_all(const mesh *m)
{
    for (int t = 0; t < m->triangles; t++)
        for (int i = 0; i < 3; i++)
            expect(m, m->triangle[t][i], m->triangle[t][(i + 1) % 3]);
}

TEST(a_tetrahedron)
{
    mesh m = tetrahedron();
    expect_all(&m);
}

TEST(an_octahedron)
{
    mesh m = octahedron();
    expect_all(&m);
}

TEST(a_torus_with_a_narrow_waist)
{
    mesh m = torus(6, 3);
    expect_all(&m);
}

TEST(a_vertex_of_three_triangles)
{
    mesh m = octahedron();
    add_inside(&m, 0);
    add_inside(&m, 5);
    expect_all(&m);
}

TEST(after_random_collapses)
{
    generator random = generator_new(0);
    for (int run = 0; run < 40; run++) {
        mesh m = run % 3 == 0 ? torus(4, 5) : octahedron();
        for (int i = 0; i < 12 && m.triangles + 2 <= TRIANGLES; i++)
            add_inside(&m, below(&random, m.triangles));
        for (int i = 0; i < 60; i++) {
            const int *t = m.triangle[below(&random, m.triangles)];
            int a = t[0], b = t[1];
            expect(&m, a, b);
            mesh after = collapsed(&m, a, b);
            if (is_surface(&after))
                m = after;
        }
    }
}

void run_tests(void)
{
    check_run(1, a_tetrahedron);
    check_run(1, an_octahedron);
    check_run(1, a_torus_with_a_narrow_waist);
    check_run(1, a_vertex_of_three_triangles);
    check_run(1, after_random_collapses);
}

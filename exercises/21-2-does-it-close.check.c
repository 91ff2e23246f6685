#include "check.h"

#include "support/support.h"

#include <stdbool.h>
#include <stdio.h>

enum {
    MOST_VERTICES = 64,
    MOST_TRIANGLES = 96,
    MOST_CROSSINGS = 256
};

int count_closed(int triangles, const int triangle[][3], int crossings,
                 const int crossing[][5], int *open);

/// A surface in space, and where it crosses itself.
typedef struct tangle {
    int vertices, place[MOST_VERTICES][3];
    int triangles, triangle[MOST_TRIANGLES][3];
    int crossings, crossing[MOST_CROSSINGS][5];
    int pierced[MOST_CROSSINGS]; ///< the triangle of each crossing
    bool flat; ///< whether something touches without crossing, perhaps
} tangle;

static void add_triangle(tangle *t, int a, int b, int c)
{
    int *corner = t->triangle[t->triangles++];
    corner[0] = a;
    corner[1] = b;
    corner[2] = c;
}

static bool has_corner(const int triangle[3], int vertex)
{
    return triangle[0] == vertex || triangle[1] == vertex ||
           triangle[2] == vertex;
}

/// The sign of the volume of four vertices.
static int side(tangle *t, int a, int b, int c, int d)
{
    long u[3][3];
    const int corner[] = {b, c, d};
    for (int j = 0; j < 9; j++)
        u[j / 3][j % 3] = t->place[corner[j / 3]][j % 3] - t->place[a][j % 3];
    long volume = u[0][0] * (u[1][1] * u[2][2] - u[1][2] * u[2][1]) +
                  u[0][1] * (u[1][2] * u[2][0] - u[1][0] * u[2][2]) +
                  u[0][2] * (u[1][0] * u[2][1] - u[1][1] * u[2][0]);
    t->flat |= volume == 0;
    return (volume > 0) - (volume < 0);
}

static void try_edge(tangle *t, int a, int b, int triangle)
{
    const int *c = t->triangle[triangle];
    if (has_corner(c, a) || has_corner(c, b) ||
        side(t, a, c[0], c[1], c[2]) == side(t, b, c[0], c[1], c[2]))
        return;
    int first = side(t, a, b, c[0], c[1]);
    if (side(t, a, b, c[1], c[2]) != first ||
        side(t, a, b, c[2], c[0]) != first)
        return;
    t->pierced[t->crossings] = triangle;
    int *crossing = t->crossing[t->crossings++];
    crossing[0] = a;
    crossing[1] = b;
    for (int k = 0; k < 3; k++)
        crossing[2 + k] = c[k];
}

/// Finds all crossings, as long as there is room for them.
static bool cross(tangle *t)
{
    t->crossings = 0;
    t->flat = false;
    for (int a = 0; a < t->vertices; a++)
        for (int b = a + 1; b < t->vertices; b++) {
            bool is_edge = false;
            for (int s = 0; s < t->triangles; s++)
                is_edge |= has_corner(t->triangle[s], a) &&
                           has_corner(t->triangle[s], b);
            for (int s = 0; is_edge && s < t->triangles; s++) {
                if (t->crossings == MOST_CROSSINGS)
                    return false;
                try_edge(t, a, b, s);
            }
        }
    return !t->flat;
}

/// The pairs of triangles that have a segment in common, and its ends: crossings,
/// or -1.
typedef struct segments {
    int count, pair[2 * MOST_CROSSINGS][2], end[2 * MOST_CROSSINGS][2];
} segments;

static void add_end(segments *s, int a, int b, int crossing)
{
    int low = a < b ? a : b, high = a < b ? b : a, i = 0;
    while (i < s->count && (s->pair[i][0] != low || s->pair[i][1] != high))
        i++;
    if (i == s->count) {
        s->pair[i][0] = low;
        s->pair[i][1] = high;
        s->end[i][0] = s->end[i][1] = -1;
        s->count++;
    }
    s->end[i][s->end[i][0] >= 0] = crossing;
}

/// Walks along a curve from one of its segments; whether it ends somewhere.
static bool walk(const segments *s, int from, bool seen[])
{
    bool ends = false;
    seen[from] = true;
    for (int k = 0; k < 2; k++) {
        int next = -1;
        for (int i = 0; i < s->count && s->end[from][k] >= 0; i++)
            if (i != from && (s->end[i][0] == s->end[from][k] ||
                              s->end[i][1] == s->end[from][k]))
                next = i;
        ends |= next < 0 || (!seen[next] && walk(s, next, seen));
    }
    return ends;
}

/// How many curves are closed, and how many are not, segment by segment.
static void count(const tangle *t, int *closed, int *open)
{
    static segments s;
    bool seen[2 * MOST_CROSSINGS] = {false};
    s.count = *closed = *open = 0;
    for (int i = 0; i < t->crossings; i++)
        for (int k = 0; k < t->triangles; k++)
            if (has_corner(t->triangle[k], t->crossing[i][0]) &&
                has_corner(t->triangle[k], t->crossing[i][1]))
                add_end(&s, k, t->pierced[i], i);
    for (int i = 0; i < s.count; i++)
        if (!seen[i])
            ++*(walk(&s, i, seen) ? open : closed);
}

static void show(const tangle *t)
{
    static char text[40 * MOST_TRIANGLES + 60 * MOST_CROSSINGS];
    int length = 0;
    for (int i = 0; i < t->triangles; i++)
        length +=
            snprintf(text + length, sizeof text - (size_t)length, "%s%d %d %d",
                     i ? ", " : "triangles ", t->triangle[i][0],
                     t->triangle[i][1], t->triangle[i][2]);
    for (int i = 0; i < t->crossings; i++) {
        const int *v = t->crossing[i];
        length +=
            snprintf(text + length, sizeof text - (size_t)length,
                     "%s%d %d through %d %d %d",
                     i ? ", " : "\ncrossings: ", v[0], v[1], v[2], v[3], v[4]);
    }
    check_input("%s", text);
}

/// Expects numbers of curves.
static void expect(int closed, int open, const tangle *t)
{
    int got[2] = {-1, -1};
    show(t);
    check_call(got, got[0] = count_closed(t->triangles, t->triangle,
                                          t->crossings, t->crossing, &got[1]));
    char text[80];
    snprintf(text, sizeof text, "%d closed, %d open", closed, open);
    check_that(got[0] == closed && got[1] == open, text, "%d closed, %d open",
               got[0], got[1]);
}

static void add_vertex(tangle *t, int x, int y, int z)
{
    int *place = t->place[t->vertices++];
    place[0] = x;
    place[1] = y;
    place[2] = z;
}

/// A corner of a box, or the like: a tip and the triangles around it.
static void add_spike(tangle *t, int x, int y, int top)
{
    int tip = t->vertices;
    add_vertex(t, x, y, -7);
    add_vertex(t, x - 9, y - 7, top);
    add_vertex(t, x + 8, y - 6, top);
    add_vertex(t, x + 1, y + 9, top);
    for (int k = 0; k < 3; k++)
        add_triangle(t, tip, tip + 1 + k, tip + 1 + (k + 1) % 3);
}

static void add_floor(tangle *t)
{
    int first = t->vertices;
    add_vertex(t, -60, -61, 0);
    add_vertex(t, 67, -62, 0);
    add_vertex(t, 63, 65, 0);
    add_vertex(t, -64, 66, 0);
    add_triangle(t, first, first + 1, first + 2);
    add_triangle(t, first, first + 2, first + 3);
}

TEST(a_spike_through_a_floor)
{
    tangle t = {0};
    add_floor(&t);
    add_spike(&t, 20, -21, 9);
    cross(&t);
    expect(1, 0, &t);
    add_spike(&t, 23, 28, 9);
    cross(&t);
    expect(2, 0, &t);
}

TEST(a_triangle_through_a_floor)
{
    tangle t = {0};
    add_floor(&t);
    add_vertex(&t, 20, -21, -5);
    add_vertex(&t, 29, -23, 6);
    add_vertex(&t, 22, -35, 7);
    add_triangle(&t, 4, 5, 6);
    cross(&t);
    expect(0, 1, &t);
    add_spike(&t, 23, 28, 9);
    cross(&t);
    expect(1, 1, &t);
}

TEST(over_the_border)
{
    tangle t = {0};
    add_floor(&t);
    add_spike(&t, 66, 3, 9);
    cross(&t);
    expect(0, 1, &t);
}

TEST(a_common_vertex)
{
    // Two tetrahedra with a tip in common, and a face of one through the other.
    tangle t = {0};
    static const int place[7][3] = {{0, 0, 0},    {9, -6, 20}, {-10, -5, 21},
                                    {1, 11, 22},  {2, -2, 41}, {30, 3, 26},
                                    {27, -19, 23}};
    static const int face[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    for (int v = 0; v < 7; v++)
        add_vertex(&t, place[v][0], place[v][1], place[v][2]);
    for (int i = 0; i < 8; i++) {
        int corner[3];
        for (int k = 0; k < 3; k++) {
            int v = face[i % 4][k];
            corner[k] = v == 0 || i < 4 ? v : v + 3;
        }
        add_triangle(&t, corner[0], corner[1], corner[2]);
    }
    cross(&t);
    expect(0, 1, &t);
}

/// Octahedra, closed surfaces, with corners anywhere.
TEST(octahedra)
{
    generator random = generator_new(21);
    for (int times = 0; times < 400; times++) {
        tangle t = {0};
        int octahedra = 1 + below(&random, 2), closed, open;
        for (int v = 0; v < 6 * octahedra; v++)
            add_vertex(&t, below(&random, 201) - 100, below(&random, 201) - 100,
                       below(&random, 201) - 100);
        for (int i = 0; i < 8 * octahedra; i++) {
            int o = 6 * (i / 8);
            add_triangle(&t, o + (i & 1), o + 2 + (i >> 1 & 1),
                         o + 4 + (i >> 2 & 1));
        }
        if (cross(&t)) {
            count(&t, &closed, &open);
            expect(closed, open, &t);
        }
    }
}

void run_tests(void)
{
    check_run(1, a_spike_through_a_floor);
    check_run(1, a_triangle_through_a_floor);
    check_run(1, over_the_border);
    check_run(1, a_common_vertex);
    check_run(1, octahedra);
}

#include "check.h"

#include "support/support.h"

#include <stdbool.h>
#include <stdio.h>

enum {
    MOST_VERTICES = 64,
    MOST_EDGES = 160
};

int mark_wrong(int vertices, int edges, const int edge[][2],
               const int pierced[], bool wrong[]);

/// Edges, and how many triangles each of them pierces.
typedef struct tangle {
    int vertices, edges, edge[MOST_EDGES][2], pierced[MOST_EDGES];
} tangle;

static void add(tangle *t, int a, int b, int pierced)
{
    t->edge[t->edges][0] = a;
    t->edge[t->edges][1] = b;
    t->pierced[t->edges++] = pierced;
}

static void show(const tangle *t)
{
    char text[32 * MOST_EDGES] = "";
    int length = 0;
    for (int e = 0; e < t->edges; e++)
        length +=
            snprintf(text + length, sizeof text - (size_t)length, "%s%d-%d",
                     e ? ", " : "", t->edge[e][0], t->edge[e][1]);
    for (int e = 0; e < t->edges; e++)
        if (t->pierced[e])
            length += snprintf(text + length, sizeof text - (size_t)length,
                               "; %d-%d pierces %d", t->edge[e][0],
                               t->edge[e][1], t->pierced[e]);
    check_input("%d vertices, edges %s", t->vertices, text);
}

/// Marks all that can be reached from a vertex, and returns how many they are.
static int reach(const tangle *t, bool all, int from, bool seen[])
{
    int count = 1;
    seen[from] = true;
    for (int e = 0; e < t->edges; e++)
        for (int end = 0; end < 2; end++) {
            int to = t->edge[e][1 - end];
            if (t->edge[e][end] == from && !seen[to] &&
                (all || !(t->pierced[e] & 1)))
                count += reach(t, all, to, seen);
        }
    return count;
}

/// Whether a vertex is in a wrong region: some vertex of its part is in a larger
/// region, or in one as large that has a lower vertex.
static bool is_wrong(const tangle *t, int vertex)
{
    bool part[MOST_VERTICES] = {false}, own[MOST_VERTICES] = {false};
    reach(t, true, vertex, part);
    int size = reach(t, false, vertex, own), lowest = 0;
    while (!own[lowest])
        lowest++;
    for (int v = 0; v < t->vertices; v++) {
        bool other[MOST_VERTICES] = {false};
        if (!part[v] || own[v])
            continue;
        int others = reach(t, false, v, other);
        if (others > size || (others == size && v < lowest))
            return true;
    }
    return false;
}

static void expect(const tangle *t)
{
    bool got[MOST_VERTICES] = {false};
    int count, right = 0;
    show(t);
    check_value(count,
                mark_wrong(t->vertices, t->edges, t->edge, t->pierced, got));
    check_also(got);
    for (int v = 0; v < t->vertices; v++) {
        bool wrong = is_wrong(t, v);
        right += wrong;
        check_that(got[v] == wrong, wrong ? "wrong" : "right",
                   "%s for vertex %d", got[v] ? "wrong" : "right", v);
    }
    check_real(right, count);
}

/// A strip of n vertices in a row, of which one edge pierces something.
static tangle strip_of(int n, int edge, int pierced)
{
    tangle t = {.vertices = n};
    for (int v = 0; v + 1 < n; v++)
        add(&t, v, v + 1, v == edge ? pierced : 0);
    return t;
}

TEST(a_strip_that_pierces_a_surface)
{
    tangle t = strip_of(5, 1, 1);
    expect(&t);
    t = strip_of(5, 3, 3);
    expect(&t);
    t = strip_of(6, 2, 1);
    expect(&t);
}

TEST(in_and_out_again)
{
    tangle t = strip_of(5, 1, 2);
    expect(&t);
    t.pierced[3] = 1;
    expect(&t);
}

TEST(a_way_around)
{
    tangle t = strip_of(6, 2, 1);
    add(&t, 5, 0, 0);
    expect(&t);
    t.pierced[4] = 1;
    expect(&t);
}

TEST(two_parts)
{
    tangle t = strip_of(10, 1, 1);
    t.edge[5][0] = t.edge[5][1] - 2;
    expect(&t);
    t = strip_of(12, 4, 1);
    t.edges--;
    t.vertices = 14;
    add(&t, 11, 12, 1);
    add(&t, 12, 13, 0);
    expect(&t);
}

/// Any edges, of which few pierce anything, so that there are large regions.
TEST(some_at_random)
{
    generator random = generator_new(21);
    for (int times = 0; times < 300; times++) {
        tangle t = {.vertices = 2 + below(&random, MOST_VERTICES - 2)};
        int edges = below(&random, 2 * t.vertices);
        for (int i = 0; i < edges; i++) {
            int a = below(&random, t.vertices - 1);
            int b = a + 1 + below(&random, t.vertices - 1 - a);
            if (b - a < 9)
                add(&t, a, b, below(&random, 3) ? 0 : 1 + below(&random, 3));
        }
        expect(&t);
    }
}

void run_tests(void)
{
    check_run(1, a_strip_that_pierces_a_surface);
    check_run(1, in_and_out_again);
    check_run(1, a_way_around);
    check_run(1, two_parts);
    check_run(1, some_at_random);
}

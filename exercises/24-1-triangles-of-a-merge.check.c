#include "check.h"

#include "support/support.h"

#include <stdio.h>

enum {
    SIDES = 8, // triangles of a tube
    VERTICES = 30
};

void zip(const int p[4], const int q[4], int triangle[8][3]);

static int tube[SIDES][3];

static void write_triangles(char text[200])
{
    int length = 0;
    text[0] = '\0';
    for (int t = 0; t < SIDES; t++)
        length +=
            snprintf(text + length, 200 - (size_t)length, "%s%d %d %d",
                     t == 0 ? "" : ", ", tube[t][0], tube[t][1], tube[t][2]);
}

/// How many triangles of the tube pass an edge in this direction.
static int count_edge(int from, int to)
{
    int count = 0;
    for (int t = 0; t < SIDES; t++)
        for (int i = 0; i < 3; i++)
            count += tube[t][i] == from && tube[t][(i + 1) % 3] == to;
    return count;
}

static void expect_edge(int from, int to, int forth, int back)
{
    char expected[120], got[200];
    snprintf(expected, sizeof expected,
             "the edge from %d to %d in %s triangle, and from %d to %d in %s",
             from, to, forth ? "one" : "no", to, from, back ? "one" : "none");
    write_triangles(got);
    check_that(count_edge(from, to) == forth && count_edge(to, from) == back,
               expected, "%s", got);
}

static void expect_vertices(const int p[4], const int q[4])
{
    for (int i = 0; i < 3 * SIDES; i++) {
        int v = tube[i / 3][i % 3], found = 0;
        for (int k = 0; k < 4; k++)
            found += p[k] == v || q[k] == v;
        check_that(found == 1, "only the eight corners", "%d", v);
    }
}

/// Each edge of the quadrilaterals once, as the removed triangles passed it;
/// each edge between them as often forth as back.
static void expect_tube(const int p[4], const int q[4])
{
    check_input("p: %d %d %d %d; q: %d %d %d %d", p[0], p[1], p[2], p[3], q[0],
                q[1], q[2], q[3]);
    for (int i = 0; i < 3 * SIDES; i++)
        tube[i / 3][i % 3] = -1;
    check_call(tube, zip(p, q, tube));
    expect_vertices(p, q);
    int diagonals = 0;
    for (int i = 0; i < 4; i++) {
        expect_edge(p[i], p[(i + 1) % 4], 1, 0);
        expect_edge(q[i], q[(i + 1) % 4], 1, 0);
        expect_edge(p[i], q[(4 - i) % 4], 1, 1);
        for (int k = 0; k < 4; k++)
            if (k != (4 - i) % 4 && count_edge(p[i], q[k]) > 0) {
                expect_edge(p[i], q[k], 1, 1);
                diagonals++;
            }
    }
    check_that(diagonals == 4, "4 diagonals", "%d", diagonals);
}

TEST(a_cube)
{
    expect_tube((int[]){0, 1, 2, 3}, (int[]){4, 7, 6, 5});
}

TEST(any_numbers)
{
    generator random = generator_new(0);
    for (int i = 0; i < 100; i++) {
        int all[VERTICES];
        for (int v = 0; v < VERTICES; v++)
            all[v] = v;
        for (int v = 0; v < 8; v++) {
            int other = v + below(&random, VERTICES - v), kept = all[v];
            all[v] = all[other];
            all[other] = kept;
        }
        expect_tube(all, all + 4);
    }
}

void run_tests(void)
{
    check_run(1, a_cube);
    check_run(1, any_numbers);
}

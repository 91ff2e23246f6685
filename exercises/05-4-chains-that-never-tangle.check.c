#include "check.h"

#include "query/query.h"
#include "support/rational.h"
#include "support/support.h"

#include <stdio.h>
#include <string.h>

void untangle(int vertices, const double start[][2], int edges,
              const int edge[][2], double end[][2]);

enum {
    MOST = 24
};

/// Chains, and where their vertices are; those of the last chain are fixed.
typedef struct chains {
    int vertices, edges, edge[MOST][2];
    double place[MOST][2];
} chains;

static void add_chain(chains *all, int count, const double place[][2])
{
    for (int i = 0; i < count; i++) {
        if (i > 0) {
            all->edge[all->edges][0] = all->vertices - 1;
            all->edge[all->edges++][1] = all->vertices;
        }
        memcpy(all->place[all->vertices++], place[i], sizeof place[i]);
    }
}

/// Those of a vertex and of the ends of an edge.
static void worldlines(const chains *all, const double end[][2], int vertex,
                       const int edge[2], tf_worldline line[3])
{
    const int index[3] = {vertex, edge[0], edge[1]};
    for (int i = 0; i < 3; i++)
        line[i] = tf_worldline_between(2, all->place[index[i]], end[index[i]]);
}

/// Whether a vertex touches an edge, exactly.
static bool touch(const chains *all, const double end[][2], int vertex,
                  const int edge[2])
{
    tf_worldline line[3];
    worldlines(all, end, vertex, edge, line);
    tf_contact contact;
    tf_query(&oracle_arithmetic, 2, 1, line, 2, line + 1, &contact);
    return contact.verdict == TF_HIT;
}

/// Fails where a vertex touches an edge that it is no end of.
static void expect_apart(const chains *all, const double end[][2],
                         const char *where, int vertex, const int edge[2])
{
    if (vertex == edge[0] || vertex == edge[1] ||
        !touch(all, end, vertex, edge))
        return;
    tf_worldline line[3];
    worldlines(all, end, vertex, edge, line);
    check_input("%s\nthe vertex %d: %s\nand an edge from %d: %s\nto %d: %s",
                where, vertex, text_line(2, &line[0]), edge[0],
                text_line(2, &line[1]), edge[1], text_line(2, &line[2]));
    check_picture(2, 1, line, 2, line + 1);
    check_that(false, "no contact", "one");
}

/// Lets the answer change the ends, and looks at them.
static void step(chains *all, const char *scene, int number, double end[][2])
{
    char where[160];
    snprintf(where, sizeof where, "%s, step %d: %d vertices, %d edges", scene,
             number, all->vertices, all->edges);
    check_input("%s", where);
    check_call_n((size_t)all->vertices, end,
                 untangle(all->vertices, (const double(*)[2])all->place,
                          all->edges, (const int(*)[2])all->edge, end));
    for (int v = 0; v < all->vertices; v++)
        for (int k = 0; k < 2; k++)
            check_that(end[v][k] == end[v][k], "a place for each vertex",
                       "vertex %d at %s", v, text_point(2, end[v]));
    for (int v = 0; v < all->vertices; v++)
        for (int e = 0; e < all->edges; e++)
            expect_apart(all, (const double(*)[2])end, where, v, all->edge[e]);
}

static chains two_bars(void)
{
    chains all = {.vertices = 0};
    add_chain(&all, 2, (const double[][2]){{0, 0}, {4, 0}});
    add_chain(&all, 2, (const double[][2]){{1, 0.7}, {3, 1}});
    add_chain(&all, 2, (const double[][2]){{10, 0}, {12, 3}});
    return all;
}

/// Fails if some of the vertices, which touch nothing, do not end as proposed.
static void expect_as_proposed(const char *why, int from, int to,
                               const double proposed[][2],
                               const double got[][2])
{
    for (int v = from; v < to; v++)
        check_that(memcmp(proposed[v], got[v], sizeof got[v]) == 0, why,
                   "vertex %d, proposed to end at %s, ends at %s", v,
                   text_point(2, proposed[v]), text_point(2, got[v]));
}

TEST(nothing_in_the_way)
{
    chains all = two_bars();
    double proposed[MOST][2], end[MOST][2];
    for (int v = 0; v < all.vertices; v++)
        for (int k = 0; k < 2; k++)
            proposed[v][k] = end[v][k] = all.place[v][k] + 2 - k;
    step(&all, "all are shifted by (2, 1)", 0, end);
    expect_as_proposed("ends as proposed, as nothing touches", 0, all.vertices,
                       (const double(*)[2])proposed, (const double(*)[2])end);
}

TEST(far_from_it_nothing_changes)
{
    chains all = two_bars();
    double proposed[MOST][2], end[MOST][2];
    memcpy(proposed, all.place, sizeof proposed);
    proposed[2][1] = -1;
    proposed[4][0] = 9;
    memcpy(end, proposed, sizeof end);
    step(&all, "the second bar falls through the first, the third turns", 0,
         end);
    expect_as_proposed(
        "a chain that ends as proposed, as no other comes near it", 4, 6,
        (const double(*)[2])proposed, (const double(*)[2])end);
}

TEST(ends_that_touch)
{
    chains all = {.vertices = 0};
    add_chain(&all, 2, (const double[][2]){{0, 0}, {0.3, 0.9}});
    add_chain(&all, 2, (const double[][2]){{-1, 0.3}, {-2, 0.3}});
    double end[MOST][2];
    memcpy(end, all.place, sizeof end);
    // A third of the way up the edge, or next to it: rounding decides nothing.
    for (int i = -2; i <= 2; i++) {
        memcpy(end[2], (double[]){0.1 + i * 0x1p-56, 0.3}, sizeof end[2]);
        step(&all, "a vertex is proposed to end on an edge, or almost", i, end);
    }
}

/// The vertices fall and swing; what lies below does not move.
TEST(chains_that_fall)
{
    chains all = {.vertices = 0};
    double place[6][2];
    for (int chain = 0; chain < 3; chain++) {
        for (int i = 0; i < 6; i++) {
            place[i][0] = 0.5 * i + 0.1 * chain;
            place[i][1] = 1 + 0.5 * chain + 0.1 * (i % 2);
        }
        add_chain(&all, 6, (const double(*)[2])place);
    }
    add_chain(&all, 4,
              (const double[][2]){{-1, 0.5}, {0.7, 0}, {1.6, 0.4}, {4, -1}});
    generator random = generator_new(5);
    double end[MOST][2], lowest = 1;
    for (int n = 0; n < 40; n++) {
        for (int v = 0; v < all.vertices; v++) {
            bool fixed = v >= all.vertices - 4;
            double swing = uniform(&random, -0.1, 0.1);
            end[v][0] = all.place[v][0] + (fixed ? 0 : swing);
            end[v][1] = all.place[v][1] - (fixed ? 0 : 0.06);
        }
        step(&all, "three chains fall on a floor", n, end);
        memcpy(all.place, end, sizeof end);
    }
    for (int v = 0; v < all.vertices - 4; v++)
        lowest = all.place[v][1] < lowest ? all.place[v][1] : lowest;
    check_that(lowest < 0.6, "chains that have fallen to the floor",
               "the lowest vertex at height %s", text_real(lowest));
}

void run_tests(void)
{
    check_run(1, nothing_in_the_way);
    check_run(1, far_from_it_nothing_changes);
    check_run(1, ends_that_touch);
    check_run(1, chains_that_fall);
}

#include "check.h"

#include "query/edge_edge.h"
#include "query/point_triangle.h"
#include "support/rational.h"
#include "support/support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct row {
    int kind;
    int vertex[4];
} row;

int every_contact(const tf_arithmetic *arithmetic, const tf_motion *step,
                  int triangles, const int triangle[][3], row found[]);

/// Of chapter 11: exact signs, in much less time than the oracle takes.
extern const tf_arithmetic tf_exact;

enum {
    ACROSS = 10,
    ALONG = 5, // squares of a sheet
    SHEETS = 2,
    VERTICES = SHEETS * (ACROSS + 1) * (ALONG + 1),
    TRIANGLES = SHEETS * ACROSS * ALONG * 2,
    MOST = 20000 // rows, also of an answer that finds some twice
};

typedef struct scene {
    const char *name;
    int vertices, triangles, triangle[TRIANGLES][3];
    double start[VERTICES][3], end[VERTICES][3];
} scene;

// The right list --------------------------------------------------------------

static bool share(int count, const int a[], int others, const int b[])
{
    for (int i = 0; i < count; i++)
        for (int j = 0; j < others; j++)
            if (a[i] == b[j])
                return true;
    return false;
}

/// Whether two numbers are the ends of an edge of some triangle.
static bool is_edge(const scene *s, int a, int b)
{
    for (int t = 0; t < s->triangles; t++)
        if (share(1, &a, 3, s->triangle[t]) && share(1, &b, 3, s->triangle[t]))
            return true;
    return false;
}

static int compare_rows(const void *a, const void *b)
{
    const row *p = a, *q = b;
    int difference = p->kind - q->kind;
    for (int i = 0; i < 4 && difference == 0; i++)
        difference = p->vertex[i] - q->vertex[i];
    return difference;
}

static int compare_numbers(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

/// Ascending corners and ends, and of two edges the first the lower.
static void normalize(row *one)
{
    int *v = one->vertex, swapped[4] = {v[2], v[3], v[0], v[1]};
    if (one->kind == 1) {
        qsort(v + 1, 3, sizeof *v, compare_numbers);
        return;
    }
    qsort(swapped, 2, sizeof *v, compare_numbers);
    qsort(swapped + 2, 2, sizeof *v, compare_numbers);
    bool turned = swapped[0] < swapped[2] ||
                  (swapped[0] == swapped[2] && swapped[1] < swapped[3]);
    memcpy(v, swapped + (turned ? 0 : 2), 2 * sizeof *v);
    memcpy(v + 2, swapped + (turned ? 2 : 0), 2 * sizeof *v);
}

static bool is_contact(const tf_motion *step, const row *one)
{
    tf_contact contact = {.verdict = TF_UNDECIDED};
    if (one->kind == 1)
        tf_point_triangle(&oracle_arithmetic, step, one->vertex[0],
                          one->vertex + 1, &contact);
    else
        tf_edge_edge(&oracle_arithmetic, step, one->vertex, one->vertex + 2,
                     &contact);
    return contact.verdict == TF_HIT;
}

static int add_if_contact(const tf_motion *step, row one, row right[],
                          int count)
{
    if (share(1 + (one.kind == 2), one.vertex, 4 - one.kind,
              one.vertex + one.kind))
        return count;
    normalize(&one);
    check_that(count < MOST, "room for all rows", "none");
    right[count] = one;
    return count + is_contact(step, &one);
}

static int list_contacts(const scene *s, const tf_motion *step, row right[])
{
    static int edge[3 * TRIANGLES][2];
    int count = 0, edges = 0;
    for (int t = 0; t < s->triangles; t++) {
        const int *c = s->triangle[t];
        for (int v = 0; v < s->vertices; v++)
            count = add_if_contact(step, (row){1, {v, c[0], c[1], c[2]}}, right,
                                   count);
    }
    for (int a = 0; a < s->vertices; a++)
        for (int b = a + 1; b < s->vertices; b++)
            if (is_edge(s, a, b)) {
                edge[edges][0] = a;
                edge[edges++][1] = b;
            }
    for (int e = 0; e < edges; e++)
        for (int f = 0; f < e; f++)
            count = add_if_contact(
                step,
                (row){2, {edge[f][0], edge[f][1], edge[e][0], edge[e][1]}},
                right, count);
    qsort(right, (size_t)count, sizeof *right, compare_rows);
    return count;
}

// The comparison --------------------------------------------------------------

static const char *text_row(const row *one)
{
    static char text[2][80];
    static int next;
    const int *v = one->vertex;
    next = !next;
    snprintf(text[next], sizeof *text,
             one->kind == 1 ? "vertex %d and the triangle %d, %d, %d"
                            : "the edges %d, %d and %d, %d",
             v[0], v[1], v[2], v[3]);
    return text[next];
}

static void expect_rows(int rights, const row right[], int count, row found[])
{
    for (int i = 0; i < count; i++) {
        check_that(found[i].kind == 1 || found[i].kind == 2, "kind 1 or 2",
                   "%d in row %d", found[i].kind, i);
        normalize(&found[i]);
    }
    qsort(found, (size_t)count, sizeof *found, compare_rows);
    for (int i = 0; i < count || i < rights; i++) {
        int order = i == count    ? 1
                    : i == rights ? -1
                                  : compare_rows(&found[i], &right[i]);
        bool twice =
            i > 0 && i < count && compare_rows(&found[i], &found[i - 1]) == 0;
        check_that(!twice, "each contact once", "%s twice",
                   text_row(&found[i < count ? i : 0]));
        check_that(order <= 0, text_row(&right[i < rights ? i : 0]),
                   "not in your list");
        check_that(order >= 0, "no such contact", "%s",
                   text_row(&found[i < count ? i : 0]));
    }
}

static void expect(const scene *s)
{
    static row found[MOST], right[MOST];
    const tf_motion step = {3, s->vertices, s->start[0], s->end[0]};
    memset(found, 0, sizeof found);
    check_input("%s: %d vertices, %d triangles", s->name, s->vertices,
                s->triangles);
    int count;
    check_value(count, every_contact(&tf_exact, &step, s->triangles,
                                     s->triangle, found));
    check_also(found);
    check_that(count >= 0 && count <= MOST, "a number of rows", "%d", count);
    if (!check_makes_calls())
        expect_rows(list_contacts(s, &step, right), right, count, found);
}

// The scenes ------------------------------------------------------------------

/// A sheet at a height, and its two triangles of each square.
static void add_sheet(scene *s, generator *random, int across, double low,
                      double high, bool on_lattice)
{
    int first = s->vertices;
    for (int i = 0; i <= across; i++)
        for (int j = 0; j <= ALONG; j++) {
            double z = uniform(random, -0.4, 0.4);
            double *start = s->start[s->vertices], *end = s->end[s->vertices];
            memcpy(start, (double[]){i, j, low}, sizeof *s->start);
            memcpy(end, (double[]){i, j, high}, sizeof *s->end);
            start[2] += on_lattice ? 0 : z;
            end[on_lattice ? 0 : 2] += on_lattice ? below(random, 2) : z / 2;
            s->vertices++;
        }
    for (int i = 0; i < across; i++)
        for (int j = 0; j < ALONG; j++) {
            int a = first + i * (ALONG + 1) + j, b = a + ALONG + 1;
            memcpy(s->triangle[s->triangles++], (int[]){a, b, b + 1},
                   sizeof *s->triangle);
            memcpy(s->triangle[s->triangles++], (int[]){b + 1, a + 1, a},
                   sizeof *s->triangle);
        }
}

TEST(two_triangles)
{
    static const scene tips = {
        "a triangle falls on another one, tip first",
        6,
        2,
        {{5, 1, 3}, {0, 2, 4}},
        {{2, 1, 0}, {0, 0, 0}, {1, 0, 2}, {4, 0, 0}, {2, 1, 3}, {0, 4, 0}},
        {{2, 1, 0}, {0, 0, 0}, {1, 0, 2}, {4, 0, 0}, {2, 1, 3}, {0, 4, 0}}};
    scene s = tips;
    expect(&s);
    s.end[0][2] = s.end[2][2] = s.end[4][2] = -1;
    expect(&s);
}

TEST(sheets_that_cross)
{
    static scene s = {.name = "two wavy sheets pass through each other"};
    generator random = generator_new(8);
    add_sheet(&s, &random, ACROSS, 0, 0.2, false);
    add_sheet(&s, &random, ACROSS, 0.7, -0.3, false);
    expect(&s);
}

TEST(sheets_that_touch)
{
    static scene s = {.name = "a sheet falls flat on another"};
    generator random = generator_new(9);
    add_sheet(&s, &random, 1, 0, 0, true);
    add_sheet(&s, &random, 1, 1, 0, true);
    expect(&s);
}

void run_tests(void)
{
    check_run(1, two_triangles);
    check_run(1, sheets_that_cross);
    check_run(1, sheets_that_touch);
}

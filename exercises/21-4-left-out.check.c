#include "check.h"

#include "support/support.h"

#include <stdbool.h>
#include <stdio.h>

enum {
    ACROSS = 4, ///< squares of a row of the sheets
    ROW = ACROSS + 1,
    SHEET = 2 * ACROSS * ACROSS, ///< triangles of a sheet
    TRIANGLES = 2 * SHEET
};

bool is_left_out(int triangles, const int triangle[][3], const int zone[],
                 int first, const int a[], int second, const int b[]);

/// Two sheets, with the zone of each triangle.
typedef struct sheets {
    int triangle[TRIANGLES][3], zone[TRIANGLES];
} sheets;

/// An element, and with it an unused vertex where it has fewer than three.
typedef struct element {
    int count, vertex[3];
} element;

static sheets sheets_new(void)
{
    sheets s;
    for (int t = 0; t < TRIANGLES; t++) {
        int square = t % SHEET / 2;
        int corner =
            t / SHEET * ROW * ROW + square / ACROSS * ROW + square % ACROSS;
        const int half[2][3] = {{corner, corner + 1, corner + ROW + 1},
                                {corner, corner + ROW + 1, corner + ROW}};
        for (int k = 0; k < 3; k++)
            s.triangle[t][k] = half[t % 2][k];
        s.zone[t] = -1;
    }
    return s;
}

static bool contains(const int triangle[3], const element *e)
{
    int found = 0;
    for (int i = 0; i < e->count; i++)
        for (int k = 0; k < 3; k++)
            found += triangle[k] == e->vertex[i];
    return found == e->count;
}

/// Whether each triangle at a is in the zone of each triangle at b.
static bool share_one_zone(const sheets *s, const element *a, const element *b)
{
    for (int i = 0; i < TRIANGLES; i++)
        for (int j = 0; j < TRIANGLES; j++)
            if (contains(s->triangle[i], a) && contains(s->triangle[j], b) &&
                (s->zone[i] < 0 || s->zone[i] != s->zone[j]))
                return false;
    return true;
}

/// "edge 1 2, at triangles of the zones 0, 0".
static void describe(const sheets *s, const element *e, char text[200])
{
    static const char *const name[] = {"vertex", "edge", "triangle"};
    int length = sprintf(text, "%s", name[e->count - 1]);
    for (int i = 0; i < e->count; i++)
        length += sprintf(text + length, " %d", e->vertex[i]);
    length += sprintf(text + length, " (triangles of the zones");
    for (int t = 0; t < TRIANGLES; t++)
        if (contains(s->triangle[t], e))
            length += sprintf(text + length, " %d", s->zone[t]);
    sprintf(text + length, ")");
}

static void expect(const sheets *s, const element *a, const element *b)
{
    char of_a[200], of_b[200];
    describe(s, a, of_a);
    describe(s, b, of_b);
    check_input("%s and %s", of_a, of_b);
    bool got;
    check_value(got, is_left_out(TRIANGLES, s->triangle, s->zone, a->count,
                                 a->vertex, b->count, b->vertex));
    check_bool(share_one_zone(s, a, b), got);
}

static const element low_vertex = {1, {6}}, high_vertex = {1, {33}},
                     low_edge = {2, {6, 7}}, high_edge = {2, {33, 32}},
                     low_face = {3, {6, 7, 12}}, high_face = {3, {31, 37, 36}};

static void expect_all(const sheets *s)
{
    expect(s, &low_face, &high_face);
    expect(s, &low_edge, &high_edge);
    expect(s, &low_vertex, &high_face);
    expect(s, &high_vertex, &low_face);
}

TEST(no_zone)
{
    sheets s = sheets_new();
    expect_all(&s);
}

TEST(one_zone)
{
    sheets s = sheets_new();
    for (int t = 0; t < TRIANGLES; t++)
        s.zone[t] = 0;
    expect_all(&s);
}

TEST(a_zone_for_each_sheet)
{
    sheets s = sheets_new();
    for (int t = 0; t < TRIANGLES; t++)
        s.zone[t] = t / SHEET;
    expect_all(&s);
    expect(&s, &low_vertex, &low_edge);
}

/// In one zone but for a triangle at a time, which is in none or in another.
static void expect_all_but_one(int another)
{
    for (int t = 0; t < TRIANGLES; t++) {
        sheets s = sheets_new();
        for (int i = 0; i < TRIANGLES; i++)
            s.zone[i] = i == t ? another : 0;
        expect_all(&s);
    }
}

TEST(all_but_one)
{
    expect_all_but_one(-1);
    expect_all_but_one(1);
}

static element random_element(generator *random, const sheets *s)
{
    element e = {.count = 1 + below(random, 3)};
    int t = below(random, TRIANGLES), turn = below(random, 3);
    for (int i = 0; i < 3; i++)
        e.vertex[i] = s->triangle[t][(i + turn) % 3];
    return e;
}

TEST(some_at_random)
{
    generator random = generator_new(21);
    for (int times = 0; times < 400; times++) {
        sheets s = sheets_new();
        // Zones are patches: a triangle seldom differs from the one before.
        int zone = 0, often = 2 + below(&random, 30);
        for (int t = 0; t < TRIANGLES; t++) {
            zone = below(&random, often) ? zone : below(&random, 3) - 1;
            s.zone[t] = zone;
        }
        element a = random_element(&random, &s);
        element b = random_element(&random, &s);
        expect(&s, &a, &b);
    }
}

void run_tests(void)
{
    check_run(1, no_zone);
    check_run(1, one_zone);
    check_run(1, a_zone_for_each_sheet);
    check_run(1, all_but_one);
    check_run(1, some_at_random);
}

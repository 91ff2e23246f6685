#include "check.h"

#include "support/support.h"

#include <stdio.h>
#include <string.h>

enum {
    FACES = 4,
    PLACES = 8
};

long six_volumes(int triangles, const int triangle[][3], const int place[][3]);

static const int regular[4][3] = {
    {1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
static const int faces[FACES][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};

static void expect(long right, int triangles, const int triangle[][3],
                   int places, const int place[][3])
{
    char text[600];
    int length = 0;
    for (int v = 0; v < places; v++)
        length += snprintf(text + length, sizeof text - (size_t)length,
                           "%s%d: (%d, %d, %d)", v == 0 ? "" : ", ", v,
                           place[v][0], place[v][1], place[v][2]);
    for (int t = 0; t < triangles; t++)
        length += snprintf(text + length, sizeof text - (size_t)length,
                           "%s%d %d %d", t == 0 ? "; triangles " : ", ",
                           triangle[t][0], triangle[t][1], triangle[t][2]);
    check_input("%s", text);
    long got;
    check_value(got, six_volumes(triangles, triangle, place));
    char expected[32];
    snprintf(expected, sizeof expected, "%ld", right);
    check_that(got == right, expected, "%ld", got);
}

TEST(a_corner_through_the_opposite_side)
{
    int place[4][3];
    memcpy(place, regular, sizeof place);
    expect(16, FACES, faces, 4, (const int(*)[3])place);
    for (int k = 0; k < 3; k++)
        place[0][k] = -2;
    expect(-20, FACES, faces, 4, (const int(*)[3])place);
}

TEST(gaps)
{
    static const int triangle[FACES + 2][3] = {
        {0, 1, 2}, {-1, 5, -1}, {0, 2, 3}, {0, 3, 1}, {-1, -1, -1}, {1, 3, 2}};
    expect(16, FACES + 2, triangle, 4, regular);
}

TEST(far_from_the_origin)
{
    int place[4][3];
    for (int v = 0; v < 4; v++)
        for (int k = 0; k < 3; k++)
            place[v][k] = regular[v][k] + 990;
    expect(16, FACES, faces, 4, (const int(*)[3])place);
}

/// Tetrahedra, of which some are inside out.
TEST(at_random)
{
    generator random = generator_new(0);
    for (int i = 0; i < 500; i++) {
        int place[PLACES][3], triangle[2 * FACES][3];
        long right = 0;
        for (int v = 0; v < PLACES; v++)
            for (int k = 0; k < 3; k++)
                place[v][k] = below(&random, 2001) - 1000;
        for (int part = 0; part < 2; part++) {
            const int(*x)[3] = (const int(*)[3])place + 4 * part;
            long u[3][3];
            for (int j = 0; j < 9; j++)
                u[j / 3][j % 3] = x[j / 3 + 1][j % 3] - x[0][j % 3];
            // Faces turn outward if the three edges turn to the left.
            right -= u[0][0] * (u[1][1] * u[2][2] - u[1][2] * u[2][1]) +
                     u[0][1] * (u[1][2] * u[2][0] - u[1][0] * u[2][2]) +
                     u[0][2] * (u[1][0] * u[2][1] - u[1][1] * u[2][0]);
            for (int t = 0; t < FACES; t++)
                for (int j = 0; j < 3; j++)
                    triangle[part * FACES + t][j] = 4 * part + faces[t][j];
        }
        expect(right, 2 * FACES, (const int(*)[3])triangle, PLACES,
               (const int(*)[3])place);
    }
}

void run_tests(void)
{
    check_run(1, a_corner_through_the_opposite_side);
    check_run(1, gaps);
    check_run(1, far_from_the_origin);
    check_run(1, at_random);
}

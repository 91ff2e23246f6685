#include "check.h"

#include "support/support.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum {
    MOST_ROWS = 24,
    MOST_COLUMNS = 12,
    PRIME = 1000003
};

int rank_of(int n, double a[]);

/// The rank of integers, modulo a prime: exact as they are small.
static int rank_modulo(int rows, int columns,
                       const int64_t given[MOST_ROWS][MOST_COLUMNS])
{
    int64_t m[MOST_ROWS][MOST_COLUMNS];
    memcpy(m, given, sizeof m);
    int rank = 0;
    for (int j = 0; j < columns && rank < rows; j++) {
        int p = rank;
        while (p < rows && m[p][j] % PRIME == 0)
            p++;
        if (p == rows)
            continue;
        for (int k = 0; k < columns; k++) {
            int64_t swapped = m[p][k];
            m[p][k] = m[rank][k];
            m[rank][k] = swapped;
        }
        for (int i = rank + 1; i < rows; i++) {
            int64_t above = m[rank][j], here = m[i][j];
            for (int k = 0; k < columns; k++)
                m[i][k] = (m[i][k] * above - m[rank][k] * here) % PRIME;
        }
        rank++;
    }
    return rank;
}

/// The rank of J J', where J are integers, times a unit.
static void expect(int rows, int columns,
                   const int64_t j[MOST_ROWS][MOST_COLUMNS], double unit)
{
    static double a[MOST_ROWS * MOST_ROWS];
    for (int i = 0; i < rows; i++)
        for (int k = 0; k < rows; k++) {
            int64_t sum = 0;
            for (int l = 0; l < columns; l++)
                sum += j[i][l] * j[k][l];
            a[rows * i + k] = unit * (double)sum;
        }
    char text[32 * MOST_ROWS];
    int length = 0, right = rank_modulo(rows, columns, j);
    for (int i = 0; i < rows * rows && i < 16; i++)
        length += snprintf(text + length, sizeof text - (size_t)length, "%s%s",
                           i ? ", " : "", text_real(a[i]));
    check_input("a matrix with %d rows: %s%s", rows, text,
                rows * rows > 16 ? ", ..." : "");
    int got;
    check_value(got, rank_of(rows, a));
    char number[16];
    snprintf(number, sizeof number, "%d", right);
    check_that(got == right, number, "%d", got);
}

TEST(beads)
{
    const int64_t three[MOST_ROWS][MOST_COLUMNS] = {
        {-1, 1, 0}, {0, -1, 1}, {0, 0, -1}};
    expect(1, 3, three, 1);
    expect(3, 3, three, 1);
    expect(3, 3, three, 1e-12);
}

TEST(rows_that_repeat)
{
    const int64_t first[MOST_ROWS][MOST_COLUMNS] = {
        {-1, 1, 0}, {-1, 1, 0}, {0, -1, 1}, {0, 0, -1}};
    expect(2, 3, first, 1);
    expect(4, 3, first, 1);
    const int64_t all[MOST_ROWS][MOST_COLUMNS] = {
        {-1, 1, 0}, {0, -1, 1}, {-1, 0, 1}, {-2, 1, 1}};
    expect(4, 3, all, 1);
    expect(4, 3, all, 1.0 / 3);
}

TEST(some_at_random)
{
    static const double unit[] = {1, 0.1, 1.0 / 3, 1e-15, 1e12};
    generator random = generator_new(18);
    for (int times = 0; times < 500; times++) {
        int64_t j[MOST_ROWS][MOST_COLUMNS] = {{0}};
        int rows = 1 + below(&random, MOST_ROWS);
        int columns = 1 + below(&random, MOST_COLUMNS);
        for (int i = 0; i < rows; i++)
            for (int k = 0; k < columns; k++)
                j[i][k] = i > 0 && below(&random, 3) == 0
                              ? j[below(&random, i)][k]
                              : below(&random, 3) - 1;
        for (int i = 1; i < rows; i++)
            if (below(&random, 3) == 0)
                memcpy(j[i], j[below(&random, i)], sizeof j[i]);
        expect(rows, columns, (const int64_t(*)[MOST_COLUMNS])j,
               unit[below(&random, 5)]);
    }
}

void run_tests(void)
{
    check_run(1, beads);
    check_run(1, rows_that_repeat);
    check_run(1, some_at_random);
}

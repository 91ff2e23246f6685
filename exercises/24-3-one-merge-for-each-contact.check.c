#include "check.h"

#include "support/support.h"

#include <stdbool.h>
#include <stdio.h>

enum {
    PIECES = 12,
    PAIRS = 40
};

int merge_contacts(int pieces, int pairs, const int pair[][2],
                   const bool refused[], bool merged[]);

/// Whether two pieces are connected by the first pairs that are merged.
static bool are_connected(int pairs, const int pair[][2], const bool merged[],
                          int a, int b)
{
    bool reached[PIECES] = {false};
    reached[a] = true;
    for (int round = 0; round < PIECES; round++)
        for (int i = 0; i < pairs; i++)
            if (merged[i] && (reached[pair[i][0]] || reached[pair[i][1]]))
                reached[pair[i][0]] = reached[pair[i][1]] = true;
    return reached[b];
}

static void expect(int pairs, const int pair[][2], const bool refused[])
{
    bool right[PAIRS], got[PAIRS];
    char text[20 * PAIRS], expected[PAIRS + 32], found[PAIRS + 32];
    int length = 0, count = 0;
    bool same = true;
    for (int i = 0; i < pairs; i++) {
        right[i] = !refused[i] &&
                   !are_connected(i, pair, right, pair[i][0], pair[i][1]);
        got[i] = false;
        count += right[i];
        length += snprintf(text + length, sizeof text - (size_t)length,
                           "%s%d %d%s", i == 0 ? "" : ", ", pair[i][0],
                           pair[i][1], refused[i] ? " refused" : "");
    }
    check_input("%d pieces, pairs %s", PIECES, text);
    int returned;
    check_value(returned, merge_contacts(PIECES, pairs, pair, refused, got));
    check_also(got);
    int ends[] = {snprintf(expected, sizeof expected, "%d, merged: ", count),
                  snprintf(found, sizeof found, "%d, merged: ", returned)};
    for (int i = 0; i < pairs; i++) {
        expected[ends[0]++] = right[i] ? '1' : '0';
        found[ends[1]++] = got[i] ? '1' : '0';
        same &= right[i] == got[i];
    }
    expected[ends[0]] = found[ends[1]] = '\0';
    check_that(same && returned == count, expected, "%s", found);
}

TEST(one_contact)
{
    static const int pair[][2] = {{0, 1}, {1, 0}, {0, 1}};
    expect(3, pair, (bool[]){false, false, false});
}

TEST(the_nearest_is_refused)
{
    static const int pair[][2] = {{0, 1}, {1, 0}, {0, 1}};
    expect(3, pair, (bool[]){true, false, false});
}

TEST(within_a_piece)
{
    static const int pair[][2] = {{3, 3}, {3, 4}};
    expect(2, pair, (bool[]){false, false});
}

// Three pieces that all face each other.
TEST(no_cycle)
{
    static const int pair[][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 2}};
    expect(5, pair, (bool[]){false, false, false, false, false});
}

TEST(at_random)
{
    generator random = generator_new(0);
    for (int run = 0; run < 200; run++) {
        int pair[PAIRS][2];
        bool refused[PAIRS];
        for (int i = 0; i < PAIRS; i++) {
            pair[i][0] = below(&random, PIECES);
            pair[i][1] = below(&random, PIECES);
            refused[i] = below(&random, 3) == 0;
        }
        expect(PAIRS, (const int(*)[2])pair, refused);
    }
}

void run_tests(void)
{
    check_run(1, one_contact);
    check_run(1, the_nearest_is_refused);
    check_run(1, within_a_piece);
    check_run(1, no_cycle);
    check_run(1, at_random);
}

#include "check.h"

#include "support/support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct box {
    float low[3], high[3];
} box;

int find_overlaps(int count, const box boxes[], int pair[][2]);

enum {
    FEW = 200,
    SIDE = 316, // boxes along a side of the sheet
    SHEET = SIDE * SIDE,
    MOST = 5 * SHEET // pairs
};

static int found[MOST][2], right[MOST][2];

// The right list --------------------------------------------------------------

static bool overlap(const box *a, const box *b)
{
    bool all = true;
    for (int k = 0; k < 3; k++)
        all &= fmaxf(a->low[k], b->low[k]) <= fminf(a->high[k], b->high[k]);
    return all;
}

static int add_if_overlap(const box boxes[], int a, int b, int count)
{
    right[count][0] = a < b ? a : b;
    right[count][1] = a < b ? b : a;
    return count + overlap(&boxes[a], &boxes[b]);
}

static int compare_pairs(const void *a, const void *b)
{
    const int *p = a, *q = b;
    int first = (p[0] > q[0]) - (p[0] < q[0]);
    return first ? first : (p[1] > q[1]) - (p[1] < q[1]);
}

// The comparison --------------------------------------------------------------

static const char *text_box(const box *one)
{
    static char text[2][200];
    static int next;
    next = !next;
    double low[3], high[3];
    for (int k = 0; k < 3; k++) {
        low[k] = (double)one->low[k];
        high[k] = (double)one->high[k];
    }
    snprintf(text[next], sizeof *text, "%s to %s", text_point(3, low),
             text_point(3, high));
    return text[next];
}

static const char *text_pair(const box boxes[], const int pair[2])
{
    static char text[500];
    snprintf(text, sizeof text, "the pair %d, %d:\n%s\n%s", pair[0], pair[1],
             text_box(&boxes[pair[0]]), text_box(&boxes[pair[1]]));
    return text;
}

static void expect_pairs(int count, const box boxes[], int rights, int pairs)
{
    for (int i = 0; i < pairs; i++)
        check_that(0 <= found[i][0] && found[i][0] < found[i][1] &&
                       found[i][1] < count,
                   "the numbers of two boxes, the smaller one first", "%d, %d",
                   found[i][0], found[i][1]);
    qsort(found, (size_t)pairs, sizeof *found, compare_pairs);
    for (int i = 0; i < pairs || i < rights; i++) {
        int order = i == pairs    ? 1
                    : i == rights ? -1
                                  : compare_pairs(found[i], right[i]);
        bool twice =
            i > 0 && i < pairs && compare_pairs(found[i], found[i - 1]) == 0;
        check_that(!twice, "each pair once", "%d, %d twice", found[i][0],
                   found[i][1]);
        if (order > 0)
            check_that(false, text_pair(boxes, right[i]), "not it");
        if (order < 0)
            check_that(false, "no pair that is apart", "%s",
                       text_pair(boxes, found[i]));
    }
}

/// There is room for `room` pairs; of the right ones there are `rights`.
static void expect(const char *name, int count, const box boxes[], int room,
                   int rights)
{
    check_input("%s: %d boxes", name, count);
    memset(found, 0, sizeof *found * (size_t)room);
    int pairs;
    check_value(pairs, find_overlaps(count, boxes, found));
    check_that(0 <= pairs && pairs <= room, "a number of pairs", "%d", pairs);
    check_take(found, sizeof *found * (size_t)pairs);
    qsort(right, (size_t)rights, sizeof *right, compare_pairs);
    expect_pairs(count, boxes, rights, pairs);
}

static void expect_few(const char *name, int count, const box boxes[])
{
    int rights = 0;
    for (int a = 0; a < count; a++)
        for (int b = a + 1; b < count; b++)
            rights = add_if_overlap(boxes, a, b, rights);
    expect(name, count, boxes, count * count, rights);
}

// The scenes ------------------------------------------------------------------

TEST(a_touch_is_an_overlap)
{
    const float after = nextafterf(1, 2);
    expect_few("a side, an edge, a corner", 4,
               (box[]){{{0, 0, 0}, {1, 1, 1}},
                       {{1, 0, 0}, {2, 1, 1}},
                       {{1, 1, 0}, {2, 2, 1}},
                       {{1, 1, 1}, {2, 2, 2}}});
    expect_few("apart by a unit in the last place", 2,
               (box[]){{{0, 0, 0}, {1, 1, 1}}, {{0, after, 0}, {1, 2, 1}}});
}

TEST(one_box_holds_all)
{
    box boxes[FEW] = {{{0, 0, 0}, {FEW, 1, 1}}};
    for (int i = 1; i < FEW; i++) {
        float x = (float)(i * 71 % FEW); // in no order
        boxes[i] = (box){{x, 0, 0}, {x + 0.5F, 0.5F, 0.5F}};
    }
    expect_few("one large box and many small ones in it", FEW, boxes);
}

TEST(all_are_the_same)
{
    box boxes[FEW / 4];
    for (int i = 0; i < FEW / 4; i++)
        boxes[i] = (box){{1, 2, 3}, {2, 3, 4}};
    expect_few("a box, many times", FEW / 4, boxes);
}

/// Some are flat, or points; many touch.
TEST(on_a_lattice)
{
    generator random = generator_new(0);
    for (int run = 0; run < 100; run++) {
        box boxes[FEW];
        int count = below(&random, run < 20 ? 3 : FEW);
        for (int i = 0; i < count; i++)
            for (int k = 0; k < 3; k++) {
                int low = below(&random, 12) - 6;
                boxes[i].low[k] = (float)low;
                boxes[i].high[k] = (float)(low + below(&random, 4));
            }
        expect_few("boxes on a lattice", count, boxes);
    }
}

/// Each box overlaps none but its neighbors in the sheet.
TEST(along_a_sheet)
{
    static box boxes[SHEET];
    static int number[SHEET];
    generator random = generator_new(1);
    int rights = 0;
    for (int i = 0; i < SHEET; i++) {
        int other = below(&random, i + 1);
        number[i] = number[other];
        number[other] = i;
    }
    for (int i = 0; i < SHEET; i++) {
        const double at[3] = {i / SIDE, i % SIDE, 10 * sin(i % SIDE * 0.1)};
        for (int k = 0; k < 3; k++) {
            boxes[number[i]].low[k] =
                (float)(at[k] - uniform(&random, 0.3, 0.6));
            boxes[number[i]].high[k] =
                (float)(at[k] + uniform(&random, 0.3, 0.6));
        }
    }
    for (int i = 0; i < SHEET; i++)
        for (int n = 0; n < 4; n++) {
            int x = i / SIDE + (n > 0), y = i % SIDE + (n == 0 ? 1 : n - 2);
            if (x < SIDE && y >= 0 && y < SIDE)
                rights = add_if_overlap(boxes, number[i], number[SIDE * x + y],
                                        rights);
        }
    expect("a wavy sheet", SHEET, boxes, MOST, rights);
}

void run_tests(void)
{
    check_run(1, a_touch_is_an_overlap);
    check_run(1, one_box_holds_all);
    check_run(1, all_are_the_same);
    check_run(1, on_a_lattice);
    check_run(1, along_a_sheet);
}

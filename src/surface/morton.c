//: Shuffle the bits of three numbers
#include "surface/morton.h"

#include <string.h>

/// The ten bits of x, two zeros between each and the next.
static uint32_t spread(uint32_t x)
{
    x = (x | x << 16) & 0x030000ff;
    x = (x | x << 8) & 0x0300f00f;
    x = (x | x << 4) & 0x030c30c3;
    return (x | x << 2) & 0x09249249;
}

//: Find the place along the Morton curve
uint32_t tf_morton_key(const tf_box *box, const tf_box *whole)
{
    uint32_t key = 0;
    for (int k = 0; k < 3; k++) {
        float extent = whole->high[k] - whole->low[k];
        float twice =
            (box->low[k] - whole->low[k]) + (box->high[k] - whole->low[k]);
        float place = extent > 0 ? twice / (2 * extent) : 0;
        // A float, too, where expressions are evaluated as doubles.
        float at = place * TF_CELLS;
        // At the high side of the whole, rounded to 1, it has none of its own.
        uint32_t cell = at < TF_CELLS ? (uint32_t)at : TF_CELLS - 1;
        key |= spread(cell) << k;
    }
    return key;
}

//: Hold one pass of the sort
typedef struct pass {
    int count, size; ///< of all items, and of a task
    int shift;       ///< of the digit of this pass
    const tf_keyed *from;
    tf_keyed *to;
    tf_digit_counts *counts; ///< of each task: of its digits, then their places
} pass;

static int digit(const pass *p, int i)
{
    return (int)(p->from[i].key >> p->shift & (TF_DIGITS - 1));
}

//: Count the digits of a part
static void count_digits(void *argument, int task, int worker)
{
    const pass *p = argument;
    tf_range part = tf_range_part(p->count, p->size, task);
    int *count = p->counts[task];
    (void)worker;
    memset(count, 0, sizeof *p->counts);
    for (int i = part.begin; i < part.end; i++)
        count[digit(p, i)]++;
}

//: Turn counts into places
/// Where the items of each task go, digit by digit, and for each digit task by
/// task: so equal digits stay in their order.
static void place_digits(const pass *p)
{
    int tasks = tf_range_parts(p->count, p->size);
    tf_digit_counts next = {0};
    for (int task = 0; task < tasks; task++)
        for (int d = 0; d < TF_DIGITS; d++)
            next[d] += p->counts[task][d];
    int place = 0;
    for (int d = 0; d < TF_DIGITS; d++) {
        int count = next[d];
        next[d] = place;
        place += count;
    }
    for (int task = 0; task < tasks; task++)
        for (int d = 0; d < TF_DIGITS; d++) {
            int count = p->counts[task][d];
            p->counts[task][d] = next[d];
            next[d] += count;
        }
}

//: Move the items of a part
static void move_items(void *argument, int task, int worker)
{
    const pass *p = argument;
    tf_range part = tf_range_part(p->count, p->size, task);
    int *place = p->counts[task];
    (void)worker;
    for (int i = part.begin; i < part.end; i++)
        p->to[place[digit(p, i)]++] = p->from[i];
}

//: Sort by Morton key
tf_keyed *tf_morton_sort(int count, tf_keyed *from, tf_keyed *to,
                         tf_digit_counts *counts, const tf_parallel *parallel)
{
    pass p = {.count = count,
              .size = tf_range_size(count, TF_SORT_PARTS, TF_SORT_PART),
              .counts = counts};
    for (p.shift = 0; p.shift < 30; p.shift += 10) {
        p.from = from;
        p.to = to;
        int tasks = tf_range_parts(count, p.size);
        tf_parallel_for_each(parallel, tasks, count_digits, &p);
        place_digits(&p);
        tf_parallel_for_each(parallel, tasks, move_items, &p);
        to = from;
        from = p.to;
    }
    return from;
}

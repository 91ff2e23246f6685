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
tf_morton_grid tf_morton_grid_of(const tf_box *whole, int paths)
{
    tf_morton_grid grid;
    for (int k = 0; k < TF_AXES; k++) {
        float extent = (float)paths * (whole->high[k] - whole->low[k]);
        grid.low[k] = (float)paths * whole->low[k];
        // What is as flat as this has one cell, and nothing overflows.
        grid.cells[k] = extent > 0x1p-100f ? TF_CELLS / extent : 0;
    }
    return grid;
}

uint32_t tf_morton_key(const tf_path *path, const tf_morton_grid *grid)
{
    uint32_t key = 0;
    for (int k = 0; k < TF_AXES; k++) {
        int cell = (int)((path->at[k] - grid->low[k]) * grid->cells[k]);
        cell = cell < 0 ? 0 : cell < TF_CELLS ? cell : TF_CELLS - 1;
        key |= spread((uint32_t)cell) << k;
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

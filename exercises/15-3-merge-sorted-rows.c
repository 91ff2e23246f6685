/* Exercise 15.3.  Merging the sorted rows of all workers.
 *
 * The library sorts the rows of all workers at once, on one thread.  Each worker
 * could sort its own while the others do the same, and only merging would be
 * left.  Write that: row[i] are the count[i] rows of worker i, in the order of a
 * detection, and no two rows of all are equal in that order.  Store all of them
 * in `merged`, in order, without sorting.
 *
 * Section: One order for all.
 *
 * Hint 1: At each worker keep the place of the first row that is not merged yet.
 *     The next row of all is the least of these.
 * Hint 2: A worker may have no rows, at the start or after some time.
 * Hint 3: Rows are ordered by kind, then by the first vertex, then by the
 *     second, the third and the fourth.
 */
#include "surface/detect.h"

enum {
    MOST_WORKERS = 8
};

/// Whether a row comes before another one.
static bool is_before(const tf_surface_contact *a, const tf_surface_contact *b)
{
    if (a->kind != b->kind)
        return a->kind < b->kind;
#if defined TF_WRONG_1 // compares the first vertices only
    return a->vertex[0] < b->vertex[0];
#else
    for (int i = 0; i < 4; i++)
        if (a->vertex[i] != b->vertex[i])
            return a->vertex[i] < b->vertex[i];
    return false;
#endif
}

void merge_rows(int workers, const size_t count[],
                const tf_surface_contact *const row[],
                tf_surface_contact merged[])
{
    size_t next[MOST_WORKERS] = {0}, all = 0;
#if defined TF_SOLUTION || defined TF_WRONG_1
    for (;;) {
        int least = -1;
        for (int i = 0; i < workers; i++)
            if (next[i] < count[i] &&
                (least < 0 ||
                 is_before(&row[i][next[i]], &row[least][next[least]])))
                least = i;
        if (least < 0)
            return;
        merged[all++] = row[least][next[least]++];
    }
#elif defined TF_WRONG_2 // stops when the first worker has no more
    while (next[0] < count[0]) {
        int least = 0;
        for (int i = 1; i < workers; i++)
            if (next[i] < count[i] &&
                is_before(&row[i][next[i]], &row[least][next[least]]))
                least = i;
        merged[all++] = row[least][next[least]++];
    }
#elif defined TF_WRONG_3 // takes from each in turn
    for (size_t i = 0; i < 1000; i++)
        for (int w = 0; w < workers; w++)
            if (next[w] < count[w] && !is_before(row[w], row[w]))
                merged[all++] = row[w][next[w]++];
#else
    // Your turn: all rows are there, but not in order.
    for (int i = 0; i < workers; i++)
        for (; next[i] < count[i]; next[i]++)
            if (!is_before(row[i], row[i]))
                merged[all++] = row[i][next[i]];
#endif
}

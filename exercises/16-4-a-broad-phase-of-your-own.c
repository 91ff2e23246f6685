/* Exercise 16.4.  Project: a broad phase of your own.
 *
 * Find all pairs of boxes that overlap.  Boxes are closed, so two that only
 * touch overlap, too.  Write each pair once, in any order, with the smaller of
 * its two numbers first, and return how many pairs there are; there is room for
 * all.
 *
 * Any method will do: sort the boxes along an axis, put them into the cells of
 * a grid, build a tree.  Do it without the library's tree.  The last check has
 * 100,000 boxes along a sheet, and to compare every two of these takes longer
 * than the 5 seconds that an answer may compute.  Once all checks pass, find
 * the scene that is worst for your method, and improve it.  How does the time
 * grow with the number of boxes?  From which number on is the tree of chapter
 * 14 faster?
 *
 * Section: What it comes to.
 *
 * Hint 1: Sort the boxes by where they begin on the x axis.  Which of those
 *     that begin later can overlap a box?
 * Hint 2: They follow it in the sorted order, up to the first one that begins
 *     behind its end.  Only these have to be compared on the other axes.
 * Hint 3: qsort sorts an array of structs, each with the beginning of a box and
 *     the number of the box.
 */
#include <stdbool.h>
#include <stdlib.h>

typedef struct box {
    float low[3], high[3];
} box;

#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
/// Where a box begins on the x axis.
typedef struct beginning {
    float x;
    int box;
} beginning;

static int compare(const void *a, const void *b)
{
    float x = ((const beginning *)a)->x, y = ((const beginning *)b)->x;
    return (x > y) - (x < y);
}
#endif

static bool overlap(const box *a, const box *b)
{
    for (int k = 0; k < 3; k++)
#if defined TF_WRONG_1 // wants more than a touch
        if (a->high[k] <= b->low[k] || b->high[k] <= a->low[k])
            return false;
#else
        if (a->high[k] < b->low[k] || b->high[k] < a->low[k])
            return false;
#endif
    return true;
}

int find_overlaps(int count, const box boxes[], int pair[][2])
{
    int found = 0;
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    beginning *sorted = malloc((size_t)count * sizeof *sorted);
    if (!sorted)
        return 0;
    for (int i = 0; i < count; i++)
        sorted[i] = (beginning){boxes[i].low[0], i};
    qsort(sorted, (size_t)count, sizeof *sorted, compare);
    for (int i = 0; i < count; i++) {
        int a = sorted[i].box;
        float end = boxes[a].high[0];
        for (int j = i + 1; j < count && sorted[j].x <= end; j++) {
            int b = sorted[j].box;
#if defined TF_WRONG_2 // stops at the first one that is apart on any axis
            if (!overlap(&boxes[a], &boxes[b]))
                break;
#else
            if (!overlap(&boxes[a], &boxes[b]))
                continue;
#endif
            pair[found][0] = a < b ? a : b;
            pair[found++][1] = a < b ? b : a;
        }
    }
    free(sorted);
#elif defined TF_WRONG_3 // finds each pair from both of its boxes
    for (int i = 0; i < count; i++)
        for (int j = 0; j < count; j++)
            if (i != j && overlap(&boxes[i], &boxes[j])) {
                pair[found][0] = i < j ? i : j;
                pair[found++][1] = i < j ? j : i;
            }
#else
    // Your turn: so far each box is compared only with the next one.
    for (int i = 0; i + 1 < count; i++)
        if (overlap(&boxes[i], &boxes[i + 1])) {
            pair[found][0] = i;
            pair[found++][1] = i + 1;
        }
#endif
    return found;
}

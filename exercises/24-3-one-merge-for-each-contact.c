/* Exercise 24.3.  One merge for each contact.
 *
 * The pairs of edges that face each other are given by the pieces to which
 * their two edges belong, numbers from 0 to pieces - 1, the nearest pair first.
 * Go through them in order: a pair is wanted if its edges belong to different
 * pieces, and if it is merged its pieces become one.  Some pairs are refused by
 * the exact tests, and then nothing changes; refused[i] says so.  Set merged[i]
 * to whether the pair i is merged, and return how many are.
 *
 * Section: Safe isn't enough.
 *
 * Hint 1: Give each piece a label, its own number at first.
 * Hint 2: When two pieces become one, which labels have to change?
 * Hint 3: Pieces that have become one with another one before must come along.
 */
#include <stdbool.h>

enum {
    MOST_PIECES = 32
};

/// Makes one piece of two.
static void unite(int pieces, int label[], int a, int b)
{
    int from = label[a], to = label[b];
    for (int i = 0; i < pieces; i++)
#if defined TF_WRONG_1 // leaves behind what came with the piece
        if (i == a && label[i] == from)
            label[i] = to;
#else
        if (label[i] == from)
            label[i] = to;
#endif
}

int merge_contacts(int pieces, int pairs, const int pair[][2],
                   const bool refused[], bool merged[])
{
    int label[MOST_PIECES], count = 0;
    for (int i = 0; i < pieces; i++)
        label[i] = i;
    for (int i = 0; i < pairs; i++) {
        int a = pair[i][0], b = pair[i][1];
#if defined TF_SOLUTION || defined TF_WRONG_1
        merged[i] = label[a] != label[b] && !refused[i];
        if (merged[i])
            unite(pieces, label, a, b);
#elif defined TF_WRONG_2 // makes one of two pieces that were not merged
        merged[i] = label[a] != label[b] && !refused[i];
        unite(pieces, label, a, b);
#elif defined TF_WRONG_3 // merges wherever something is near
        merged[i] = a != b && !refused[i];
        if (merged[i])
            unite(pieces, label, a, b);
#else
        // Your turn: which pairs are wanted?
        merged[i] = !refused[i];
        if (merged[i])
            unite(pieces, label, a, b);
#endif
        count += merged[i];
    }
    return count;
}

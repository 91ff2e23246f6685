/* Exercise 23.3.  Does a flip bring vertices nearer to six neighbors?
 *
 * Another rule for flips: an inner vertex would like to have six neighbors, a
 * vertex on the boundary four.  The edge between a and b has the triangles abc
 * and bad.  Given are, for a, b, c and d in this order, how many neighbors they
 * have, and whether they are on the boundary.  Return whether the flip makes
 * the sum of the squares of (neighbors - wanted) smaller.
 *
 * Section: The passes.
 *
 * Hint 1: Who loses a neighbor when ab becomes cd, and who gains one?
 * Hint 2: If a and b would keep fewer than three neighbors, or two on the
 *     boundary, the flip is impossible, whatever the sum is.
 */
#include <stdbool.h>

static int wanted(bool on_boundary)
{
    return on_boundary ? 4 : 6;
}

bool is_flip_wanted(const int neighbors[4], const bool on_boundary[4])
{
    int before = 0, after = 0;
    for (int i = 0; i < 4; i++) {
#if defined TF_WRONG_1 // wants six everywhere
        int off = neighbors[i] - wanted(false) + 0 * on_boundary[i];
#else
        int off = neighbors[i] - wanted(on_boundary[i]);
#endif
        int change = i < 2 ? -1 : 1;
        before += off * off;
        after += (off + change) * (off + change);
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_3
        if (i < 2 && neighbors[i] - 1 < (on_boundary[i] ? 2 : 3))
            return false;
#endif
    }
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    return after < before;
#elif defined TF_WRONG_3 // flips to and fro
    return after <= before;
#else
    // Your turn: decide, and mind what is impossible.
    return before < after;
#endif
}

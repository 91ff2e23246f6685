/* Exercise 4.1.  Do two segments on a line meet?
 *
 * Near the bottom of the cascade, with time fixed and one axis left, two
 * segments lie on a line.  One has the ends a[0] and a[1], in either order and
 * possibly equal; the other has b[0] and b[1].  Do they have a point in common?
 * Touching counts.
 *
 * Section: At one time.
 *
 * Hint 1: It is easier to determine when they are apart.
 * Hint 2: They are apart if all of one lies strictly to the left of all of the
 *     other.  Either of them may be the one on the left.
 * Hint 3: Find the smaller and the larger end of each first.
 */
#include "intersect/cascade.h"

#include <math.h>

bool segments_intersect(const double a[2], const double b[2])
{
#if defined TF_SOLUTION
    return fmax(a[0], a[1]) >= fmin(b[0], b[1]) &&
           fmax(b[0], b[1]) >= fmin(a[0], a[1]);
#elif defined TF_WRONG_1 // assumes that a[0] is to the left of a[1]
    return a[1] >= b[0] && b[1] >= a[0];
#elif defined TF_WRONG_2 // touching does not count
    return fmax(a[0], a[1]) > fmin(b[0], b[1]) &&
           fmax(b[0], b[1]) > fmin(a[0], a[1]);
#elif defined TF_WRONG_3 // overlooks an a that covers all of b
    return (a[0] >= fmin(b[0], b[1]) && a[0] <= fmax(b[0], b[1])) ||
           (a[1] >= fmin(b[0], b[1]) && a[1] <= fmax(b[0], b[1]));
#else
    // Your turn: true if the segments start at the same point.
    return a[0] == b[0];
#endif
}

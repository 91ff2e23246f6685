/* Exercise 13.2.  Do two edges with a common vertex overlap?
 *
 * Two edges of a curve in the plane share the vertex v; one ends at a, the
 * other at c.  They are no pair for the static check, which looks only at
 * elements without a common vertex.  Find out, exactly, whether they have more
 * in common than v.  Either may have no length.
 *
 * Section: What is missed.
 *
 * Hint 1: Two edges from v have more in common than v if they point in the same
 *     direction.  Edges that point in opposite directions do not.
 * Hint 2: turn() gives the exact sign of a turn.  It is zero if v, a and c lie
 *     on one line, whatever their order.
 * Hint 3: On one line, compare coordinates: a and c are on the same side of v
 *     if on some axis both are greater than v, or both less.  A product of
 *     differences would be rounded.
 */
#include "arithmetic/exact.h"
#include "arithmetic/functions.h"

#include <stdbool.h>

static tf_event event_at(const double x[2])
{
    return (tf_event){.x = {x[0], x[1]}, .vertex = TF_NO_INDEX};
}

/// The exact sign of the turn from v through a to c.
static tf_sign turn(const double v[2], const double a[2], const double c[2])
{
#if defined TF_WRONG_1 // rounds the turn
    double left = (a[0] - v[0]) * (c[1] - v[1]);
    double right = (a[1] - v[1]) * (c[0] - v[0]);
    return left > right ? TF_POSITIVE : left < right ? TF_NEGATIVE : TF_ZERO;
#endif
    tf_event at[3] = {event_at(v), event_at(a), event_at(c)};
    tf_differences d = {.n = 2,
                        .from = {&at[0], &at[0]},
                        .to = {&at[1], &at[2]},
                        .axis = {0, 1}};
    return tf_exact.sign(&d);
}

bool lie_upon_each_other(const double v[2], const double a[2],
                         const double c[2])
{
    if (turn(v, a, c) != TF_ZERO)
        return false;
#if defined TF_WRONG_2 // forgets that they may point in opposite directions
    return (a[0] != v[0] || a[1] != v[1]) && (c[0] != v[0] || c[1] != v[1]);
#elif defined TF_WRONG_3 // the product of tiny differences is zero
    return (a[0] - v[0]) * (c[0] - v[0]) + (a[1] - v[1]) * (c[1] - v[1]) > 0;
#elif defined TF_WRONG_4 // looks at one axis only
    return (a[0] > v[0] && c[0] > v[0]) || (a[0] < v[0] && c[0] < v[0]);
#elif defined TF_SOLUTION || defined TF_WRONG_1
    for (int k = 0; k < 2; k++)
        if ((a[k] > v[k] && c[k] > v[k]) || (a[k] < v[k] && c[k] < v[k]))
            return true;
    return false;
#else
    // Your turn: they are on one line, but on which sides of v?
    return true;
#endif
}

/* Exercise 19.2.  Halving a step until it is clear.
 *
 * A point, vertex 0, and an edge, vertices 1 and 2, move in the plane, from
 * `start` to `end`, two coordinates a vertex.  They do not touch at the start.
 * Find the least k for which the step from `start` to start + 2^-k (end -
 * start), rounded, has no contact, set `end` to where that step ends, and
 * return k.  If the step has become so short that nothing moves any more,
 * return -1; then `end` is `start`.
 *
 * The function touch(), above yours, answers whether a step has a contact.
 *
 * Section: A shorter step is another step.
 *
 * Hint 1: k = 0 is the step as it is given.
 * Hint 2: ldexp(x, -k) is 2^-k x.
 * Hint 3: Take each fraction of the step that was given.  If you halve what is
 *     left after the last halving, roundings add up.
 */
#include "arithmetic/exact.h"
#include "geometry/event.h"
#include "query/query.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/// Asks for the contact of the point and the edge.
static tf_contact ask(const double start[6], const double end[6])
{
    tf_worldline line[3];
    for (int v = 0; v < 3; v++)
        line[v] = tf_worldline_between(2, start + 2 * v, end + 2 * v);
    tf_contact contact;
    tf_query(&tf_exact, 2, 1, line, 2, line + 1, &contact);
    return contact;
}

bool touch(const double start[6], const double end[6])
{
    return ask(start, end).verdict == TF_HIT;
}

int halve(const double start[6], double end[6])
{
#if defined TF_SOLUTION || defined TF_WRONG_2 || defined TF_WRONG_3
    double proposed[6];
    memcpy(proposed, end, sizeof proposed);
    for (int k = 0; k < 3000; k++) {
        bool moves = false;
        for (int i = 0; i < 6; i++) {
#if defined TF_WRONG_2 // halves what is left
            if (k > 0)
                end[i] = start[i] + (end[i] - start[i]) / 2;
#else
            if (k > 0)
                end[i] = start[i] + ldexp(proposed[i] - start[i], -k);
#endif
            moves |= end[i] != start[i];
        }
#if defined TF_WRONG_3 // does not see that nothing moves
        moves = true;
#endif
        if (!moves)
            return -1;
        if (!touch(start, end))
            return k;
    }
    return -1;
#elif defined TF_WRONG_1 // goes as far as the time of impact allows
    tf_contact contact = ask(start, end);
    int k = 0;
    while (contact.verdict == TF_HIT && ldexp(1, -k) >= contact.toi_lo)
        k++;
    for (int i = 0; i < 6 && k > 0; i++)
        end[i] = start[i] + ldexp(end[i] - start[i], -k);
    return k;
#elif defined TF_WRONG_4 // stays where it is after a contact
    if (!touch(start, end))
        return 0;
    memcpy(end, start, 6 * sizeof *end);
    return -1;
#else
    // Your turn: the step is taken as it is.
    return 0;
#endif
}

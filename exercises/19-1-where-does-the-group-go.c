/* Exercise 19.1.  Where does the group go?
 *
 * The vertices of a group move along a line.  Given are where each of them
 * starts, where it was proposed to end, and its inverse mass.  move_group(), at
 * the end of your file, sets `end` to where it ends in fact; two decisions are
 * yours.
 *
 * If no vertex is scripted, each ends at its start plus the mean of the proposed
 * displacements, weighted by mass.  If some are scripted, that is, have the
 * inverse mass 0, the others take over the displacement of these, but only if
 * all of these have exactly the same one, and if it is a double.  Otherwise the
 * whole group stays where it starts, bit for bit.
 *
 * Section: Scripted vertices.
 *
 * Hint 1: tf_two_difference(a, b) yields a - b as a sum of two doubles, hi and
 *     lo, without any error.
 * Hint 2: a - b is a double if lo is 0.
 * Hint 3: Two displacements may be equal after they have been rounded and
 *     differ before.
 */
#include "arithmetic/two_sum.h"

#include <stdbool.h>
#include <stddef.h>

/// The weight, in the mean, of a vertex that is not scripted.
static double weight_of(double inverse_mass)
{
#if defined TF_WRONG_1 // weights by inverse masses
    return inverse_mass;
#elif defined TF_SOLUTION || defined TF_WRONG_3 || defined TF_WRONG_4
    return 1 / inverse_mass;
#else
    // Your turn, part one: for now all count alike.
    return 1;
#endif
}

/// Whether a scripted vertex lets its group move: its displacement is
/// proposed - start, and `before`, unless NULL, is that of the scripted vertices
/// before it.
static bool agrees(double start, double proposed, const double *before)
{
#if defined TF_WRONG_3 // compares rounded displacements
    return !before || proposed - start == *before;
#elif defined TF_WRONG_4 // lets the last one decide
    return tf_two_difference(proposed, start).lo == 0;
#elif defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    tf_two d = tf_two_difference(proposed, start);
    return d.lo == 0 && (!before || d.hi == *before);
#else
    // Your turn, part two.
    return true;
#endif
}

void move_group(int count, const double start[], const double proposed[],
                const double inverse_mass[], double end[])
{
    bool fixed = false, rests = false;
    double displacement = 0, mass = 0, momentum = 0;
    for (int i = 0; i < count; i++) {
        if (inverse_mass[i] > 0) {
            mass += weight_of(inverse_mass[i]);
            momentum += weight_of(inverse_mass[i]) * (proposed[i] - start[i]);
        } else {
            if (!agrees(start[i], proposed[i], fixed ? &displacement : NULL))
                rests = true;
            displacement = proposed[i] - start[i];
            fixed = true;
        }
    }
    if (!fixed)
        displacement = momentum / mass;
    for (int i = 0; i < count; i++)
        end[i] = rests ? start[i] : start[i] + displacement;
}

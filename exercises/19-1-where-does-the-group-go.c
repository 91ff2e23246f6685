/* Exercise 19.1.  The displacement of a group of the failsafe.
 *
 * The vertices of a group move along a line.  Given are where each of them
 * starts, where it was proposed to end, and its inverse mass.  move_group(), at
 * the end of your file, sets `end` to where it ends in fact; two decisions are
 * yours.
 *
 * If no vertex is scripted, the displacement of the group is the mean of the
 * proposed displacements, weighted by mass.  If some are scripted, that is, have
 * the inverse mass 0, it is that of the first of them.  A free vertex ends at
 * its start plus the displacement of the group, and a scripted one exactly where
 * it was proposed to end.
 *
 * Section: Scripted vertices.
 *
 * Hint 1: You are given inverse masses, and the weight of a vertex is its mass.
 * Hint 2: A scripted vertex ends where its script has it, whatever its group
 *     does.
 * Hint 3: start + (proposed - start) may be another double than proposed.
 */
#include <stdbool.h>
#include <stddef.h>

/// The weight, in the mean, of a free vertex.
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

/// Where a vertex ends whose group has this displacement.
static double end_of(double start, double proposed, bool scripted,
                     double displacement)
{
#if defined TF_WRONG_3 // rounds where a scripted vertex ends
    return start + (scripted ? proposed - start : displacement);
#elif defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    return scripted ? proposed : start + displacement;
#else
    // Your turn, part two: for now all follow the group.
    return start + displacement;
#endif
}

void move_group(int count, const double start[], const double proposed[],
                const double inverse_mass[], double end[])
{
    bool any_scripted = false;
    double displacement = 0, mass = 0, momentum = 0;
    for (int i = 0; i < count; i++) {
        if (inverse_mass[i] > 0) {
            mass += weight_of(inverse_mass[i]);
            momentum += weight_of(inverse_mass[i]) * (proposed[i] - start[i]);
        } else if (!any_scripted) {
            displacement = proposed[i] - start[i];
            any_scripted = true;
        }
    }
    if (!any_scripted)
        displacement = momentum / mass;
    for (int i = 0; i < count; i++)
        end[i] =
            end_of(start[i], proposed[i], !(inverse_mass[i] > 0), displacement);
}

/* Exercise 18.2.  A bead and its walls.
 *
 * A bead of the plane runs into walls that do not move.  Wall i has a normal of
 * length 1, and its row demands that normal[i] . d >= bound[i], where d is the
 * displacement of the bead.  Visit all rows once, in their order: bring d, the
 * displacement with all impulses so far, and impulse[], the impulses of the
 * rows, up to date.
 *
 * Section: Impulses with memory.
 *
 * Hint 1: An impulse along row i changes d by the impulse times normal[i],
 *     divided by the mass.
 * Hint 2: So the compliance of each row is 1 / mass.
 * Hint 3: An impulse must not be negative, but its change may.
 */
#include <math.h>

void sweep(int walls, const double normal[][2], const double bound[],
           double mass, double d[2], double impulse[])
{
#if defined TF_WRONG_5 // sees the displacement as it was before the sweep
    double before[2] = {d[0], d[1]};
#else
    const double *before = d;
#endif
    for (int i = 0; i < walls; i++) {
        double parting = normal[i][0] * before[0] + normal[i][1] * before[1];
#if defined TF_WRONG_1 // forgets the mass
        double wanted = bound[i] - parting;
#else
        double wanted = (bound[i] - parting) * mass;
#endif
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_5
        double change = fmax(impulse[i] + wanted, 0) - impulse[i];
        impulse[i] += change;
#elif defined TF_WRONG_2 // takes nothing back
        double change = fmax(wanted, 0);
        impulse[i] += change;
#elif defined TF_WRONG_3 // pulls
        double change = wanted;
        impulse[i] += change;
#elif defined TF_WRONG_4 // forgets the impulse that was there
        double change = fmax(wanted, 0);
        impulse[i] = change;
#else
        // Your turn: nothing is pushed.
        double change = 0 * wanted;
        impulse[i] = fmax(impulse[i], 0);
#endif
        for (int k = 0; k < 2; k++)
            d[k] += change * normal[i][k] / mass;
    }
}

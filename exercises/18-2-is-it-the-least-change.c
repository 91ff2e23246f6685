/* Exercise 18.2.  Is a solution the least change?
 *
 * Beads are on a wire, bead i before bead i + 1, and a knot is behind the last.
 * Constraint i demands that bead i + 1, or for the last bead the knot, move no
 * less than bead i does.  The knot does not move.  Bead i has the mass mass[i];
 * it was to move by proposal[i], and a solver lets it move by d[i].  Is d the
 * least change of the proposal that satisfies all constraints?  Don't solve
 * anything: look at the impulses.  What is at most 10^-9 may be a rounding
 * error.
 *
 * Section: Equations glue.
 *
 * Hint 1: Only the first constraint has pushed the first bead.  So you can
 *     compute the impulse of that constraint, and then, from the second bead,
 *     that of the next.
 * Hint 2: An impulse along constraint i pushes bead i back and bead i + 1
 *     forward, each by the impulse divided by its mass.
 * Hint 3: No constraint is violated, no impulse is negative, and where there is
 *     an impulse, the gap does not change.
 */
#include <stdbool.h>

static const double rounding = 1e-9;

bool is_least_change(int beads, const double mass[], const double proposal[],
                     const double d[])
{
    double impulse = 0;
    for (int i = 0; i < beads; i++) {
        double gap_change = (i + 1 < beads ? d[i + 1] : 0) - d[i];
        if (gap_change < -rounding)
            return false;
#if defined TF_WRONG_3 // all beads weigh the same
        impulse += proposal[i] - d[i];
#elif defined TF_WRONG_4 // thinks that only one constraint pushes a bead
        impulse = mass[i] * (proposal[i] - d[i]);
#else
        impulse += mass[i] * (proposal[i] - d[i]);
#endif
#if defined TF_SOLUTION || defined TF_WRONG_3 || defined TF_WRONG_4
        bool pulls = impulse < -rounding;
        bool pushes_for_nothing = impulse > rounding && gap_change > rounding;
#elif defined TF_WRONG_1 // takes glue for granted
        bool pulls = false;
        bool pushes_for_nothing = impulse > rounding && gap_change > rounding;
#elif defined TF_WRONG_2 // takes needless pushes for granted
        bool pulls = impulse < -rounding;
        bool pushes_for_nothing = false;
#else
        // Your turn: content if all constraints are satisfied.
        bool pulls = false, pushes_for_nothing = false;
#endif
        if (pulls || pushes_for_nothing)
            return false;
    }
    return true;
}

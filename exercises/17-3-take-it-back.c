/* Exercise 17.3.  Taking an impulse back: one visit of a constraint.
 *
 * Bodies move along a line.  A constraint wants that
 *
 *     sum of coefficient[i] * move[i] >= bound
 *
 * and remembers in `*impulse` what it has pushed so far, which is at least 0.
 * Visit it: change its impulse so that the sum becomes the bound.  But if the
 * impulse would become negative, make it 0.  Push the bodies by the change: to
 * each move add the change times the body's coefficient and inverse mass.  A
 * scripted body, one of inverse mass 0, is not moved, and a constraint whose
 * bodies are all scripted is left as it is, with the impulse that it has.
 *
 * Section: A round of impulses.
 *
 * Hint 1: An impulse of 1 moves body i by coefficient[i] * inverse_mass[i].  By
 *     how much does it raise the sum?
 * Hint 2: Divide what is missing by that.  It may be negative: then there is
 *     too much.
 * Hint 3: The new impulse is the old one plus the quotient, or 0 if that is
 *     negative.  The bodies are pushed by the difference between the new one
 *     and the old one.
 */
#include <math.h>

void visit(int count, const double coefficient[], const double inverse_mass[],
           double bound, double *impulse, double move[])
{
#if defined TF_SOLUTION
    double sum = 0, compliance = 0;
    for (int i = 0; i < count; i++) {
        sum += coefficient[i] * move[i];
        compliance += coefficient[i] * coefficient[i] * inverse_mass[i];
    }
    if (!(compliance > 0))
        return;
    double before = *impulse;
    *impulse = fmax(before + (bound - sum) / compliance, 0);
    for (int i = 0; i < count; i++)
        move[i] += (*impulse - before) * coefficient[i] * inverse_mass[i];
#elif defined TF_WRONG_1 // no memory: never takes anything back
    double sum = 0, compliance = 0;
    for (int i = 0; i < count; i++) {
        sum += coefficient[i] * move[i];
        compliance += coefficient[i] * coefficient[i] * inverse_mass[i];
    }
    if (!(compliance > 0))
        return;
    double push = fmax((bound - sum) / compliance, 0);
    *impulse += push;
    for (int i = 0; i < count; i++)
        move[i] += push * coefficient[i] * inverse_mass[i];
#elif defined TF_WRONG_2 // pulls
    double sum = 0, compliance = 0;
    for (int i = 0; i < count; i++) {
        sum += coefficient[i] * move[i];
        compliance += coefficient[i] * coefficient[i] * inverse_mass[i];
    }
    if (!(compliance > 0))
        return;
    double push = (bound - sum) / compliance;
    *impulse += push;
    for (int i = 0; i < count; i++)
        move[i] += push * coefficient[i] * inverse_mass[i];
#elif defined TF_WRONG_3 // pushes by all of the impulse again
    double sum = 0, compliance = 0;
    for (int i = 0; i < count; i++) {
        sum += coefficient[i] * move[i];
        compliance += coefficient[i] * coefficient[i] * inverse_mass[i];
    }
    if (!(compliance > 0))
        return;
    *impulse = fmax(*impulse + (bound - sum) / compliance, 0);
    for (int i = 0; i < count; i++)
        move[i] += *impulse * coefficient[i] * inverse_mass[i];
#elif defined TF_WRONG_4 // pushes all bodies alike, whatever their masses
    double sum = 0, compliance = 0;
    for (int i = 0; i < count; i++) {
        sum += coefficient[i] * move[i];
        compliance += coefficient[i] * coefficient[i];
    }
    double before = *impulse;
    *impulse = fmax(before + (bound - sum) / compliance, 0);
    for (int i = 0; i < count; i++)
        move[i] += (*impulse - before) * coefficient[i];
#elif defined TF_WRONG_5 // divides by zero where all are scripted
    double sum = 0, compliance = 0;
    for (int i = 0; i < count; i++) {
        sum += coefficient[i] * move[i];
        compliance += coefficient[i] * coefficient[i] * inverse_mass[i];
    }
    double before = *impulse;
    *impulse = fmax(before + (bound - sum) / compliance, 0);
    for (int i = 0; i < count; i++)
        move[i] += (*impulse - before) * coefficient[i] * inverse_mass[i];
#else
    // Your turn: so far it does nothing.
#endif
}

/* Exercise 17.2.  The constraint of a contact's pivots.
 *
 * Two elements meet, the first with `first` vertices and the second with
 * `second`.  Make the constraint that stops their pivots: a coefficient for
 * each vertex, 1 or -1 for a pivot and 0 for the others, those of the first
 * element and then those of the second; a normal of length 1, reversed if
 * necessary so that the first pivot starts on the positive side of the second;
 * and the gap, the distance along the normal at which they start, which follows
 * from the contact alone.  For the time of impact take `toi_lo`.  The contact
 * has a normal, and its normal velocity is not zero.
 *
 * Section: Three constraints that fail.
 *
 * Hint 1: Which two vertices are the pivots?  contact->pivot[0] is a place in
 *     the first element, contact->pivot[1] a place in the second.
 * Hint 2: If the first element moves along the contact's normal as seen from
 *     the second, on which side of the second does it start?
 * Hint 3: Along the normal the pivots meet at the time of impact.  How far do
 *     they get by then, at the normal velocity?
 */
#include "query/contact.h"

#include <math.h>

typedef struct pivot_constraint {
    double coefficient[4], normal[3], gap;
} pivot_constraint;

pivot_constraint constraint_of_pivots(const tf_contact *contact, int first,
                                      int second)
{
    pivot_constraint constraint = {{0}, {0}, 0};
#if defined TF_SOLUTION || defined TF_WRONG_2 || defined TF_WRONG_3
    constraint.coefficient[contact->pivot[0]] = 1;
    constraint.coefficient[first + contact->pivot[1]] = -1;
#elif defined TF_WRONG_1 // the dots, not the pivots
    for (int i = 0; i < first; i++)
        constraint.coefficient[i] = contact->barycentric[0][i];
    for (int i = 0; i < second; i++)
        constraint.coefficient[first + i] = -contact->barycentric[1][i];
#endif
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_3
    double side = contact->normal_velocity > 0 ? -1 : 1;
#elif defined TF_WRONG_2 // turned with the motion
    double side = contact->normal_velocity > 0 ? 1 : -1;
#else
    // Your turn: coefficients, normal and gap.
    double side = 1;
#endif
    for (int k = 0; k < 3; k++)
        constraint.normal[k] = side * contact->normal[k];
#if defined TF_WRONG_3 // the distance at the end
    constraint.gap = (1 - contact->toi_lo) * fabs(contact->normal_velocity);
#elif defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    constraint.gap = contact->toi_lo * fabs(contact->normal_velocity);
#endif
    return constraint;
}

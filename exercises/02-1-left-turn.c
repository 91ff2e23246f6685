/* Exercise 2.1.  A left turn: the sign of a determinant.
 *
 * Walk from a to b and on to c, in the plane.  Do you turn left (positive),
 * turn right (negative) or go straight (zero)?  Return the sign of the
 * determinant of differences that decides this.  Here the coordinates are small
 * multiples of 1/8: the differences and their products are exact, so ordinary
 * doubles will do.
 *
 * Section: Signs of determinants.
 *
 * Hint 1: Both rows are differences to the same point: b - a and c - a.
 * Hint 2: The determinant is (b - a).x (c - a).y - (b - a).y (c - a).x.
 * Hint 3: A sign has three values.  A determinant of 1/4 is positive, and a
 *     conversion to an integer would make it zero.
 */
#include "arithmetic/sign.h"
#include "geometry/event.h"

tf_sign left_turn(const tf_event *a, const tf_event *b, const tf_event *c)
{
#if defined TF_SOLUTION
    double determinant = (b->x[0] - a->x[0]) * (c->x[1] - a->x[1]) -
                         (b->x[1] - a->x[1]) * (c->x[0] - a->x[0]);
    return determinant > 0   ? TF_POSITIVE
           : determinant < 0 ? TF_NEGATIVE
                             : TF_ZERO;
#elif defined TF_WRONG_1 // multiplies along the rows, not along the diagonals
    double determinant = (b->x[0] - a->x[0]) * (b->x[1] - a->x[1]) -
                         (c->x[0] - a->x[0]) * (c->x[1] - a->x[1]);
    return determinant > 0   ? TF_POSITIVE
           : determinant < 0 ? TF_NEGATIVE
                             : TF_ZERO;
#elif defined TF_WRONG_2 // truncates a small determinant to zero
    double determinant = (b->x[0] - a->x[0]) * (c->x[1] - a->x[1]) -
                         (b->x[1] - a->x[1]) * (c->x[0] - a->x[0]);
    int whole = (int)determinant;
    return whole > 0 ? TF_POSITIVE : whole < 0 ? TF_NEGATIVE : TF_ZERO;
#elif defined TF_WRONG_3 // forgets that you may go straight
    double determinant = (b->x[0] - a->x[0]) * (c->x[1] - a->x[1]) -
                         (b->x[1] - a->x[1]) * (c->x[0] - a->x[0]);
    return determinant > 0 ? TF_POSITIVE : TF_NEGATIVE;
#elif defined TF_WRONG_4 // uses positions in place of differences
    double determinant = b->x[0] * c->x[1] - b->x[1] * c->x[0];
    return determinant > 0   ? TF_POSITIVE
           : determinant < 0 ? TF_NEGATIVE
                             : TF_ZERO;
#else
    // Your turn.
    return TF_UNKNOWN;
#endif
}

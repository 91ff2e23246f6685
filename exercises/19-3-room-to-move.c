/* Exercise 19.3.  How far may vertices move without a contact?
 *
 * A point and an edge are at rest in the plane.  In the next step each of the
 * three vertices may move by up to some distance r, in any direction.  Find an
 * r, as large as you can, for which the step certainly has no contact, and
 * return it.  It has to be at least 0.49 times the distance of the point from
 * the edge.  All coordinates are below 1 in absolute value.  The point is at
 * least 10^-6 away from the edge, or on it; then return 0.
 *
 * First answer on paper: how far can a point *within* the bent edge get from
 * where it starts, if the ends move by at most r?
 *
 * Section: Beside other promises.
 *
 * Hint 1: In the staircase motion a point of the edge has at any time the
 *     velocity of one of its ends, or rests.  So it moves by at most r, too.
 * Hint 2: The nearest point of the edge may be one of its ends.
 * Hint 3: Half of the distance is too much: then the elements may touch.  And
 *     the distance has been rounded.
 */
#include <math.h>

/// The weight w, 0 to 1, for which a + w (b - a) is the point of the edge that
/// is nearest; `to` is the vector from a to the point, `along` that from a to b.
static double weight_of_nearest(const double to[2], const double along[2])
{
    double square = along[0] * along[0] + along[1] * along[1];
    double at = to[0] * along[0] + to[1] * along[1];
#if defined TF_WRONG_1 // takes the line for the edge
    return square > 0 ? at / square : 0;
#elif defined TF_WRONG_4 // takes the nearest end for the nearest point
    return at > square / 2 ? 1 : 0;
#elif defined TF_WRONG_5 // divides by zero where the edge is a point
    double weight = at / square;
    return weight < 0 ? 0 : weight > 1 ? 1 : weight;
#elif defined TF_SOLUTION || defined TF_WRONG_2 || defined TF_WRONG_3
    return square > 0 ? fmax(0, fmin(1, at / square)) : 0;
#else
    // Your turn, part one: where is the nearest point?
    return at > square ? 1 : 0;
#endif
}

double room(const double point[2], const double a[2], const double b[2])
{
    double along[2] = {b[0] - a[0], b[1] - a[1]};
    double to[2] = {point[0] - a[0], point[1] - a[1]};
    double weight = weight_of_nearest(to, along);
    double distance =
        hypot(to[0] - weight * along[0], to[1] - weight * along[1]);
#if defined TF_WRONG_2 // lets the point move alone
    return 0.999 * distance;
#elif defined TF_WRONG_3 // lets them touch
    return distance / 2;
#elif defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_4
    return 0.499 * distance;
#elif defined TF_WRONG_5
    return 0.499 * distance;
#else
    // Your turn, part two: how much of the distance may each of them use up?
    return distance;
#endif
}

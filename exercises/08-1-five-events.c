/* Exercise 8.1.  The orientation of five events.
 *
 * The orientation of five events in space-time is the sign of the determinant
 * of the five rows (x, y, z, t, 1).  The events are in any order, some at t = 0
 * and some at t = 1, or all at one time, and their coordinates are small
 * integers.  Find the sign.  It is zero if the events lie in a hyperplane.  If
 * there are events at both times, that is a plane of space that moves without
 * turning and contains all of them.
 *
 * Section: One moving plane.
 *
 * Hint 1: Subtract the last row from the others: the last column becomes 0, 0,
 *     0, 0, 1, and a determinant of four rows (x, y, z, t) is left.
 * Hint 2: Expand that along the column of times.  Each term is a difference of
 *     times multiplied by a determinant of three rows (x, y, z), with row i
 *     left out.
 * Hint 3: The column of times is the fourth, so row i, counted from 0, has the
 *     sign of (-1)^(i + 3): minus for the first.
 */
#include "arithmetic/sign.h"
#include "geometry/event.h"

static double det3(const double a[3], const double b[3], const double c[3])
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) +
           a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

tf_sign orientation(const tf_event event[5])
{
    double d[4][3]; // the differences of the first four events to the last
    int late[4];    // and of their times
    for (int i = 0; i < 4; i++) {
        late[i] = event[i].t - event[4].t;
        for (int k = 0; k < 3; k++)
            d[i][k] = event[i].x[k] - event[4].x[k];
    }
    const double minor[4] = {det3(d[1], d[2], d[3]), det3(d[0], d[2], d[3]),
                             det3(d[0], d[1], d[3]), det3(d[0], d[1], d[2])};
#if defined TF_SOLUTION
    double sum = -late[0] * minor[0] + late[1] * minor[1] - late[2] * minor[2] +
                 late[3] * minor[3];
#elif defined TF_WRONG_1 // forgets that the signs alternate
    double sum = late[0] * minor[0] + late[1] * minor[1] + late[2] * minor[2] +
                 late[3] * minor[3];
#elif defined TF_WRONG_2 // starts with plus: the sign of the first column
    double sum = late[0] * minor[0] - late[1] * minor[1] + late[2] * minor[2] -
                 late[3] * minor[3];
#elif defined TF_WRONG_3 // believes that only the fourth event is at the end
    double sum = late[3] * minor[3];
#elif defined TF_WRONG_4 // forgets the times
    late[0] = late[1] = late[2] = late[3] = 1;
    double sum = late[3] * (-minor[0] + minor[1] - minor[2] + minor[3]);
#else
    // Your turn.
    double sum = late[0] + minor[0];
#endif
    return sum > 0 ? TF_POSITIVE : sum < 0 ? TF_NEGATIVE : TF_ZERO;
}

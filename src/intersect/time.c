//: Include what the time of impact needs
#include "intersect/time.h"

#include <float.h>

//: Find the smaller operand
int tf_pair_smaller_operand(const tf_pair *pair)
{
    int sum = 0;
    for (int i = 0; i < pair->count; i++)
        sum += pair->operand[i];
    return sum <= 0 ? +1 : -1;
}

//: Bound the rounding of a ratio
/// How far end / (start + end) may be from the true ratio t.  Each value hides
/// one rounding; at most one sum within a time, the sum of the two times and
/// the quotient add one each.  The hidden roundings and the sum within a time
/// change t by at most 3 t (1 - t) u, the last two operations by 2 t u; one
/// more t u covers the rounding of the bounds themselves, and 2^-40 t u the
/// terms of second order.
static double ratio_margin(double t)
{
    return t * (6 + 0x1p-40 - 3 * t) * (DBL_EPSILON / 2) + 0x1p-1070;
}

//: Enclose the time of impact
tf_interval tf_pair_time(const tf_pair *pair, const tf_coordinates *c)
{
    //: Sum the coordinates by time
    double low[2] = {0, 0}, high[2] = {0, 0};
    for (int i = 0; i < pair->count; i++) {
        low[i >= pair->start_count] += c->low[i];
        high[i >= pair->start_count] += c->high[i];
    }

    //: Divide the end's share by the whole
    double first = low[1] / (low[1] + high[0]);
    double last = high[1] / (high[1] + low[0]);
    bool start_only = high[0] > high[1] && high[1] == 0;
    bool end_only = high[1] > high[0] && high[0] == 0;
    double lo = first - ratio_margin(first), hi = last + ratio_margin(last);
    tf_interval time;
    time.lo = end_only ? 1 : first >= 0 && lo > 0 ? lo : 0;
    time.hi = start_only ? 0 : last <= 1 && hi < 1 ? hi : 1;
    return time;
}

/* Exercise 9.2.  A root in a bracket, to the last bit.
 *
 * The polynomial c[0] + c[1] t + c[2] t^2 is negative at `lo` and positive at
 * `hi`, or the reverse, and monotone between them.  Return its root to the last
 * bit: a double at which the computed value is zero, or one of two neighboring
 * doubles at which the computed values have opposite signs.  Evaluate the
 * polynomial at most 100 times, by calling value().
 *
 * Section: A root in a bracket.
 *
 * Hint 1: Keep two times between which the sign changes.  Each new time
 *     replaces the one whose value has the same sign.
 * Hint 2: Newton's step from t is t - f(t) / f'(t).  Take it only if it lies
 *     strictly inside the bracket; otherwise take the middle.
 * Hint 3: Newton may creep in from one side for ever while the other end of
 *     the bracket stays.  Take the middle, too, where the last step did not
 *     halve the bracket.
 * Hint 4: End when the middle is one of the two ends: then no double is left
 *     between them.
 */
#include <math.h>
#include <stdbool.h>

double value(const double c[3], double t);

static double slope(const double c[3], double t)
{
    return c[1] + 2 * c[2] * t;
}

double root_between(const double c[3], double lo, double hi)
{
    double at_lo = value(c, lo);
#if defined TF_SOLUTION
    double width = INFINITY;
    for (;;) {
        double middle = lo + (hi - lo) / 2;
        if (middle == lo || middle == hi)
            return lo;
        double t = lo - at_lo / slope(c, lo);
        bool halved = hi - lo <= width / 2;
        width = hi - lo;
        if (!(t > lo && t < hi) || !halved)
            t = middle;
        double at = value(c, t);
        if (at == 0)
            return t;
        *((at > 0) == (at_lo > 0) ? &lo : &hi) = t;
        at_lo = lo == t ? at : at_lo;
    }
#elif defined TF_WRONG_1 // Newton's method without a bracket
    double t = lo + (hi - lo) / 2;
    for (int i = 0; i < 60 && at_lo != 0; i++)
        t -= value(c, t) / slope(c, t);
    return t;
#elif defined TF_WRONG_2 // stops when the value is small
    double t = lo;
    for (int i = 0; i < 60 && fabs(value(c, t)) > 1e-12; i++) {
        t = lo - value(c, lo) / slope(c, lo);
        if (!(t > lo && t < hi) || i % 2)
            t = lo + (hi - lo) / 2;
        *((value(c, t) > 0) == (at_lo > 0) ? &lo : &hi) = t;
    }
    return t;
#elif defined TF_WRONG_3 // Newton's step from the low end alone
    for (int i = 0; i < 98; i++) {
        double t = lo - value(c, lo) / slope(c, lo);
        if (!(t > lo && t < hi))
            t = lo + (hi - lo) / 2;
        *((value(c, t) > 0) == (at_lo > 0) ? &lo : &hi) = t;
    }
    return hi - lo > 1e-9 ? hi : lo;
#else
    // Your turn: this is one step of Newton's.
    return fmin(lo - at_lo / slope(c, lo), hi);
#endif
}

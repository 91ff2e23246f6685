/* Exercise 11.1.  The rounding error of a sum, exactly.
 *
 * A program has rounded the sum a + b of two doubles and needs to find what the
 * rounding took away: the number r that, added to the rounded sum, gives the
 * true one.  Return r.  It must be exact for all doubles below 2^1000 in
 * absolute value, whichever of the two is larger.
 *
 * Section: The sum of two doubles.
 *
 * Hint 1: Let s be the rounded sum.  If |a| >= |b|, then s - a is a double, and
 *     r = b - (s - a).
 * Hint 2: You may find out which of the two is larger, or use a formula that
 *     does not depend on it: what did s take from b, and what from a?
 * Hint 3: t = s - a is what s took from b, s - t is what it took from a.  What
 *     is left is (a - (s - t)) + (b - t).
 */
#include <math.h>

double what_is_lost(double a, double b)
{
#if defined TF_SOLUTION
    double sum = a + b;
    double from_b = sum - a, from_a = sum - from_b;
    return (a - from_a) + (b - from_b);
#elif defined TF_WRONG_1 // computes only what the sum took from b
    double sum = a + b;
    return b - (sum - a);
#elif defined TF_WRONG_2 // rounds again what was rounded
    return (a + b) - (a + b);
#elif defined TF_WRONG_3 // has the order of the two the wrong way around
    double sum = a + b, large = fmin(a, b), small = fmax(a, b);
    return small - (sum - large);
#elif defined TF_WRONG_4 // the excess instead of what is missing
    double sum = a + b;
    double from_b = sum - a, from_a = sum - from_b;
    return (from_a - a) + (from_b - b);
#else
    // Your turn: as if nothing were lost.
    return 0 * (a + b);
#endif
}

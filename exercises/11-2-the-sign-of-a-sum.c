/* Exercise 11.2.  The sign of a sum of doubles, exactly.
 *
 * Return the sign, -1, 0 or 1, of x[0] + x[1] + ... + x[n - 1] as real numbers,
 * for at most 24 doubles below 2^1000 in absolute value.  You may use
 * expansion_add.
 *
 * Section: Sums that do not fit.
 *
 * Hint 1: A double alone is an expansion of one term; zero is one of no terms.
 * Hint 2: Keep an expansion of what has been added up, and repeatedly add an
 *     expansion of one term to it.  The sum must be a different variable from
 *     the two summands.
 * Hint 3: The terms do not overlap and the last is the largest: its sign is
 *     that of the sum.  Without terms the sum is zero.
 */
#include "kit/expansion.h"

#include <math.h>

int sign_of_sum(int n, const double x[])
{
#if defined TF_SOLUTION
    expansion sum = {.count = 0};
    for (int i = 0; i < n; i++) {
        expansion before = sum, next = {.count = x[i] != 0, .term = {x[i]}};
        expansion_add(&before, &next, &sum);
    }
    double last = sum.count > 0 ? sum.term[sum.count - 1] : 0;
    return (last > 0) - (last < 0);
#elif defined TF_WRONG_1 // rounds
    double sum = 0;
    for (int i = 0; i < n; i++)
        sum += x[i];
    return (sum > 0) - (sum < 0);
#elif defined TF_WRONG_2 // keeps one roundoff, and rounds the sum of all
    tf_two sum = {0, 0};
    for (int i = 0; i < n; i++) {
        tf_two next = tf_two_sum(sum.hi, x[i]);
        sum = (tf_two){.hi = next.hi, .lo = sum.lo + next.lo};
    }
    double whole = sum.hi + sum.lo;
    return (whole > 0) - (whole < 0);
#elif defined TF_WRONG_3 // takes the first term, the smallest
    expansion sum = {.count = 0};
    for (int i = 0; i < n; i++) {
        expansion before = sum, next = {.count = x[i] != 0, .term = {x[i]}};
        expansion_add(&before, &next, &sum);
    }
    double first = sum.count > 0 ? sum.term[0] : 0;
    return (first > 0) - (first < 0);
#elif defined TF_WRONG_4 // treats what is far below the summands as zero
    double sum = 0, size = 0;
    for (int i = 0; i < n; i++) {
        sum += x[i];
        size += fabs(x[i]);
    }
    return fabs(sum) <= 1e-15 * size ? 0 : (sum > 0) - (sum < 0);
#else
    // Your turn: this is the sign of the first.
    return n > 0 ? (x[0] > 0) - (x[0] < 0) : 0;
#endif
}

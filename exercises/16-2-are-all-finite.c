/* Exercise 16.2.  Are all numbers finite, without a branch?
 *
 * Answer whether all `count` numbers are finite: no NaN and no infinity among
 * them.  Do it as a vector unit likes it, with the same operations for every
 * number, one running number, and no decision before the end.
 *
 * Section: Not a number.
 *
 * Hint 1: Adding up keeps NaNs and infinities.  But the sum of finite numbers
 *     may overflow.
 * Hint 2: There is a number by which you can multiply every finite number, and
 *     know the product.
 * Hint 3: A NaN is not equal to itself, and 0 times an infinity is a NaN.
 */
#include <math.h>
#include <stdbool.h>

bool all_finite(int count, const double x[])
{
#if defined TF_SOLUTION
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += 0 * x[i];
    return sum == 0;
#elif defined TF_WRONG_1 // takes finite numbers for infinite if they are large
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += x[i];
    return sum - sum == 0;
#elif defined TF_WRONG_2 // a minimum and a maximum drop NaNs
    double low = 0, high = 0;
    for (int i = 0; i < count; i++) {
        low = x[i] < low ? x[i] : low;
        high = x[i] > high ? x[i] : high;
    }
    return low > -INFINITY && high < INFINITY;
#elif defined TF_WRONG_3 // looks for NaNs only
    bool equal = true;
    for (int i = 0; i < count; i++)
        equal &= x[i] == x[i];
    return equal;
#elif defined TF_WRONG_4 // lets infinities of both signs cancel
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += x[i] / 1e305 > 1e5 ? 1 : x[i] / 1e305 < -1e5 ? -1 : 0 * x[i];
    return sum == 0;
#elif defined TF_WRONG_5 // looks at the last one
    double last = 0;
    for (int i = 0; i < count; i++)
        last = 0 * x[i];
    return last == 0;
#else
    // Your turn: an optimist.
    return true;
#endif
}

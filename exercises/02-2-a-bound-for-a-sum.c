/* Exercise 2.2.  A bound on the error of a sum.
 *
 * The sum (a + b) + c of three doubles is rounded twice.  Find a bound on how
 * far it is from the true sum.  It must hold for all doubles (none so large
 * that anything overflows), and it must not be more than 2.5 u (|a| + |b| +
 * |c|), where u = 2^-53, the unit roundoff.
 *
 * Section: A bound on the error.
 *
 * Hint 1: Every rounding multiplies what it rounds by 1 + e, |e| <= u.  How
 *     many roundings affect each of a, b and c?
 * Hint 2: The rounded sum is ((a + b)(1 + e) + c)(1 + e'): a and b are rounded
 *     twice, c once.
 * Hint 3: Two roundings are off by at most (1 + u)^2 - 1 = 2u + u^2.  Your
 *     bound is itself rounded: leave room for that, for instance by taking
 *     2 + 2^-40 where you mean slightly more than 2.
 */
#include <float.h>
#include <math.h>

#define U (DBL_EPSILON / 2)

double sum_bound(double a, double b, double c)
{
#if defined TF_SOLUTION
    return (2 + 0x1p-40) * U * (fabs(a) + fabs(b) + fabs(c));
#elif defined TF_WRONG_1 // trusts a sum in which everything has canceled
    return (2 + 0x1p-40) * U * fabs(a + b + c);
#elif defined TF_WRONG_2 // counts only one rounding
    return (1 + 0x1p-40) * U * (fabs(a) + fabs(b) + fabs(c));
#elif defined TF_WRONG_3 // takes DBL_EPSILON, twice u, for u
    return 2 * DBL_EPSILON * (fabs(a) + fabs(b) + fabs(c));
#elif defined TF_WRONG_4 // the same bound for all sums
    return 1e-12;
#else
    // Your turn: as if sums were exact.
    return 0 * U;
#endif
}

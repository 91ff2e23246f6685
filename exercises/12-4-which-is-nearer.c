/* Exercise 12.4.  Project: which of two points is nearer?
 *
 * Which of two points q and r of the plane is nearer to a point p?  Decide it
 * in the way of this part of the book.  First an estimate: the squared
 * distance of r from p minus that of q, rounded, and a bound on its error.  The
 * bound may be at most 16 u times the sum of the two squared distances, where
 * u = 2^-53.  Then the sign, exact for all points: positive if q is nearer, and
 * zero if both are equally near.  Take the sign of the estimate where the bound
 * allows it, and compute exactly where not.  All coordinates are multiples of
 * 2^-450 and below 2^400.  Estimates, expansions and proofs by Gappa are in
 * chapters 2 and 11.
 *
 * The checks try your bound on many points, which proves nothing.  Prove it:
 * write a script for Gappa, say `work/nearer.gappa`, like those in
 * `tests/proofs`.  It quotes the lines of your file.  Then run `make proofs
 * SCRIPT=work/nearer.gappa`.  How small may your constant be?  Finally, perturb
 * the points: which one is nearer in a tie, if every coordinate is moved by
 * its symbol?  Let the indices be in the order p, q, r.  A squared distance is
 * no determinant, and a symbol may occur in it squared, so you have to extend
 * the rule.
 *
 * Section: Three ways, compared.
 *
 * Hint 1: How many roundings are there on the way from the coordinates to a
 *     squared distance?  The relative error of a square is twice that of the
 *     number.  The last difference is rounded once more.
 * Hint 2: The terms of a squared distance are not negative, so adding them
 *     makes the relative error no larger, except for one more rounding.  Five
 *     times u and a little more is enough.
 * Hint 3: Multiplied out, p^2 drops out: r^2 - 2 p r - q^2 + 2 p q on each
 *     axis.  These are 8 products of doubles, and two_product() makes 16
 *     doubles of them without an error.
 * Hint 4: For Gappa, write the true terms as computed ones times factors 1 +
 *     e, as in tests/proofs/2x2.gappa.  Then every term has the same share of
 *     the bound, whatever its size.
 */
#include "arithmetic/sign.h"
#include "kit/expansion.h"

#include <math.h>

typedef struct estimate {
    double value, bound;
} estimate;

#if defined TF_SOLUTION || defined TF_WRONG_2 || defined TF_WRONG_3
#define SHARE (6 * 0x1p-53)
#elif defined TF_WRONG_1 // counts the last rounding alone
#define SHARE (1 * 0x1p-53)
#else
#define SHARE (0 * 0x1p-53) // Your turn: as if nothing were rounded.
#endif

static double squared_distance(const double a[2], const double b[2])
{
    double x = a[0] - b[0], y = a[1] - b[1];
    return x * x + y * y;
}

estimate estimate_nearer(const double p[2], const double q[2],
                         const double r[2])
{
    double far = squared_distance(r, p), near = squared_distance(q, p);
#if defined TF_WRONG_2 // believes that errors cancel, too
    return (estimate){far - near, SHARE * fabs(far - near)};
#else
    return (estimate){far - near, SHARE * (far + near)};
#endif
}

#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
/// Adds a b without an error.
static void add_product(double a, double b, expansion *sum)
{
    tf_two product = two_product(a, b);
    const double term[2] = {product.lo, product.hi};
    for (int i = 0; i < 2; i++) {
        expansion before = *sum, next = {.count = term[i] != 0};
        next.term[0] = term[i];
        expansion_add(&before, &next, sum);
    }
}

static tf_sign exact_nearer(const double p[2], const double q[2],
                            const double r[2])
{
    expansion sum = {.count = 0};
    for (int k = 0; k < 2; k++) {
        add_product(r[k], r[k], &sum);
        add_product(-2 * p[k], r[k], &sum);
        add_product(-q[k], q[k], &sum);
        add_product(2 * p[k], q[k], &sum);
    }
    return expansion_sign(&sum);
}
#endif

tf_sign nearer(const double p[2], const double q[2], const double r[2])
{
    estimate rounded = estimate_nearer(p, q, r);
    if (fabs(rounded.value) > rounded.bound)
        return rounded.value > 0 ? TF_POSITIVE : TF_NEGATIVE;
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    return exact_nearer(p, q, r);
#else
    // Your turn: what if the estimate does not decide?
    return TF_ZERO;
#endif
}

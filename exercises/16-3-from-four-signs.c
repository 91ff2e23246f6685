/* Exercise 16.3.  A verdict from four of six signs.
 *
 * Of the six coordinates of the triangles S_1 = {A, B | b} and
 * R_0 = {C | c, d} four were computed: those of A, B, c and d.  The true ones
 * are at most `bound` > 0 away from these numbers.  What is certain about the
 * pair?  Answer
 *
 *     TF_HIT        if all six certainly have the same sign;
 *     TF_APART      if two of the six certainly have opposite signs;
 *     TF_UNDECIDED  otherwise.
 *
 * Section: Fewer determinants.
 *
 * Hint 1: The other two are sums of two of these.
 * Hint 2: A number that is `bound` or less away from zero may have any sign.
 * Hint 3: The least and the greatest of the four tell everything.
 */
#include "intersect/verdict.h"

#include <math.h>

tf_verdict pair_verdict(const double number[4], double bound)
{
#if defined TF_SOLUTION
    double least = number[0], most = number[0];
    for (int i = 1; i < 4; i++) {
        least = fmin(least, number[i]);
        most = fmax(most, number[i]);
    }
    return least > bound || -most > bound   ? TF_HIT
           : most > bound && -least > bound ? TF_APART
                                            : TF_UNDECIDED;
#elif defined TF_WRONG_1 // takes unknown signs for zeros
    int positive = 0, negative = 0;
    for (int i = 0; i < 4; i++) {
        positive |= number[i] > bound;
        negative |= -number[i] > bound;
    }
    return positive && negative   ? TF_APART
           : positive || negative ? TF_HIT
                                  : TF_UNDECIDED;
#elif defined TF_WRONG_2 // wants all signs before it finds a conflict
    int positive = 0, negative = 0;
    for (int i = 0; i < 4; i++) {
        positive += number[i] > bound;
        negative += -number[i] > bound;
    }
    return positive + negative < 4        ? TF_UNDECIDED
           : positive > 0 && negative > 0 ? TF_APART
                                          : TF_HIT;
#elif defined TF_WRONG_3 // trusts a number that is as large as the bound
    double least = number[0], most = number[0];
    for (int i = 1; i < 4; i++) {
        least = fmin(least, number[i]);
        most = fmax(most, number[i]);
    }
    return least >= bound || -most >= bound   ? TF_HIT
           : most >= bound && -least >= bound ? TF_APART
                                              : TF_UNDECIDED;
#elif defined TF_WRONG_4 // looks at the bits of the signs
    int negative = 0, small = 0;
    for (int i = 0; i < 4; i++) {
        negative += signbit(number[i]) != 0;
        small |= fabs(number[i]) <= bound;
    }
    return negative > 0 && negative < 4 ? TF_APART
           : small                      ? TF_UNDECIDED
                                        : TF_HIT;
#elif defined TF_WRONG_5 // adds up first
    double start = number[0] + number[1], end = number[2] + number[3];
    return start * end < 0 && fabs(start) > bound && fabs(end) > bound
               ? TF_APART
           : fabs(start) > bound && fabs(end) > bound ? TF_HIT
                                                      : TF_UNDECIDED;
#else
    // Your turn: too careful.
    return TF_UNDECIDED;
#endif
}

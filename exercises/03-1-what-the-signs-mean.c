/* Exercise 3.1.  What barycentric signs mean, if some are unknown.
 *
 * Two complementary simplices intersect if the signs of their barycentric
 * coordinates, turned so that those of S and R count alike, agree: none is
 * positive while another is negative.  A zero agrees with both; but if all are
 * zero the signs decide nothing (the next chapter continues from there).  And
 * some signs may be unknown: each may be any of the three.  Answer TF_HIT or
 * TF_APART only if it is certain, and TF_UNDECIDED otherwise.
 *
 * Section: Barycentric signs.
 *
 * Hint 1: A positive and a negative sign settle it, whatever else there is.
 * Hint 2: Without such a conflict, one unknown sign leaves it open: it may be
 *     the one that conflicts, or it may be zero like all the others.
 * Hint 3: What is left has no unknown sign and no conflict: a hit, unless all
 *     are zero.
 */
#include "intersect/complementary.h"

tf_verdict read_signs(int count, const tf_sign sign[])
{
    bool positive = false, negative = false, unknown = false;
    for (int i = 0; i < count; i++) {
        positive |= sign[i] == TF_POSITIVE;
        negative |= sign[i] == TF_NEGATIVE;
        unknown |= sign[i] == TF_UNKNOWN;
    }
#if defined TF_SOLUTION
    if (positive && negative)
        return TF_APART;
    if (unknown || (!positive && !negative))
        return TF_UNDECIDED;
    return TF_HIT;
#elif defined TF_WRONG_1 // treats an unknown sign as zero: misses contacts
    if (positive && negative)
        return TF_APART;
    if (!positive && !negative)
        return unknown ? TF_APART : TF_UNDECIDED;
    return TF_HIT;
#elif defined TF_WRONG_2 // touching does not count
    if (positive && negative)
        return TF_APART;
    for (int i = 0; i < count; i++)
        if (sign[i] == TF_ZERO)
            return TF_APART;
    return unknown ? TF_UNDECIDED : TF_HIT;
#elif defined TF_WRONG_3 // gives up at an unknown sign that does not matter
    if (unknown || (!positive && !negative))
        return TF_UNDECIDED;
    return positive && negative ? TF_APART : TF_HIT;
#elif defined TF_WRONG_4 // treats all zeros as a hit
    if (positive && negative)
        return TF_APART;
    return unknown ? TF_UNDECIDED : TF_HIT;
#else
    // Your turn: this is never wrong, and seldom useful.
    return positive && negative && unknown ? TF_APART : TF_UNDECIDED;
#endif
}

/* Exercise 16.1.  The signs of sixty-four determinants at once.
 *
 * You are given sixty-four triples of points in the plane, p, q and r.  The
 * number at[v][k][i] is coordinate k (x or y) of point v (0 for p, 1 for q,
 * 2 for r) in lane i.  For each lane, find on which side of the path from p to
 * q the point r is: left if
 *
 *     D = (q_x - p_x) (r_y - p_y) - (q_y - p_y) (r_x - p_x)
 *
 * is positive, right if it is negative.  Set bit i of *left or of *right only
 * where that is certain, and all other bits to zero.
 *
 * Bound the error by the ranges of the lane: with Mx and My, the largest
 * differences to p on each axis, every D of more than 16 u Mx My in absolute
 * value must be decided, u = 2^-53.  All coordinates are finite, and no product
 * of two differences overflows or underflows.
 *
 * Section: Errors by ranges.
 *
 * Hint 1: Count, as the text does: a difference is off by u of itself, and each
 *     of the two terms has two of them and is rounded itself.  No term is larger
 *     than Mx My.
 * Hint 2: An M of all axes together would be too large where the axes are
 *     scaled differently.
 * Hint 3: (uint64_t)1 << i is the bit.
 */
#include <math.h>
#include <stdint.h>

void sides(const double at[3][2][64], uint64_t *left, uint64_t *right)
{
    *left = *right = 0;
#if defined TF_SOLUTION
    for (int i = 0; i < 64; i++) {
        double ex = at[1][0][i] - at[0][0][i], ey = at[1][1][i] - at[0][1][i];
        double fx = at[2][0][i] - at[0][0][i], fy = at[2][1][i] - at[0][1][i];
        double number = ex * fy - ey * fx;
        double bound =
            8 * 0x1p-53 * fmax(fabs(ex), fabs(fx)) * fmax(fabs(ey), fabs(fy));
        *left |= (uint64_t)(number > bound) << i;
        *right |= (uint64_t)(-number > bound) << i;
    }
#elif defined TF_WRONG_1 // trusts every sign
    for (int i = 0; i < 64; i++) {
        double ex = at[1][0][i] - at[0][0][i], ey = at[1][1][i] - at[0][1][i];
        double fx = at[2][0][i] - at[0][0][i], fy = at[2][1][i] - at[0][1][i];
        double number = ex * fy - ey * fx;
        *left |= (uint64_t)(number > 0) << i;
        *right |= (uint64_t)(number < 0) << i;
    }
#elif defined TF_WRONG_2 // one range for both axes
    for (int i = 0; i < 64; i++) {
        double ex = at[1][0][i] - at[0][0][i], ey = at[1][1][i] - at[0][1][i];
        double fx = at[2][0][i] - at[0][0][i], fy = at[2][1][i] - at[0][1][i];
        double number = ex * fy - ey * fx;
        double most = fmax(fmax(fabs(ex), fabs(fx)), fmax(fabs(ey), fabs(fy)));
        double bound = 8 * 0x1p-53 * most * most;
        *left |= (uint64_t)(number > bound) << i;
        *right |= (uint64_t)(-number > bound) << i;
    }
#elif defined TF_WRONG_3 // counts no differences
    for (int i = 0; i < 64; i++) {
        double ex = at[1][0][i] - at[0][0][i], ey = at[1][1][i] - at[0][1][i];
        double fx = at[2][0][i] - at[0][0][i], fy = at[2][1][i] - at[0][1][i];
        double number = ex * fy - ey * fx;
        double bound =
            0x1p-53 * fmax(fabs(ex), fabs(fx)) * fmax(fabs(ey), fabs(fy));
        *left |= (uint64_t)(number > bound) << i;
        *right |= (uint64_t)(-number > bound) << i;
    }
#elif defined TF_WRONG_4 // exchanges left and right
    for (int i = 0; i < 64; i++) {
        double ex = at[1][0][i] - at[0][0][i], ey = at[1][1][i] - at[0][1][i];
        double fx = at[2][0][i] - at[0][0][i], fy = at[2][1][i] - at[0][1][i];
        double number = ex * fy - ey * fx;
        double bound =
            8 * 0x1p-53 * fmax(fabs(ex), fabs(fx)) * fmax(fabs(ey), fabs(fy));
        *right |= (uint64_t)(number > bound) << i;
        *left |= (uint64_t)(-number > bound) << i;
    }
#else
    // Your turn: nothing is certain yet.
#endif
}

/* Exercise 12.2.  The turn of three perturbed points.
 *
 * Walk from p[0] to p[1] and on to p[2], in the plane.  `turn` computes exactly
 * whether you turn left (positive), turn right (negative) or go straight
 * (zero).  Now each point is moved by two symbols, as in the chapter: those of
 * a point with a lower index come before those of one with a higher index, and
 * for a point x comes before y.  The indices are different, and in any order.
 * Find how you turn then.  The answer is never zero, even if all points are the
 * same.  Two things are missing: how a coefficient is computed, and the list of
 * products whose coefficients are tried.
 *
 * Section: The coefficient of a product.
 *
 * Hint 1: First try with nothing moved.  While the answer is zero, try the
 *     coefficients of products of symbols, the largest product first.
 * Hint 2: Let q, r and s be the points in the order of their indices.  The
 *     products are, from the largest: q's x; q's y; r's x; r's x times q's y.
 *     The list can end there, since the coefficient of this product is 1 or -1.
 * Hint 3: In the coefficient of q's x, replace the x of q by 1 and the x of the
 *     two others by 0.  In a product of two symbols replace all x and all y.
 * Hint 4: Replace coordinates in a copy of p, in which the points keep their
 *     places 0, 1, 2: their order in the walk has nothing to do with their
 *     indices.
 */
#include "arithmetic/arithmetic.h"
#include "arithmetic/functions.h"

enum {
    POINTS = 3,
    STAYS = -1
};

/// The exact sign of the determinant with the rows p[1] - p[0] and p[2] - p[0].
static tf_sign turn(const tf_arithmetic *arithmetic, const tf_event p[POINTS])
{
    tf_differences rows = {
        .n = 2, .to = {&p[1], &p[2]}, .from = {&p[0], &p[0]}, .axis = {0, 1}};
    return arithmetic->sign(&rows);
}

/// The place of the point that has `rank` points of lower index.
static int place_of(const tf_event p[POINTS], int rank)
{
    for (int i = 0; i < POINTS; i++) {
        int lower = 0;
        for (int j = 0; j < POINTS; j++)
            lower += p[j].vertex < p[i].vertex;
        if (lower == rank)
            return i;
    }
    return STAYS;
}

/// The sign of the coefficient of a product that has, on axis k, the symbol of
/// the point moved[k], or none if that is STAYS.
static tf_sign coefficient(const tf_arithmetic *arithmetic,
                           const tf_event p[POINTS], const int moved[2])
{
    tf_event copy[POINTS] = {p[0], p[1], p[2]};
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < POINTS; i++)
            if (moved[k] != STAYS)
                copy[i].x[k] = moved[k] == i;
#elif defined TF_WRONG_3 // leaves the other points where they are
    for (int k = 0; k < 2; k++)
        if (moved[k] != STAYS)
            copy[moved[k]].x[k] = 1;
#else
    // Your turn: nothing is replaced yet.
#endif
    return turn(arithmetic, copy);
}

tf_sign moved_turn(const tf_arithmetic *arithmetic, const tf_event p[POINTS])
{
    int q = place_of(p, 0);
#if defined TF_SOLUTION || defined TF_WRONG_3
    int r = place_of(p, 1);
    const int product[][2] = {
        {STAYS, STAYS}, {q, STAYS}, {STAYS, q}, {r, STAYS}, {r, q}};
#elif defined TF_WRONG_1 // does not try a product of two symbols
    int r = place_of(p, 1);
    const int product[][2] = {
        {STAYS, STAYS}, {q, STAYS}, {STAYS, q}, {r, STAYS}, {STAYS, r}};
#elif defined TF_WRONG_2 // takes y before x
    int r = place_of(p, 1);
    const int product[][2] = {
        {STAYS, STAYS}, {STAYS, q}, {q, STAYS}, {STAYS, r}, {q, r}};
#else
    // Your turn: these are nothing moved, and the x of q.
    const int product[][2] = {{STAYS, STAYS}, {q, STAYS}};
#endif
    int count = (int)(sizeof product / sizeof *product);
    tf_sign sign = TF_ZERO;
    for (int i = 0; i < count && sign == TF_ZERO; i++)
        sign = coefficient(arithmetic, p, product[i]);
    return sign;
}

/* Exercise 10.2.  Rounding to a grid.
 *
 * Round a place in space to a grid of cells of size `cell`, a power of two:
 * `snapped` becomes the nearest point of the grid, counted in cells, each
 * coordinate an integer below 2^bits in absolute value.  A coordinate halfway
 * between two integers is rounded away from zero.  Return false if the result
 * is out of range; then `snapped` may be anything.  The coordinates of `place`
 * are finite, 1 <= bits <= 53, and place / cell neither overflows nor
 * underflows.
 *
 * Section: Rounding to a grid.
 *
 * Hint 1: <math.h> has a function that does this for one number: it rounds ties
 *     away from zero, whatever the rounding mode of the machine.
 * Hint 2: Adding one half and truncating is not the same.  Try
 *     0.49999999999999994.
 * Hint 3: A number within the range may be rounded out of it.  Check what you
 *     return, not what you were given.
 */
#include <math.h>
#include <stdbool.h>

bool snap(double cell, int bits, const double place[3], double snapped[3])
{
    for (int k = 0; k < 3; k++) {
        double x = place[k] / cell;
#if defined TF_SOLUTION
        snapped[k] = round(x);
        if (fabs(snapped[k]) >= ldexp(1, bits))
            return false;
#elif defined TF_WRONG_1 // adds one half and rounds down
        snapped[k] = floor(x + 0.5);
        if (fabs(snapped[k]) >= ldexp(1, bits))
            return false;
#elif defined TF_WRONG_2 // truncates: moves a point by up to a whole cell
        snapped[k] = trunc(x);
        if (fabs(snapped[k]) >= ldexp(1, bits))
            return false;
#elif defined TF_WRONG_3 // checks the range too early
        if (fabs(x) >= ldexp(1, bits))
            return false;
        snapped[k] = round(x);
#elif defined TF_WRONG_4 // rounds ties to even
        snapped[k] = rint(x);
        if (fabs(snapped[k]) >= ldexp(1, bits))
            return false;
#else
        // Your turn: nothing is rounded.
        snapped[k] = x;
#endif
    }
    return true;
}

/* Exercise 21.5.  A step home.
 *
 * The vertices of a surface are in a clear state, x, and are to return towards
 * the input as far as they can.  All are `count` numbers.  propose() sets `end`
 * to where a step is to end: the given fraction, more than 0 and at most 1, of
 * the way from x to the input.  With the fraction 1 that is the input itself, to
 * the last bit; and a number that is at home stays as it is, to the last bit.
 *
 * The response makes the proposed step clear, and may change any end.  Then
 * accept() decides: if the sum of the squares of the distances from the input
 * has fallen, it sets x to the end of the step and returns true.  Otherwise x
 * stays as it is, to the last bit.
 *
 * Section: The way home.
 *
 * Hint 1: x + (input - x) may be another number than input.
 * Hint 2: -0 + 0 is 0, and that has other bits than -0.
 * Hint 3: If a step is accepted without any gain, the next one may be accepted
 *     for the same reason, and so on without end.
 */
#include <stdbool.h>

void propose(int count, const double input[], const double x[], double fraction,
             double end[])
{
    for (int i = 0; i < count; i++)
#if defined TF_SOLUTION || defined TF_WRONG_3 || defined TF_WRONG_4
        end[i] = fraction < 1 && x[i] != input[i]
                     ? x[i] + fraction * (input[i] - x[i])
                     : input[i];
#elif defined TF_WRONG_1 // rounds where the whole way ends
        end[i] =
            x[i] != input[i] ? x[i] + fraction * (input[i] - x[i]) : input[i];
#elif defined TF_WRONG_2 // turns -0 into 0
        end[i] = fraction < 1 ? x[i] + fraction * (input[i] - x[i]) : input[i];
#else
        // Your turn, part one: is this right to the last bit?
        end[i] = x[i] + fraction * (input[i] - x[i]);
#endif
}

/// The sum of the squares of the differences.
static double squares(int count, const double a[], const double b[])
{
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

bool accept(int count, const double input[], const double end[], double x[])
{
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    if (!(squares(count, end, input) < squares(count, x, input)))
        return false;
    for (int i = 0; i < count; i++)
        x[i] = end[i];
    return true;
#elif defined TF_WRONG_3 // accepts a step that gains nothing
    if (squares(count, end, input) > squares(count, x, input))
        return false;
    for (int i = 0; i < count; i++)
        x[i] = end[i];
    return true;
#elif defined TF_WRONG_4 // decides vertex by vertex, which need not be clear
    bool any = false;
    for (int i = 0; i < count; i++)
        if (squares(1, end + i, input + i) < squares(1, x + i, input + i)) {
            x[i] = end[i];
            any = true;
        }
    return any;
#else
    // Your turn, part two: for now each step is accepted.
    for (int i = 0; i < count; i++)
        x[i] = end[i];
    return squares(count, x, input) >= 0;
#endif
}

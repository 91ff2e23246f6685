/* Exercise 9.3.  Never past the point: advancing a bar that turns.
 *
 * A bar of length 1 turns about one end, counterclockwise by `turn` radians per
 * step.  A point rests at the distance `radius` < 1 from that end, `ahead`
 * radians ahead of the bar, less than a right angle.  Advance the bar until its
 * distance from the point is at most `threshold`, or to the end of the step,
 * t = 1.  Every advance must be safe whatever is known of the point but its
 * distance, and as large as it can be: all of the distance over a bound on the
 * speed of the bar.  Return the time, and count the advances in *steps.
 *
 * Section: Advance until close.
 *
 * Hint 1: The distance is radius times the sine of the angle that is left.
 * Hint 2: No point of the bar is faster than its tip, which moves `turn` units
 *     of length per step.  The point of the bar that will touch is slower, but
 *     to use that you would have to know where it is.
 * Hint 3: Find the distance; end if it is at most the threshold; otherwise add
 *     the distance over the speed to the time.  An advance that would go
 *     beyond t = 1 ends there, and counts.
 */
#include <math.h>

double advance_bar(double radius, double ahead, double turn, double threshold,
                   int *steps)
{
    double t = 0;
    *steps = 0;
#if defined TF_SOLUTION
    for (;;) {
        double distance = radius * sin(ahead - turn * t);
        if (distance <= threshold || t == 1)
            return t;
        t = fmin(t + distance / turn, 1);
        (*steps)++;
    }
#elif defined TF_WRONG_1 // the speed at the point: passes it
    for (;;) {
        double distance = radius * sin(ahead - turn * t);
        if (distance <= threshold || t == 1)
            return t;
        t = fmin(t + distance / (turn * radius * cos(ahead - turn * t)), 1);
        (*steps)++;
    }
#elif defined TF_WRONG_2 // a fixed number of steps
    for (; *steps < 20 && t < 1; (*steps)++)
        t = fmin(t + radius * sin(ahead - turn * t) / turn, 1);
    return t;
#elif defined TF_WRONG_3 // stops at the threshold as a time
    for (;;) {
        double advance = radius * sin(ahead - turn * t) / turn;
        if (advance <= threshold || t == 1)
            return t;
        t = fmin(t + advance, 1);
        (*steps)++;
    }
#elif defined TF_WRONG_4 // half of the distance: safe, but too careful
    for (;;) {
        double distance = radius * sin(ahead - turn * t);
        if (distance <= threshold || t == 1)
            return t;
        t = fmin(t + distance / (2 * turn), 1);
        (*steps)++;
    }
#else
    // Your turn: this makes one advance.
    *steps = 1;
    return t + radius * sin(ahead) / turn;
#endif
}

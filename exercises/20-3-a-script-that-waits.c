/* Exercise 20.3.  A script that waits for vertices that are held back.
 *
 * A step of a simulation has been resolved.  go_on() ends it: given are the
 * resolved ends, `count` numbers, the length of the step in seconds, and how many
 * scripted vertices the response has held back.  Set the velocities with which
 * the next step begins, go on to the new positions, and wind the clock of the
 * script.  In each step the script moves its hand to where it should be at the
 * time clock + step.  No step may ask the hand to go farther than the script
 * would in the time of one step, even after it was held back for long.
 *
 * Section: Predict, resolve, go on.
 *
 * Hint 1: Velocities are what happened, divided by the time that it took.
 * Hint 2: Afterwards the old positions are gone.
 * Hint 3: What should the clock show after a step in which the hand was stuck?
 */

void go_on(int count, const double end[], double step, int held,
           double position[], double velocity[], double *clock)
{
    for (int i = 0; i < count; i++) {
#if defined TF_WRONG_1 // forgets where it comes from
        position[i] = end[i];
        velocity[i] = (end[i] - position[i]) / step;
#elif defined TF_WRONG_2 // takes the way for the velocity
        velocity[i] = end[i] - position[i];
        position[i] = end[i];
#elif defined TF_SOLUTION || defined TF_WRONG_3 || defined TF_WRONG_4
        velocity[i] = (end[i] - position[i]) / step;
        position[i] = end[i];
#elif defined TF_WRONG_5
        velocity[i] = (end[i] - position[i]) / step;
        position[i] = end[i];
#else
        // Your turn, part one: and the velocity?
        position[i] = end[i];
#endif
    }
#if defined TF_WRONG_3 // takes no notice of what is held
    *clock += step;
#elif defined TF_WRONG_4 // turns back
    *clock += held > 0 ? -step : step;
#elif defined TF_WRONG_5 // waits only if it is held in more than one place
    *clock += held > 1 ? 0 : step;
#elif defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    *clock += held > 0 ? 0 : step;
#else
    // Your turn, part two: does the clock always go on?
    *clock += step;
#endif
}

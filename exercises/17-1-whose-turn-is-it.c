/* Exercise 17.1.  Whose turn is it: shares of a displacement over time.
 *
 * The vertices of an element take turns in pulling a dot, the last vertex
 * first, each for a time that is the dot's barycentric coordinate.  Store in
 * share[i] the factor with which the displacement of vertex i has entered the
 * path of the dot by the time t.  Then the dot is at the sum, over all vertices,
 * of coordinate[i] times the start plus share[i] times the displacement.
 *
 * `count` is 1, 2 or 3, the coordinates are at least 0 and add up to 1, and t
 * is from 0 to 1.
 *
 * Section: The path of a painted point.
 *
 * Hint 1: When does the turn of vertex i begin?  The turns of all vertices with
 *     higher indices come first.
 * Hint 2: Before its turn the share is zero, and after its turn it is the
 *     coordinate.
 * Hint 3: Go from the last vertex to the first, and add up the coordinates.
 */
#include <math.h>

void shares(int count, const double coordinate[], double t, double share[])
{
#if defined TF_SOLUTION
    double begin = 0;
    for (int i = count - 1; i >= 0; i--) {
        share[i] = fmin(fmax(t - begin, 0), coordinate[i]);
        begin += coordinate[i];
    }
#elif defined TF_WRONG_1 // linear motion: all pull all of the time
    for (int i = 0; i < count; i++)
        share[i] = t * coordinate[i];
#elif defined TF_WRONG_2 // the first vertex first
    double begin = 0;
    for (int i = 0; i < count; i++) {
        share[i] = fmin(fmax(t - begin, 0), coordinate[i]);
        begin += coordinate[i];
    }
#elif defined TF_WRONG_3 // turns that never end
    double begin = 0;
    for (int i = count - 1; i >= 0; i--) {
        share[i] = fmax(t - begin, 0);
        begin += coordinate[i];
    }
#elif defined TF_WRONG_4 // turns that have begun before the step
    double begin = 0;
    for (int i = count - 1; i >= 0; i--) {
        share[i] = fmin(t - begin, coordinate[i]);
        begin += coordinate[i];
    }
#elif defined TF_WRONG_5 // all turns begin at the start
    for (int i = 0; i < count; i++)
        share[i] = fmin(t, coordinate[i]);
#else
    // Your turn: so far nobody pulls.
    for (int i = 0; i < count; i++)
        share[i] = 0;
#endif
}

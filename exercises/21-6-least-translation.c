/* Exercise 21.6.  The least translation that moves two parts apart.
 *
 * Two convex polygons in the plane overlap; each is given by its corners, two
 * coordinates each, counterclockwise.  Given are also some directions, of
 * different lengths.  Find the shortest translation of the first polygon along
 * one of them, a positive multiple of the direction, after which the insides of
 * the polygons have nothing in common, and set `move` to it.  Return the index of
 * its direction, or the lower one of two equally short ones.
 *
 * Section: Apart.
 *
 * Hint 1: Convex polygons whose insides have nothing in common are on different
 *     sides of some line along an edge of one of them.
 * Hint 2: Along a direction, each edge says how far the polygon must go until the
 *     line along that edge is between the two.  Which of these is enough?
 * Hint 3: An edge never is between the two if the direction does not lead away
 *     from it.
 */
#include <math.h>

/// The least value, for all corners, of the product with a normal.
static double least(int corners, const double corner[][2], double x, double y)
{
    double value = INFINITY;
    for (int i = 0; i < corners; i++)
        value = fmin(value, x * corner[i][0] + y * corner[i][1]);
    return value;
}

/// How many times a direction the first polygon must go until it is on the side
/// of a line along an edge of `from` to which (x, y) points, and the second one
/// on the other side.
static double times_along(int first, const double a[][2], int second,
                          const double b[][2], const double direction[2],
                          double x, double y)
{
    double speed = x * direction[0] + y * direction[1];
    double overlap = -least(second, b, -x, -y) - least(first, a, x, y);
    return speed > 0 ? overlap / speed : INFINITY;
}

/// How many times a direction the first polygon must go.
static double times(int first, const double a[][2], int second,
                    const double b[][2], const double direction[2])
{
    double enough = INFINITY;
    for (int i = 0; i < second; i++) { // the normals of b point outward
        double x = b[(i + 1) % second][1] - b[i][1];
        double y = b[i][0] - b[(i + 1) % second][0];
        double t = times_along(first, a, second, b, direction, x, y);
#if defined TF_WRONG_1 // demands that every edge be between the two
        enough = isinf(enough) ? t : isinf(t) ? enough : fmax(enough, t);
#else
        enough = fmin(enough, t);
#endif
    }
#if defined TF_SOLUTION || defined TF_WRONG_3 || defined TF_WRONG_4
    for (int i = 0; i < first; i++) { // and those of a inward
        double x = a[i][1] - a[(i + 1) % first][1];
        double y = a[(i + 1) % first][0] - a[i][0];
        enough =
            fmin(enough, times_along(first, a, second, b, direction, x, y));
    }
#elif defined TF_WRONG_2 // takes the normals of both outward
    for (int i = 0; i < first; i++) {
        double x = a[(i + 1) % first][1] - a[i][1];
        double y = a[i][0] - a[(i + 1) % first][0];
        enough =
            fmin(enough, times_along(first, a, second, b, direction, x, y));
    }
#else
    // Your turn, part one: what about the edges of a?
#endif
    return enough;
}

int move_apart(int first, const double a[][2], int second, const double b[][2],
               int directions, const double direction[][2], double move[2])
{
    int best = 0;
    double shortest = INFINITY;
    for (int i = 0; i < directions; i++) {
        double t = times(first, a, second, b, direction[i]);
#if defined TF_WRONG_3 // forgets that directions have lengths
        double length = t;
#elif defined TF_WRONG_4 // takes the last of equally short ones
        double length = t * hypot(direction[i][0], direction[i][1]);
        if (length == shortest)
            best = i;
#elif defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
        double length = t * hypot(direction[i][0], direction[i][1]);
#else
        // Your turn, part two: for now the first direction will do.
        double length = i == 0 ? t : shortest;
#endif
        if (length < shortest) {
            shortest = length;
            best = i;
        }
    }
    double t = times(first, a, second, b, direction[best]);
    for (int k = 0; k < 2; k++)
        move[k] = t * direction[best][k];
    return best;
}

/* Exercise 20.2.  One spring: an iteration of projective dynamics.
 *
 * In the plane a vertex of mass m hangs on a spring from a scripted vertex at the
 * origin.  The spring has the stiffness k and is r long at rest.  Inertia would
 * lead the vertex to y.  iterate() makes one iteration of projective dynamics for
 * a step of h seconds: it changes z, where the vertex is to end.  A local step
 * finds the sum p that the spring wants, and a global step the z that suits it
 * best.  At z = 0 the spring points nowhere; then let p be 0.
 *
 * Section: One matrix for the whole film.
 *
 * Hint 1: p has the direction of z and the length r.
 * Hint 2: The global step minimizes
 *     m / (2 h^2) |z - y|^2 + k / 2 |z - p|^2.
 * Hint 3: Set the derivative with respect to z to zero, and multiply by h^2.
 */
#include <math.h>

/// The local step.
static void want(double r, const double z[2], double p[2])
{
    double length = hypot(z[0], z[1]);
#if defined TF_WRONG_1 // is content with any length
    double scale = length > 0 ? 1 : 0;
#elif defined TF_WRONG_2 // divides by zero
    double scale = r / length;
#elif defined TF_SOLUTION || defined TF_WRONG_3 || defined TF_WRONG_4
    double scale = length > 0 ? r / length : 0;
#elif defined TF_WRONG_5
    double scale = length > 0 ? r / length : 0;
#else
    // Your turn, part one: which multiple of z is it?
    double scale = r + 0 * length;
#endif
    for (int i = 0; i < 2; i++)
        p[i] = scale * z[i];
}

void iterate(double m, double k, double r, double h, const double y[2],
             double z[2])
{
    double p[2];
    want(r, z, p);
    for (int i = 0; i < 2; i++) {
#if defined TF_WRONG_3 // forgets the square
        z[i] = (m * y[i] + h * k * p[i]) / (m + h * k);
#elif defined TF_WRONG_4 // adds the force where the vertex was
        z[i] = y[i] + h * h * k / m * (p[i] - z[i]);
#elif defined TF_WRONG_5 // takes the mean of both
        z[i] = (y[i] + p[i]) / 2;
#elif defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
        z[i] = (m * y[i] + h * h * k * p[i]) / (m + h * h * k);
#else
        // Your turn, part two: for now the vertex goes where the spring wants.
        z[i] = p[i];
#endif
    }
}

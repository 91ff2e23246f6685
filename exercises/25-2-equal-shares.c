/* Exercise 25.2.  Equal shares: restoring a volume, vertex by vertex.
 *
 * A closed surface has lost the volume `lost`, and `count` of its vertices are
 * to restore it, one after the other.  Each moves along the normal of its star.
 * In its turn a vertex restores an equal share of what is left for itself and
 * those after it, unless it would have to move farther than `most`.  Then it
 * stays where it is, and the others have to restore more.  What is left in the
 * end is returned.
 *
 * The function normal_of(vertex, normal) finds the sum of the normals of the
 * triangles at a vertex, each as long as twice the area, in the positions of
 * that moment.  The position of the vertex v is position[v].
 *
 * Section: Restoring volume.
 *
 * Hint 1: If a vertex moves by s N, where N is the sum of the normals, the
 *     volume grows by s N . N / 6.
 * Hint 2: With i vertices before it, how many are left to restore it?
 * Hint 3: The next normal must be found after the last vertex has moved.  Why
 *     does it matter?
 */
#include <math.h>

void normal_of(int vertex, double normal[3]);

double restore_volume(int count, const int vertex[], double lost, double most,
                      double position[][3])
{
    for (int i = 0; i < count; i++) {
        double normal[3], square = 0;
        normal_of(vertex[i], normal);
        for (int k = 0; k < 3; k++)
            square += normal[k] * normal[k];
#if defined TF_SOLUTION || defined TF_WRONG_2 || defined TF_WRONG_3
        double share = lost / (count - i);
#elif defined TF_WRONG_1 // takes a share as if all were yet to restore
        double share = lost / count;
#else
        // Your turn, part one: what is this vertex to restore?
        double share = 0 * lost;
#endif
#if defined TF_WRONG_2 // forgets that the normals are twice the areas
        double factor = 3 * share / square;
#else
        double factor = 6 * share / square;
#endif
#if defined TF_WRONG_3 // counts what it does not move
        lost -= share;
#endif
        if (!(fabs(factor) * sqrt(square) <= most))
            continue;
        for (int k = 0; k < 3; k++)
            position[vertex[i]][k] += factor * normal[k];
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
        lost -= share;
#elif !defined TF_WRONG_3
        // Your turn, part two: who has restored what?
        lost -= 0 * share;
#endif
    }
    return lost;
}

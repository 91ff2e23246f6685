/* Exercise 20.1.  What a fold measures: the weights of bending.
 *
 * Two triangles share the edge from a to b; their other corners are c and d.
 * Given are the positions of a, b, c and d, in that order, when the two lie flat.
 * Find weights for which the sum of weight times position is zero as long as the
 * triangles lie in any one plane, on different sides of the edge.  Folded by an
 * angle theta, with edges of the same lengths, the sum is to have the length
 * 2 l sin(theta / 2), where l is the length of the edge.  The triangles have an
 * area.
 *
 * Section: Cloth.
 *
 * Hint 1: The cotangent of the angle between two vectors is their dot product
 *     divided by the length of their cross product.
 * Hint 2: a is weighted by angles at b, and b by angles at a.
 * Hint 3: The four weights add up to zero; otherwise the sum would change if the
 *     sheet were moved.
 */
#include <math.h>

/// The cotangent of the angle at `corner` in the triangle with b and c.
static double cotangent(const double corner[3], const double b[3],
                        const double c[3])
{
    double dot = 0, to_b = 0, to_c = 0;
    for (int k = 0; k < 3; k++) {
        dot += (b[k] - corner[k]) * (c[k] - corner[k]);
        to_b += (b[k] - corner[k]) * (b[k] - corner[k]);
        to_c += (c[k] - corner[k]) * (c[k] - corner[k]);
    }
#if defined TF_WRONG_1 // takes the cosine
    return dot / sqrt(to_b * to_c);
#elif defined TF_WRONG_2 // forgets to divide
    return dot;
#elif defined TF_SOLUTION || defined TF_WRONG_3 || defined TF_WRONG_4
    // The length of the cross product, by Lagrange's identity.
    return dot / sqrt(to_b * to_c - dot * dot);
#else
    // Your turn, part one: this is right for angles of 45 degrees.
    return 1;
#endif
}

void fold_weights(const double rest[4][3], double weight[4])
{
    const double *a = rest[0], *b = rest[1], *c = rest[2], *d = rest[3];
    double c_at_a = cotangent(a, b, c), c_at_b = cotangent(b, a, c);
    double d_at_a = cotangent(a, b, d), d_at_b = cotangent(b, a, d);
#if defined TF_WRONG_3 // weights each end by its own angles
    weight[0] = c_at_a + d_at_a;
    weight[1] = c_at_b + d_at_b;
#elif defined TF_WRONG_4 // forgets one of the triangles
    weight[0] = c_at_b;
    weight[1] = c_at_a;
#elif defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    weight[0] = c_at_b + d_at_b;
    weight[1] = c_at_a + d_at_a;
#else
    // Your turn, part two.
    weight[0] = c_at_a;
    weight[1] = d_at_a;
#endif
    weight[2] = -c_at_a - c_at_b;
    weight[3] = -d_at_a - d_at_b;
}

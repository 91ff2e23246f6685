/* Exercise 24.1.  The triangles of a merge.
 *
 * Two quadrilaterals of a surface face each other.  The corners of both are
 * given counterclockwise, each as seen from the outer side of its own part of
 * the surface.  Both are removed, and a tube of eight triangles takes their
 * place.  Fill in its triangles, three vertices each, counterclockwise as seen
 * from outside.  The corner p[0] is to be joined to q[0]; of two diagonals
 * either will do.
 *
 * Section: The zipper.
 *
 * Hint 1: Which way around does the second quadrilateral go, if you look at it
 *     through the first one?
 * Hint 2: The removed triangles passed the edge from p[0] to p[1] in this
 *     direction.  So must one of the new ones.
 * Hint 3: The corner p[i] is joined to q[(4 - i) % 4].
 */

/// The corner of the second quadrilateral that p[i] is joined to, i up to 4.
static int partner(const int q[4], int i)
{
#if defined TF_SOLUTION || defined TF_WRONG_2 || defined TF_WRONG_3
    return q[(4 - i) % 4];
#elif defined TF_WRONG_1 // goes around in the same sense
    return q[i % 4];
#else
    // Your turn: who faces whom?
    return q[0 * i];
#endif
}

static void set(int triangle[3], int a, int b, int c)
{
    triangle[0] = a;
    triangle[1] = b;
    triangle[2] = c;
}

void zip(const int p[4], const int q[4], int triangle[8][3])
{
    for (int i = 0; i < 4; i++) {
        int p0 = p[i], p1 = p[(i + 1) % 4];
        int q0 = partner(q, i), q1 = partner(q, i + 1);
#if defined TF_SOLUTION || defined TF_WRONG_1
        set(triangle[2 * i], p0, p1, q1);
        set(triangle[2 * i + 1], p0, q1, q0);
#elif defined TF_WRONG_2 // looks from inside
        set(triangle[2 * i], p0, q1, p1);
        set(triangle[2 * i + 1], p0, q0, q1);
#elif defined TF_WRONG_3 // takes both diagonals
        set(triangle[2 * i], p0, p1, q1);
        set(triangle[2 * i + 1], p1, q1, q0);
#else
        // Your turn: two triangles for each side of the tube.
        set(triangle[2 * i], p0, p1, q1);
        set(triangle[2 * i + 1], p0, p1, q0);
#endif
    }
}

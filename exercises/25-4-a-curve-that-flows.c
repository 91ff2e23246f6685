/* Exercise 25.4.  Project: a curve that flows and keeps its area.
 *
 * A closed polygon in the plane, counterclockwise, is carried along by a flow.
 * After each step your function repairs it: in `position` it finds `count`
 * vertices, leaves others there, and returns how many.  There is room for 1000,
 * and it never needs that many.
 *
 * Afterward no edge may be longer than `most`, and at most one edge in ten may
 * be shorter than `most` / 4.  The polygon must enclose the same area as before,
 * up to a rounding error of 10^-9 of it.  No two edges may meet, except in the
 * vertex that they share.  Neither polygon, the old one or the new one, may be
 * farther than `most` / 2 from the other.
 *
 * There are many good answers.  The checks look only at what is listed above,
 * and decide exactly whether edges meet.  The last one lets a vortex stretch a
 * disk and turn back.  Once they pass, use flows of your own, and improve your
 * answer: put new vertices where the curve would be, not on the chord, and let
 * their neighbors restore the area.  How round is the disk afterward, and how
 * does the error depend on `most`?  Then let curves merge when they come near.
 *
 * Section: The second policy.
 *
 * Hint 1: Splitting an edge into equal parts changes neither the area nor what
 *     meets what.  Do that last.
 * Hint 2: To collapse the edge bc of a row a, b, c, d, put a vertex p between a
 *     and d where the triangle apd has the area of abcd.  Those positions are
 *     on a line parallel to ad.  Which is nearest to the middle of bc?
 * Hint 3: The edges ap and pd may meet others.  tf_edges_cross decides that for
 *     edges without a common vertex.  An edge that can't be collapsed stays.
 */
#include "surface/crossing.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum {
    ROOM = 1000
};

static double distance(const double a[2], const double b[2])
{
    return hypot(a[0] - b[0], a[1] - b[1]);
}

/// Splits each edge that is longer than `most` into equal parts.
static int split_all(int count, double most, double position[][2])
{
    double made[ROOM][2];
    int number = 0;
    for (int i = 0; i < count; i++) {
        const double *a = position[i], *b = position[(i + 1) % count];
#if defined TF_WRONG_1 // splits in two, however long it is
        int parts = distance(a, b) > most ? 2 : 1;
#else
        int parts = (int)ceil(distance(a, b) / most);
#endif
        for (int n = 0; n < parts && number < ROOM; n++, number++)
            for (int k = 0; k < 2; k++)
                made[number][k] = a[k] + (b[k] - a[k]) * n / parts;
    }
    memcpy(position, made, sizeof *made * (size_t)number);
    return number;
}

#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
/// Twice the area of the triangle.
static double area(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Finds p so that apd has the area of abcd; false if it is far away.
static bool find_position(double least, const double a[2], const double b[2],
                          const double c[2], const double d[2], double p[2])
{
    double length = distance(a, d);
    for (int k = 0; k < 2; k++)
        p[k] = (b[k] + c[k]) / 2;
    double rise = (area(a, b, c) + area(a, c, d) - area(a, p, d)) / length;
    p[0] += rise * (d[1] - a[1]) / length;
    p[1] -= rise * (d[0] - a[0]) / length;
    return fabs(rise) <= least / 2;
}

/// Whether ap and pd meet no edge but ab, bc, cd, of which b is number i.
static bool is_clear(int count, const double position[][2], int i,
                     const double p[2])
{
    const double *a = position[(i + count - 1) % count];
    const double *d = position[(i + 2) % count];
#if !defined TF_WRONG_2                   // does not look
    for (int n = 2; n < count - 1; n++) { // from d to a
        const double *from = position[(i + n) % count];
        const double *to = position[(i + n + 1) % count];
        if ((to != a && tf_edges_cross(a, p, from, to)) ||
            (from != d && tf_edges_cross(p, d, from, to)))
            return false;
    }
#endif
    return a != d && isfinite(p[0]);
}

/// Makes one vertex of the i-th and the next; whether it could.
static bool collapse(int count, double least, double position[][2], int i)
{
    double p[2], *b = position[i], *c = position[(i + 1) % count];
    if (count < 5 || distance(b, c) >= least ||
        !find_position(least, position[(i + count - 1) % count], b, c,
                       position[(i + 2) % count], p) ||
        !is_clear(count, (const double(*)[2])position, i, p))
        return false;
    memcpy(b, p, sizeof p);
    memmove(c, c + 2, (size_t)(position[count - 1] - c) * sizeof *c);
    return true;
}
#endif

int repair(int count, double most, double position[][2])
{
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    for (int i = 0; i < count;)
        if (collapse(count, most / 4, position, i)) {
            i -= i == count - 1; // the first one is gone
            count--;
        } else {
            i++;
        }
#elif defined TF_WRONG_3 // collapses into the middle
    for (int i = 0; i + 1 < count; i++)
        if (count > 4 && distance(position[i], position[i + 1]) < most / 4) {
            for (int k = 0; k < 2; k++)
                position[i][k] = (position[i][k] + position[i + 1][k]) / 2;
            count--;
            memmove(position[i + 1], position[i + 2],
                    (size_t)(count - i - 1) * sizeof *position);
        }
#else
    // Your turn: so far no edge is collapsed.
#endif
    return split_all(count, most, position);
}

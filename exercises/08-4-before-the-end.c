/* Exercise 8.4.  Before the end: a proof for two crossing edges.
 *
 * This is a proof, of the hard case of the lemma on time, for two edges in a
 * plane.  At t = 1 they cross, away from their ends.  Prove that they have
 * crossed before: find coordinates of a common point of S = {s | s1, s2} and
 * R = {r | r1, r2} at some time t < 1.
 *
 * The input is six places with integer coordinates from -20 to 20.  The edges
 * from s1 to s2 and from r1 to r2 cross in a single point, which is an end of
 * neither.  Return six integers, the coordinates of a common point times any
 * positive common factor.
 * They are a certificate that anyone can check; so a program that finds them
 * for every input, and a reason why it always does, make a proof.
 *
 * Section: Few events are enough.
 *
 * Hint 1: With coordinates 1 on s and on r, and k on the end events of either
 *     edge together, what is wanted is a common point of two edges that are
 *     shifted a little: s1 + s / k, and so on.
 * Hint 2: Write the point of one edge as s1 + (L / D) (s2 - s1) with
 *     D = det(s2 - s1, r1 - r2).  By Cramer's rule L is a determinant, and the
 *     shift adds a multiple of 1 / k to it.
 * Hint 3: D, L and D - L are integers that are not zero and have one sign.  So
 *     k times each of them is farther from zero than any number between -k
 *     and k.
 */
typedef struct place {
    long long x, y;
} place;

/// Homogeneous barycentric coordinates of a common point.
typedef struct common {
    long long s, s1, s2, r, r1, r2;
} common;

static place minus(place a, place b)
{
    return (place){a.x - b.x, a.y - b.y};
}

static long long det(place a, place b)
{
    return a.x * b.y - a.y * b.x;
}

common before_the_end(place s, place s1, place s2, place r, place r1, place r2)
{
    place u = minus(s2, s1), v = minus(r1, r2), w = minus(r1, s1);
    place shift = minus(r, s);
    // At t = 1 the coordinates are l / d on s2 and m / d on r2.
    long long d = det(u, v), l = det(w, v), m = det(u, w);
#if defined TF_SOLUTION
    long long dl = det(shift, v), dm = det(u, shift);
    if (d < 0) {
        d = -d, l = -l, m = -m, dl = -dl, dm = -dm;
    }
    long long k = 1 + (dl < 0 ? -dl : dl) + (dm < 0 ? -dm : dm);
    long long on_s2 = k * l + dl, on_r2 = k * m + dm;
    return (common){d, k * d - on_s2, on_s2, d, k * d - on_r2, on_r2};
#elif defined TF_WRONG_1 // goes back to t = 1/2, however far that is
    long long dl = det(shift, v), dm = det(u, shift);
    if (d < 0) {
        d = -d, l = -l, m = -m, dl = -dl, dm = -dm;
    }
    return (common){d, d - l - dl, l + dl, d, d - m - dm, m + dm};
#elif defined TF_WRONG_2 // forgets that d may be negative
    long long dl = det(shift, v), dm = det(u, shift);
    long long k = 1 + (dl < 0 ? -dl : dl) + (dm < 0 ? -dm : dm);
    long long on_s2 = k * l + dl, on_r2 = k * m + dm;
    return (common){d, k * d - on_s2, on_s2, d, k * d - on_r2, on_r2};
#elif defined TF_WRONG_3 // stays at t = 1
    long long sign = d < 0 ? -1 : 1 + 0 * shift.x;
    return (common){0, sign * (d - l), sign * l, 0, sign * (d - m), sign * m};
#elif defined TF_WRONG_4 // keeps the coordinates while the edges shift
    long long sign = d < 0 ? -1 : 1, one = sign * d + 0 * shift.x;
    return (common){one, sign * (d - l), sign * l,
                    one, sign * (d - m), sign * m};
#else
    // Your turn: this is a common point at t = 1, but for signs.
    return (common){0 * shift.x, d - l, l, 0, d - m, m};
#endif
}

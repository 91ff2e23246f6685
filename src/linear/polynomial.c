//: Include what polynomials need
#include "linear/polynomial.h"

#include <math.h>

//: Evaluate a polynomial
double tf_polynomial_value(const tf_polynomial *p, double t)
{
    const double *b = p->coefficient;
    double s = 1 - t;
    if (p->degree == 2)
        return b[0] * s * s + 2 * b[1] * s * t + b[2] * t * t;
    return s * s * (s * b[0] + 3 * t * b[1]) +
           t * t * (3 * s * b[2] + t * b[3]);
}

/// The derivative.
static double slope(const tf_polynomial *p, double t)
{
    const double *b = p->coefficient;
    double s = 1 - t;
    if (p->degree == 2)
        return 2 * ((b[1] - b[0]) * s + (b[2] - b[1]) * t);
    return 3 * ((b[1] - b[0]) * s * s + 2 * (b[2] - b[1]) * s * t +
                (b[3] - b[2]) * t * t);
}

//: Find where a line is zero
/// Adds the root strictly between 0 and 1 of b0 (1 - t) + b1 t.
static int add_root(double b0, double b1, int count, double root[])
{
    double t = b0 / (b0 - b1);
    if (t > 0 && t < 1)
        root[count++] = t;
    return count;
}

//: Find where a quadratic is zero
/// The roots strictly between 0 and 1 of b0 (1 - t)^2 + 2 b1 (1 - t) t + b2
/// t^2, in increasing order.
static int quadratic_roots(double b0, double b1, double b2, double root[2])
{
    double discriminant = b1 * b1 - b0 * b2;
    if (!(discriminant >= 0))
        return 0;
    // t / (1 - t) is q / b2 and b0 / q: no difference cancels.
    double q = -(b1 + copysign(sqrt(discriminant), b1));
    int count = add_root(q, -b2, 0, root);
    count = add_root(b0, -q, count, root);
    if (count == 2 && root[1] < root[0]) {
        double greater = root[0];
        root[0] = root[1];
        root[1] = greater;
    }
    return count;
}

//: Cut at the extrema
int tf_polynomial_cuts(const tf_polynomial *p, double cut[TF_MOST_CUTS])
{
    const double *b = p->coefficient;
    cut[0] = 0;
    int count = 1;
    if (p->degree == 2)
        count = add_root(b[1] - b[0], b[2] - b[1], count, cut);
    else
        count +=
            quadratic_roots(b[1] - b[0], b[2] - b[1], b[3] - b[2], cut + 1);
    cut[count++] = 1;
    return count;
}

//: Find the root of a monotone piece
double tf_polynomial_root(const tf_polynomial *p, double lo, double hi)
{
    double at_lo = tf_polynomial_value(p, lo);
    double at_hi = tf_polynomial_value(p, hi);
    double last = hi - lo, t = lo + last * (at_lo / (at_lo - at_hi));
    bool rises = at_lo < 0;
    while (lo < t && t < hi) {
        double value = tf_polynomial_value(p, t);
        if (value == 0)
            return t;
        if ((value < 0) == rises)
            lo = t;
        else
            hi = t;

        //: Take Newton's step if it is good
        double step = -value / slope(p, t), next = t + step;
        bool newton = next > lo && next < hi && fabs(step) < last / 2;
        last = newton ? fabs(step) : (hi - lo) / 2;
        t = newton ? next : lo + last;
        if (last <= 0x1p-52 * t)
            break;
    }
    return t;
}

//: Judge a polynomial by its coefficients
bool tf_polynomial_can_reach(const tf_polynomial *p, double reach)
{
    bool above = true, below = true;
    for (int i = 0; i <= p->degree; i++) {
        above = above && p->coefficient[i] > reach;
        below = below && p->coefficient[i] < -reach;
    }
    return !above && !below;
}

bool tf_polynomial_is_zero(const tf_polynomial *p)
{
    for (int i = 0; i <= p->degree; i++)
        if (p->coefficient[i] != 0)
            return false;
    return true;
}

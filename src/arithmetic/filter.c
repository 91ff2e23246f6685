//: Include what the filter needs
#include "arithmetic/filter.h"

#include <float.h>
#include <math.h>

//: State the error bounds
// In the rounded determinant every term picks up a factor 1 + e, |e| <= u, for
// each rounding it goes through.  In 3x3: three differences, a product, a
// difference of products, a product, a sum: seven.  In 2x2: two differences and
// a product: three.  The last addition is not counted: the rounded sum of two
// numbers has the sign of their sum.  A sum of terms that are each off by a
// factor within (1 + u)^k is off by at most ((1 + u)^k - 1) times the sum of
// their absolute values, the permanent, which is itself computed with at most
// eight roundings; the extra 2^-40 covers that and the second-order terms.
#define U (DBL_EPSILON / 2)
#define SHARE_3X3 ((7 + 0x1p-40) * U)
#define SHARE_2X2 ((3 + 0x1p-40) * U)

// A product that falls below the normal numbers loses at most 2^-1075 besides.
// In 3x3 two such losses are multiplied by each entry of the first row and
// three are not; the rest is room for the roundings of the bound.
#define UNDERFLOW 0x1p-1071

//: Recognize a certain zero
/// Whether every term of the determinant has a factor that is exactly zero.
/// If so, the determinant is exactly zero.  A computed number that is zero
/// proves nothing: rounding or underflow may have made it.
static bool every_term_vanishes(const tf_differences *differences)
{
    static const int order[6][3] = {{0, 1, 2}, {1, 0, 2}, {0, 2, 1},
                                    {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    double entry[TF_AXES][TF_AXES];
    tf_differences_round(differences, entry);
    int n = differences->n;
    for (int p = 0; p < (n == 3 ? 6 : n); p++) {
        int nonzero = 0;
        for (int i = 0; i < n; i++)
            nonzero += entry[i][order[p][i]] != 0;
        if (nonzero == n)
            return false;
    }
    return true;
}

//: Estimate a 1x1 determinant
static tf_estimate estimate_1x1(const tf_differences *differences)
{
    double e[TF_AXES][TF_AXES];
    tf_differences_round(differences, e);

    // The difference of two doubles has the sign of the rounded difference.
    return (tf_estimate){.number = e[0][0], .bound = 0};
}

//: Estimate a 2x2 determinant
static tf_estimate estimate_2x2(const tf_differences *differences)
{
    double e[TF_AXES][TF_AXES];
    tf_differences_round(differences, e);
    double down = e[0][0] * e[1][1];
    double up = e[0][1] * e[1][0];
    double permanent = fabs(down) + fabs(up);
    return (tf_estimate){.number = down - up,
                         .bound = SHARE_2X2 * permanent + UNDERFLOW};
}

//: Estimate a 3x3 determinant
static tf_estimate estimate_3x3(const tf_differences *differences)
{
    double e[TF_AXES][TF_AXES];
    tf_differences_round(differences, e);

    //: Multiply the last two rows
    double yz = e[1][1] * e[2][2], zy = e[1][2] * e[2][1];
    double zx = e[1][2] * e[2][0], xz = e[1][0] * e[2][2];
    double xy = e[1][0] * e[2][1], yx = e[1][1] * e[2][0];

    //: Expand along the first row
    double ax = fabs(e[0][0]), ay = fabs(e[0][1]), az = fabs(e[0][2]);
    double number =
        e[0][0] * (yz - zy) + e[0][1] * (zx - xz) + e[0][2] * (xy - yx);
    double permanent = ax * (fabs(yz) + fabs(zy)) + ay * (fabs(zx) + fabs(xz)) +
                       az * (fabs(xy) + fabs(yx));

    //: Add what underflow can lose, where it counts
    // Some processors take over a hundred cycles to multiply by a subnormal
    // number.  Where the permanent is larger than this test allows, the product
    // would be less than 2^-58 of the bound and round away.
    double row = ax + ay + az + 1, bound = SHARE_3X3 * permanent;
    if (!(permanent * 0x1p961 > row))
        bound += UNDERFLOW * row;
    return (tf_estimate){.number = number, .bound = bound};
}

//: Estimate a determinant
tf_estimate tf_differences_estimate(const tf_differences *differences)
{
    int n = differences->n;
    tf_estimate estimate = n == 3   ? estimate_3x3(differences)
                           : n == 2 ? estimate_2x2(differences)
                                    : estimate_1x1(differences);
    if (estimate.number == 0 && every_term_vanishes(differences))
        estimate.bound = 0;
    return estimate;
}

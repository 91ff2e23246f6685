//: Include what exact signs need
#include "arithmetic/exact.h"

#include "arithmetic/accumulator.h"
#include "arithmetic/clamped.h"
#include "arithmetic/two_sum.h"

#include <math.h>

//: Hold the split differences
/// The entries of a determinant, each the exact sum of two doubles.
typedef struct split_entries {
    int n;
    double head[TF_AXES][TF_AXES], tail[TF_AXES][TF_AXES];
} split_entries;

//: Split a difference
static tf_two split_difference(double to, double from)
{
    tf_two difference = tf_two_difference(to, from);

    // Where the rounded difference overflows, or comes near, the two
    // coordinates themselves are its parts.
    if (fabs(difference.hi) < 0x1p1022)
        return difference;
    return (tf_two){.hi = to, .lo = -from};
}

//: Split all differences
static split_entries split(const tf_differences *d)
{
    split_entries entries = {.n = d->n};
    for (int i = 0; i < d->n; i++)
        for (int j = 0; j < d->n; j++) {
            int k = d->axis[j];
            tf_two entry = split_difference(d->to[i]->x[k], d->from[i]->x[k]);
            entries.head[i][j] = entry.hi;
            entries.tail[i][j] = entry.lo;
        }
    return entries;
}

//: Accumulate the terms of the determinant
/// Add the products of one term of the determinant, a permutation of the
/// columns: as many as its entries have combinations of parts.
static void accumulate_term(tf_accumulator *sum, const split_entries *e,
                            const int column[TF_AXES], double sign)
{
    double part[TF_AXES][2] = {{1, 0}, {1, 0}, {1, 0}};
    for (int i = 0; i < e->n; i++) {
        part[i][0] = e->head[i][column[i]];
        part[i][1] = e->tail[i][column[i]];
    }
    for (int mask = 0; mask < 8; mask++) {
        double a = part[0][mask & 1], b = part[1][mask >> 1 & 1];
        double c = part[2][mask >> 2];
        if (a != 0 && b != 0 && c != 0)
            tf_accumulator_add(sum, sign * a, b, c);
    }
}

//: Accumulate all terms
static void accumulate(const split_entries *entries, tf_accumulator *sum)
{
    static const int column[6][TF_AXES] = {{0, 1, 2}, {1, 0, 2}, {1, 2, 0},
                                           {0, 2, 1}, {2, 0, 1}, {2, 1, 0}};
    static const int terms[TF_AXES + 1] = {0, 1, 2, 6};
    tf_accumulator_clear(sum);
    for (int p = 0; p < terms[entries->n]; p++)
        accumulate_term(sum, entries, column[p], p % 2 == 0 ? 1 : -1);
}

//: Find an exact sign
tf_sign tf_exact_sign(const tf_differences *differences, tf_stage *stage)
{
    //: Try the estimate
    *stage = TF_BY_ESTIMATE;
    tf_estimate estimate = tf_differences_estimate(differences);
    if (fabs(estimate.number) > estimate.bound)
        return estimate.number > 0 ? TF_POSITIVE : TF_NEGATIVE;
    if (estimate.bound == 0)
        return TF_ZERO;

    //: Accumulate all products
    *stage = TF_BY_ACCUMULATOR;
    split_entries entries = split(differences);
    tf_accumulator sum;
    accumulate(&entries, &sum);
    return tf_accumulator_sign(&sum);
}

//: Find an exact value
static tf_value exact_value(const tf_differences *differences)
{
    split_entries entries = split(differences);
    tf_accumulator sum;
    accumulate(&entries, &sum);
    return tf_accumulator_value(&sum);
}

//: Name the exact arithmetic
static tf_sign exact_sign(const tf_differences *differences)
{
    tf_stage stage;
    return tf_exact_sign(differences, &stage);
}

const tf_arithmetic tf_exact = {
    .name = "exact", .sign = exact_sign, .value = exact_value};

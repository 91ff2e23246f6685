//: Include what accumulated determinants need
#include "arithmetic/accumulated.h"

#include "arithmetic/superaccumulator.h"
#include "arithmetic/two_sum.h"

#include <math.h>

//: Hold the split differences
/// The exact entry of a determinant: the sum of `count` parts, at most two.
/// Parts that are zero are left out, except where the difference comes near
/// overflow.
typedef struct split_entry {
    int count;
    double part[2];
} split_entry;

typedef struct split_entries {
    int n;
    split_entry entry[TF_AXES][TF_AXES];
} split_entries;

//: Split a difference
static split_entry split_difference(double to, double from)
{
    tf_two difference = tf_two_difference(to, from);

    // Where the rounded difference overflows, or comes near, the two
    // coordinates themselves are its parts.
    if (fabs(difference.hi) >= 0x1p1022)
        return (split_entry){.count = 2, .part = {to, -from}};
    return (split_entry){.count = (difference.hi != 0) + (difference.lo != 0),
                         .part = {difference.hi, difference.lo}};
}

//: Split all differences
static split_entries split(const tf_differences *d)
{
    split_entries entries;
    entries.n = d->n;
    for (int i = 0; i < d->n; i++)
        for (int j = 0; j < d->n; j++) {
            int k = d->axis[j];
            entries.entry[i][j] =
                split_difference(d->to[i]->x[k], d->from[i]->x[k]);
        }
    return entries;
}

//: Accumulate the terms of the determinant
/// Adds one term of the determinant, a permutation of the columns: a product
/// for each choice of one part from each entry.
static void accumulate_term(tf_superaccumulator *sum, const split_entries *e,
                            const int column[TF_AXES], double sign)
{
    static const split_entry one = {.count = 1, .part = {1}};
    const split_entry *a = &e->entry[0][column[0]];
    const split_entry *b = e->n > 1 ? &e->entry[1][column[1]] : &one;
    const split_entry *c = e->n > 2 ? &e->entry[2][column[2]] : &one;
    for (int i = 0; i < a->count; i++)
        for (int j = 0; j < b->count; j++)
            for (int k = 0; k < c->count; k++)
                tf_superaccumulator_add(sum, sign * a->part[i], b->part[j],
                                        c->part[k]);
}

//: Accumulate all terms
static void accumulate(const tf_differences *differences,
                       tf_superaccumulator *sum)
{
    static const int column[6][TF_AXES] = {{0, 1, 2}, {1, 0, 2}, {1, 2, 0},
                                           {0, 2, 1}, {2, 0, 1}, {2, 1, 0}};
    static const int terms[TF_AXES + 1] = {0, 1, 2, 6};
    split_entries entries = split(differences);
    tf_superaccumulator_clear(sum);
    for (int p = 0; p < terms[entries.n]; p++)
        accumulate_term(sum, &entries, column[p], p % 2 == 0 ? 1 : -1);
}

//: Find the sign and the value of a sum
tf_sign tf_accumulated_sign(const tf_differences *differences)
{
    tf_superaccumulator sum;
    accumulate(differences, &sum);
    return tf_superaccumulator_sign(&sum);
}

tf_value tf_accumulated_value(const tf_differences *differences)
{
    tf_superaccumulator sum;
    accumulate(differences, &sum);
    return tf_superaccumulator_value(&sum);
}

#include "support/rational.h"

#include "arithmetic/functions.h"
#include "support/dyadic.h"

#include <gmp.h>
#include <limits.h>
#include <math.h>
#include <stdint.h>

/// A determinant of differences: a matrix of integers, times 2^exponent.
typedef struct scaled_matrix {
    int n, exponent;
    mpz_t entry[TF_AXES][TF_AXES];
} scaled_matrix;

static void set_entry(mpz_t entry, double to, double from, int exponent)
{
    mpz_t subtrahend;
    mpz_init(subtrahend);
    dyadic_scale(entry, to, exponent);
    dyadic_scale(subtrahend, from, exponent);
    mpz_sub(entry, entry, subtrahend);
    mpz_clear(subtrahend);
}

static void set_column(scaled_matrix *matrix, const tf_differences *d, int j)
{
    int axis = d->axis[j], exponent = INT_MAX;
    for (int i = 0; i < d->n; i++) {
        exponent = dyadic_least(exponent, d->to[i]->x[axis]);
        exponent = dyadic_least(exponent, d->from[i]->x[axis]);
    }
    if (exponent == INT_MAX)
        exponent = 0; // a column of zeros
    for (int i = 0; i < d->n; i++)
        set_entry(matrix->entry[i][j], d->to[i]->x[axis], d->from[i]->x[axis],
                  exponent);
    matrix->exponent += exponent;
}

/// Add to `sum` the cofactor expansion of the rows from `row` on, on the
/// columns that `used` leaves, times `factor`.
static void add_minor(mpz_t sum, const scaled_matrix *matrix, int row,
                      unsigned used, const mpz_t factor)
{
    if (row == matrix->n || row == TF_AXES) {
        mpz_add(sum, sum, factor);
        return;
    }
    mpz_t term;
    mpz_init(term);
    bool odd = false;
    for (int j = 0; j < matrix->n; j++) {
        if (used & 1U << j)
            continue;
        mpz_mul(term, factor, matrix->entry[row][j]);
        if (odd)
            mpz_neg(term, term);
        add_minor(sum, matrix, row + 1, used | 1U << j, term);
        odd = !odd;
    }
    mpz_clear(term);
}

int rational_determinant(mpz_t determinant, const tf_differences *d)
{
    scaled_matrix matrix = {.n = d->n};
    for (int k = 0; k < d->n * d->n; k++)
        mpz_init(matrix.entry[k / d->n][k % d->n]);
    for (int j = 0; j < d->n; j++)
        set_column(&matrix, d, j);

    mpz_t one;
    mpz_init_set_ui(one, 1);
    mpz_set_ui(determinant, 0);
    add_minor(determinant, &matrix, 0, 0, one);

    mpz_clear(one);
    for (int k = 0; k < d->n * d->n; k++)
        mpz_clear(matrix.entry[k / d->n][k % d->n]);
    return matrix.exponent;
}

static tf_sign rational_sign(const tf_differences *differences)
{
    mpz_t determinant;
    mpz_init(determinant);
    rational_determinant(determinant, differences);
    int sign = mpz_sgn(determinant);
    mpz_clear(determinant);
    return sign > 0 ? TF_POSITIVE : sign < 0 ? TF_NEGATIVE : TF_ZERO;
}

/// Round to nearest: integer * 2^exponent.  Rounds `integer` down in place.
static tf_value rounded(mpz_t integer, int exponent)
{
    // Keep 62 bits, of which the last also tells whether a lower one was set:
    // the conversion to double then rounds once, and rightly.
    int excess = (int)mpz_sizeinbase(integer, 2) - 62;
    int sticky = 0;
    if (excess > 0) {
        mp_bitcnt_t bits = (mp_bitcnt_t)excess;
        sticky = mpz_divisible_2exp_p(integer, bits) ? 0 : mpz_sgn(integer);
        mpz_tdiv_q_2exp(integer, integer, bits);
        exponent += excess;
    }
    int64_t kept = mpz_get_si(integer);
    kept += kept % 2 == 0 ? sticky : 0;
    return (tf_value){.number = (double)kept, .exponent = exponent};
}

bool rational_is(const mpz_t integer, int exponent, tf_value value)
{
    mpz_t copy;
    mpz_init_set(copy, integer);
    tf_value truth = rounded(copy, exponent);
    mpz_clear(copy);

    // One number can come with two exponents: both made 0.5 to 1.
    int shift, truth_shift;
    double fraction = frexp(value.number, &shift);
    double truth_fraction = frexp(truth.number, &truth_shift);
    return value.radius == 0 && fraction == truth_fraction &&
           (fraction == 0 ||
            value.exponent + shift == truth.exponent + truth_shift);
}

static tf_value rational_value(const tf_differences *differences)
{
    mpz_t determinant;
    mpz_init(determinant);
    int exponent = rational_determinant(determinant, differences);
    tf_value value = rounded(determinant, exponent);
    mpz_clear(determinant);
    return value;
}

const tf_arithmetic oracle_arithmetic = {
    .name = "rational",
    .sign = rational_sign,
    .value = rational_value,
};

// What is true of a determinant, and what the rounded arithmetic makes of it.
#ifndef SUPPORT_ESTIMATES_H
#define SUPPORT_ESTIMATES_H

#include "arithmetic/filter.h"
#include "arithmetic/sign.h"
#include "support/matrices.h"

#include <gmp.h>

typedef struct judged_estimate {
    tf_estimate estimate;
    tf_value value; ///< tf_clamped's
    mpz_t truth;    ///< the determinant, as support/sums.h
    mpz_t error;    ///< of the number, absolute; where it is finite
} judged_estimate;

void judged_estimate_init(judged_estimate *j, const matrix *m);
void judged_estimate_clear(judged_estimate *j);

/// The last place of a double.
double last_place(double x);

/// Whether the bound that decides the sign covers all but the last addition.
bool bound_is_kept(const judged_estimate *j);

/// Whether the value's radius covers all but a last rounding.
bool radius_is_kept(const judged_estimate *j);

/// Whether a sign that the estimate decides, zero included, is the true one.
bool estimate_is_true(const judged_estimate *j);

/// A matrix close to singular, scaled so that some products of entries are
/// about 2^exponent.
matrix matrix_close(generator *random, int n, int exponent);

/// What decides signs by an estimate.
typedef struct estimate_test {
    void (*judge)(const matrix *m); ///< expects that all it says is true
    bool (*decides)(const matrix *m);
} estimate_test;

/// What to try; called by the function that is given to estimates_add().
void estimates_use(const estimate_test *test);

/// Adds the tests of which signs are decided; `use` calls estimates_use().
void estimates_add(Suite *suite, void (*use)(void));

#endif

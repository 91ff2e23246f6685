#include "support/estimates.h"

#include "arithmetic/clamped.h"
#include "arithmetic/functions.h"
#include "support/sums.h"

#include <float.h>
#include <math.h>

void judged_estimate_init(judged_estimate *j, const matrix *m)
{
    tf_differences differences = matrix_differences(m);
    j->estimate = tf_differences_estimate(&differences);
    j->value = tf_clamped.value(&differences);
    mpz_inits(j->truth, j->error, NULL);
    sum_determinant(j->truth, &differences);
    if (isfinite(j->estimate.number)) {
        mpz_set(j->error, j->truth);
        sum_add(j->error, -1, j->estimate.number, 1);
        mpz_abs(j->error, j->error);
    }
}

void judged_estimate_clear(judged_estimate *j)
{
    mpz_clears(j->truth, j->error, NULL);
}

/// Whether the error is at most a + b c.
static bool error_within(const judged_estimate *j, double a, double b, double c)
{
    mpz_t bound;
    mpz_init(bound);
    sum_add(bound, a, 1, 1);
    sum_add(bound, b, c, 1);
    bool within = mpz_cmp(j->error, bound) <= 0;
    mpz_clear(bound);
    return within;
}

double last_place(double x)
{
    return x == 0 ? 0 : fmax(ldexp(1, ilogb(x) - 52), DBL_TRUE_MIN);
}

bool bound_is_kept(const judged_estimate *j)
{
    tf_estimate e = j->estimate;
    return !isfinite(e.number) || !isfinite(e.bound) ||
           error_within(j, e.bound, last_place(e.number), 0.5);
}

bool radius_is_kept(const judged_estimate *j)
{
    tf_value v = j->value;
    return !isfinite(v.number) || !isfinite(v.radius) ||
           error_within(j, v.radius, fabs(v.number), DBL_EPSILON / 2);
}

bool estimate_is_true(const judged_estimate *j)
{
    tf_estimate e = j->estimate;
    tf_sign sign = sum_sign(j->truth);
    if (e.number > e.bound)
        return sign == TF_POSITIVE;
    if (-e.number > e.bound)
        return sign == TF_NEGATIVE;
    return e.number != 0 || e.bound != 0 || sign == TF_ZERO;
}

matrix matrix_close(generator *random, int n, int exponent)
{
    matrix m =
        below(random, 2) ? matrix_flat(random, n) : matrix_singular(random, n);
    int factors = n == 3 ? 2 + below(random, 2) : n;
    for (int j = 0; j < n; j++) {
        int own = exponent / factors + below(random, 40) - 20;
        // With two factors, the third column is as large or small as it likes.
        matrix_scale(&m, j, j < factors ? own : below(random, 1800) - 900);
    }
    matrix_nudge(random, &m, below(random, 3));
    return m;
}

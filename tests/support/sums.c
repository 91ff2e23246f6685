#include "support/sums.h"

#include "support/dyadic.h"
#include "support/rational.h"

/// product = product * a / 2^(the result).
static int multiply(mpz_t product, double a)
{
    mpz_t factor;
    mpz_init(factor);
    int exponent = dyadic_exponent(a);
    dyadic_scale(factor, a, exponent);
    mpz_mul(product, product, factor);
    mpz_clear(factor);
    return exponent;
}

void sum_add(mpz_t sum, double a, double b, double c)
{
    if (a == 0 || b == 0 || c == 0)
        return;
    mpz_t product;
    mpz_init_set_si(product, 1);
    int exponent = multiply(product, a);
    exponent += multiply(product, b);
    exponent += multiply(product, c);
    mpz_mul_2exp(product, product, (mp_bitcnt_t)(exponent - SUM_EXPONENT));
    mpz_add(sum, sum, product);
    mpz_clear(product);
}

void sum_determinant(mpz_t sum, const tf_differences *differences)
{
    int exponent = rational_determinant(sum, differences);
    mpz_mul_2exp(sum, sum, (mp_bitcnt_t)(exponent - SUM_EXPONENT));
}

bool sum_is(const mpz_t sum, double hi, double lo)
{
    mpz_t rest;
    mpz_init_set(rest, sum);
    sum_add(rest, -hi, 1, 1);
    sum_add(rest, -lo, 1, 1);
    bool complete = mpz_sgn(rest) == 0;
    mpz_clear(rest);
    return complete && rational_is(sum, SUM_EXPONENT, (tf_value){.number = hi});
}

tf_sign sum_sign(const mpz_t sum)
{
    int sign = mpz_sgn(sum);
    return sign > 0 ? TF_POSITIVE : sign < 0 ? TF_NEGATIVE : TF_ZERO;
}

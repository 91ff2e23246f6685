#include "support/dyadic.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>

/// x = mantissa * 2^*exponent.
static int64_t mantissa_of(double x, int *exponent)
{
    double fraction = frexp(x, exponent);
    *exponent -= 53;
    return (int64_t)(fraction * 0x1p53);
}

int dyadic_exponent(double x)
{
    int exponent;
    int64_t mantissa = mantissa_of(x, &exponent);
    if (mantissa == 0)
        return INT_MAX;
    return exponent + ilogb((double)(mantissa & -mantissa));
}

int dyadic_least(int least, double x)
{
    int exponent = dyadic_exponent(x);
    return exponent < least ? exponent : least;
}

void dyadic_scale(mpz_t scaled, double x, int exponent)
{
    int own;
    mpz_set_si(scaled, mantissa_of(x, &own));
    if (x == 0)
        return;
    if (own >= exponent)
        mpz_mul_2exp(scaled, scaled, (mp_bitcnt_t)(own - exponent));
    else
        mpz_tdiv_q_2exp(scaled, scaled, (mp_bitcnt_t)(exponent - own));
}

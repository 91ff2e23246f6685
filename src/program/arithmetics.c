//: Include what the names of arithmetics need
#include "program/arithmetics.h"

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "arithmetic/perturbed.h"
#include "arithmetic/published.h"

#include <math.h>
#include <stddef.h>

//: Name the arithmetics
const tf_choice tf_arithmetics[] = {
    {"exact", &tf_exact},
    {"clamped", &tf_clamped},
    {"report", &tf_published},
    {"perturbed", &tf_perturbed},
    {"integer64", &tf_integer64},
    {"integer128", &tf_integer128},
    {NULL, NULL},
};

//: Compare a coordinate with the range of an arithmetic
bool tf_arithmetic_fits(const tf_arithmetic *arithmetic, int axes, double x)
{
    int bits = tf_arithmetic_bits(arithmetic, axes);
    return bits == 0 || (fabs(x) < ldexp(1, bits) && x == trunc(x));
}

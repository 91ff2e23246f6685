//: Include what the names of arithmetics need
#include "program/arithmetics.h"

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "arithmetic/perturbed.h"

#include <math.h>
#include <string.h>

//: Find an arithmetic by its name
static const tf_arithmetic *const arithmetics[] = {
    &tf_exact,     &tf_clamped,   &tf_published,
    &tf_perturbed, &tf_integer64, &tf_integer128,
};

const tf_arithmetic *tf_arithmetic_named(const char *name)
{
    for (size_t i = 0; i < sizeof arithmetics / sizeof *arithmetics; i++)
        if (strcmp(name, tf_arithmetic_name(arithmetics[i])) == 0)
            return arithmetics[i];
    return NULL;
}

//: Compare a coordinate with the range of an arithmetic
bool tf_arithmetic_fits(const tf_arithmetic *arithmetic, int axes, double x)
{
    int bits = tf_arithmetic_bits(arithmetic, axes);
    return bits == 0 || (fabs(x) < ldexp(1, bits) && x == trunc(x));
}

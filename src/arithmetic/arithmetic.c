//: Include what arithmetics need
#include "arithmetic/operations.h"

#include "base/require.h"

#include <math.h>

//: Describe an arithmetic
const char *tf_arithmetic_name(const tf_arithmetic *arithmetic)
{
    TF_REQUIRE(arithmetic);
    return arithmetic->name;
}

int tf_arithmetic_bits(const tf_arithmetic *arithmetic, int axes)
{
    TF_REQUIRE(arithmetic && (axes == 2 || axes == 3));
    return arithmetic->bits[axes];
}

//: Test whether an arithmetic holds a coordinate
bool tf_arithmetic_holds(const tf_arithmetic *arithmetic, int axes, double x)
{
    int bits = arithmetic->bits[axes];
    if (bits == 0)
        return isfinite(x);
    return fabs(x) < ldexp(1, bits) && x == trunc(x);
}

//: Include what arithmetics need
#include "arithmetic/arithmetic.h"

#include "arithmetic/functions.h"
#include "base/require.h"

//: Describe an arithmetic
const char *tf_arithmetic_name(const tf_arithmetic *arithmetic)
{
    TF_REQUIRE(arithmetic);
    return arithmetic->name;
}

int tf_arithmetic_bits(const tf_arithmetic *arithmetic, int axes)
{
    TF_REQUIRE(arithmetic);
    return axes == 2 || axes == 3 ? arithmetic->bits[axes] : -1;
}

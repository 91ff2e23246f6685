//: Read and make doubles bit by bit
#pragma once

#include <stdint.h>
#include <string.h>

/// The sign, 11 bits of the exponent and 52 of the mantissa.
static inline uint64_t tf_bits_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/// The exponent plus 1023; 0 for zero and subnormal numbers, 2047 for infinity
/// and NaN.
static inline int tf_biased_exponent(double x)
{
    return (int)(tf_bits_of(x) >> 52 & 2047);
}

/// 2^exponent, for an exponent from -1022 to 1023.
static inline double tf_power_of_two(int exponent)
{
    uint64_t bits = (uint64_t)(exponent + 1023) << 52;
    double power;
    memcpy(&power, &bits, sizeof power);
    return power;
}

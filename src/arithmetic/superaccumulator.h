//: Declare the superaccumulator
#pragma once

#include "arithmetic/sign.h"

// A product of three finite doubles is a multiple of (2^-1074)^3 = 2^-3222 and
// below (2^1024)^3 = 2^3072, and the sum of the 48 that a determinant can have
// stays below 2^3078: 6300 bits.
enum {
    TF_SUPERACCUMULATOR_WORDS = 99
};

/// A superaccumulator after Kulisch: a sum of products of three doubles, exact
/// whatever they are.  It holds two fixed-point numbers, the sums of the
/// negative and of the positive products, in units of 2^-3222, least
/// significant word first.  Only the words first..end-1 are set; the others
/// count as zero.
typedef struct tf_superaccumulator {
    int first, end;
    uint64_t sum[2][TF_SUPERACCUMULATOR_WORDS];
} tf_superaccumulator;

//: Declare what a superaccumulator does
void tf_superaccumulator_clear(tf_superaccumulator *accumulator);

/// Adds a b c, finite factors; at most 48 products before the next clearing.
void tf_superaccumulator_add(tf_superaccumulator *accumulator, double a,
                             double b, double c);

/// The sign of the sum.
tf_sign tf_superaccumulator_sign(const tf_superaccumulator *accumulator);

/// The sum, rounded to nearest once.
tf_value tf_superaccumulator_value(const tf_superaccumulator *accumulator);

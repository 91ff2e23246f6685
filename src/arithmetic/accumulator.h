//: Declare the accumulator
#ifndef TF_ARITHMETIC_ACCUMULATOR_H
#define TF_ARITHMETIC_ACCUMULATOR_H

#include "arithmetic/differences.h"

#include <stdint.h>

// A product of three finite doubles is a multiple of (2^-1074)^3 = 2^-3222 and
// below (2^1024)^3 = 2^3072, and the sum of the 48 that a determinant can have
// stays below 2^3078: 6300 bits.
enum {
    TF_ACCUMULATOR_WORDS = 99
};

/// A sum of products of three doubles, exact whatever they are: two
/// fixed-point numbers, the sums of the negative and of the positive products,
/// in units of 2^-3222, least significant word first.  Only the words
/// first..end-1 are set; the others count as zero.
typedef struct tf_accumulator {
    int first, end;
    uint64_t sum[2][TF_ACCUMULATOR_WORDS];
} tf_accumulator;

//: Declare what an accumulator does
void tf_accumulator_clear(tf_accumulator *accumulator);

/// Add a b c, finite factors; at most 48 products before the next clearing.
void tf_accumulator_add(tf_accumulator *accumulator, double a, double b,
                        double c);

/// The sign of the sum.
tf_sign tf_accumulator_sign(const tf_accumulator *accumulator);

/// The sum, rounded to nearest once.
tf_value tf_accumulator_value(const tf_accumulator *accumulator);

//: Close the accumulator
#endif

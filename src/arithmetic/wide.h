//: Declare wide integers
#pragma once

#include "arithmetic/sign.h"

#include <stdint.h>

// In units of 2^-1074 a difference of two finite doubles has at most 2099 bits.
// What distances are compared by has degree six in these, and is a sum of few
// such products: below 2^12700.
enum {
    TF_WIDE_WORDS = 200
};

/// An integer of any size up to that: a sign and a magnitude, least significant
/// word first, of which the words from `count` on are not set.  The top word is
/// not zero.
typedef struct tf_wide {
    tf_sign sign;
    int count;
    uint64_t word[TF_WIDE_WORDS];
} tf_wide;

//: Declare how wide integers are made
/// The exponent of the lowest bit of a finite double that is set; INT_MAX for
/// zero.
int tf_lowest_bit(double x);

/// Sets a wide integer to x 2^-unit, where x is a multiple of 2^unit.
void tf_wide_set(double x, int unit, tf_wide *to);

//: Declare what wide integers do
/// Results may overwrite operands, except for products.
void tf_wide_add(const tf_wide *a, const tf_wide *b, tf_wide *sum);
void tf_wide_subtract(const tf_wide *a, const tf_wide *b, tf_wide *difference);
void tf_wide_multiply(const tf_wide *a, const tf_wide *b, tf_wide *product);

/// The sign of a - b.
tf_sign tf_wide_compare(const tf_wide *a, const tf_wide *b);

/// A wide integer, rounded to nearest: the number returned times 2^*exponent.
double tf_wide_round(const tf_wide *a, int *exponent);

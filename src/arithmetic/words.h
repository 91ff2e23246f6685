//: Declare the rounding of words
#pragma once

#include <stdbool.h>
#include <stdint.h>

enum {
    TF_WORD_BITS = 64
};

/// The integer of `count` words, not zero, least significant word first,
/// rounded to nearest, ties to even: the number returned times 2^*exponent, to
/// which the exponent of the unit is still to be added.
double tf_words_round(const uint64_t word[], int count, int *exponent);

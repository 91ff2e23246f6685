//: Declare the rounding of words
#pragma once

#include "arithmetic/operations.h"

enum {
    TF_WORD_BITS = 64
};

/// Rounds the integer of `count` words, not zero, least significant word first,
/// to nearest, ties to even; its unit is 2^unit.
tf_value tf_words_round(const uint64_t word[], int count, int unit);

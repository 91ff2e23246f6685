//: Declare the rounding of words
#pragma once

#include <stdbool.h>
#include <stdint.h>

enum {
    TF_WORD_BITS = 64
};

//: Round to a double
/// The integer of `count` words, not zero, least significant word first,
/// rounded to nearest, ties to even: the number returned times 2^*exponent, to
/// which the exponent of the unit is still to be added.  Inline, because its
/// loops vanish where `count` is a constant.
static inline double tf_words_round(const uint64_t word[], int count,
                                    int *exponent)
{
    int top = count - 1;
    while (word[top] == 0)
        top--;

    //: Take the 64 leading bits
    int empty = __builtin_clzll(word[top]);
    uint64_t next = top > 0 ? word[top - 1] : 0;
    uint64_t leading = word[top] << empty | next >> 1 >> (63 - empty);

    //: Round the leading bits
    // The 11 bits that the conversion rounds away must not look like a tie if
    // anything follows.
    bool follows = (next << empty) != 0;
    for (int i = 0; i < top - 1 && !follows; i++)
        follows = word[i] != 0;
    *exponent = top * TF_WORD_BITS - empty;
    return (double)(leading | follows);
}

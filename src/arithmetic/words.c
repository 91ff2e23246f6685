//: Round to a double
#include "arithmetic/words.h"

double tf_words_round(const uint64_t word[], int count, int *exponent)
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

/* Exercise 11.3.  Round once: from 192 bits to a double.
 *
 * A number of 192 bits is given as three words of 64 bits, the least
 * significant first.  Return the double that is nearest to it, and of two that
 * are equally near the one with the even mantissa.  You may rely on this: the
 * conversion of one uint64_t to double rounds in just that way.
 *
 * Section: The value, rounded once.
 *
 * Hint 1: (double)word[2] * 2^128 + (double)word[1] * 2^64 + (double)word[0]
 *     rounds up to five times.  A number that is slightly more than halfway
 *     between two doubles may be rounded to halfway first, and then down.
 * Hint 2: Only the 64 bits from the highest one bit downward need to be
 *     converted.  Combine them from two words by shifting, and watch out for
 *     shifts by 64, which C does not define.
 * Hint 3: The conversion drops 11 of these 64 bits.  If they are a one and ten
 *     zeros it sees a tie; but if any bit below the 64 is set, there is no tie.
 *     In that case set the lowest of the 64 bits.
 */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>

double round_once(const uint64_t word[3])
{
#if defined TF_SOLUTION
    int top = 2;
    while (top > 0 && word[top] == 0)
        top--;
    if (word[top] == 0)
        return 0;
    int empty = __builtin_clzll(word[top]);
    uint64_t next = top > 0 ? word[top - 1] : 0;
    uint64_t leading = word[top] << empty | next >> 1 >> (63 - empty);
    bool follows = (next << empty) != 0 || (top == 2 && word[0] != 0);
    return ldexp((double)(leading | follows), 64 * top - empty);
#elif defined TF_WRONG_1 // rounds each word
    return ldexp((double)word[2], 128) + ldexp((double)word[1], 64) +
           (double)word[0];
#elif defined TF_WRONG_2 // ignores what is below the 64 leading bits
    int top = 2;
    while (top > 0 && word[top] == 0)
        top--;
    if (word[top] == 0)
        return 0;
    int empty = __builtin_clzll(word[top]);
    uint64_t next = top > 0 ? word[top - 1] : 0;
    uint64_t leading = word[top] << empty | next >> 1 >> (63 - empty);
    return ldexp((double)leading, 64 * top - empty);
#elif defined TF_WRONG_3 // checks the next word, but not the one after it
    int top = 2;
    while (top > 0 && word[top] == 0)
        top--;
    if (word[top] == 0)
        return 0;
    int empty = __builtin_clzll(word[top]);
    uint64_t next = top > 0 ? word[top - 1] : 0;
    uint64_t leading = word[top] << empty | next >> 1 >> (63 - empty);
    return ldexp((double)(leading | ((next << empty) != 0)), 64 * top - empty);
#elif defined TF_WRONG_4 // truncates what does not fit
    double sum = 0;
    for (int i = 0, kept = 0; i < 192 && kept < 53; i++) {
        int bit = 191 - i;
        bool set = word[bit / 64] >> bit % 64 & 1;
        sum += set ? ldexp(1, bit) : 0;
        kept += kept > 0 || set;
    }
    return sum;
#else
    // Your turn: this is right for numbers below 2^64.
    return (double)word[0];
#endif
}

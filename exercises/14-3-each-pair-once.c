/* Exercise 14.3.  Each pair once in a tree that is joined with itself.
 *
 * A tree is joined with itself: every leaf visits every leaf, itself too.  When
 * the leaf `own` visits the leaf `other`, its element in `lane` takes some of the
 * sixteen elements there as partners.  Return which, as a set: bit j is 1 if it
 * takes the one in lane j.
 *
 * In the end each pair of two different elements must have been taken exactly
 * once, whatever the number of leaves, and no element with itself.  There are
 * many such rules; any one will do.
 *
 * Section: Each pair once.
 *
 * Hint 1: Begin with a single leaf: of two of its lanes, only the earlier one
 *     may take the other.
 * Hint 2: Of two different leaves, one takes all and the other none.
 * Hint 3: The set has sixteen bits.  Those above must be 0.
 */
#include <stdint.h>

uint32_t partners(int own, int lane, int other)
{
    const uint32_t all = 0xffff;
#if defined TF_SOLUTION
    if (own != other)
        return own < other ? all : 0;
    return all & ~UINT32_C(1) << lane;
#elif defined TF_WRONG_1 // everything twice
    return own == other ? all & ~(UINT32_C(1) << lane) : all;
#elif defined TF_WRONG_2 // goes by lanes in all leaves
    (void)own;
    (void)other;
    return all & ~UINT32_C(1) << lane;
#elif defined TF_WRONG_3 // takes itself, too
    if (own != other)
        return own < other ? all : 0;
    return all & UINT32_MAX << lane;
#elif defined TF_WRONG_4 // forgets what is within a leaf
    (void)lane;
    return own < other ? all : 0;
#elif defined TF_WRONG_5 // has bits of no lane
    if (own != other)
        return own < other ? all : 0;
    return ~UINT32_C(1) << lane;
#else
    // Your turn: every element takes all, in every leaf.
    return all;
#endif
}

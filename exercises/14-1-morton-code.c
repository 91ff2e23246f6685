/* Exercise 14.1.  Half a deck: bits shuffled to a Morton code.
 *
 * Shuffle the bits of two numbers of 16 bits each: bit i of x becomes bit 2 i of
 * the result, and bit i of y becomes bit 2 i + 1.  This is the place of a cell
 * along the Morton curve in the plane, in a grid of 65,536 cells along each
 * axis.
 *
 * Section: A curve through everything.
 *
 * Hint 1: First spread the bits of one number, one zero between each and the
 *     next.  Then one shift and one `|` are left.
 * Hint 2: Move the upper eight bits of the number eight places up, then the upper
 *     four of each group of eight by four places, and so on.
 * Hint 3: x | x << 8 has a copy of everything.  A mask keeps of it the lower
 *     halves where they are and the upper ones where they belong: 0x00ff00ff.
 */
#include <stdint.h>

uint32_t shuffle(uint32_t x, uint32_t y);

#if defined TF_SOLUTION
static uint32_t spread(uint32_t x)
{
    x = (x | x << 8) & 0x00ff00ff;
    x = (x | x << 4) & 0x0f0f0f0f;
    x = (x | x << 2) & 0x33333333;
    return (x | x << 1) & 0x55555555;
}
#elif defined TF_WRONG_1 // only the lower byte
static uint32_t spread(uint32_t x)
{
    x = (x | x << 4) & 0x0f0f;
    x = (x | x << 2) & 0x3333;
    return (x | x << 1) & 0x5555;
}
#elif defined TF_WRONG_2 // masks only at the end
static uint32_t spread(uint32_t x)
{
    x = x | x << 8;
    x = x | x << 4;
    x = x | x << 2;
    return (x | x << 1) & 0x55555555;
}
#elif defined TF_WRONG_3 // two zeros, as in space
static uint32_t spread(uint32_t x)
{
    uint32_t spaced = 0;
    for (int i = 0; i < 10; i++)
        spaced |= (x >> i & 1) << 3 * i;
    return spaced;
}
#elif defined TF_WRONG_4
static uint32_t spread(uint32_t x)
{
    uint32_t spaced = 0;
    for (int i = 0; i < 16; i++)
        spaced |= (x >> i & 1) << 2 * i;
    return spaced;
}
#else
static uint32_t spread(uint32_t x)
{
    // Your turn: nothing is spread.
    return x;
}
#endif

uint32_t shuffle(uint32_t x, uint32_t y)
{
#ifdef TF_WRONG_4 // the axes are exchanged
    return spread(y) | spread(x) << 1;
#else
    return spread(x) | spread(y) << 1;
#endif
}

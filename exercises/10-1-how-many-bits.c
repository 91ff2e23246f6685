/* Exercise 10.1.  How many bits may coordinates have?
 *
 * Coordinates are integers x with |x| < 2^b, and `word` is the length in bits
 * of a signed integer, from 12 to 128, the sign bit included: it can hold
 * absolute values below 2^(word - 1).  Find the largest b for which it can hold
 * every n x n determinant of differences of coordinates, n = 2 or 3.
 *
 * Section: The largest determinant.
 *
 * Hint 1: A difference of two coordinates is less than 2^(b + 1), and an n x n
 *     determinant is a sum of products of n of them.
 * Hint 2: Not all terms of a 3 x 3 determinant can be large with the same sign:
 *     with entries up to m it is at most 4 m^3, not 6 m^3.  A 2 x 2 one is at
 *     most 2 m^2.
 * Hint 3: 4 (2^(b + 1))^3 = 2^(3b + 5).  This has to fit beside the sign.
 */

int coordinate_bits(int n, int word)
{
#if defined TF_SOLUTION
    // 2^(2b + 3) or 2^(3b + 5), and the sign.
    return n == 2 ? (word - 4) / 2 : (word - 6) / 3;
#elif defined TF_WRONG_1 // counts six terms of full size: too careful
    return n == 2 ? (word - 4) / 2 : (word - 7) / 3;
#elif defined TF_WRONG_2 // forgets the sign
    return n == 2 ? (word - 3) / 2 : (word - 5) / 3;
#elif defined TF_WRONG_3 // forgets that differences are longer
    return n == 2 ? (word - 2) / 2 : (word - 3) / 3;
#elif defined TF_WRONG_4 // forgets that terms are added
    return n == 2 ? (word - 3) / 2 : (word - 4) / 3;
#else
    // Your turn: this is safe, and wasteful.
    return (word - 8) / n;
#endif
}

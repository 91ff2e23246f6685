/* Exercise 2.3.  A determinant that is rounded to the opposite sign.
 *
 * A determinant in rounded arithmetic may come out as zero where the true one
 * is not.  Worse, it may have the opposite sign!  Find three points a, b, c
 * with coordinates from -1 to 1 for which the determinant of exercise 2.1,
 *
 *     (b - a).x * (c - a).y - (b - a).y * (c - a).x
 *
 * is positive when evaluated in doubles but truly negative, or the reverse.
 *
 * Section: How a computer rounds.
 *
 * Hint 1: If all four differences are exact the sign is right or zero, because
 *     rounding never reverses the order of two products.  So some difference
 *     must be rounded: subtract a tiny number from one near 1/2.
 * Hint 2: Take a = (-2^-54, 0) and b.x, c.x near 1/2.  Doubles there are 2^-53
 *     apart: b.x - a.x and c.x - a.x lie halfway between two doubles and are
 *     rounded to the one whose last bit is zero, down for b.x = 1/2, up for
 *     c.x = 1/2 + 2^-53.
 * Hint 3: So c.x - a.x comes out larger than b.x - a.x by a factor of about
 *     1 + 4 2^-53 instead of 1 + 2 2^-53.  Choose b.y and c.y with a ratio
 *     between the two: b.y = 3/4 and the second double after it.
 */
typedef struct three_points {
    double a[2], b[2], c[2];
} three_points;

three_points opposite_sign(void)
{
#if defined TF_SOLUTION
    return (three_points){.a = {-0x1p-54, 0},
                          .b = {0.5, 0.75},
                          .c = {0.5 + 0x1p-53, 0.75 + 0x1p-52}};
#elif defined TF_WRONG_1 // exact differences: rounded to zero, not to opposite
    return (three_points){
        .a = {0, 0}, .b = {0.5 + 0x1p-28, 0.5}, .c = {0.5, 0.5 - 0x1p-28}};
#elif defined TF_WRONG_2 // tenths: as doubles, truly on one line
    return (three_points){.a = {0, 0}, .b = {0.1, 0.1}, .c = {0.3, 0.3}};
#elif defined TF_WRONG_3 // overflows instead of rounding
    return (three_points){
        .a = {-1e308, 0}, .b = {1e308, 1e-308}, .c = {1e308, 1e-308}};
#else
    // Your turn: here both signs are positive.
    return (three_points){.a = {0, 0}, .b = {1, 0}, .c = {0, 1}};
#endif
}

/* Exercise 7.3.  Two edges whose contact has no normal.
 *
 * The contact of two parallel edges has no normal.  Find two edges that are not
 * parallel at t = 0 and not parallel at t = 1, that have a length at both,
 * and that nevertheless meet in mid-step (0 < t < 1) with a normal of zero.
 *
 * Section: Parallel, collinear, collapsed.
 *
 * Hint 1: The normal is the cross product of the horizontal edges of the two
 *     simplices that intersect.  These may be at different times.
 * Hint 2: Let one edge at t = 0 be parallel to the other edge at t = 1, and let
 *     the simplex with pivot 1 of the one intersect the simplex with pivot 0 of
 *     the other.  Then all six events of these two must lie in a hyperplane, so
 *     put them into the plane z = 0.  Each edge has one more event, which you
 *     can put elsewhere.
 * Hint 3: No other pair may intersect as early.  The worldline of vertex 1 of
 *     the one edge is only in the simplex with pivot 1, and the worldline of
 *     vertex 0 of the other edge is only in the simplex with pivot 0, so let
 *     these two vertices meet.
 */
typedef struct encounter {
    double first[2][2][3];  // [vertex][time][axis]
    double second[2][2][3]; // the same
} encounter;

encounter parallel_at_different_times(void)
{
#if defined TF_SOLUTION
    return (encounter){
        .first = {{{-2, 1, 0}, {-2, -1, 2}}, {{0, 1, 0}, {0, -1, 0}}},
        .second = {{{0, 0, 0}, {0, 0, 0}}, {{2, 0, 2}, {2, 0, 0}}}};
#elif defined TF_WRONG_1 // parallel at both times
    return (encounter){
        .first = {{{-2, 1, 0}, {-2, -1, 0}}, {{0, 1, 0}, {0, -1, 0}}},
        .second = {{{0, 0, 0}, {0, 0, 0}}, {{2, 0, 0}, {2, 0, 0}}}};
#elif defined TF_WRONG_2 // meets with a normal
    return (encounter){
        .first = {{{-2, 1, 0}, {-2, -1, 2}}, {{0, 1, 0}, {0, -1, 0}}},
        .second = {{{0, 0, -1}, {0, 0, -1}}, {{0, 0, 2}, {0, 0, 2}}}};
#elif defined TF_WRONG_3 // one edge is a point at the end
    return (encounter){
        .first = {{{-2, 1, 0}, {0, -1, 0}}, {{0, 1, 0}, {0, -1, 0}}},
        .second = {{{0, 0, 0}, {0, 0, 0}}, {{2, 0, 2}, {2, 0, 2}}}};
#elif defined TF_WRONG_4 // they miss each other in time
    return (encounter){
        .first = {{{-2, 1, 0}, {-2, -1, 2}}, {{0, 1, 0}, {0, -1, 0}}},
        .second = {{{1, 0, 0}, {1, 0, 0}}, {{2, 0, 2}, {3, 0, 0}}}};
#else
    // Your turn: here two edges cross.
    return (encounter){
        .first = {{{-1, 0, 1}, {-1, 0, -1}}, {{1, 0, 1}, {1, 0, -1}}},
        .second = {{{0, -1, 0}, {0, -1, 0}}, {{0, 2, 0}, {0, 2, 0}}}};
#endif
}

/* Exercise 7.3.  Parallel at different times.
 *
 * Two parallel edges that meet have no normal.  Find two edges that are
 * parallel neither at t = 0 nor at t = 1, that have a length at both times, and
 * that meet in mid-step (0 < t < 1) with a normal of zero all the same.
 *
 * Section: Parallel, collinear, collapsed.
 *
 * Hint 1: The normal is the product of the horizontal edges of the two
 *     simplices that meet.  These may be of different times.
 * Hint 2: Let the one edge at t = 0 be parallel to the other edge at t = 1, and
 *     let them meet by their simplices with mover 1 and mover 0.  For a meeting
 *     all six events of those two must lie in a hyperplane: put them into the
 *     plane z = 0.  Each edge has one event left over, to be put elsewhere.
 * Hint 3: No other pair may meet as early.  The worldline of vertex 1 of the
 *     one is in its simplex with mover 1 only, and that of vertex 0 of the
 *     other is in its simplex with mover 0 only: let these two vertices meet.
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
#elif defined TF_WRONG_4 // misses in time
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

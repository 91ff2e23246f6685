/* Exercise 20.4.  Project: beads on a wire.
 *
 * Beads are on a wire, bead i before bead i + 1, at most 500 of them, each with
 * a mass.  A simulation proposes where they end, without a thought of contacts.
 * Change the proposed ends so that each bead ends at least `gap` behind the one
 * before it, up to a rounding error of 10^-9.  The sum of the ends, weighted by
 * mass, must stay what it is, since the beads push only each other.  A bead
 * that nothing pushes must end exactly where it was proposed to end.
 *
 * There are many good answers, and this part of the book has three: impulses
 * between two beads, again and again, a system of equations for all that push
 * each other, and groups that move as one.  The checks accept any that changes
 * the ends by at most twice the least that is possible, in the sum of squares
 * weighted by mass.  Once they pass, compare your answer with another one: how
 * does the time of each grow with the number of beads that meet?  Then let the
 * wire end at a wall, or a bead be scripted, and find out which of your answers
 * still work.  And why is it enough to look at the ends?
 *
 * Section: Separation and friction.
 *
 * Hint 1: With z = end - i gap in place of the end of bead i, the beads have to
 *     be in order, and nothing is left of the gap.
 * Hint 2: Beads that push each other share one z: of all numbers, the mean of
 *     what was proposed, weighted by mass, is the nearest and keeps the sum.
 * Hint 3: Take one bead after the other, as a group of its own.  While the last
 *     group should end before the one in front of it, make one group of both.
 */
#include <stdbool.h>

enum {
    MOST = 500
};

/// Beads that push each other, from `first` to that of the next group.
typedef struct group {
    int first;
    double mass, place; // of the first bead, less first times gap
} group;

/// Makes one group of two that follow each other.
static void unite(group *one, const group *next)
{
#if defined TF_WRONG_1 // all beads weigh the same
    one->place = (one->place + next->place) / 2;
#else
    one->place = (one->mass * one->place + next->mass * next->place) /
                 (one->mass + next->mass);
#endif
    one->mass += next->mass;
}

void string_beads(int beads, const double mass[], double gap, double end[])
{
    group groups[MOST + 1];
    int count = 0;
#if defined TF_SOLUTION || defined TF_WRONG_1
    for (int i = 0; i < beads; i++) {
        groups[count++] = (group){i, mass[i], end[i] - i * gap};
        while (count > 1 && groups[count - 1].place < groups[count - 2].place) {
            count--;
            unite(&groups[count - 1], &groups[count]);
        }
    }
#elif defined TF_WRONG_2 // does not see that the united group meets another
    for (int i = 0; i < beads; i++) {
        groups[count++] = (group){i, mass[i], end[i] - i * gap};
        if (count > 1 && groups[count - 1].place < groups[count - 2].place) {
            count--;
            unite(&groups[count - 1], &groups[count]);
        }
    }
#elif defined TF_WRONG_3 // moves all as one if any two meet
    bool meet = false;
    for (int i = 0; i < beads; i++) {
        groups[count++] = (group){i, mass[i], end[i] - i * gap};
        meet |= count > 1 && groups[count - 1].place < groups[count - 2].place;
    }
    for (; meet && count > 1; count--)
        unite(&groups[count - 2], &groups[count - 1]);
#else
    // Your turn: so far no bead meets another.
    for (int i = 0; i < beads; i++) {
        groups[count++] = (group){i, mass[i], end[i] - i * gap};
        if (false)
            unite(&groups[0], &groups[1]);
    }
#endif
    groups[count].first = beads;
    for (int g = 0; g < count; g++)
        for (int i = groups[g].first; i < groups[g + 1].first; i++)
            if (groups[g + 1].first > groups[g].first + 1)
                end[i] = groups[g].place + i * gap;
}

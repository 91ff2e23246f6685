/* Exercise 5.4.  Project: chains that never tangle.
 *
 * Chains of edges move in the plane, step by step.  A simulation proposes
 * where the vertices end, without a thought of contacts.  Change the proposed
 * ends so that in the step from `start` to `end` no vertex touches an edge,
 * except for the edges that it is an end of.  At the start none does.
 * If there is no contact at all, nothing may change.  A chain that no other
 * comes near must end where it was proposed to end, too, unless it touches
 * itself: near means that boxes around the whole motion of both overlap.
 *
 * There are many good answers.  The checks look only at what is asked for
 * above, and judge all contacts exactly.  Once they pass, let chains of your
 * own fall, in a program with a main() that calls untangle():
 *
 *     cc -Isrc mine.c work/05-4-chains-that-never-tangle.c \
 *         build/libtanglefree.a -lm
 *
 * The drawing program, which is not part of a course's handout, shows a step
 * from two files of meshes: `tanglefree-draw surface`.  Then improve your
 * answer: how far can the chains fall, and how close can the vertices come to
 * what they would have touched?  (If you halve displacements until nothing
 * touches, give up after some tries.  Half of the smallest displacement rounds
 * back to the whole, or to nothing.)
 *
 * Section: A query about a scene.
 *
 * Hint 1: There is an end that is always good: every vertex stays at its
 *     start.  You need it only for the vertices of a point and an edge that
 *     touch.
 * Hint 2: A vertex that stays changes the motion of the edges that it is an
 *     end of, so they may touch something now that they passed before.  Look
 *     at all points and edges again until nothing changes.
 * Hint 3: That ends, because in each round at least one more vertex stays, and
 *     if all three of a point and an edge stay, they do not touch.
 * Hint 4: tf_clamped may answer TF_UNDECIDED.  If you promise that there is no
 *     contact, which verdicts are good enough?
 */
#include "arithmetic/clamped.h"
#include "query/point_edge.h"

#include <stdbool.h>

#if !defined TF_WRONG_4
/// Whether a vertex and an edge may touch in a step.
static bool may_touch(const tf_motion *step, int vertex, const int edge[2])
{
    tf_contact contact;
    tf_status status = tf_point_edge(&tf_clamped, step, vertex, edge, &contact);
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    return status != TF_OK || contact.verdict != TF_APART;
#else // TF_WRONG_3, and the stub: takes what is undecided for a miss
    return status != TF_OK || contact.verdict == TF_HIT;
#endif
}

/// Lets a vertex stay; whether it was to move.
static bool stay(const double start[2], double end[2])
{
    bool moved = end[0] != start[0] || end[1] != start[1];
    end[0] = start[0];
    end[1] = start[1];
    return moved;
}
#endif

void untangle(int vertices, const double start[][2], int edges,
              const int edge[][2], double end[][2])
{
#if defined TF_WRONG_4 // is safe, and never moves
    for (int v = 0; v < vertices; v++)
        for (int k = 0; k < 2; k++)
            end[v][k] = start[v][k] + 0 * edge[edges - 1][0];
#else
    const tf_motion step = {2, vertices, start[0], end[0]};
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_3
    bool changed = true;
    while (changed) {
        changed = false;
        for (int v = 0; v < vertices; v++)
            for (int e = 0; e < edges; e++) {
                int a = edge[e][0], b = edge[e][1];
                if (v == a || v == b || !may_touch(&step, v, edge[e]))
                    continue;
#if defined TF_WRONG_1 // lets all stay if two touch
                for (int i = 0; i < vertices; i++)
                    changed |= stay(start[i], end[i]);
#else
                changed |= stay(start[v], end[v]);
                changed |= stay(start[a], end[a]);
                changed |= stay(start[b], end[b]);
#endif
            }
    }
#else
    for (int v = 0; v < vertices; v++)
        for (int e = 0; e < edges; e++) {
            int a = edge[e][0], b = edge[e][1];
            if (v == a || v == b || !may_touch(&step, v, edge[e]))
                continue;
            stay(start[v], end[v]);
#if defined TF_WRONG_2 // does not look again
            stay(start[a], end[a]);
            stay(start[b], end[b]);
#else
            // Your turn: a vertex that touches an edge stays.  Is that enough?
#endif
        }
#endif
#endif
}

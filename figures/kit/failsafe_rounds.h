// The failsafe alone, round by round, on a step in the plane.
#ifndef FIG_FAILSAFE_ROUNDS_H
#define FIG_FAILSAFE_ROUNDS_H

#include "response/failsafe.h"
#include "surface/contacts.h"

/// What is so before a round.
typedef struct fig_round {
    int round;
    const double *end; ///< two coordinates a vertex
    tf_groups *groups;
    const tf_contacts *found; ///< what meets on the way to the ends
} fig_round;

/// Resolves a step of a mesh in the plane, all of whose vertices weigh 1, and
/// shows each round, the last one included, before which nothing meets any
/// more.  Returns how many rounds it took.
int fig_failsafe_rounds(const tf_mesh *mesh, const double start[],
                        const double proposed[],
                        void (*show)(void *context, const fig_round *now),
                        void *context);

#endif

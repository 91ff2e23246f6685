// Two elements by themselves, which a proposed step lets meet, and candidates
// for the row that pushes them apart: for the figures about impulses.
#ifndef FIG_PUSHED_PAIR_H
#define FIG_PUSHED_PAIR_H

#include "query/contact.h"
#include "renderer/vector.h"

#include <stdbool.h>

enum {
    FIG_PAIR_VERTICES = 4
};

/// The vertices of two elements and their displacements in a step; the first
/// `first` belong to the first element.  All masses are 1.
typedef struct fig_pair {
    int axes, first, count;
    tf_vector start[FIG_PAIR_VERTICES], move[FIG_PAIR_VERTICES];
} fig_pair;

/// What a row of a contact may be made of.
typedef enum fig_candidate {
    FIG_BY_COORDINATES = 0, ///< the barycentric coordinates
    FIG_BY_GRADIENT,        ///< the derivative of the gap at the contact
    FIG_BY_BOTH,            ///< pushes by the first, wants the second
    FIG_BY_PIVOTS,          ///< the two pivots
    FIG_CANDIDATES
} fig_candidate;

/// Signed shares of the vertices: the first element's are positive.  Pushing
/// follows `push` times the normal, until `want` times the normal, times the
/// displacements, is 0 or more.
typedef struct fig_pair_row {
    double push[FIG_PAIR_VERTICES], want[FIG_PAIR_VERTICES];
    tf_vector normal;
} fig_pair_row;

/// Whether the pair meets in the step, and how.
bool fig_pair_meets(const fig_pair *pair, tf_contact *contact);

/// The vector from the second element's point of contact to that of the first,
/// at the start.
tf_vector fig_pair_vector(const fig_pair *pair, const tf_contact *contact);

/// Make a row of a contact.
fig_pair_row fig_pair_row_of(const fig_pair *pair, const tf_contact *contact,
                             fig_candidate candidate);

/// What a row wants to be at least 0.
double fig_pair_parting(const fig_pair *pair, const fig_pair_row *row);

/// Push until the row has what it wants.  Returns false if it has it already.
bool fig_pair_push(fig_pair *pair, const fig_pair_row *row);

enum {
    FIG_PAIR_ROUNDS = 50 ///< that are tried
};

/// Push with a row of that kind as long as the pair meets.  Returns how often
/// it took, or -1: it meets though the row has what it wants, or still after
/// FIG_PAIR_ROUNDS.
int fig_pair_part(fig_pair *pair, fig_candidate candidate);

/// The same with the rows that the library chooses.
int fig_pair_part_as_library(fig_pair *pair);

#endif

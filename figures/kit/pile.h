// Edges in the plane that fall onto each other and onto a floor, and the rows
// of all contacts until they do not meet any more.
#ifndef FIG_PILE_H
#define FIG_PILE_H

#include "response/zones.h"

/// A stack of edges; edge i has the vertices 2 i and 2 i + 1, and edge 0 is the
/// floor, which is scripted to rest.
typedef struct fig_pile {
    int edges, vertices;
    int *edge;
    double *start;        ///< two coordinates a vertex
    double *proposed;     ///< where they would end
    double *end;          ///< where they end
    double *inverse_mass; ///< 1, of the floor 0
    int rounds;           ///< in which there were contacts
    int contacts;         ///< of the first round
    int zones_solved;     ///< in the last one
    tf_zones zones;       ///< with all rows
} fig_pile;

/// Room for a stack, of masses 1, at the origin and at rest.
fig_pile fig_pile_new(int edges);
void fig_pile_free(fig_pile *pile);

/// Puts an edge between two places, from where it would move by two
/// displacements, two numbers each.
void fig_pile_put(fig_pile *pile, int edge, const double place[4],
                  const double displacement[4]);

/// Resolves the step by zones, in so many rounds at most.
void fig_pile_resolve(fig_pile *pile, const tf_zone_solver *solver, int sweeps,
                      int most_rounds);

/// A zone with its arrays.
typedef struct fig_some_zone {
    tf_zone zone;
    double *proposal;     ///< the displacement, before any solver
    double *displacement; ///< the zone's
    double *inverse_mass; ///< the zone's
    tf_constraint *row;   ///< the zone's
} fig_some_zone;

/// All rows of a stack, with room for `more` others, before they are solved.
fig_some_zone fig_pile_zone(const fig_pile *pile, int more);
void fig_some_zone_free(fig_some_zone *some);

/// The displacement as proposed, and all impulses zero.
void fig_zone_reset(fig_some_zone *some);

/// The kinetic energy of the free vertices, as displaced.
double fig_zone_energy(const fig_some_zone *some);

/// The entries of a zone's matrix, row after row; to be freed.
double *fig_zone_matrix(const tf_zone *zone);

/// The rank of a zone's matrix.
int fig_zone_rank(const tf_zone *zone);

#endif

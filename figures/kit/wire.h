// Beads on a wire, side by side with gaps between neighbors, before a knot that
// is scripted to rest.  The first is to move by 1, the others are at rest.
#ifndef FIG_WIRE_H
#define FIG_WIRE_H

enum {
    FIG_WIRE_BEADS = 32, ///< at most
    FIG_WIRE_SEEN = 8    ///< rounds that are noted
};

/// How the step was resolved.
typedef struct fig_wire {
    int rounds;  ///< in which neighbors met
    long visits; ///< of rows, in all rounds
    /// The displacements before each round, those of the proposal first.
    double seen[FIG_WIRE_SEEN][FIG_WIRE_BEADS];
    /// The bead that meets its neighbor first of all in that round, or -1.
    int met[FIG_WIRE_SEEN];
} fig_wire;

/// By an impulse for each contact of a round.
fig_wire fig_wire_alone(int beads, double gap);

/// By projected Gauss-Seidel for all contacts of all rounds.
fig_wire fig_wire_kept(int beads, double gap, int sweeps);

#endif

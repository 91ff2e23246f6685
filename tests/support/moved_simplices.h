// Elements whose events are moved, each coordinate by a power of two of its
// own: x becomes x + 2^(-bits w), with weights w that grow so fast that a power
// is small beside every product of up to three earlier ones, at most one an
// event and an axis, and any determinant of small integers.  Earlier are the
// vertices of lower index, of a vertex its event at t = 0, of an event its
// lower axes.
//
// What is true of them is found in exact numbers, twice: by determinants of all
// the homogeneous coordinates, expanded into sums of powers of two, and by the
// oracle.
#ifndef SUPPORT_MOVED_SIMPLICES_H
#define SUPPORT_MOVED_SIMPLICES_H

#include "support/oracle.h"

/// Two simplices whose coordinates are integers up to 16 in absolute value.
typedef struct moved_pair {
    int axes;
    bool timed; ///< in space-time, axes + 3 events; or of one time, axes + 2
    oracle_simplex s, r;
} moved_pair;

/// The sign of the barycentric coordinate of an event once moved, up to a
/// factor that all events of the pair have in common; those of S come first.
int moved_sign(const moved_pair *pair, int event);

/// Whether they meet once moved; if so and if `timed`, `toi` is the time, but
/// for less than 2^-100.
bool moved_pair_meets(const moved_pair *pair, mpq_t toi);

/// Whether the staircase sweeps of two moving elements, with vertices in index
/// order, meet once moved; `toi` as above, the earliest.
bool moved_meet(int axes, int vertices, const tf_worldline first[], int others,
                const tf_worldline second[], mpq_t toi);

/// The pair moved by explicit numbers, for the oracle: the time is that of the
/// moved pair.
bool moved_pair_meets_by_oracle(const moved_pair *pair, int bits, mpq_t toi);

#endif

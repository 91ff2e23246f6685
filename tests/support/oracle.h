// The independent judge: do two closed simplices meet, and when first?  Found
// by linear programming in exact rational numbers, with no determinant, no
// predicate and no case of degeneracy, and with its own staircase.
#ifndef SUPPORT_ORACLE_H
#define SUPPORT_ORACLE_H

#include "geometry/event.h"

#include <gmp.h>
#include <stdbool.h>

enum {
    ORACLE_EVENTS = 4
};

/// The convex hull of some events.
typedef struct oracle_simplex {
    int count;
    const tf_event *event[ORACLE_EVENTS];
} oracle_simplex;

/// By how much the events of S and of R are moved first: a coordinate by
/// 2^-shift, if that is not zero.
typedef struct oracle_moves {
    int shift[2][ORACLE_EVENTS][TF_AXES];
} oracle_moves;

/// The step of a staircase: the vertices 0..pivot at t = 0, and pivot.. at
/// t = 1.
oracle_simplex oracle_step(int vertices, const tf_worldline element[],
                           int pivot);

/// Whether two simplices of space-time meet; if so `toi` is the exact earliest
/// time.
bool oracle_simplices_meet(int axes, const oracle_simplex *s,
                           const oracle_simplex *r, mpq_t toi);

/// Whether two simplices of space meet, whatever the times of their events.
bool oracle_slices_meet(int axes, const oracle_simplex *s,
                        const oracle_simplex *r);

/// The same for the moved simplices.
bool oracle_moved_simplices_meet(int axes, const oracle_simplex *s,
                                 const oracle_simplex *r,
                                 const oracle_moves *moves, mpq_t toi);
bool oracle_moved_slices_meet(int axes, const oracle_simplex *s,
                              const oracle_simplex *r,
                              const oracle_moves *moves);

/// Whether two simplices of space-time meet, moved or not, and when.
typedef bool oracle_test(int axes, const oracle_simplex *s,
                         const oracle_simplex *r, mpq_t toi);

/// Whether a test holds for any pair of simplices of two moving elements'
/// staircase sweeps, vertices in index order; if so `toi` is the earliest time.
bool oracle_earliest(oracle_test *meet, int axes, int vertices,
                     const tf_worldline first[], int others,
                     const tf_worldline second[], mpq_t toi);

/// Whether the staircase sweeps of two moving elements meet, vertices in index
/// order; if so `toi` is the exact earliest time.
bool oracle_meet(int axes, int vertices, const tf_worldline first[], int others,
                 const tf_worldline second[], mpq_t toi);

#endif

// Pairs of simplices to try, and what is true of them.
#ifndef SUPPORT_PAIRS_H
#define SUPPORT_PAIRS_H

#include "intersect/complementary.h"
#include "support/oracle.h"

/// A pair with its own events.
typedef struct own_pair {
    tf_event event[TF_PAIR_EVENTS];
    tf_pair pair;
} own_pair;

enum {
    SHAPES = 6
};

/// Point the pair at two swept simplices that span both times: shape 0 and 1 in
/// the plane, a segment against the two kinds of triangles; 2 to 4 in space, a
/// segment against the three kinds of tetrahedra; 5, two triangles.  The
/// coordinates stay as they are.
void shape_moving(own_pair *own, int shape);

/// Point the pair at two simplices of one time, of `first` and `second`
/// vertices.
void shape_static(own_pair *own, int axes, int first, int second);

/// The coordinates that count, one after the other.
int pair_size(const own_pair *own);
double *pair_coordinate(own_pair *own, int i);

/// All signs that are needed, as the complementary test finds them.
void find_signs(const tf_arithmetic *arithmetic, const tf_pair *pair,
                tf_signs *signs);

/// What is wrong with `found` as the earliest common point of the pair, found
/// with exact signs and values (or `exact` is false: then it must not claim
/// what is not so); NULL if nothing is.
const char *intersection_fault(const own_pair *own,
                               const tf_intersection *found, bool exact);

/// The pair in hexadecimal floats.  Static storage.
const char *pair_text(const own_pair *own);

#endif

//: Declare barycentric coordinates
#pragma once

#include "intersect/signs.h"

/// The barycentric coordinates of one operand up to a common factor, all >= 0,
/// indexed by the pair's events.  Each is in [low, high], except for the
/// rounding that a value may hide; one that is certainly zero has low = high =
/// 0.  Those of the other operand are zero.
typedef struct tf_coordinates {
    double low[TF_PAIR_EVENTS], high[TF_PAIR_EVENTS];
} tf_coordinates;

/// The values of all events of a pair, if the arithmetic finds them at once;
/// otherwise false.
bool tf_pair_values(const tf_arithmetic *arithmetic, const tf_pair *pair,
                    tf_value value[TF_PAIR_EVENTS]);

/// The coordinates of the operand +1 (S) or -1 (R) of a pair whose signs are
/// all found and in no conflict.  `known`: what tf_pair_values found, or NULL.
void tf_pair_coordinates(const tf_arithmetic *arithmetic, const tf_pair *pair,
                         const tf_signs *signs, int operand,
                         const tf_value known[], tf_coordinates *coordinates);

//: Declare how coordinates are normalized
/// Divides the middles of an operand's coordinates by their sum, and puts the
/// results into `barycentric`, indexed by the pair's events.  Where the
/// coordinates are not known at all, the middle of the operand is as good as
/// any point.
void tf_coordinates_normalize(const tf_coordinates *coordinates,
                              const tf_pair *pair, int operand,
                              double barycentric[TF_PAIR_EVENTS]);

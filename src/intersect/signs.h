//: Declare barycentric signs
#pragma once

#include "arithmetic/arithmetic.h"
#include "arithmetic/sign.h"
#include "intersect/pair.h"

/// Which signs occur among the barycentric coordinates of a pair's common
/// point, turned so that S and R intersect when all agree.  Once a
/// positive and a negative one have been found, the others may be unset.
typedef struct tf_signs {
    bool positive, negative, zero, unknown;
    tf_sign sign[TF_PAIR_EVENTS];
} tf_signs;

/// The signs of Cramer's rule for the common point of two complementary
/// simplices.  First those that an estimate proves at once; the others are
/// unknown.  Returns whether they are enough: all are proved, or a conflict.
bool tf_pair_sure_signs(const tf_arithmetic *arithmetic, const tf_pair *pair,
                        tf_signs *signs);

/// Then, unless they are enough, the others.
void tf_pair_other_signs(const tf_arithmetic *arithmetic, const tf_pair *pair,
                         tf_signs *signs);

//: Declare the orientation of a coordinate
/// +1 or -1: what turns the determinant of the differences without event i into
/// a positive multiple of the event's barycentric coordinate, counted positive
/// on S and negative on R.
int tf_pair_orientation(const tf_pair *pair, int i);

//: Declare elements in linear motion
#pragma once

#include "base/status.h"
#include "linear/distance.h"
#include "linear/polynomial.h"
#include "linear/tolerances.h"
#include "query/contact.h"
#include "query/motion.h"

enum {
    TF_LINEAR_PAIR_VERTICES = 4 ///< the most of two elements
};

/// Two elements all of whose points move in straight lines.
typedef struct tf_linear_pair {
    int axes, vertices, others;
    tf_vector at[2][TF_LINEAR_PAIR_VERTICES]; ///< t = 0, 1; first element first
} tf_linear_pair;

/// Takes two elements of a scene, with the checks that every query makes.
tf_status tf_linear_pair_take(int axes, const tf_motion *motion, int vertices,
                              const int first[], int others, const int second[],
                              tf_linear_pair *taken);

/// The vertices at a time.
void tf_linear_pair_positions(const tf_linear_pair *elements, double time,
                              tf_vector x[TF_LINEAR_PAIR_VERTICES]);

//: Declare the description of a contact in linear motion
/// What is known of a contact at the points `nearest` at a time.
tf_contact tf_linear_pair_contact(const tf_linear_pair *elements, double time,
                                  const tf_point_pair *nearest,
                                  tf_classification classification);

//: Declare the first touch
/// Whether a polynomial of the coordinates (the determinant that is zero when
/// the elements are in one plane, or on one line) shows that the elements
/// touch; if so, describes the first time at which it does.
tf_contact tf_linear_pair_touch(const tf_linear_pair *elements,
                                const tf_polynomial *polynomial,
                                const tf_tolerances *tolerances);

/// Whether tolerances are in their ranges.
bool tf_tolerances_valid(const tf_tolerances *tolerances);

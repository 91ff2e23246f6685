//: Declare the query of any two elements
#pragma once

#include "arithmetic/arithmetic.h"
#include "base/status.h"
#include "geometry/sweep.h"
#include "query/contact.h"
#include "query/motion.h"

#include <stdbool.h>

/// Whether, when and how two moving elements first touch.  axes = 2: 1 + 2
/// vertices, axes = 3: 1 + 3 or 2 + 2.  Elements that touch at the start have
/// their contact at t = 0, at rest or not.
///
/// An element is swept in the order of its vertices' indices, in whatever order
/// it lists them.  Either all vertices have an index, distinct and 0 or more,
/// or none has one; then the order of the list counts (but tf_perturbed needs
/// indices).  Otherwise TF_BAD_INDEX.
tf_status tf_query(const tf_arithmetic *arithmetic, int axes, int vertices,
                   const tf_worldline first[], int others,
                   const tf_worldline second[], tf_contact *contact);

/// The same for two elements of a scene, given by the indices of their
/// vertices.
tf_status tf_query_motion(const tf_arithmetic *arithmetic, int axes,
                          const tf_motion *motion, int vertices,
                          const int first[], int others, const int second[],
                          tf_contact *contact);

//: Declare the check of a motion
/// Whether a motion is one of so many axes: TF_OK; TF_BAD_AXES; or TF_BAD_COUNT
/// if it has fewer than no vertices, or vertices without coordinates.
tf_status tf_motion_check(const tf_motion *motion, int axes);

//: Declare the verdict alone
/// Only whether two elements of a scene touch, as tf_query_motion would answer;
/// `*separated`: an axis shows that they do not, without any sign.  Callers
/// with many queries check the environment once for all of them, so this
/// function does not.
tf_status tf_query_verdict(const tf_arithmetic *arithmetic, int axes,
                           const tf_motion *motion, int vertices,
                           const int first[], int others, const int second[],
                           tf_verdict *verdict, bool *separated);

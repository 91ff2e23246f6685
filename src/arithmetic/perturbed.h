//: Declare the perturbed arithmetic
#ifndef TF_ARITHMETIC_PERTURBED_H
#define TF_ARITHMETIC_PERTURBED_H

#include "arithmetic/differences.h"

/// Exact signs that are never zero: those of events that were moved, each
/// coordinate by an infinitesimal of its own, times staying as they are.  The
/// Simulation of Simplicity of Edelsbrunner and Muecke (1990).
///
/// The infinitesimals are positive, and each is infinitely smaller than any
/// product of those before it.  Before a coordinate of an event come those of
/// vertices of lower index, of its own vertex at an earlier time, and of its
/// own on a lower axis.  A vertex needs one index for all queries, 0 to
/// TF_PERTURBED_VERTICES - 1, that no other vertex has: a determinant that
/// would be zero, but for the infinitesimals, of events that cannot be told
/// apart by index and time breaks the contract.
///
/// A value is that of the largest term that is not zero; the order tells which
/// term that is.  So the times and weights of a contact are the limits of those
/// of the moved elements as the infinitesimals go to zero.
extern const tf_arithmetic tf_perturbed;

enum {
    TF_PERTURBED_VERTICES = 1 << 28
};

#endif

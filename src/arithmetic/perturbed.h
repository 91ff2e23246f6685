//: Declare the perturbed arithmetic
#pragma once

#include "base/api.h"

#include "arithmetic/arithmetic.h"

/// @addtogroup arithmetics
/// @{

/// Exact signs that are never zero: those of vertices that were moved, each
/// coordinate at each end of the step by an infinitesimal of its own.  Any
/// finite doubles.  The Simulation of Simplicity of Edelsbrunner and Muecke
/// (1990).
///
/// The infinitesimals are positive, and each is infinitely smaller than any
/// product of those before it.  Before the infinitesimal of a coordinate come
/// those of vertices of lower index, of its own vertex at an earlier time, and
/// of its own vertex and time on a lower axis.  So all answers are true of one
/// perturbed scene as long as each vertex keeps its index in all queries.
///
/// Times and barycentric coordinates of a contact are the limits of those of
/// the moved elements as the infinitesimals go to zero.
TF_API extern const tf_arithmetic tf_perturbed;

/// @}

//: Declare the vector narrow phase
#pragma once

#include "base/api.h"
#include "query/narrow_phase.h"

/// @addtogroup narrow_phases
/// @{

/// Decides many queries at a time, several times as fast as tf_reference, with
/// the same verdicts, statuses and counts.
///
/// It gathers the vertices of the queries into blocks, decides those that
/// rounded numbers decide for certain, by vector instructions, and has
/// tf_reference decide the others.  Where verdicts are exact, it looks first
/// whether a direction separates elements that lie in one plane, and whether
/// those at rest do.  So it gains most where few elements nearly touch.  Where
/// all do, or products of coordinates overflow, it takes up to half as long
/// again as tf_reference.
///
/// The rounded numbers serve tf_exact, tf_perturbed, tf_clamped and
/// tf_published, in space.  With any other arithmetic, and in the plane, it is
/// tf_reference.
TF_API extern const tf_narrow_phase tf_vectorized;

/// @}

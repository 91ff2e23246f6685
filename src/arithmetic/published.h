//: Declare the published rule
#pragma once

#include "base/api.h"

#include "arithmetic/arithmetic.h"

/// @defgroup study For study
/// What the book compares the library's own methods with, and methods for
/// special cases.  A product needs none of it.
/// @{

/// The rule of Brochu and Bridson's report: as tf_clamped, but inside the bound
/// the sign counts as zero.  Any finite doubles.  Unsound: it misses some real
/// contacts.
TF_API extern const tf_arithmetic tf_published;

/// @}

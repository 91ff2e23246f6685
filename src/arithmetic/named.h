//: Declare how to find an arithmetic
#pragma once

#include "arithmetic/arithmetic.h"
#include "base/api.h"

/// @addtogroup arithmetics
/// @{

/// Finds an arithmetic by its name.  Thread-safe.
/// @param name what tf_arithmetic_name returns and the command line takes:
///     exact, clamped, report, perturbed, integer64 or integer128
/// @return the arithmetic, or NULL if none has that name
TF_API const tf_arithmetic *tf_arithmetic_named(const char *name);

/// @}

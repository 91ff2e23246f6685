//: Declare the arithmetics
#pragma once

#include "base/api.h"

/// @addtogroup arithmetics Arithmetics
/// @{

/// How the signs of determinants are found, exactly or not: a constant that is
/// passed, by its address, to whatever needs signs.  It has no state, so any
/// number of threads may share it.
typedef struct tf_arithmetic tf_arithmetic;

/// The name by which the command line offers it.  Thread-safe.
/// @param arithmetic one of the arithmetics of the library
/// @return the name, in static storage
TF_API const char *tf_arithmetic_name(const tf_arithmetic *arithmetic);

//: Declare the range of an arithmetic
/// The range of the coordinates that an arithmetic can hold.  Thread-safe.
/// @param arithmetic one of the arithmetics of the library
/// @param axes 2 for a scene in the plane, 3 for one in space
/// @return the number of bits of a coordinate: integers below 2^bits in
///     absolute value, or any finite doubles if it is 0; -1 for other axes
TF_API int tf_arithmetic_bits(const tf_arithmetic *arithmetic, int axes);

/// @}

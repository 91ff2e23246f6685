//: Refuse a compiler that rewrites floating-point arithmetic
#pragma once

#include <float.h>
#include <stdbool.h>

#if defined __FAST_MATH__ || defined __ASSOCIATIVE_MATH__ ||                   \
    defined __RECIPROCAL_MATH__ || defined __NO_SIGNED_ZEROS__ ||              \
    (defined __FINITE_MATH_ONLY__ && __FINITE_MATH_ONLY__)
#error "tanglefree: exact signs need IEEE arithmetic: no part of -ffast-math"
#endif
// 0 and 16 keep floats as they are, 1 evaluates them as doubles; all three
// leave doubles alone.
#if FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 1 && FLT_EVAL_METHOD != 16
#error "tanglefree: doubles must be evaluated as doubles (-msse2 -mfpmath=sse)"
#endif

//: Declare the check of the floating-point environment
/// Whether the calling thread rounds to nearest and keeps subnormal numbers,
/// and the library was compiled to the operations that are written in it.
/// Linking anything built with -ffast-math can turn subnormals off for the
/// thread that loads it.  Costs some tens of cycles where there is a control
/// register to read.
bool tf_environment_is_ieee(void);

//: Declare the version
#pragma once

#include "base/api.h"

/// @addtogroup version Version
/// @{

/// Major, minor, patch: incompatible changes raise the first number, additions
/// the second, and corrections the third.
#define TF_VERSION "0.2.0"

/// The version of the library that the program runs with, which may be newer
/// than the TF_VERSION it was compiled with.  Thread-safe.
/// @return the version in the form of TF_VERSION, in static storage
TF_API const char *tf_version(void);

/// @}

//: Declare the version
#pragma once

#include "base/api.h"

/// @addtogroup version Version
/// @{

/// Raised by an incompatible change: programs must be compiled again.  The name
/// that they find the shared library by has this number, libtanglefree.so.1, so
/// that those compiled with another one do not take it.
#define TF_VERSION_MAJOR 1

/// Raised by additions: functions, constants, values of enums, and members at
/// the end of structs that may grow.  A program that was compiled with an older
/// header runs with the newer library as before.
#define TF_VERSION_MINOR 0

/// Raised by corrections.
#define TF_VERSION_PATCH 0

/// The three numbers.
#define TF_VERSION "1.0.0"

/// The version of the library that the program runs with, which may be newer
/// than the TF_VERSION it was compiled with.  Thread-safe.
/// @return the version in the form of TF_VERSION, in static storage
TF_API const char *tf_version(void);

/// @}

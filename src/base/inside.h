//: Keep a function inside others
#pragma once

/// Makes a function part of each that calls it, however large it is: of those
/// that are compiled several times, or call it with constants.
#ifdef __GNUC__
#define TF_INSIDE static inline __attribute__((always_inline))
#else
#define TF_INSIDE static inline
#endif

//: Inline a function always
#pragma once

/// Inlines a function into each of its callers, however large it is, so that it
/// is compiled for their processor and with the constants that they pass.
#ifdef __GNUC__
#define TF_ALWAYS_INLINE static inline __attribute__((always_inline))
#else
#define TF_ALWAYS_INLINE static inline
#endif

//: Compile for the vector registers of the processor
#pragma once

/// Marks a function whose loops become vector instructions: gcc compiles it for
/// several kinds of processors, and the program takes the best that its
/// processor has when it starts.  Elsewhere it is compiled once, for whatever
/// the options choose.  The answers are the same bits in each.
///
/// TF_SIMD_256 stops at registers of 256 bits: for functions that work on four
/// numbers at a time, and for loops that collect a bit of each lane, for which
/// gcc takes longer with 512 bits.
#if defined __GNUC__ && __GNUC__ >= 12 && !defined __clang__ &&                \
    defined __x86_64__ && defined __gnu_linux__ &&                             \
    !defined __SANITIZE_ADDRESS__ && !defined __SANITIZE_THREAD__
#define TF_SIMD                                                                \
    __attribute__((                                                            \
        target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#define TF_SIMD_256 __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#define TF_SIMD
#define TF_SIMD_256
#endif

//: Let lanes choose without a branch
/// Marks a function that computes what it may not need.  gcc believes that
/// every comparison could raise a trap, and may therefore keep a choice as a
/// branch, which no vector can take, unless it is told that nobody listens to
/// traps.  This changes no number: only flags that the library never reads.
#if defined __GNUC__ && !defined __clang__
#define TF_NO_TRAPS __attribute__((optimize("no-trapping-math")))
#else
#define TF_NO_TRAPS
#endif

//: Keep a loop whole
/// Keeps a loop over the lanes of a vector whole: gcc unrolls short loops
/// before it looks for vectors, and then finds none.
#if defined __GNUC__ && !defined __clang__
#define TF_LANE_LOOP _Pragma("GCC unroll 1")
#else
#define TF_LANE_LOOP
#endif

// A reproducible source of random numbers.
#ifndef SUPPORT_GENERATOR_H
#define SUPPORT_GENERATOR_H

#include <stdint.h>

/// The seed of the run: TF_SEED (environment), or a fixed one.  main() prints
/// it; a failure message names it.
uint64_t seed(void);

/// A stream of random numbers that depends on the seed and on its own number
/// only.
typedef struct generator {
    uint64_t state;
} generator;

generator generator_new(uint64_t stream);

/// 64 random bits.
uint64_t next_bits(generator *random);

/// A random integer in 0..n-1, n > 0.
int below(generator *random, int n);

/// A random number in [lo, hi), from 53 random bits.
double uniform(generator *random, double lo, double hi);

#endif

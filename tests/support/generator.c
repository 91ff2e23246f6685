#include "support/generator.h"

#include <stdlib.h>

uint64_t seed(void)
{
    const char *told = getenv("TF_SEED");
    return told ? strtoull(told, NULL, 0) : 20090610;
}

// The generator is splitmix64: an odd step and a mixing function.

static uint64_t mix(uint64_t z)
{
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

generator generator_new(uint64_t stream)
{
    return (generator){mix(mix(seed()) + stream)};
}

uint64_t next_bits(generator *random)
{
    random->state += UINT64_C(0x9e3779b97f4a7c15);
    return mix(random->state);
}

int below(generator *random, int n)
{
    // The bias of n / 2^32 is of no matter here.
    uint64_t high = next_bits(random) >> 32;
    return (int)((high * (uint64_t)n) >> 32);
}

double uniform(generator *random, double lo, double hi)
{
    double unit = (double)(next_bits(random) >> 11) * 0x1p-53;
    return lo + (hi - lo) * unit;
}

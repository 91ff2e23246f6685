// Random numbers for the figures that count what happens in random queries,
// the same in every run.
#ifndef FIG_RANDOM_H
#define FIG_RANDOM_H

#include "geometry/event.h"

#include <stdint.h>

/// The next 64 bits of a sequence that may start with any state: Steele, Lea
/// and Flood's splitmix64.
static inline uint64_t fig_random_bits(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

/// The same as a number from 0 up to, but not including, 1.
static inline double fig_random_number(uint64_t *state)
{
    return (double)(fig_random_bits(state) >> 11) * 0x1p-53;
}

/// Another sequence, of which only the upper bits are random: Knuth's linear
/// congruences.
static inline uint64_t fig_congruent_bits(uint64_t *state)
{
    return *state = *state * 6364136223846793005u + 1442695040888963407u;
}

/// Vertices that start anywhere in the unit square or cube and move by up to
/// `displacement` along each axis.
static inline void fig_random_vertices(uint64_t *state, int axes,
                                       double displacement, int count,
                                       tf_worldline vertex[])
{
    for (int i = 0; i < count; i++) {
        double start[TF_AXES], end[TF_AXES];
        for (int k = 0; k < axes; k++) {
            start[k] = fig_random_number(state);
            end[k] =
                start[k] + displacement * (2 * fig_random_number(state) - 1);
        }
        vertex[i] = tf_worldline_between(axes, start, end);
    }
}

#endif

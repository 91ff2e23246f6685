// The pairs of a surface that are nearer than a length, found by trying all pairs
// in rational numbers.
#ifndef SUPPORT_NEAR_ORACLE_H
#define SUPPORT_NEAR_ORACLE_H

#include "surface/surface.h"

#include <stdbool.h>
#include <stddef.h>

/// A pair, with its vertices in the order of a tf_surface_contact.
typedef struct near_oracle_pair {
    int kind; ///< a tf_kind
    int vertex[4];
} near_oracle_pair;

enum {
    NEAR_ORACLE_PAIRS = 40000
};

/// All that share no vertex and are nearer at these positions and, unless `before`
/// is NULL, not nearer at those; sorted.  Static storage; aborts if there are too
/// many.
const near_oracle_pair *near_oracle(const tf_surface *surface,
                                    const double position[],
                                    const double before[], double length,
                                    size_t *count);

#endif

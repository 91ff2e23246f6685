// Random pairs of elements at rest, on lattices, degenerate, and at all scales.
#ifndef SUPPORT_REST_PAIRS_H
#define SUPPORT_REST_PAIRS_H

#include "query/kind.h"
#include "support/generator.h"

enum {
    REST_FAMILIES = 9
};

/// Two elements: coordinates, and where each vertex is.
typedef struct rest_pair {
    tf_kind kind;
    double at[12];
    const double *x[4];
} rest_pair;

extern const char *const rest_family_names[REST_FAMILIES];

/// A pair of a family, of a kind that is drawn, too.
void rest_pair_make(generator *random, int family, rest_pair *pair);

/// How many coordinates it has.
int rest_pair_coordinates(const rest_pair *pair);

/// The pair in words, for a message; the last one's is overwritten.
const char *rest_pair_text(const rest_pair *pair);

#endif

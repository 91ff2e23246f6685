// Families of queries in space, most of them hard for rounded numbers.
#ifndef SUPPORT_FAMILIES_H
#define SUPPORT_FAMILIES_H

#include "support/queries.h"

typedef struct family {
    const char *name;
    query (*make)(generator *random, query_kind kind);
} family;

enum {
    FAMILIES = 15
};

/// The first RANDOM_FAMILIES are not hard.
extern const family families[FAMILIES];

enum {
    RANDOM_FAMILIES = 2
};

#endif

// Simplices at rest, and whether they meet, by linear programs in rational
// numbers.
#ifndef SUPPORT_AT_REST_H
#define SUPPORT_AT_REST_H

#include "support/generator.h"

#include <stdbool.h>

/// Whether the closed simplices of these corners have a point in common.
bool meet_at_rest(int axes, int count, double a[][3], int others,
                  double b[][3]);

/// Places points at random on an n x n x n lattice.
void place_on_lattice(generator *random, int count, int n, double x[][3]);

#endif

// Zones as text:
//
//     zone AXES VERTICES CONSTRAINTS
//
// then a line a vertex, its inverse mass and its proposed displacement, and a
// line a constraint: vertices, -1 for none; coefficients; normal; bound.
#ifndef SUPPORT_ZONE_FILES_H
#define SUPPORT_ZONE_FILES_H

#include "support/zones.h"

#include <stdbool.h>
#include <stdio.h>

/// Writes a zone as it is posed to a solver, with six digits.
void zone_write(FILE *file, const tf_zone *zone);

/// Reads the next one, with room for more constraints, a part of those it has;
/// false at the end.  Aborts where the text is no zone.
bool zone_read(FILE *file, double more, zone_case *read);

#endif

//: Declare where regions are wrong
#pragma once

#include "surface/sort.h"
#include "untangle/regions.h"

/// A point of a curve where a wrong region ends: its side of an edge has passed
/// through a facet that its other side has not.
typedef struct tf_breach {
    int region;       ///< the wrong one
    int facet, sheet; ///< what it has passed through, and the sheet of that
    int side;         ///< 1 if what is right is where the sheet's normal
                      ///< points to, -1 if it is on the other side
    tf_vector place;
    tf_vector inward; ///< from the right end of the edge to the wrong one
} tf_breach;

/// How the breaches of a region see another region, whose facets they are in: of
/// these facets' vertices, how many are on the region's side of the curve minus
/// how many are on the other side.
typedef struct tf_region_pair {
    int region, other;
    int near; ///< the difference
    int all;  ///< the sum
} tf_region_pair;

/// The sum of the sides of a region's breaches of a sheet.
typedef struct tf_region_side {
    int region, sheet;
    int sum, all;
    size_t first; ///< the first of these breaches
} tf_region_side;

//: Declare lists of breaches
typedef struct tf_breaches {
    size_t count, pairs, sides;
    const tf_breach *breach;    ///< sorted by region, then by sheet
    const tf_region_pair *pair; ///< sorted by region, then by the other
    const tf_region_side *side; ///< sorted by region, then by sheet
    tf_buffer storage, pair_storage, side_storage;
    tf_sort_memory sorting;
} tf_breaches;

/// Lists the breaches at x, pairs and sides.  False if there is no memory, or if
/// the caller of the tangle's watch cancels.
bool tf_breaches_find(tf_breaches *breaches, const tf_tangle *tangle,
                      const tf_curves *curves, const tf_regions *regions,
                      const double x[]);

void tf_breaches_free(tf_breaches *breaches);

/// The end, 0 or 1, of a curve point's edge that is wrong: of two wrong ends that
/// of the smaller region; -1 if both are of one region.
int tf_wrong_end(const tf_regions *regions, const tf_neighbors *all,
                 const tf_curve_point *point);

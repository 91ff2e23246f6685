//: Declare the regions between curves
#pragma once

#include "untangle/curves.h"

/// The regions into which curves cut a surface: vertices are of one region if
/// edges connect them that the curves cross an even number of times, or never.  Of
/// each part one region, usually the largest, is right, the others are wrong.
typedef struct tf_regions {
    int count;
    int *region;      ///< of each vertex
    int *size;        ///< of each region: how many vertices it has
    int *right;       ///< of each part: the region that is right
    tf_lists members; ///< of each region: its vertices, increasing
    tf_buffer storage;
} tf_regions;

/// Finds the regions.  `preferred` is of each part a vertex, or -1: its region is
/// right if it has more than half as many vertices as the largest.  False if
/// there is no memory.
bool tf_regions_find(tf_regions *regions, const tf_tangle *tangle,
                     const tf_curves *curves, const int preferred[]);

void tf_regions_free(tf_regions *regions);

//: Declare which regions are wrong
/// The part of a region; -1: it is a particle.
int tf_region_part(const tf_regions *regions, const tf_neighbors *all,
                   int region);

bool tf_is_wrong(const tf_regions *regions, const tf_neighbors *all,
                 int region);

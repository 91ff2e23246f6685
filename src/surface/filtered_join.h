//: Declare the join of elements
#pragma once

#include "surface/surface_memory.h"

/// Joins the elements of a surface that have so many corners with those that
/// have `others`: 1 with 2 or 3, or 2 with 2 or 3.  Does what tf_workers_join
/// does with their trees, but leaves out the pairs that the surface's filter
/// does, those whose vertices all have the inverse mass 0, and those of two
/// elements in one zone.  A pair of a vertex more than those of a step, which
/// only a surface at rest is checked for, is left out for one of the first two
/// reasons if any of the pairs are that remain when one of its vertices is
/// taken away.  (If it is in no zone, neither are these.)
void tf_surface_join(tf_surface *surface, int corners, int others,
                     bool (*take)(tf_pair_sink *, int, const tf_candidate[]),
                     tf_task_rows rows[], const tf_parallel *parallel);

//: Declare zones of a surface
/// Has the surface leave out pairs of two elements in one zone, until
/// tf_surface_leave_zones.  `zone` is that of tf_detect_options, borrowed;
/// NULL: everything stays as it is.  False if there is no memory.
bool tf_surface_enter_zones(tf_surface *surface, const int zone[]);

void tf_surface_leave_zones(tf_surface *surface);

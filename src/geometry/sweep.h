//: Declare the staircase sweep
#pragma once

#include "geometry/event.h"

enum {
    TF_VERTICES = 3,            ///< the most vertices of an element
    TF_EVENTS = TF_VERTICES + 1 ///< the most events of a swept simplex
};

/// One step of a staircase: the vertices 0..pivot at t = 0, then the vertices
/// pivot..k at t = 1.  Between the ends all of it moves with one velocity, that
/// of the vertex `pivot`, the only one with both its events here.
typedef struct tf_simplex {
    int count;                        ///< number of events, k + 2
    int pivot;                        ///< pivot + 1 events are at t = 0
    const tf_event *event[TF_EVENTS]; ///< t = 0 first; borrowed
} tf_simplex;

//: Declare the sweep of an element
/// Splits what a point, edge or triangle sweeps in space-time into as many
/// simplices as it has vertices, last pivot first.
///
/// `element` holds `vertices` (1, 2 or 3) worldlines in increasing global
/// vertex index: then elements that share a face share the simplices of its
/// sweep, and no crack opens between them.  The simplices point into `element`.
void tf_sweep(int vertices, const tf_worldline element[],
              tf_simplex sweep[/* vertices */]);

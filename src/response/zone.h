//: Declare zones
#pragma once

#include "base/api.h"
#include "response/row.h"

#include <stddef.h>

/// @addtogroup response
/// @{

/// An impact zone: rows that share vertices, to be satisfied together with as
/// little motion as possible.  It is a problem on its own, in its own numbering
/// of vertices: the least sum of mass |d - proposal|^2 over all displacements d
/// that satisfy its rows.
typedef struct tf_zone {
    int axes;     ///< 2 or 3
    int vertices; ///< how many
    int rows;     ///< how many, at least 1
    int solved;   ///< the first so many rows were solved before;
                  ///< a solver may leave them as they are
    tf_row *row;  ///< with places in this zone's lists of vertices;
                  ///< in: impulses to start from, or 0; out: those
                  ///< that were found
    const double
        *inverse_mass;    ///< of each vertex; 0: it cannot be moved, and a
                          ///< row has at least one that can
    double *displacement; ///< `axes` numbers a vertex; in: as proposed,
                          ///< out: with all impulses applied
    double friction;      ///< Coulomb's coefficient; 0: none
    int sweeps;           ///< iterations at most, at least 1
    double *room;         ///< as many numbers as the solver asks for
} tf_zone;

//: Declare solvers
/// A solver of zones: a constant that is passed, by its address, to the
/// response.
typedef struct tf_zone_solver {
    const char *name; ///< in static storage

    /// How many numbers `solve` needs in the zone's `room`.
    size_t (*room)(int axes, int vertices, int rows);

    /// Finds impulses, applies them, and returns how many iterations it took.
    /// It need not satisfy all rows, but its answer depends on nothing but the
    /// zone.  Thread-safe.
    int (*solve)(tf_zone *zone);
} tf_zone_solver;

//: Declare the product with a zone's matrix
/// Adds the effect of impulses, one a row, to the displacements of a zone's
/// vertices; those of friction are left out.  Thread-safe.
/// @param zone the zone
/// @param impulse one number a row
/// @param[in,out] displacement `axes` numbers a vertex
TF_API void tf_zone_push(const tf_zone *zone, const double impulse[],
                         double displacement[]);

/// Finds how far displacements part the elements of each row along its normal.
/// Thread-safe.
/// @param zone the zone
/// @param displacement `axes` numbers a vertex
/// @param[out] parting one number a row: the left side of its inequality
TF_API void tf_zone_partings(const tf_zone *zone, const double displacement[],
                             double parting[]);

/// Multiplies a zone's matrix, the inverse masses as the rows see them (how far
/// impulses part the elements of each row), by a vector.  Thread-safe.
/// @param zone the zone
/// @param impulse one number a row
/// @param[out] parting one number a row
/// @param room `axes` numbers a vertex, overwritten
TF_API void tf_zone_multiply(const tf_zone *zone, const double impulse[],
                             double parting[], double room[]);

/// @}

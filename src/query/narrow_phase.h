//: Declare many queries
#pragma once

#include "base/api.h"

#include "arithmetic/arithmetic.h"
#include "base/status.h"
#include "intersect/verdict.h"
#include "query/kind.h"
#include "query/motion.h"

#include <stddef.h>

/// @addtogroup narrow_phases
/// @{

/// Queries of one kind about one scene, borrowed from the caller.
typedef struct tf_queries {
    tf_kind kind;            ///< of all of them
    const tf_motion *motion; ///< the scene
    size_t count;            ///< how many queries
    const int *vertices; ///< three indices a query for point-edge, otherwise
                         ///< four: those of the first element, then of the
                         ///< second
} tf_queries;

//: Declare the narrow phase
/// A narrow phase decides which of many pairs of elements meet.  It is a
/// constant that is passed, by its address, to whatever needs verdicts.  With
/// an exact arithmetic all narrow phases give the same answers; they differ in
/// speed.  Before an exact arithmetic, detection may ask by one of the library's
/// own whose verdicts are certain or TF_UNDECIDED.
typedef struct tf_narrow_phase {
    const char *name; ///< in static storage

    /// Stores in `verdict[count]` whether the elements of each query meet, as
    /// tf_point_edge, tf_point_triangle and tf_edge_edge would answer.  Returns
    /// the status of the first bad query, if there is one, or TF_BAD_OPTION for a
    /// kind that there is not; the verdicts from
    /// that query on are not set.  Adds to `*separated` the number of queries
    /// whose elements an axis separates, so that no sign was needed.
    /// Thread-safe.
    tf_status (*decide)(void *context, const tf_arithmetic *arithmetic,
                        const tf_queries *queries, tf_verdict verdict[],
                        size_t *separated);

    /// The same, and stores in `clearance[count]` how far the ends of the
    /// elements of each query may move while the elements certainly stay apart:
    /// the largest movement of a vertex of the first element plus that of the
    /// second must be less, where a movement by (dx, dy, dz) counts as
    /// |dx| + |dy| + |dz|.  0 where that is not known.  NULL: the narrow phase
    /// does not measure.
    tf_status (*measure)(void *context, const tf_arithmetic *arithmetic,
                         const tf_queries *queries, tf_verdict verdict[],
                         size_t *separated, double clearance[]);

    void *context; ///< passed on to both; not used by those of the library
} tf_narrow_phase;

/// Decides one query after another.
TF_API extern const tf_narrow_phase tf_reference;

/// @}

//: Declare what reconnecting does
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "surgery/adaptive.h"
#include "surgery/outcome.h"

/// @addtogroup adaptive
/// @{

/// The operations that change how a surface is connected.
typedef enum tf_reconnection {
    TF_MERGE = 0,     ///< of edges that face each other
    TF_PINCH,         ///< of thin necks and holes
    TF_DROP,          ///< of small parts
    TF_RECONNECTIONS, ///< how many operations there are
} tf_reconnection;

/// What reconnecting has done.
typedef struct tf_reconnect_report {
    /// How often an operation was tried, by its outcome.
    size_t tried[TF_RECONNECTIONS][TF_OUTCOMES];
    /// How much volume the surface gained by each, rounded.
    double gained[TF_RECONNECTIONS];
} tf_reconnect_report;

//: Declare how to reconnect
/// How to reconnect.
typedef struct tf_reconnect_options {
    double edge;  ///< the usual length of an edge, above 0: the unit below
    double merge; ///< how near edges are that are joined; 0: 0.3
    double patch; ///< how near edges are that belong to one contact; 0: 0.5
    double pinch; ///< how long the three edges around a neck are; 0: 0.7
    double drop;  ///< how large a part is that is dropped, in cubes; 0: 0.5
} tf_reconnect_options;

/// Changes how a surface is connected where it is as thin, or as near to
/// itself, as its edges are long: merges where it faces itself across a gap,
/// once in each contact; pinches necks and holes; and drops the small parts.
///
/// Each operation is exact: the surface stays embedded.  Only which ones are
/// wanted is a matter of rounding.
///
/// @param surface the surface; its numbers stay, and gaps come about
/// @param options how
/// @param[in,out] report what was done is added to it; may be NULL
/// @return TF_OK; TF_BAD_TOLERANCE if a length is negative or not finite, or
///     that of edges zero; TF_BAD_ENVIRONMENT; or TF_OUT_OF_MEMORY, and then
///     the surface is still embedded
TF_API tf_status tf_adaptive_reconnect(tf_adaptive_surface *surface,
                                       const tf_reconnect_options *options,
                                       tf_reconnect_report *report);

/// @}

//: Declare what a reconnection reports
#pragma once

#include "base/api.h"
#include "base/progress.h"
#include "surgery/outcome.h"

#include <stddef.h>

/// @addtogroup adaptive
/// @{

/// The operations that change how a surface is connected.
typedef enum tf_reconnection {
    TF_MERGE = 0,        ///< of edges that face each other
    TF_PINCH,            ///< of thin necks and holes
    TF_DROP,             ///< of small components
    TF_RECONNECTIONS = 8 ///< room for those of later versions
} tf_reconnection;

/// What reconnecting has done.  Lent; later versions may add to its end.
typedef struct tf_reconnect_report {
    /// How often an operation was tried, by its outcome.
    size_t tried[TF_RECONNECTIONS][TF_OUTCOMES];
    /// How much volume the surface gained by each, rounded.
    double gained[TF_RECONNECTIONS];
} tf_reconnect_report;

//: Declare how to reconnect
/// How to reconnect.
typedef struct tf_reconnect_options {
    size_t size;  ///< sizeof(tf_reconnect_options); 0: that of version 1.0
    double edge;  ///< the usual length of an edge, above 0: the unit below
    double merge; ///< how near edges are that are joined; 0: 0.3; negative:
                  ///< none are
    double patch; ///< how near edges are that belong to one contact, in which
                  ///< there is one merge; 0: 0.5; negative, or less than
                  ///< `merge`: as near as those that are joined
    double pinch; ///< how long the three edges around a neck are; 0: 0.7;
                  ///< negative: there is no pinch
    double drop;  ///< how large a component is that is dropped, in cubes of the
                  ///< edge; 0: 0.5; negative: none is
    tf_progress *progress; ///< NULL: nothing is told
    void *context;         ///< passed on to `progress`
} tf_reconnect_options;

/// @}

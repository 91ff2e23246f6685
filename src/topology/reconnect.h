//: Declare what reconnecting does
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "surgery/adaptive.h"
#include "topology/options.h"

/// @addtogroup adaptive
/// @{

/// Changes how a surface is connected where it is as thin, or as near to
/// itself, as its edges are long: merges where it faces itself across a gap,
/// once in each contact; pinches necks and holes; and drops small components.
///
/// Each operation is exact: the surface stays embedded.  Only which ones are
/// wanted is a matter of rounding.
///
/// @param surface the surface; its numbers stay, and gaps come about
/// @param options how
/// @param[in,out] report what was done is added to it; may be NULL
/// @return TF_OK; TF_BAD_OPTION if a length is negative or not finite, or
///     that of edges zero; TF_BAD_ENVIRONMENT; or TF_OUT_OF_MEMORY, and then
///     the surface is still embedded
TF_API tf_status tf_adaptive_reconnect(tf_adaptive_surface *surface,
                                       const tf_reconnect_options *options,
                                       tf_reconnect_report *report);

/// @}

//: Declare what reconnecting does
#pragma once

#include "base/api.h"
#include "base/error.h"
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
/// @param surface the surface; its numbers stay, and gaps come about.  With any
///     status but TF_OK it is exactly as it was
/// @param options how
/// @param[out] report what was done, lent until the next call for this surface;
///     set only with TF_OK; may be NULL
/// @param[out] error what is wrong, if anything; may be NULL
/// @return TF_OK; TF_BAD_OPTION if a length is not finite, or that of edges not
///     above 0; TF_OUT_OF_RANGE if a coordinate is beyond 2^250;
///     TF_BAD_ENVIRONMENT; TF_OUT_OF_MEMORY; or TF_CANCELLED
TF_API tf_status tf_adaptive_reconnect(tf_adaptive_surface *surface,
                                       const tf_reconnect_options *options,
                                       const tf_reconnect_report **report,
                                       tf_error *error);

/// @}

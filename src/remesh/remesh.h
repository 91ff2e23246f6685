//: Declare remeshing
#pragma once

#include "base/api.h"
#include "base/error.h"
#include "remesh/options.h"
#include "surgery/adaptive.h"

/// @addtogroup adaptive
/// @{

/// Changes a surface to triangles that are nearly equilateral, with edges of
/// about one length, and keeps its shape: its sharp edges and its boundary,
/// where corners stay and vertices move along them, if at all, and elsewhere
/// vertices stay on the original surface, up to rounding.
///
/// Each operation is exact, and what might tangle is refused; so the new
/// surface is embedded, and the old one can be moved to it without passing
/// through itself.  Only how good the triangles are is a matter of rounding,
/// and where things are close they may stay poor.  The result is the same, to
/// the last bit, on every machine.
///
/// Where each vertex comes from, tf_adaptive_origins tells.
///
/// @param surface the surface; its gaps are closed.  With any status but TF_OK
///     it is exactly as it was
/// @param options how
/// @param[out] report what was done, lent until the next call for this surface;
///     set only with TF_OK; may be NULL
/// @param[out] error what is wrong, if anything; may be NULL
/// @return TF_OK; TF_BAD_OPTION if the length is not above 0 and finite, or
///     so short that there would be more triangles than numbers for their
///     corners; TF_OUT_OF_RANGE if a coordinate is beyond 2^1000;
///     TF_BAD_ENVIRONMENT; TF_OUT_OF_MEMORY; or TF_CANCELLED
TF_API tf_status tf_adaptive_remesh(tf_adaptive_surface *surface,
                                    const tf_remesh_options *options,
                                    const tf_remesh_report **report,
                                    tf_error *error);

/// @}

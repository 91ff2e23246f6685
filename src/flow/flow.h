//: Declare flows
#pragma once

#include "base/api.h"
#include "base/error.h"
#include "flow/options.h"
#include "surgery/adaptive.h"

/// @addtogroup adaptive
/// @{

/// A surface that flows, and the memory that its steps need, which is kept from
/// one step to the next.  Only one thread at a time may use it.
typedef struct tf_flow tf_flow;

/// Begins a flow.
/// @param surface the surface, borrowed: it must live until the flow is freed,
///     and may be changed between steps
/// @param[out] flow the flow, to be freed by tf_flow_free; set only with TF_OK
/// @return TF_OK or TF_OUT_OF_MEMORY
TF_API tf_status tf_flow_create(tf_adaptive_surface *surface, tf_flow **flow);

/// Frees a flow, but not its surface.
/// @param flow the flow; may be NULL
TF_API void tf_flow_free(tf_flow *flow);

/// Returns how much memory a flow holds by now, without its surface.
/// @param flow the flow
/// @return bytes
TF_API size_t tf_flow_memory(const tf_flow *flow);

//: Declare a step of a flow
/// Makes a step in which a surface flows: first it gets triangles with edges of
/// about one length, then it is merged and pinched where it is thin, or near to
/// itself, and then all its vertices move along the velocity.
///
/// Long edges are split, others flipped, short ones collapsed and vertices
/// smoothed, each exactly, and such that the volume is kept, up to rounding,
/// unless a move that is to restore it is refused; at a boundary there is no
/// volume to be kept.
/// Merging, pinching and dropping change it; see tf_adaptive_reconnect.  In the
/// end nothing may be left of a surface.
///
/// The vertices then move from where they are to where the method of Runge and
/// Kutta leads, as far as tf_step_resolve lets them.  So the surface stays
/// embedded, and no part of it passes through another.
///
/// A triangle whose edges are all on the boundary stays where it is.  The
/// vertices and triangles get new numbers.
///
/// Memory is kept: a step asks only for what no step before it has needed, and
/// to drop a component.
///
/// @param flow the flow; with any status but TF_OK its surface is exactly as it
///     was
/// @param time when the step begins
/// @param step how long it takes; below 0: back in time
/// @param options how
/// @param[out] report what was done, lent until the next step of this flow; set
///     only with TF_OK; may be NULL
/// @param[out] error what is wrong, if anything; may be NULL
/// @return TF_OK; the status of the first defect, if a part of the surface is
///     left alone (tf_adaptive_create_around); TF_BAD_OPTION if the length is
///     not above 0 and finite, or so short that there would be more triangles
///     than numbers for their corners, or the number of threads is not in its
///     range; TF_OUT_OF_RANGE if a coordinate is beyond 2^250; TF_NOT_FINITE if
///     a velocity leads out of what doubles can hold; TF_BAD_ENVIRONMENT;
///     TF_OUT_OF_MEMORY; or TF_CANCELLED
TF_API tf_status tf_flow_step(tf_flow *flow, double time, double step,
                              const tf_flow_options *options,
                              const tf_flow_report **report, tf_error *error);

/// @}

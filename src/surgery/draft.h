//: Declare drafts
#pragma once

#include "base/status.h"
#include "base/watch.h"
#include "surgery/adaptive_surface.h"

/// Makes a draft of a surface, in the memory that the draft has already: a copy
/// for a call to work on, so that the surface is as it was unless the call
/// succeeds.  All numbers, gaps and boxes are the same, and so is all that is
/// done to it.  Returns TF_OK, TF_OUT_OF_MEMORY or TF_CANCELLED.
/// @param watch over the call, also while it works on the draft; may be NULL
tf_status tf_draft_begin(tf_adaptive_surface *draft,
                         const tf_adaptive_surface *surface, tf_watch *watch);

/// Makes a surface what the draft is; the draft keeps the surface's memory.
void tf_draft_accept(tf_adaptive_surface *draft, tf_adaptive_surface *surface);

/// Frees all that a draft, or a surface, holds.
void tf_draft_free(tf_adaptive_surface *draft);

//: Declare surgery in stages
#pragma once

#include "surgery/adaptive_surface.h"

/// Ends a stage, once it is tried: what the surgery has added is there then,
/// and what follows is another surgery, which is done together with it or not
/// at all.
void tf_surgery_end_stage(tf_adaptive_surface *surface);

/// Removes a triangle that an earlier stage has added, before this one adds
/// any.
void tf_surgery_withdraw(tf_adaptive_surface *surface, int a, int b, int c);

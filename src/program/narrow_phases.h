//: Declare the names of narrow phases
#pragma once

#include "query/narrow_phase.h"

/// The names that tf_narrow_phase_named accepts, for help and messages.
#define TF_NARROW_PHASE_NAMES "reference or vector"

/// The narrow phase of that name; NULL if there is none.
const tf_narrow_phase *tf_narrow_phase_named(const char *name);

//: Declare how a tangle is smoothed
#pragma once

#include "untangle/change.h"

/// Sets the moves of a change that brings the vertices of crossings, and of some
/// rings of neighbors around them, half way to the means of their neighbors; those
/// at a boundary go along it, by half as much.  Fixed vertices stay.  False if there
/// is no memory.
bool tf_smooth(tf_change *change, const tf_tangle *tangle, const double x[],
               int rings);

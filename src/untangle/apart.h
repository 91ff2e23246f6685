//: Declare how parts are moved apart
#pragma once

#include "untangle/tangle.h"

/// Moves the connected parts of a surface apart: one after another, those with
/// fixed vertices first, which stay, then those with more vertices, each by
/// about the least of some translations that free it of all those before it.
/// Intersections of a part with itself don't count.  The tangle's last check is
/// that of x; parts that touch there move. `*moved` tells whether a part has
/// moved.  False if there is no memory, or the caller cancels.
bool tf_move_apart(const tf_tangle *tangle, double x[], bool *moved);

//: Declare the pass of pinches
#pragma once

#include "base/status.h"
#include "topology/reconnector.h"

/// Pinches the loops of three short edges.  Returns TF_OK or what went wrong.
tf_status tf_pinch_pass(tf_reconnector *reconnector);

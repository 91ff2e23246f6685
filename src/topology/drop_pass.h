//: Declare the pass of drops
#pragma once

#include "base/status.h"
#include "topology/reconnector.h"

/// Drops the components of small volume.  Returns TF_OK or what went wrong.
tf_status tf_drop_pass(tf_reconnector *reconnector);

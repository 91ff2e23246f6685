//: Declare the pass of merges
#pragma once

#include "base/status.h"
#include "topology/reconnector.h"

/// Merges the edges that face each other at a small distance, once in each
/// contact.  Returns TF_OK or what went wrong.
tf_status tf_merge_pass(tf_reconnector *reconnector);

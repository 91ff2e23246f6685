//: Declare the flag
#pragma once

#include "simulate/scene.h"

/// A flag on a pole, which the wind blows to the other side.
void tf_build_flag(tf_stage *stage, int size);

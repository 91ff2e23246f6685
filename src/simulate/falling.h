//: Declare what falls
#pragma once

#include "simulate/scene.h"

/// Cloth falls on a ball, which then turns.
void tf_build_sphere(tf_stage *stage, int size);

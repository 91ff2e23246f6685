//: Declare solids
#pragma once

#include "simulate/body.h"

/// Adds a ball, whose vertices are scripted.
/// @param sectors how many triangles are around each pole, 3 or more
void tf_ball_add(tf_body *body, const double center[3], double radius,
                 int sectors);

/// Adds a floor: a horizontal square of two triangles, scripted.
void tf_floor_add(tf_body *body, double height, double side);

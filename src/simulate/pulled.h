//: Declare what is pulled
#pragma once

#include "simulate/scene.h"

/// A strip whose ends are turned, and brought nearer to each other.
void tf_build_twist(tf_stage *stage, int size);

/// A rope with a knot, whose ends are pulled.
void tf_build_knot(tf_stage *stage, int size);

/// A curtain that is pulled through a ring by its middle.
void tf_build_curtain(tf_stage *stage, int size);

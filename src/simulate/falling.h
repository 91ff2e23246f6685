//: Declare what falls
#pragma once

#include "simulate/scene.h"

/// Cloth falls on a ball, which then turns.
void tf_build_sphere(tf_stage *stage, int size);

/// Sheets fall on a column, one upon the other.
void tf_build_stack(tf_stage *stage, int size);

/// In the plane a chain, laid out in rows, falls into a box.
void tf_build_chain(tf_stage *stage, int size);

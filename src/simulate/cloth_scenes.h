//: Declare the scenes of cloth
#pragma once

#include "simulate/scene.h"

/// The scenes of cloth, ropes and chains, up to one without a name.
extern const tf_scene tf_cloth_scenes[];

//: Declare the scenes of flows
#pragma once

#include "simulate/scene.h"

/// The scenes of surfaces that flow, up to one without a name.
extern const tf_scene tf_flow_scenes[];

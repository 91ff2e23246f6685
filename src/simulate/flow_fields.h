//: Declare velocity fields
#pragma once

#include "flow/flow.h"
#include "simulate/scene.h"

// None of these has sources, except growth, which depends on the surface and is
// not a field in space.

/// Two halves of space flow towards the plane x = 0, and along it outwards until
/// the time 1.5, and back until 3.
tf_velocity_field tf_splash;

/// A ring around the axis x = 0 of the other two pulls itself together, and
/// pushes what is inside out along the axis.
tf_velocity_field tf_squeeze;

/// Enright's test: vortices stretch a ball in the unit cube to a thin sheet until
/// the time 1.5, and back until 3.
tf_velocity_field tf_vortices;

/// The curl of waves in random directions.
tf_velocity_field tf_turbulence;

/// Around the second axis, the faster the nearer.
tf_velocity_field tf_whirl;

/// Along the normals of the surface.
tf_velocity_field tf_growth;

/// Applies a field point by point.
/// @param context a pointer to a pointer to a tf_velocity_field
tf_flow_velocity tf_field_apply;

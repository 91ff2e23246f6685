//: Declare the air
#pragma once

#include "simulate/body.h"

/// The air about a body.
typedef struct tf_air {
    double drag;    ///< the pressure on a surface, in pascals, for each meter
                    ///< per second at which air meets it head-on
    double wind[3]; ///< at the start, in meters per second
    double veer;    ///< how fast it turns about the vertical, in radians per
                    ///< second
    double gust; ///< how strongly waves in the wind swing to its sides and up
                 ///< and down, in meters per second
} tf_air;

/// Adds to velocities what the air does to them in a time, in seconds.
///
/// It pushes each triangle along its normal, and air that flows along a triangle
/// does not.  In the plane there is none.
/// @param time since the start, on which the gusts depend, in seconds
void tf_air_blow(const tf_air *air, const tf_body *body, double time,
                 double step, const double position[], double velocity[]);

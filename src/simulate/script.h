//: Declare scripts
#pragma once

#include "simulate/body.h"

/// Scripted vertices that move as a rigid body from one time to another, slowly
/// at first and at last.
typedef struct tf_script {
    int first, count;  ///< which vertices
    double begin, end; ///< times, in seconds
    double center[3];  ///< about which they turn
    double axis[3];    ///< of length 1, unless they only shift
    double turn;       ///< by which angle, in radians
    double shift[3];   ///< and where to, in meters
} tf_script;

/// Writes where the vertices of a script are at a time.
/// @param body which holds where they start
/// @param[out] position of all vertices, of which only those are written
void tf_script_place(const tf_script *script, const tf_body *body, double time,
                     double position[]);

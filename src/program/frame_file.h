//: Declare the frames of a simulation
#pragma once

#include "simulate/simulation.h"

#include <stdio.h>

/// Writes the state of a simulation: the mesh as binary PLY, with velocities vx,
/// vy and vz of the vertices, and a comment that names the scene and the step.
/// In the plane z is 0.  Errors are those of the stream; false without memory.
bool tf_frame_write(FILE *stream, const tf_simulation *simulation);

typedef enum tf_frame_fault {
    TF_FRAME_GOOD = 0,
    TF_FRAME_UNREADABLE, ///< errno says why
    TF_FRAME_FOREIGN     ///< it is no frame of this scene in this size
} tf_frame_fault;

/// Reads the state that a simulation of the same scene and size has written, bit
/// for bit.  After a fault the simulation is of no use.
tf_frame_fault tf_frame_read(tf_simulation *simulation, const char *path);

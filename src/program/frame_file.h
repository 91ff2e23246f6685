//: Declare the frames of a simulation
#pragma once

#include "simulate/simulation.h"

#include <stdio.h>

enum {
    TF_SIMULATION_NAME = 100
};

/// Writes the arguments that make a simulation: its scene, its resolution with
/// as many digits as that needs, and of a scene from a file the checksum.
void tf_simulation_name(const tf_simulation *simulation,
                        char name[TF_SIMULATION_NAME]);

/// Writes the state of a simulation: the mesh as binary PLY, with velocities vx,
/// vy and vz of the vertices of cloth, a comment that names the scene and the
/// step, and the scene's notes.  In the plane z is 0.  Errors are those of the
/// stream.
void tf_frame_write(FILE *stream, const tf_simulation *simulation);

typedef enum tf_frame_fault {
    TF_FRAME_GOOD = 0,
    TF_FRAME_UNREADABLE, ///< errno says why
    TF_FRAME_FOREIGN     ///< it is no frame of this scene in this resolution
} tf_frame_fault;

/// Reads the state that a simulation of the same scene and resolution has
/// written, bit for bit.  After a fault the simulation is of no use.
tf_frame_fault tf_frame_read(tf_simulation *simulation, const char *path);

//: Declare the folder of a simulation
#pragma once

#include "files/fault.h"
#include "simulate/simulation.h"

#include <stdio.h>

enum {
    TF_MOST_STEPS = 99999, ///< so that frames are sorted by their names
    TF_PATH_ROOM = 4096    ///< bytes of a path, with the 0 at its end
};

/// The folder that a simulation is written to: frame-00000.ply, the start, a
/// frame after each step, and the table steps.csv.  A frame is there whole or
/// not at all, and with it the line of its step.
typedef struct tf_simulation_folder {
    const char *path;        ///< borrowed
    FILE *table;             ///< NULL: it is not open
    char file[TF_PATH_ROOM]; ///< the path of the file that is at work
    double bytes;            ///< of the last frame; unless resumed, with meshes
    tf_fault fault;          ///< of that file or of the folder
} tf_simulation_folder;

/// Makes the folder, unless it is there and empty, and writes the start.  False:
/// there is a fault.  Borrows the path.  Close the folder in any case.
bool tf_simulation_folder_begin(tf_simulation_folder *folder, const char *path,
                                const tf_simulation *simulation);

/// Takes the state of the last frame in the folder.  False: there is a fault.
bool tf_simulation_folder_resume(tf_simulation_folder *folder, const char *path,
                                 tf_simulation *simulation);

/// Writes the line and the frame of the step that was just made.  False: there
/// is a fault, and neither or only the line is there.
bool tf_simulation_folder_add(tf_simulation_folder *folder,
                              const tf_simulation *simulation);

/// Forecasts the frames that are to come until that step.
void tf_simulation_folder_forecast(tf_simulation_folder *folder,
                                   const tf_simulation *simulation, int steps);

void tf_simulation_folder_close(tf_simulation_folder *folder);

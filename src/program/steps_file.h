//: Declare the table of steps
#pragma once

#include "simulate/simulation.h"

#include <stdio.h>

/// Makes a table without lines, over what is there; NULL, with errno, if that
/// fails.
FILE *tf_steps_file_begin(const char *path, const tf_simulation_kind *kind);

/// Opens a table to go on after some steps, and removes the lines of later ones.
/// NULL if it has not got a line for each; with errno, or 0 if it could be read.
FILE *tf_steps_file_resume(const char *path, const tf_simulation_kind *kind,
                           int steps);

/// Adds the line of the last step, and flushes.  False, with errno, if that
/// fails.
bool tf_steps_file_add(FILE *table, const tf_simulation *simulation);

//: Declare files of masses
#pragma once

#include "files/text_lines.h"

/// Reads the masses of all vertices, in their order, from the file at `path`
/// ("-": standard input), and sets their inverses.  False: there is a fault.
/// Close the lines in any case.
bool tf_masses_read(tf_text_lines *lines, const char *path, int vertices,
                    double inverse_mass[]);

/// Reads the numbers, from 0, of the scripted vertices, and sets their inverse
/// masses to 0.
bool tf_fixed_read(tf_text_lines *lines, const char *path, int vertices,
                   double inverse_mass[]);

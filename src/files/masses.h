//: Declare files of masses
#pragma once

#include "files/text.h"

/// Reads the masses of all vertices, in their order, from the file at `path`
/// ("-": standard input), and sets their inverses.  False: there is a fault.
bool tf_masses_read(const char *path, int vertices, double inverse_mass[],
                    tf_fault *fault);

/// Reads Coulomb's coefficients of all vertices, in their order.
bool tf_friction_read(const char *path, int vertices, double friction[],
                      tf_fault *fault);

/// Reads the lengths of edges at all vertices, in their order.
bool tf_lengths_read(const char *path, int vertices, double length[],
                     tf_fault *fault);

/// Reads the number of a vertex, from 0, and steps behind it.
bool tf_vertex_read(tf_text *text, int vertices, int *vertex);

/// Reads the numbers, from 0, of the scripted vertices, and sets their inverse
/// masses to 0.
bool tf_fixed_read(const char *path, int vertices, double inverse_mass[],
                   tf_fault *fault);

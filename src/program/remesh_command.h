//: Declare the command remesh
#pragma once

/// Runs `tanglefree remesh`; returns the exit status: 0 if the new mesh is
/// written, 2 after any error.
int tf_remesh_command(int argc, char *argv[]);

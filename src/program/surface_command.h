//: Declare the commands about surfaces
#pragma once

/// Runs `tanglefree detect`; returns the exit status: 0 if no step has a
/// contact, 1 if some has, 2 after bad usage or input.
int tf_detect_command(int argc, char *argv[]);

/// Runs `tanglefree check`; returns the exit status: 0 if all surfaces are free
/// of intersections, 1 if some are not, 2 after bad usage or input.
int tf_check_command(int argc, char *argv[]);

//: Declare the command resolve
#pragma once

/// Runs `tanglefree resolve`; returns the exit status: 0 if the file is written
/// and the step to it is clear, 2 after any error.
int tf_resolve_command(int argc, char *argv[]);

//: Declare the command simulate
#pragma once

/// Runs `tanglefree simulate`; returns the exit status: 0 if all steps are made,
/// 2 after any error, 128 and the number of the signal if one ended it.
int tf_simulate_command(int argc, char *argv[]);

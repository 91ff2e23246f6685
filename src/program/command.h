//: Declare commands
#pragma once

#include "program/options.h"

/// A command of the program.
typedef struct tf_command {
    tf_command_set set; ///< itself alone
    const char *name;
    const char *purpose;     ///< for the list of commands
    const char *operands;    ///< as help calls them
    int least, most;         ///< how many operands
    const char *wanted;      ///< how many, for a message
    const char *description; ///< what help says before the options, \v, and
                             ///< what it says behind them
    void (*check)(tf_request *request); ///< whether all goes together; or NULL
    int (*run)(const tf_request *request); ///< the exit status
} tf_command;

/// These are made of src/package/manual, as the manual pages are.
extern const char tf_query_description[], tf_detect_description[],
    tf_check_description[], tf_resolve_description[], tf_remesh_description[],
    tf_simulate_description[], tf_weld_description[], tf_untangle_description[];

extern const tf_command tf_query_command, tf_detect_command, tf_check_command,
    tf_resolve_command, tf_remesh_command, tf_simulate_command, tf_weld_command,
    tf_untangle_command;

/// Parses the arguments, and does what they request; the first one is not
/// looked at.  Wrong ones end the program.
/// @return the exit status
int tf_command_run(const tf_command *command, int argc, char *argv[]);

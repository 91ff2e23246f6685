//: Declare the command query
#ifndef TF_PROGRAM_QUERY_COMMAND_H
#define TF_PROGRAM_QUERY_COMMAND_H

/// Answer the queries of the files that the arguments name; argv[0] is the
/// name of the command in messages.  Returns the exit status.
int tf_query_command(int argc, char *argv[]);

#endif

//: Declare the command query
#pragma once

/// Answer the queries of the files that the arguments name; argv[0] is the
/// name of the command in messages.  Returns the exit status.
int tf_query_command(int argc, char *argv[]);

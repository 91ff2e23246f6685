//: Declare how to parse arguments
#pragma once

#include "files/record.h"

#include <argp.h>

/// Ends the program with the message that there is no such thing as `name`, and
/// which names there are.
void tf_refuse_name(struct argp_state *state, const char *what,
                    const char *name, const char *names);

/// The number from 0 to `most` that is the argument of `--option`; `wanted`
/// describes in words which it may be, for the message that ends the program if
/// it is none.
double tf_parse_number(struct argp_state *state, const char *option,
                       const char *text, double most, const char *wanted);

/// How many threads are meant; ends the program if that is no number of them.
int tf_parse_threads(struct argp_state *state, const char *text);

/// The format that is named; of reports, which have no rows, not TF_CSV.
tf_format tf_parse_format(struct argp_state *state, const char *text,
                          bool rows);

/// The names of formats, of rows and of reports, for help.
#define TF_ROWS_FORMAT_NAMES "csv, json or summary"
#define TF_REPORT_FORMAT_NAMES "summary or json"

/// What is said of the option --threads by --help.
#define TF_THREADS_HELP                                                        \
    "How many threads to use; the default is one per processor"

//: Declare the response that a command line requests
#pragma once

#include "program/options.h"
#include "program/progress.h"
#include "response/options.h"

/// The options of a response, but for what is about its start, threads and
/// vertices.  It shows its stages in the line, which it borrows.
tf_response_options tf_response_requested(const tf_request *wanted,
                                          tf_progress_line *progress);

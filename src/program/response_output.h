//: Declare the output about responses
#pragma once

#include "files/record.h"
#include "response/options.h"

/// Writes what it took to resolve a step, and how many seconds, and flushes.
/// False, with errno, if a write failed.
bool tf_response_output_write(FILE *stream, tf_format format,
                              const tf_response_report *report, double seconds);
